# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solver Status: version and folder of the solver, or the remedy where it is missing or wrong."""

from __future__ import annotations

import platform
import sys
import sysconfig
from html import escape
from pathlib import Path

import FreeCAD
import FreeCADGui

from ... import __version__
from ...base.errors import CurveUpsError
from ...base.native import native
from ..qt import QT_TRANSLATE_NOOP, QtCore, QtWidgets, translate
from .command import Command


def solver_status() -> list[tuple[str, str]]:
    """Lines of a table: what, and how it stands. Works without the native module."""
    folder = Path(__file__).parents[2]
    built = sorted(path.name for path in folder.glob("_native*") if path.suffix != ".pyi")
    rows = [("CurveUps", __version__),
            ("FreeCAD", ".".join(FreeCAD.Version()[:3])),
            ("Python", f"{platform.python_version()}, {sysconfig.get_config_var('SOABI') or sys.platform}"),
            (translate("CurveUps_SolverStatus", "Folder"), str(folder)),
            (translate("CurveUps_SolverStatus", "Solver"),
             ", ".join(built) or translate("CurveUps_SolverStatus", "none"))]
    try:
        threads = native.thread_count()
    except CurveUpsError as error:
        rows += [(translate("CurveUps_SolverStatus", "State"), error.what),
                 (translate("CurveUps_SolverStatus", "Remedy"), _remedy(folder)),
                 (translate("CurveUps_SolverStatus", "Meanwhile"),
                  translate("CurveUps_SolverStatus", "designs can be opened, shown and exported as they are "
                                                     "stored"))]
    else:
        rows.append((translate("CurveUps_SolverStatus", "State"),
                     translate("CurveUps_SolverStatus", "ready; threads: {count}", count=threads)))
    return rows


def _remedy(folder: Path) -> str:
    root = folder.parents[1]
    if (root / "tools" / "setup").is_file():
        return translate("CurveUps_SolverStatus", "run {command}, then start FreeCAD again",
                         command=root / "tools" / "setup")
    return translate("CurveUps_SolverStatus", "install the package for this FreeCAD's Python again")


class SolverStatus(Command):
    """CurveUps_SolverStatus"""

    name = "CurveUps_SolverStatus"
    text = QT_TRANSLATE_NOOP("CurveUps_SolverStatus", "Solver Status")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_SolverStatus",
                                "Show the version and folder of the solver, or the reason why it can't be "
                                "loaded and the remedy")

    def run(self) -> None:
        rows = solver_status()
        for what, how in rows:
            FreeCAD.Console.PrintMessage(f"CurveUps, {what}: {how}\n")
        box = QtWidgets.QMessageBox(FreeCADGui.getMainWindow())
        box.setObjectName("CurveUpsSolverStatus")
        box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        box.setWindowTitle(translate(self.name, self.text))
        box.setTextFormat(QtCore.Qt.RichText)
        box.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        lines = "".join(f"<tr><td><b>{escape(what)}</b>&nbsp;&nbsp;</td><td>{escape(how)}</td></tr>"
                        for what, how in rows)
        box.setText(f"<table>{lines}</table>")
        box.setModal(False)
        box.show()


COMMAND = SolverStatus()
