# SPDX-License-Identifier: LGPL-2.1-or-later
"""What went wrong, in one line where the user looks: a panel that is open, else a notice over the
window that waits for nobody; and the report view. Names of tiles in it select them."""

from __future__ import annotations

import os
import re
import traceback
import xml.etree.ElementTree as xml
from contextlib import contextmanager
from functools import lru_cache
from html import escape
from typing import Any, Callable, Iterable, Iterator, Optional

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError, Stopped, tile_name
from ..base.findings import Finding, Style
from ..base.sentences import CONTEXT
from ..features.properties import as_properties
from .guide import SCHEME, link, link_to, show_guide
from .qt import RESOURCES, QtCore, QtGui, QtWidgets, translate
from .selection import select_tiles
from .units import in_user_units

# Commands that messages name, as the guide does.
_TOPICS = ("Solve", "Verify", "Repair", "Actuate", "Build Solids", "New Design", "Change Target", "Examples",
           "Solver Status")
_panel: Optional[Callable[[str], None]] = None  # shows a line of rich text


@contextmanager
def errors_shown(what: str) -> Iterator[None]:
    """Whatever the work inside raises becomes a notice. what: names the work, for the report view."""
    try:
        yield
    except Stopped:
        pass
    except Exception as error:
        show_error(error, what)


def show_error(error: Exception, what: str = "") -> None:
    """Says an error; a traceback only where CURVEUPS_DEBUG=1 asks for it."""
    if os.environ.get("CURVEUPS_DEBUG") == "1":
        lines = traceback.format_exception(type(error), error, error.__traceback__)
        FreeCAD.Console.PrintError("".join(lines))
    if not isinstance(error, CurveUpsError):
        error = CurveUpsError(translate(
            "CurveUps", "unexpected {kind} ({said}): please report it, with what CURVEUPS_DEBUG=1 shows",
            kind=type(error).__name__, said=" ".join(str(error).split())))
    line = str(error)
    FreeCAD.Console.PrintError(f"CurveUps{f', {what}' if what else ''}: {line}\n")
    found = getattr(error, "finding", None)
    if found is None:
        _show(with_links(said(error), getattr(error, "tiles", ())))
    else:
        place = with_links(str(error)[len(str(found)):], found.tiles)
        _show(in_user_units(found.sentence(_RICH)) + place.replace(found.remedy(), found.remedy(_RICH), 1))


def said(error: CurveUpsError) -> str:
    """An error in the user's language, in a line."""
    return str(CurveUpsError(words_of(error.what), error.where, words_of(error.remedy)))


def show_line(line: str) -> None:
    """A line for the user: in the panel that is open, else as a notice."""
    _show(with_links(line))


def _show(text: str) -> None:
    if _panel is not None:
        _panel(text)
    else:
        Notice.show_text(text)


def show_in(panel: Optional[Callable[[str], None]]) -> None:
    """Where lines go while a panel is open; None when it closes."""
    global _panel
    _panel = panel


def words_of(text: str) -> str:
    """A text of sentences.py, or of an error, in the user's language; also where names or numbers stand in
    it in the places {0}, {1} and so on."""
    found = translate(CONTEXT, text)
    if found != text:
        return found
    for template, pattern in _templates():
        match = pattern.fullmatch(text)
        if match:
            parts = match.groups()
            return re.sub(r"{(\d)}", lambda place: words_of(parts[int(place[1])]),
                          translate(CONTEXT, template))
    return text


@lru_cache(maxsize=None)
def _templates() -> list[tuple[str, re.Pattern]]:
    """With places, those with the most words first; any language has them all."""
    path = next((RESOURCES / "translations").glob("*.ts"))
    texts = [message.findtext("source", "") for context in xml.parse(path).getroot().iter("context")
             if context.findtext("name") == CONTEXT for message in context.iter("message")]
    return [(text, re.compile(re.sub(r"\\{\d\\}", "(.+)", re.escape(text)), re.DOTALL))
            for text in sorted(texts, key=len, reverse=True) if re.search(r"{\d}", text)]


def _link(tile: int) -> str:
    return link(tile_name(tile), tile_name(tile))


_PLAIN = Style(words_of)
_RICH = Style(words_of, _link, lambda text: escape(text, quote=False))


def shown(design: Any, found: Finding, rich: bool = True) -> str:
    """A finding in the user's language and units, with parameters called as the design's properties are;
    in rich text names of tiles and of commands can be clicked."""
    text = in_user_units(as_properties(design, found.sentence(_RICH if rich else _PLAIN)))
    return _with_topics(text) if rich else text


def with_links(line: str, tiles: Iterable[int] = ()) -> str:
    """Rich text in the user's units, in which names of these tiles and of commands can be clicked."""
    links = {tile_name(tile): _link(tile) for tile in tiles}
    text = escape(in_user_units(line), quote=False)
    if links:
        text = re.sub(rf"\b({'|'.join(links)})\b", lambda match: links[match[0]], text)
    return _with_topics(text)


def _with_topics(text: str) -> str:
    topics = {translate(f"CurveUps_{topic.replace(' ', '')}", topic): topic for topic in _TOPICS}
    topics |= {topic: topic for topic in _TOPICS}
    return re.sub(rf"\b({'|'.join(map(re.escape, topics))})\b",
                  lambda match: link_to(topics[match[0]], match[0]), text)


def follow_link(link: str) -> None:
    """Selects the tiles that a link names, or opens its file, or the guide at its topic."""
    if link.startswith(SCHEME):
        show_guide(link[len(SCHEME):])
    elif link.startswith("file:"):
        QtGui.QDesktopServices.openUrl(QtCore.QUrl(link))
    else:
        select_tiles(link)


class Notice(QtWidgets.QFrame):
    """A line over the views that goes by itself or when it is closed."""

    SECONDS = 20
    _shown: Optional["Notice"] = None

    @classmethod
    def show_text(cls, text: str) -> None:
        """Shows rich text, in place of an earlier notice."""
        cls.hide_text()
        cls._shown = cls(FreeCADGui.getMainWindow(), text)

    @classmethod
    def hide_text(cls) -> None:
        """Takes the notice away."""
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
        """Over the upper edge of the views."""
        area = window.centralWidget().geometry()
        width = max(240, min(720, area.width() - 40))
        self.setFixedWidth(width)
        self.adjustSize()
        self.move(area.center().x() - width // 2, area.top() + 40)

    def _leave(self) -> None:
        if Notice._shown is self:
            Notice.hide_text()
