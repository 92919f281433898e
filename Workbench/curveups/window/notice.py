# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors in one line: in an open panel, else in a notice over the window, and in the report view. A click on
a tile's name selects the tile."""

from __future__ import annotations

import os
import re
import traceback
import xml.etree.ElementTree as xml
from contextlib import contextmanager
from functools import lru_cache
from html import escape
from typing import Any, Callable, Iterator, Optional

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError, Stopped, tile_name
from ..base.findings import Finding, Style
from ..base.sentences import CONTEXT
from ..features.properties import named
from .overlays import select_tiles
from .qt import RESOURCES, QtCore, QtGui, QtWidgets, ink_and_paper, translate
from .units import quantity

_panel: Optional[Callable[[str], None]] = None  # shows a line of rich text


@contextmanager
def errors_shown(what: str) -> Iterator[None]:
    """Show an error of the work inside. what: names the work, for the report view."""
    try:
        yield
    except Stopped:
        pass
    except Exception as error:
        show_error(error, what)


def show_error(error: Exception, what: str = "") -> None:
    """Show an error; with CURVEUPS_DEBUG=1 its traceback too."""
    if os.environ.get("CURVEUPS_DEBUG") == "1":
        lines = traceback.format_exception(type(error), error, error.__traceback__)
        FreeCAD.Console.PrintError("".join(lines))
    if not isinstance(error, CurveUpsError):
        error = CurveUpsError(translate(
            "CurveUps", "unexpected {kind} ({said}): please report it, with what CURVEUPS_DEBUG=1 shows",
            kind=type(error).__name__, said=" ".join(str(error).split())))
    FreeCAD.Console.PrintError(f"CurveUps{f', {what}' if what else ''}: {error}\n")
    _show(_rich(error))


def _rich(error: CurveUpsError) -> str:
    """Rich text of an error in the user's language, with links to its tiles."""
    what, remedy = (escape(words_of(text), quote=False) for text in (error.what, error.remedy))
    if error.finding is not None:
        what, remedy = error.finding.sentence(_RICH), error.finding.remedy(_RICH)
    place = escape(error.where, quote=False)
    for tile in error.tiles:
        place = place.replace(tile_name(tile), _link(tile))
    return what + (f" ({place})" if place else "") + (f": {remedy}" if remedy else "")


def show_line(line: str) -> None:
    """Show a line in the panel that is open, else as a notice."""
    _show(escape(line, quote=False))


def _show(text: str) -> None:
    if _panel is not None:
        _panel(text)
    else:
        Notice.show_text(text)


def show_in(panel: Optional[Callable[[str], None]]) -> None:
    """Show lines in a panel from now on; None: as notices."""
    global _panel
    _panel = panel


def words_of(text: str) -> str:
    """Translate the text of an error, or of a step of work, also with names or numbers in the placeholders
    {0}, {1} and so on."""
    translated = translate(CONTEXT, text)
    if translated != text:
        return translated
    for template, pattern in _templates():
        match = pattern.fullmatch(text)
        if match:
            return translate(CONTEXT, template).format(*map(words_of, match.groups()))
    return text


@lru_cache(maxsize=None)
def _templates() -> list[tuple[str, re.Pattern]]:
    """Texts with placeholders and their patterns, the longest first; any language has them all."""
    path = next((RESOURCES / "translations").glob("*.ts"))
    texts = [message.findtext("source", "") for context in xml.parse(path).getroot().iter("context")
             if context.findtext("name") == CONTEXT for message in context.iter("message")]
    return [(text, re.compile(re.sub(r"\\{\d\\}", "(.+)", re.escape(text)), re.DOTALL))
            for text in sorted(texts, key=len, reverse=True) if re.search(r"{\d}", text)]


def link(target: str, text: str) -> str:
    """Rich text that can be clicked, on a dark ground in a lighter blue than Qt's."""
    style = ' style="color: #6cb4ff"' if ink_and_paper()[0].lightness() > 128 else ""
    return f'<a href="{target}"{style}>{text}</a>'


def _link(tile: int) -> str:
    return link(tile_name(tile), tile_name(tile))


_PLAIN = Style(lambda text: named(words_of(text)), quantity=quantity)
_RICH = Style(_PLAIN.words, _link, lambda text: escape(text, quote=False), quantity)


def shown(finding: Finding, rich: bool = True) -> str:
    """Sentence of a finding in the user's language and units; in rich text names of tiles can be clicked."""
    return finding.sentence(_RICH if rich else _PLAIN)


def follow_link(link: str) -> None:
    """Open a file, or select the tiles that a link names."""
    if link.startswith("file:"):
        QtGui.QDesktopServices.openUrl(QtCore.QUrl(link))
    else:
        select_tiles(link)


class Notice(QtWidgets.QFrame):
    """A line over the views. It closes after a while."""

    SECONDS = 20
    _shown: Optional["Notice"] = None

    @classmethod
    def show_text(cls, text: str) -> None:
        """Show rich text, in place of an earlier notice."""
        cls.hide_text()
        cls._shown = cls(FreeCADGui.getMainWindow(), text)

    @classmethod
    def hide_text(cls) -> None:
        """Close the notice."""
        if cls._shown is not None:
            cls._shown.close()
            cls._shown = None

    def __init__(self, window: Any, text: str):
        super().__init__(window)
        self.setObjectName("CurveUpsNotice")
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.setFrameShape(QtWidgets.QFrame.StyledPanel)
        self.setAutoFillBackground(True)
        label = QtWidgets.QLabel(text)
        label.setObjectName("text")
        label.setWordWrap(True)
        label.setTextFormat(QtCore.Qt.RichText)
        label.setTextInteractionFlags(QtCore.Qt.TextBrowserInteraction)
        label.linkActivated.connect(lambda link: follow_link(link))
        close = QtWidgets.QToolButton()
        close.setText("×")
        close.setToolTip(translate("CurveUps", "Close"))
        close.clicked.connect(lambda: Notice.hide_text())
        row = QtWidgets.QHBoxLayout(self)
        row.addWidget(label, 1)
        row.addWidget(close)
        self._place(window)
        self.show()
        for milliseconds in (0, 500):  # the report view may open above it
            QtCore.QTimer.singleShot(milliseconds, self, QtCore.SLOT("raise()"))
        QtCore.QTimer.singleShot(1000 * self.SECONDS, self._leave)

    def _place(self, window: Any) -> None:
        """Move the notice to the upper edge of the views."""
        area = window.centralWidget().geometry()
        width = max(240, min(720, area.width() - 40))
        self.setFixedWidth(width)
        self.adjustSize()
        self.move(area.center().x() - width // 2, area.top() + 40)

    def _leave(self) -> None:
        if Notice._shown is self:
            Notice.hide_text()
