# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make a design: of the selected surface or a file, or of a built-in target."""

from __future__ import annotations

from typing import Any, Optional, Sequence

import FreeCAD
import FreeCADGui

from ...base.native import native, problem
from ..notice import errors_shown
from ..panels.panel import show
from ..panels.preferences import remembered
from ..panels.solve import SolvePanel
from ..qt import QT_TRANSLATE_NOOP, QtWidgets, translate
from ..run import LIVE
from ..runs import assign, call, named, new_document
from .command import Command

SURFACE = "Surface of the design"
_FORMATS = "*.stl *.obj *.ply *.off *.3mf *.step *.stp *.iges *.igs *.brep *.brp"


class NewDesign(Command):
    """CurveUps_NewDesign"""

    name = "CurveUps_NewDesign"
    text = QT_TRANSLATE_NOOP("CurveUps_NewDesign", "New Design")
    tooltip = QT_TRANSLATE_NOOP("CurveUps_NewDesign",
                                "Make a design of the selected Part or Mesh object, of its selected faces, "
                                "or of a file if nothing is selected")
    shortcut = "C, N"

    def reason(self) -> str:
        return str(problem() or "")

    def run(self) -> None:
        source = selected_surface()
        if source is not None:
            make_design(source.Document, named(source), selected_faces(source))
            return
        path = ask_for_file(SURFACE)
        if path:
            make_design(FreeCAD.ActiveDocument or new_document("Unnamed", "Unnamed"), repr(path))


def make_design(document: Any, source: str, faces: str = "") -> Any:
    """source: Python text for new_design; faces: those of it that are wanted. The design, with the
    parameters that the user wants new ones to begin with; selected, and in view. Raises CurveUpsError, with
    nothing made."""
    document.openTransaction(translate("CurveUps_NewDesign", "New Design"))
    before = set(obj.Name for obj in document.Objects)
    try:
        call("document.new_design", f"FreeCAD.getDocument({document.Name!r})", source)
        design = next(obj for obj in document.Objects
                      if obj.Name not in before and "CurveUpsVersion" in obj.PropertiesList)
        for name, value in remembered(design).items():
            assign(design, name, value)
        if faces:
            assign(design, "Faces", faces)
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(design)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return design


def selected_surface() -> Optional[Any]:
    """The one Mesh or Part object with faces that is selected, if there is just one."""
    found = [obj for obj in FreeCADGui.Selection.getSelection() if _has_faces(obj)]
    return found[0] if len(found) == 1 else None


def selected_faces(obj: Any) -> str:
    """The faces of an object that are selected, as the parameter `faces` has them; empty for all of it."""
    names = [name for one in FreeCADGui.Selection.getSelectionEx() if one.Object is obj
             for name in one.SubElementNames if name.startswith("Face")]
    return ",".join(names)


def _has_faces(obj: Any) -> bool:
    if "CurveUpsType" in obj.PropertiesList:
        return False
    if hasattr(obj, "Mesh"):
        return bool(obj.Mesh.CountFacets)
    return hasattr(obj, "Shape") and not obj.Shape.isNull() and bool(obj.Shape.Faces)


def ask_for_file(title: str) -> str:
    """The path of a surface that the user chooses; empty where the dialog is closed."""
    kinds = translate("CurveUps_NewDesign", "Surfaces")
    path, _ = QtWidgets.QFileDialog.getOpenFileName(FreeCADGui.getMainWindow(), title, "",
                                                    f"{kinds} ({_FORMATS})")
    return str(path)


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
