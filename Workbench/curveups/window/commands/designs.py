# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that work on a design, as a table."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import FreeCADGui

from ...base.native import problem
from ...features import actions
from ...features.document import has_layout
from ...features.status import has_tiles
from .. import runs
from ..overlays import overlay_of
from ..panels.actuate import ActuatePanel
from ..panels.check import CheckPanel
from ..panels.cuts import CutsPanel
from ..panels.export import ExportPanel, KitPanel
from ..panels.overlay import OverlayPanel, WorstContactsPanel
from ..panels.panel import Panel, obstacle, show
from ..panels.solve import SolvePanel
from ..qt import QT_TRANSLATE_NOOP, QtCore, QtGui, translate
from ..run import LIVE, Task
from ..runs import call, named
from .command import DesignCommand, Reason, Work
from .new_design import SURFACE, ask_for_file, selected_surface


def _opens(panel: type[Panel]) -> Work:
    return lambda design: show(panel, design)


def _starts(which: str) -> Work:
    """A run, in the design's panel."""
    return lambda design: show(SolvePanel, design).run(which)


def _let_it_need_little_friction(design: Any) -> None:
    """Sets SelfShaping, and goes on from the layout."""
    title = translate("CurveUps_LittleFriction", "Let It Need Little Friction")
    with actions.transaction(design.Document, title):
        runs.assign(design, "SelfShaping", True)
    show(SolvePanel, design).run("repair")


def _other_panel(design: Any) -> str:
    return obstacle()


def _not_ready(which: str) -> Reason:
    """Why a run (runs.reason) can't start."""
    return lambda design: runs.reason(which, design)


def _no_tiles(design: Any) -> str:
    """Why there is nothing to draw; a hidden design may have no scene yet."""
    if _scene_of(design) is not None or has_tiles(design) or has_layout(design):
        return ""
    return translate("CurveUps", "There are no tiles yet: run Solve")


def _no_layout(design: Any) -> str:
    scene = _scene_of(design)
    if has_layout(design) if scene is None else scene.flat is not None:
        return ""
    return translate("CurveUps", "There is no layout yet: run Solve")


def _scene_of(design: Any) -> Any:
    try:
        return overlay_of(design).scene
    except KeyError:
        return None


def _no_solids(design: Any) -> str:
    if design.Tiles is None or design.Tiles.Shape.isNull():
        return translate("CurveUps", "There are no solids yet: run Build Solids")
    return ""


def _no_solver(design: Any) -> str:
    return str(problem() or "")


def _at_work(design: Any) -> str:
    return LIVE.obstacle()


def _shows(function: str) -> Work:
    """A function of overlay/showing.py, recorded for macros in a window. It changes nothing but views, which
    undo leaves alone."""
    def work(design: Any) -> None:
        FreeCADGui.doCommandGui("from curveups.window.overlay import showing")
        FreeCADGui.doCommandGui(f"showing.{function}({named(design)})")

    return work


def _actuate(design: Any) -> None:
    panel = show(ActuatePanel, design)
    if design.Actuation != "current":
        panel.run()


def _write_report(design: Any) -> None:
    """Beside the document; in a temporary folder where that was never saved."""
    saved = design.Document.FileName
    place = Path(saved).parent if saved else Path(tempfile.mkdtemp(prefix="curveups-"))
    folder = str(place / f"{actions.file_name(design)}-report")

    def opened(design: Any, page: str) -> None:
        runs.finish("report", design, page, repr(folder))
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(page))

    work = actions.report_work(design, folder)
    LIVE.start(design, Task(translate("CurveUps_Report", "Report"), work, opened))


def _change_target(design: Any) -> None:
    source = selected_surface()
    text = named(source) if source is not None else ""
    if not text:
        path = ask_for_file(SURFACE)
        text = repr(path) if path else ""
    if text:
        with actions.transaction(design.Document, translate("CurveUps_Target", "Change Target")):
            call("document.set_source", named(design), text)
        design.Document.recompute()


COMMANDS = (
    DesignCommand(
        "CurveUps_Check", QT_TRANSLATE_NOOP("CurveUps_Check", "Check"),
        QT_TRANSLATE_NOOP("CurveUps_Check",
                          "Find out which parts of the target can become tiles, before you solve"),
        _opens(CheckPanel), _other_panel, _not_ready("check"), shortcut="C, K"),
    DesignCommand(
        "CurveUps_Solve", QT_TRANSLATE_NOOP("CurveUps_Solve", "Solve"),
        QT_TRANSLATE_NOOP("CurveUps_Solve",
                          "Lay the tiles out flat, verify that the membranes hold the shape, and repair weak "
                          "contacts"),
        _starts("solve"), _other_panel, _not_ready("solve"), shortcut="C, S"),
    DesignCommand(
        "CurveUps_Cuts", QT_TRANSLATE_NOOP("CurveUps_Cuts", "Cuts"),
        QT_TRANSLATE_NOOP("CurveUps_Cuts",
                          "Pick edges along which tiles are disconnected, or ask for suggestions"),
        _opens(CutsPanel), _other_panel, _no_solver, _at_work),
    DesignCommand(
        "CurveUps_Overlay", QT_TRANSLATE_NOOP("CurveUps_Overlay", "Overlay"),
        QT_TRANSLATE_NOOP("CurveUps_Overlay",
                          "Choose the value that colours the tiles, fold them, and read their values"),
        _opens(OverlayPanel), _other_panel, _no_tiles),
    DesignCommand(
        "CurveUps_Export", QT_TRANSLATE_NOOP("CurveUps_Export", "Export Print Files"),
        QT_TRANSLATE_NOOP("CurveUps_Export",
                          "Write 3MF, STEP and STL files of the bodies, and the report for the print shop"),
        _opens(ExportPanel), _other_panel, _not_ready("export"), shortcut="C, E"),
    DesignCommand(
        "CurveUps_Target", QT_TRANSLATE_NOOP("CurveUps_Target", "Change Target"),
        QT_TRANSLATE_NOOP("CurveUps_Target",
                          "Give the design another surface: the selected Part or Mesh object, or a file"),
        _change_target, _no_solver),
    DesignCommand(
        "CurveUps_Verify", QT_TRANSLATE_NOOP("CurveUps_Verify", "Verify"),
        QT_TRANSLATE_NOOP("CurveUps_Verify",
                          "Decide whether the present layout is valid with the present tiles and membranes"),
        _starts("verify"), _other_panel, _not_ready("verify"), shortcut="C, V"),
    DesignCommand(
        "CurveUps_Repair", QT_TRANSLATE_NOOP("CurveUps_Repair", "Repair"),
        QT_TRANSLATE_NOOP("CurveUps_Repair", "Move tiles and pins of the layout until weak contacts hold"),
        _starts("repair"), _other_panel, _not_ready("repair"), shortcut="C, R"),
    DesignCommand(
        "CurveUps_LittleFriction",
        QT_TRANSLATE_NOOP("CurveUps_LittleFriction", "Let It Need Little Friction"),
        QT_TRANSLATE_NOOP("CurveUps_LittleFriction",
                          "Move pins and tiles of the layout until the design needs as little friction as it "
                          "can, so that the piece comes to rest near its target"),
        _let_it_need_little_friction, _other_panel, _not_ready("repair")),
    DesignCommand(
        "CurveUps_Actuate", QT_TRANSLATE_NOOP("CurveUps_Actuate", "Actuate"),
        QT_TRANSLATE_NOOP("CurveUps_Actuate",
                          "Compute the shape of the built piece: released from flat, shaken, and pressed "
                          "over its former"),
        _actuate, _other_panel, _not_ready("actuate")),
    DesignCommand(
        "CurveUps_BuildSolids", QT_TRANSLATE_NOOP("CurveUps_BuildSolids", "Build Solids"),
        QT_TRANSLATE_NOOP("CurveUps_BuildSolids",
                          "Build the solids of tiles, support and anchors with the present parameters"),
        _starts("build_solids"), _other_panel, _not_ready("build_solids")),
    DesignCommand(
        "CurveUps_Report", QT_TRANSLATE_NOOP("CurveUps_Report", "Report"),
        QT_TRANSLATE_NOOP("CurveUps_Report",
                          "Write report.html, with verdict, pictures and figures, and open it"),
        _write_report, _not_ready("report")),
    DesignCommand(
        "CurveUps_Kit", QT_TRANSLATE_NOOP("CurveUps_Kit", "Fabrication Kit"),
        QT_TRANSLATE_NOOP("CurveUps_Kit",
                          "Write the order for the print shop, templates for the latex and the steps of "
                          "assembly"),
        _opens(KitPanel), _other_panel, _not_ready("kit")),
    DesignCommand(
        "CurveUps_ShowFlat", QT_TRANSLATE_NOOP("CurveUps_ShowFlat", "Show Flat"),
        QT_TRANSLATE_NOOP("CurveUps_ShowFlat", "Show the tiles in the flat layout"),
        _shows("show_flat"), _no_layout),
    DesignCommand(
        "CurveUps_ShowActuated", QT_TRANSLATE_NOOP("CurveUps_ShowActuated", "Show Actuated"),
        QT_TRANSLATE_NOOP("CurveUps_ShowActuated", "Show the tiles in the target shape"),
        _shows("show_actuated"), _no_tiles),
    DesignCommand(
        "CurveUps_ShowSolids", QT_TRANSLATE_NOOP("CurveUps_ShowSolids", "Show Solids"),
        QT_TRANSLATE_NOOP("CurveUps_ShowSolids",
                          "Show tiles and anchors as printed solids. They are exact, but slow for thousands "
                          "of tiles"),
        _shows("show_solids"), _no_layout, _no_solids),
    DesignCommand(
        "CurveUps_WorstContacts", QT_TRANSLATE_NOOP("CurveUps_WorstContacts", "Worst Contacts"),
        QT_TRANSLATE_NOOP("CurveUps_WorstContacts",
                          "List contacts and tiles, the worst first. Click one to go there"),
        _opens(WorstContactsPanel), _other_panel, _no_tiles),
)
