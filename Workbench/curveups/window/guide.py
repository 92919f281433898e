# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user guide in a window of its own: from the menu, by F1 over a command or in a panel, and by links.

A topic is the name of a command as the guide has it in bold; the guide opens where it says most of it, at
the last place.
"""

from __future__ import annotations

from typing import Any, Optional

import FreeCADGui

from .qt import RESOURCES, EventFilter, QtCore, QtGui, QtWidgets, ink_and_paper, translate

GUIDE = RESOURCES / "docs" / "guide.md"
SCHEME = "guide:"  # of links to a topic
_WIDTH = 640  # of pictures, px

_window: Optional["GuideWindow"] = None
_keys: Any = None


def show_guide(topic: str = "") -> None:
    """Opens the guide at a topic, or at its beginning."""
    global _window
    if _window is None:
        _window = GuideWindow(FreeCADGui.getMainWindow())
    _window.turn_to(topic)
    _window.show()
    _window.raise_()


def link(target: str, text: str) -> str:
    """Rich text that can be clicked: on a dark ground in a lighter blue than Qt's."""
    style = ' style="color: #6cb4ff"' if ink_and_paper()[0].lightness() > 128 else ""
    return f'<a href="{target}"{style}>{text}</a>'


def link_to(topic: str, text: str) -> str:
    """Rich text that opens the guide at a topic."""
    return link(SCHEME + topic, text)


class _Page(QtWidgets.QTextBrowser):
    """Pictures are as wide as the page at most."""

    def loadResource(self, kind: int, place: Any) -> Any:
        found = super().loadResource(kind, place)
        if kind == QtGui.QTextDocument.ImageResource:
            picture = QtGui.QImage(self.source().resolved(place).toLocalFile())
            if picture.width() > _WIDTH:
                return picture.scaledToWidth(_WIDTH, QtCore.Qt.SmoothTransformation)
        return found


class GuideWindow(QtWidgets.QDialog):
    """Holds nothing up; Escape closes it."""

    def __init__(self, window: Any):
        super().__init__(window)
        self.setObjectName("CurveUpsGuide")
        self.setWindowTitle(translate("CurveUps_Guide", "Guide to CurveUps"))
        self.page = _Page()
        self.page.setObjectName("page")
        self.page.setOpenExternalLinks(True)
        # As its pictures are. Qt writes links in dark blue, whatever the theme.
        self.page.setStyleSheet("QTextBrowser { background: white; color: black; }")
        back = QtWidgets.QPushButton(translate("CurveUps_Guide", "Back"))
        back.setEnabled(False)
        back.clicked.connect(lambda *_: self.page.backward())
        self.page.backwardAvailable.connect(back.setEnabled)
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(self.page)
        column.addWidget(back, 0, QtCore.Qt.AlignLeft)
        self.resize(_WIDTH + 80, 760)

    def turn_to(self, topic: str) -> None:
        """To the last place that has the topic in bold; to the beginning where none has."""
        self.page.setSource(QtCore.QUrl.fromLocalFile(str(GUIDE)))
        text, found = self.page.document(), None
        place = text.find(topic, 0, _WHOLE) if topic else QtGui.QTextCursor()
        while not place.isNull():
            if place.charFormat().fontWeight() >= QtGui.QFont.Bold:
                found = place
            place = text.find(topic, place, _WHOLE)
        cursor = QtGui.QTextCursor(text)
        if found is not None:
            cursor.movePosition(QtGui.QTextCursor.End)
            self.page.setTextCursor(cursor)  # so that the place comes to the top
            cursor = QtGui.QTextCursor(found)
        self.page.setTextCursor(cursor)


_WHOLE = QtGui.QTextDocument.FindWholeWords | QtGui.QTextDocument.FindCaseSensitively


def install() -> None:
    """Gives F1 and the links of What's This to the guide, where they are about CurveUps. Once a session."""
    global _keys
    if _keys is None:
        _keys = answer_keys(FreeCADGui.getMainWindow())


def answer_keys(widget: Any) -> Any:
    """The same for what comes to a widget and those in it."""
    return _Keys(widget, widget)


class _Asked(EventFilter):
    """Between Shift+F1 and the click of What's This, which FreeCAD leaves to its Help addon."""

    def takes(self, event: Any) -> bool:
        if event.type() != QtCore.QEvent.WhatsThis:
            return False
        topic = _topic_at(QtWidgets.QApplication.widgetAt(QtGui.QCursor.pos()))
        if topic:
            event.accept()
            QtWidgets.QWhatsThis.leaveWhatsThisMode()
            show_guide(topic)
        return bool(topic)


class _Keys(EventFilter):
    """Sees what nobody took before a widget gets it."""

    _asked: Any = None

    def takes(self, event: Any) -> bool:
        kind = event.type()
        if kind == QtCore.QEvent.EnterWhatsThisMode and self._asked is None:
            application = QtWidgets.QApplication.instance()
            self._asked = _Asked(application, application)
        if kind == QtCore.QEvent.LeaveWhatsThisMode and self._asked is not None:
            QtWidgets.QApplication.instance().removeEventFilter(self._asked)
            self._asked = None
        if kind == QtCore.QEvent.WhatsThisClicked and event.href().startswith(SCHEME):
            show_guide(event.href()[len(SCHEME):])
            return True
        # The dock of panels keeps the key itself. Qt 5 asks all widgets for it before, Qt 6 does not.
        if kind not in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress) or (
                event.key() != QtCore.Qt.Key_F1 or event.modifiers() != QtCore.Qt.NoModifier):
            return False
        topic = _topic_at(QtWidgets.QApplication.widgetAt(QtGui.QCursor.pos())) or _topic_at(
            QtWidgets.QApplication.focusWidget())
        if topic:
            event.accept()
            show_guide(topic)
        return bool(topic)


def _topic_at(widget: Any) -> str:
    """Of a command's button, or of the panel that a widget is in; empty elsewhere."""
    while widget is not None:
        action = widget.defaultAction() if isinstance(widget, QtWidgets.QToolButton) else None
        for thing in (action, widget):
            topic = thing.property("CurveUpsTopic") if thing is not None else ""
            if topic:
                return str(topic)
        widget = widget.parentWidget()
    return ""
