# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user guide in a window of its own; version and folder of the solver, or the remedy where that is
missing."""

from __future__ import annotations

import platform
import sys
import sysconfig
from html import escape
from pathlib import Path
from typing import Any, Optional

import FreeCAD
import FreeCADGui

from ... import __version__
from ...base.errors import CurveUpsError
from ...base.native import native
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
