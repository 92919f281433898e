# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs of the selected surface, of a file, or of a built-in target."""

from __future__ import annotations

from typing import Any, Optional

import FreeCAD
import FreeCADGui

from ..base.errors import CurveUpsError
from ..features.actions import transaction
from .notice import errors_shown
from .panel import obstacle, show
from .preferences import remembered
from .qt import QtWidgets, translate
from .run import assign, call, named, new_document
from .solve import SolvePanel

SURFACE = "Surface of the design"
_FORMATS = "*.stl *.obj *.ply *.off *.3mf *.step *.stp *.iges *.igs *.brep *.brp"


def new_design(_: Any) -> None:
    """Make a design of the selected surface, or of a file that the user chooses, and show its panel: Check
    and Solve are the next steps."""
    source = selected_surface()
    if source is not None:
        design = make_design(source.Document, named(source), _selected_faces(source))
    else:
        path = ask_for_file(SURFACE)
        if not path:
            return
        design = make_design(FreeCAD.ActiveDocument or new_document("Unnamed", "Unnamed"), repr(path))
    if not obstacle():
        show(SolvePanel, design)


def open_example(target: str, title: str, _: Any) -> None:
    """Solve a built-in target in a new document."""
    document = new_document(target.replace("-", "_"), title)
    design = make_design(document, repr(target))
    FreeCADGui.getDocument(document.Name).ActiveView.viewIsometric()
    with errors_shown(title):
        show(SolvePanel, design).run("solve")


def change_target(design: Any) -> None:
    """Give a design the selected surface, or a file that the user chooses."""
    source = selected_surface()
    text = named(source) if source is not None else ""
    if not text:
        path = ask_for_file(SURFACE)
        text = repr(path) if path else ""
    if text:
        with transaction(design.Document, translate("CurveUps_Target", "Change Target")):
            call("document.set_source", named(design), text)
        design.Document.recompute()


def make_design(document: Any, source: str, faces: str = "") -> Any:
    """Make a design with the parameters that the user wants new ones to begin with, select and show it.
    source: Python text for new_design; faces: names of its faces to use, all if empty. Raises CurveUpsError,
    with nothing made."""
    before = {obj.Name for obj in document.Objects}
    with transaction(document, translate("CurveUps_NewDesign", "New Design")):
        call("document.new_design", f"FreeCAD.getDocument({document.Name!r})", source)
        design = next(obj for obj in document.Objects
                      if obj.Name not in before and "CurveUpsVersion" in obj.PropertiesList)
        for name, value in remembered(design).items():
            assign(design, name, value)
        if faces:
            assign(design, "Faces", faces)
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(design)
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return design


def selected_surface() -> Optional[Any]:
    """The selected Mesh or Part object with faces, if any. Raises CurveUpsError where several are."""
    surfaces = list(filter(_has_faces, FreeCADGui.Selection.getSelection()))
    if len(surfaces) > 1:
        raise CurveUpsError(
            translate("CurveUps_NewDesign", "{count} surfaces are selected", count=len(surfaces)),
            ", ".join(surface.Label for surface in surfaces), translate("CurveUps_NewDesign", "select one"))
    return surfaces[0] if surfaces else None


def _selected_faces(obj: Any) -> str:
    """Selected faces of an object as the parameter `faces` names them; empty for all."""
    return ",".join(name for selected in FreeCADGui.Selection.getSelectionEx() if selected.Object is obj
                    for name in selected.SubElementNames if name.startswith("Face"))


def _has_faces(obj: Any) -> bool:
    if "CurveUpsType" in obj.PropertiesList:
        return False
    if hasattr(obj, "Mesh"):
        return bool(obj.Mesh.CountFacets)
    return hasattr(obj, "Shape") and not obj.Shape.isNull() and bool(obj.Shape.Faces)


def ask_for_file(title: str) -> str:
    """Path of a surface that the user chooses; empty if there is none."""
    kinds = translate("CurveUps_NewDesign", "Surfaces")
    path, _ = QtWidgets.QFileDialog.getOpenFileName(FreeCADGui.getMainWindow(), title, "",
                                                    f"{kinds} ({_FORMATS})")
    return str(path)
