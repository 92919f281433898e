# SPDX-License-Identifier: LGPL-2.1-or-later
"""Built-in targets, each by one click: a new document, a design in it, solved while one watches."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from ...base.errors import CurveUpsError
from ...base.native import native, problem
from ..notice import errors_shown
from ..panels.solve import open_panel
from ..qt import QT_TRANSLATE_NOOP, translate
from ..run import LIVE
from .command import Command
from .new_design import make_design


class Examples(Command):
    """CurveUps_Examples: a menu of all."""

    name = "CurveUps_Examples"
    text = QT_TRANSLATE_NOOP("CurveUps_Examples", "Examples")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Examples",
                                "Open a new document with a built-in target, and watch its design being "
                                "solved")

    def __init__(self) -> None:
        self._targets = [] if problem() else list(native.builtin_targets())

    def reason(self) -> str:
        return str(problem() or "")

    def menu(self) -> list[Command]:
        return [_Example(name, meaning) for name, meaning in self._targets]

    def GetCommands(self) -> tuple[str, ...]:
        return tuple(command.name for command in self.menu())

    def GetDefaultCommand(self) -> int:
        return 0

    def run(self) -> None:
        raise CurveUpsError(translate(self.name, "there are no examples without the solver"), "",
                            translate(self.name, "see Solver Status"))


class _Example(Command):
    """One built-in target."""

    def __init__(self, target: str, meaning: str):
        self._target = target
        self.name = f"CurveUps_Example_{target}"
        self.text = target.replace("-", " ").title().replace(" ", "-")
        self.tooltip = f"{self.text}: {meaning}"

    def GetResources(self) -> dict[str, Any]:
        return {**super().GetResources(), "Pixmap": "CurveUps_Examples"}

    def reason(self) -> str:
        if LIVE.busy:
            return translate("CurveUps", "CurveUps is at work: stop or cancel that first")
        return str(problem() or "")

    def run(self) -> None:
        document = FreeCAD.newDocument(self._target.replace("-", "_"))
        document.Label = self.text
        design = make_design(document, repr(self._target))
        FreeCADGui.getDocument(document.Name).ActiveView.viewIsometric()
        with errors_shown(self.text):
            open_panel(design).run("solve")


COMMAND = Examples()
