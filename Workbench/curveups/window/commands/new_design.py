# SPDX-License-Identifier: LGPL-2.1-or-later
"""New Design: makes a design of the selected surface or of a file."""

from __future__ import annotations

from typing import Any, Optional

import FreeCAD
import FreeCADGui

from ...base.native import problem
from ..macro import assign, call, named, new_document
from ..panels.preferences import remembered
from ..qt import QT_TRANSLATE_NOOP, QtWidgets, translate
from .command import Command

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
        path = ask_for_file(translate(self.name, "Surface of the design"))
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


COMMAND = NewDesign()
