# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of commands, from which FreeCAD's commands, toolbar and menus are made."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Callable, Iterator

import FreeCADGui

from ..base.native import native, problem
from ..features import actions
from ..features.document import has_layout
from ..features.status import has_tiles
from . import run
from .actuate import actuate
from .check import CheckPanel
from .cuts import CutsPanel
from .export import ExportPanel, KitPanel
from .help import show_guide, show_solver_status
from .new_design import change_target, new_design, open_example
from .notice import errors_shown
from .overlay.panel import OverlayPanel, WorstContactsPanel
from .overlays import chosen_design, no_design, overlay_of
from .panel import Panel, obstacle, show
from .qt import QT_TRANSLATE_NOOP, QtCore, QtGui, translate
from .run import LIVE, Task, named
from .solve import SolvePanel, let_it_need_little_friction

Action = Callable[[Any], object]  # on a Design object; None for commands that need none
Reason = Callable[[Any], str]     # why nothing can be done with it now; empty if something can


@dataclass(frozen=True)
class Command:
    """A command as FreeCAD sees it. FreeCAD translates its texts in the context of its name. `reasons` give
    sentences without a full stop; the first that is not empty counts. FreeCAD asks several times a second."""

    name: str
    text: str
    tooltip: str
    action: Action
    reasons: tuple[Reason, ...] = ()
    shortcut: str = ""
    icon: str = ""  # file in resources/icons, by default of the command's name
    on_design: bool = True  # the selected design, or the document's only one

    def GetResources(self) -> dict[str, Any]:
        return {"Pixmap": self.icon or self.name, "MenuText": self.text, "ToolTip": self.tooltip,
                "WhatsThis": self.name, "Accel": self.shortcut, "CmdType": "AlterDoc"}

    def IsActive(self) -> bool:
        try:
            reason = self._reason()
        except Exception as error:  # a timer asks: an exception would be a traceback each time
            reason = str(error)
        self._show_reason(reason)
        return not reason

    def Activated(self, index: int = 0) -> None:
        with errors_shown(translate(self.name, self.text)):
            self.action(chosen_design() if self.on_design else None)

    def _reason(self) -> str:
        design = chosen_design() if self.on_design else None
        if self.on_design and design is None:
            return no_design()
        return next(filter(None, (reason(design) for reason in self.reasons)), "")

    def _show_reason(self, reason: str) -> None:
        """Show the reason in tooltip and status tip: FreeCAD only greys a command out. A change of language
        takes it away again."""
        command = FreeCADGui.Command.get(self.name)
        tip = translate(self.name, self.tooltip)
        text = f"<b>{translate(self.name, self.text)}</b><br>{tip}" + f"<br><i>{reason}</i>" * bool(reason)
        for action in command.getAction() if command is not None else ():
            if action.toolTip() != text:
                action.setToolTip(text)
                action.setStatusTip(reason or tip)


def _opens(panel: type[Panel]) -> Action:
    return lambda design: show(panel, design)


def _starts(which: str) -> Action:
    """Start a run in the design's panel."""
    return lambda design: show(SolvePanel, design).run(which)


def _shows(function: str) -> Action:
    """Call a function of overlay/showing.py, and record it for macros in a window. It changes only views,
    which undo leaves alone."""
    def action(design: Any) -> None:
        FreeCADGui.doCommandGui("from curveups.window.overlay import showing")
        FreeCADGui.doCommandGui(f"showing.{function}({named(design)})")

    return action


def _write_report(design: Any) -> None:
    """Write the report beside the document, or in a temporary folder if that was never saved; open it."""
    saved = design.Document.FileName
    place = Path(saved).parent if saved else Path(tempfile.mkdtemp(prefix="curveups-"))
    folder = str(place / f"{actions.file_name(design)}-report")

    def opened(design: Any, page: str) -> None:
        run.finish("report", design, page, repr(folder))
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(page))

    work = actions.report_work(design, folder)
    LIVE.start(design, Task(translate("CurveUps_Report", "Report"), work, opened))


def _other_panel(_: Any) -> str:
    return obstacle()


def _no_solver(_: Any) -> str:
    return str(problem() or "")


def _at_work(_: Any) -> str:
    return LIVE.obstacle()


def _not_ready(which: str) -> Reason:
    return partial(run.reason, which)


def _no_tiles(design: Any) -> str:
    if has_tiles(design) or has_layout(design):
        return ""
    return translate("CurveUps", "There are no tiles yet: run Solve")


def _no_layout(design: Any) -> str:
    return "" if has_layout(design) else translate("CurveUps", "There is no layout yet: Solve makes it")


def _no_flat_tiles(design: Any) -> str:
    scene = overlay_of(design).scene  # Cuts shows layouts that no document holds
    return "" if scene is not None and scene.flat is not None else _no_layout(design)


def _no_solids(design: Any) -> str:
    if design.Tiles is None or design.Tiles.Shape.isNull():
        return translate("CurveUps", "There are no solids yet: run Build Solids")
    return ""


def _examples() -> Iterator[Command]:
    """A command for each built-in target; none without the native module."""
    for target, meaning in [] if problem() else native.builtin_targets():
        title = target.replace("-", " ").title().replace(" ", "-")
        yield Command(f"CurveUps_Example_{target}", title, f"{title}: {meaning}",
                      partial(open_example, target, title), (_at_work, _no_solver),
                      icon="CurveUps_Examples", on_design=False)


# Toolbar and head of the menu: the steps from a surface to print files.
_STEPS = (
    Command("CurveUps_NewDesign", "New Design",
            "Make a design of the selected Part or Mesh object, of its selected faces, or of a file if "
            "nothing is selected",
            new_design, (_no_solver,), "C, N", on_design=False),
    Command("CurveUps_Check", "Check",
            "Find out which parts of the target can become tiles, before you solve",
            _opens(CheckPanel), (_other_panel, _not_ready("check")), "C, K"),
    Command("CurveUps_Solve", "Solve",
            "Lay the tiles out flat, verify that the membranes hold the shape, and repair weak contacts",
            _starts("solve"), (_other_panel, _not_ready("solve")), "C, S"),
    Command("CurveUps_Verify", "Verify",
            "Decide whether the present layout is valid with the present tiles and membranes",
            _starts("verify"), (_other_panel, _not_ready("verify")), "C, V"),
    Command("CurveUps_Cuts", "Cuts",
            "Pick edges along which tiles are disconnected, or ask for suggestions",
            _opens(CutsPanel), (_other_panel, _no_solver, _at_work)),
    Command("CurveUps_Overlay", "Overlay",
            "Choose the value that colours the tiles, fold them, and read their values",
            _opens(OverlayPanel), (_other_panel, _no_tiles)),
    Command("CurveUps_Export", "Export Print Files",
            "Write 3MF, STEP and STL files of the bodies, and the report for the print shop",
            _opens(ExportPanel), (_other_panel, _not_ready("export")), "C, E"),
)
# Menus below that of CurveUps, by their titles.
_DESIGN, _SHOW, _EXAMPLES, _HELP = (
    QT_TRANSLATE_NOOP("Workbench", "Design"), QT_TRANSLATE_NOOP("Workbench", "Show"),
    QT_TRANSLATE_NOOP("Workbench", "Examples"), QT_TRANSLATE_NOOP("Workbench", "Help"))
_MENU = QT_TRANSLATE_NOOP("Workbench", "&CurveUps")
_MENUS = {
    _DESIGN: (
        Command("CurveUps_Target", "Change Target",
                "Give the design another surface: the selected Part or Mesh object, or a file",
                change_target, (_no_solver,)),
        Command("CurveUps_TileAnew", "Tile Anew",
                "Solve with new tiles: they do not follow the earlier ones, and get other numbers",
                _starts("tile_anew"), (_other_panel, _not_ready("tile_anew"), _no_tiles)),
        Command("CurveUps_Repair", "Repair",
                "Move tiles and pins of the layout until weak contacts hold",
                _starts("repair"), (_other_panel, _not_ready("repair")), "C, R"),
        Command("CurveUps_LittleFriction", "Let It Need Little Friction",
                "Move pins and tiles of the layout until the design needs as little friction as it can, so "
                "that the piece comes to rest near its target",
                let_it_need_little_friction, (_other_panel, _not_ready("repair"))),
        Command("CurveUps_Actuate", "Actuate",
                "Compute the shape of the built piece: released from flat, shaken, and pressed over its "
                "former",
                actuate, (_other_panel, _not_ready("actuate"))),
        Command("CurveUps_BuildSolids", "Build Solids",
                "Build the solids of tiles, support and anchors with the present parameters",
                _starts("build_solids"), (_other_panel, _not_ready("build_solids"))),
        Command("CurveUps_Report", "Report",
                "Write report.html, with verdict, pictures and figures, and open it",
                _write_report, (_not_ready("report"),)),
        Command("CurveUps_Kit", "Fabrication Kit",
                "Write the order for the print shop, templates for the latex and the steps of assembly",
                _opens(KitPanel), (_other_panel, _not_ready("kit"))),
    ),
    _SHOW: (
        Command("CurveUps_ShowFlat", "Show Flat", "Show the tiles in the flat layout",
                _shows("show_flat"), (_no_flat_tiles,)),
        Command("CurveUps_ShowActuated", "Show Actuated", "Show the tiles in the target shape",
                _shows("show_actuated"), (_no_tiles,)),
        Command("CurveUps_ShowSolids", "Show Solids",
                "Show tiles and anchors as printed solids. They are exact, but slow for thousands of tiles",
                _shows("show_solids"), (_no_layout, _no_solids)),
        Command("CurveUps_WorstContacts", "Worst Contacts",
                "List contacts and tiles, the worst first. Click one to go there",
                _opens(WorstContactsPanel), (_other_panel, _no_tiles)),
    ),
    _EXAMPLES: tuple(_examples()),
    _HELP: (
        Command("CurveUps_Guide", "Guide", "Open the guide, from a surface to print files",
                show_guide, on_design=False),
        Command("CurveUps_SolverStatus", "Solver Status",
                "Show the version and folder of the solver, or the reason why it can't be loaded and the "
                "remedy",
                show_solver_status, on_design=False),
    ),
}
COMMANDS = (*_STEPS, *(command for menu in _MENUS.values() for command in menu))


def steps() -> list[str]:
    """Names of the commands of the toolbar."""
    return [command.name for command in _STEPS]


def menus() -> list[tuple[list[str], list[str]]]:
    """Titles on the way to each menu, for FreeCAD to translate, and the names of its commands."""
    return [([_MENU], [*steps(), "Separator"]),
            *(([_MENU, title], [command.name for command in commands])
              for title, commands in _MENUS.items() if commands)]


def register() -> None:
    """Make all commands known to FreeCAD."""
    for command in COMMANDS:
        FreeCADGui.addCommand(command.name, command)
