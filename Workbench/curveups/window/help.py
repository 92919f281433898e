# SPDX-License-Identifier: LGPL-2.1-or-later
"""Help: the guide, and the state of the solver."""

from __future__ import annotations

import platform
import sys
import sysconfig
from html import escape
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from .. import __version__
from ..base.errors import CurveUpsError
from ..base.native import native
from .notice import show_box, words_of
from .qt import RESOURCES, QtCore, QtGui, QtWidgets, translate

_WIDTH = 640  # of pictures, px


def show_guide(_: Any) -> None:
    """Open the guide in a window of its own."""
    page = _Page(FreeCADGui.getMainWindow())
    page.setWindowFlags(QtCore.Qt.Window)
    page.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    page.setObjectName("CurveUpsGuide")
    page.setWindowTitle(translate("CurveUps_Guide", "Guide to CurveUps"))
    page.setOpenExternalLinks(True)
    # White as its pictures. Qt writes links in dark blue, whatever the theme.
    page.setStyleSheet("QTextBrowser { background: white; color: black; }")
    page.resize(_WIDTH + 80, 760)
    page.setSource(QtCore.QUrl.fromLocalFile(str(RESOURCES / "docs" / "guide.md")))
    page.show()


class _Page(QtWidgets.QTextBrowser):
    """A page whose pictures are at most as wide as the window."""

    def loadResource(self, kind: int, address: Any) -> Any:
        resource = super().loadResource(kind, address)
        if kind == QtGui.QTextDocument.ImageResource:
            picture = QtGui.QImage(self.source().resolved(address).toLocalFile())
            if picture.width() > _WIDTH:
                return picture.scaledToWidth(_WIDTH, QtCore.Qt.SmoothTransformation)
        return resource


def solver_status() -> list[tuple[str, str]]:
    """State of the solver, as rows of a table. Works without the native module."""
    folder = Path(__file__).parents[1]
    built = sorted(path.name for path in folder.glob("_native*") if path.suffix != ".pyi")
    rows = [("CurveUps", __version__),
            ("FreeCAD", ".".join(FreeCAD.Version()[:3])),
            ("Python", f"{platform.python_version()}, {sysconfig.get_config_var('SOABI') or sys.platform}"),
            (translate("CurveUps_SolverStatus", "Folder"), str(folder)),
            (translate("CurveUps_SolverStatus", "Solver"),
             ", ".join(built) or translate("CurveUps_SolverStatus", "none"))]
    state = translate("CurveUps_SolverStatus", "State")
    try:
        threads = native.thread_count()
    except CurveUpsError as error:
        rows += [(state, words_of(error.what)),
                 (translate("CurveUps_SolverStatus", "Remedy"), words_of(error.remedy)),
                 (translate("CurveUps_SolverStatus", "Meanwhile"),
                  translate("CurveUps_SolverStatus", "designs can be opened, shown and exported as they are "
                                                     "stored"))]
    else:
        rows.append((state, translate("CurveUps_SolverStatus", "ready; threads: {count}", count=threads)))
    return rows


def show_solver_status(_: Any) -> None:
    """Show the state of the solver in a box, and in the report view to be copied."""
    rows = solver_status()
    for what, text in rows:
        FreeCAD.Console.PrintMessage(f"CurveUps, {what}: {text}\n")
    table = "".join(f"<tr><td><b>{escape(what)}</b>&nbsp;&nbsp;</td><td>{escape(text)}</td></tr>"
                    for what, text in rows)
    show_box("CurveUpsSolverStatus", translate("CurveUps_SolverStatus", "Solver Status"),
             f"<table>{table}</table>")
