# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user guide in a window of its own."""

from __future__ import annotations

from typing import Any, Optional

import FreeCADGui

from ..qt import QT_TRANSLATE_NOOP, RESOURCES, QtCore, QtGui, QtWidgets, translate
from .command import Command

_WIDTH = 640  # of pictures, px


class Guide(Command):
    """CurveUps_Guide"""

    name = "CurveUps_Guide"
    text = QT_TRANSLATE_NOOP("CurveUps_Guide", "Guide")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Guide", "Open the guide, from a surface to print files")
    _window: Optional["_Window"] = None

    def run(self) -> None:
        if self._window is None:
            self._window = _Window(FreeCADGui.getMainWindow())
        self._window.show()
        self._window.raise_()


class _Page(QtWidgets.QTextBrowser):
    """Pictures are as wide as the page at most."""

    def loadResource(self, kind: int, place: Any) -> Any:
        found = super().loadResource(kind, place)
        if kind == QtGui.QTextDocument.ImageResource:
            picture = QtGui.QImage(self.source().resolved(place).toLocalFile())
            if picture.width() > _WIDTH:
                return picture.scaledToWidth(_WIDTH, QtCore.Qt.SmoothTransformation)
        return found


class _Window(QtWidgets.QDialog):
    """Holds nothing up; Escape closes it."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName("CurveUpsGuide")
        self.setWindowTitle(translate("CurveUps_Guide", "Guide to CurveUps"))
        page = _Page()
        page.setObjectName("page")
        page.setOpenExternalLinks(True)
        # As its pictures are. Qt writes links in dark blue, whatever the theme.
        page.setStyleSheet("QTextBrowser { background: white; color: black; }")
        back = QtWidgets.QPushButton(translate("CurveUps_Guide", "Back"))
        back.setEnabled(False)
        back.clicked.connect(lambda *_: page.backward())
        page.backwardAvailable.connect(back.setEnabled)
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(page)
        column.addWidget(back, 0, QtCore.Qt.AlignLeft)
        self.resize(_WIDTH + 80, 760)
        page.setSource(QtCore.QUrl.fromLocalFile(str(RESOURCES / "docs" / "guide.md")))


COMMAND = Guide()
