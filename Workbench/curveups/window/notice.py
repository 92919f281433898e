# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors in one line: in an open panel, else in a box, and in the report view. A click on a tile's name
selects the tile."""

from __future__ import annotations

import os
import re
import traceback
import xml.etree.ElementTree as xml
from contextlib import contextmanager
from functools import lru_cache
from html import escape
from typing import Callable, Iterator, Optional

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError, Stopped, tile_name, without_package
from ..base.findings import Finding, Style
from ..base.sentences import CONTEXT
from ..features.properties import named
from .overlays import select_tiles
from .qt import RESOURCES, QtCore, QtGui, QtWidgets, ink_and_paper, translate
from .units import quantity

_SHOWN = 20_000  # ms that a line stays in the status bar
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
    error = without_package(error)
    if not isinstance(error, CurveUpsError):
        error = CurveUpsError(translate(
            "CurveUps", "unexpected {kind} ({said}): please report it, with what CURVEUPS_DEBUG=1 shows",
            kind=type(error).__name__, said=" ".join(str(error).split())))
    FreeCAD.Console.PrintError(f"CurveUps{f', {what}' if what else ''}: {error}\n")
    if _panel is not None:
        _panel(rich(error))
    else:
        show_box("CurveUpsNotice", "CurveUps", rich(error))


def rich(error: CurveUpsError) -> str:
    """Rich text of an error in the user's language, with links to its tiles."""
    what, remedy = (escape(words_of(text), quote=False) for text in (error.what, error.remedy))
    if error.finding is not None:
        what, remedy = error.finding.sentence(_RICH), error.finding.remedy(_RICH)
    place = escape(error.where, quote=False)
    for tile in error.tiles:
        place = place.replace(tile_name(tile), _link(tile))
    return what + (f" ({place})" if place else "") + (f": {remedy}" if remedy else "")


def show_line(line: str) -> None:
    """Show a line in the panel that is open, else in the status bar."""
    if _panel is not None:
        _panel(escape(line, quote=False))
    else:
        FreeCADGui.getMainWindow().statusBar().showMessage(line, _SHOWN)


def show_in(panel: Optional[Callable[[str], None]]) -> None:
    """Show lines in a panel from now on; None: in none."""
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


def show_box(name: str, title: str, text: str) -> None:
    """Show rich text in a box beside which work goes on. name: of the box, which replaces an earlier one."""
    window = FreeCADGui.getMainWindow()
    earlier = window.findChild(QtWidgets.QMessageBox, name)
    if earlier is not None:
        earlier.close()
    box = QtWidgets.QMessageBox(window)
    box.setObjectName(name)
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.setWindowTitle(title)
    box.setTextFormat(QtCore.Qt.RichText)
    box.setTextInteractionFlags(QtCore.Qt.TextBrowserInteraction)
    box.setText(text)
    box.findChild(QtWidgets.QLabel, "qt_msgbox_label").linkActivated.connect(lambda link: follow_link(link))
    box.setModal(False)
    box.show()
