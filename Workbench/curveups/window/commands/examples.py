# SPDX-License-Identifier: LGPL-2.1-or-later
"""Built-in targets, each by one click: a new document, a design in it, solved while one watches."""

from __future__ import annotations

from typing import Any, Sequence

import FreeCADGui

from ...base.native import native, problem
from ..macro import new_document
from ..notice import errors_shown
from ..panels.panel import show
from ..panels.solve import SolvePanel
from ..qt import QT_TRANSLATE_NOOP
from ..run import LIVE
from .command import Command
from .new_design import make_design


class Examples(Command):
    """CurveUps_Examples: a menu of all."""

    name = "CurveUps_Examples"
    text = QT_TRANSLATE_NOOP("CurveUps_Examples", "Examples")
    QT_TRANSLATE_NOOP("PythonGroupCommand", "Examples")  # where FreeCAD looks when the language changes
    tooltip = QT_TRANSLATE_NOOP("CurveUps_Examples",
                                "Open a new document with a built-in target, and watch its design being "
                                "solved")

    def __init__(self) -> None:
        targets = [] if problem() else native.builtin_targets()
        self._examples = [_Example(name, meaning) for name, meaning in targets]

    def reason(self) -> str:
        return _reason()

    def menu(self) -> Sequence[Command]:
        return self._examples

    def GetCommands(self) -> tuple[str, ...]:
        return tuple(command.name for command in self._examples)

    def GetDefaultCommand(self) -> int:
        return 0

    def Activated(self, index: int = 0) -> None:
        self._examples[index].Activated()  # FreeCAD tells the group, not what was chosen of it

    def run(self) -> None:
        self._examples[0].run()


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
        return _reason()

    def run(self) -> None:
        document = new_document(self._target.replace("-", "_"), self.text)
        design = make_design(document, repr(self._target))
        FreeCADGui.getDocument(document.Name).ActiveView.viewIsometric()
        with errors_shown(self.text):
            show(SolvePanel, design).run("solve")


def _reason() -> str:
    return LIVE.obstacle() or str(problem() or "")


COMMAND = Examples()
