# SPDX-License-Identifier: LGPL-2.1-or-later
"""3D views of a document, and their cameras."""

from __future__ import annotations

from typing import Any, Optional

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

_TILES_ACROSS = 12  # of a view that looks at one tile


def views_of(document: str) -> list:
    """All 3D views of a document."""
    gui = FreeCADGui.getDocument(document)
    return list(gui.mdiViewsOfType("Gui::View3DInventor")) if gui else []


def active_view(document: str) -> Optional[Any]:
    """The 3D view that is in use; None if that is a table, say."""
    gui = FreeCADGui.getDocument(document)
    view = gui.ActiveView if gui else None
    return view if hasattr(view, "getCameraNode") else None


def look_at(document: str, front: np.ndarray, placement: Any) -> None:
    """Turn the view that is in use to triangles (K x 3 x 3, mm, before `placement`), head on."""
    view = active_view(document) or next(iter(views_of(document)), None)
    if view is None or not len(front):
        return
    normal = np.cross(front[:, 1] - front[:, 0], front[:, 2] - front[:, 0]).sum(0)
    middle = placement.multVec(FreeCAD.Vector(*front.mean((0, 1))))
    towards = placement.Rotation.multVec(FreeCAD.Vector(*normal)).normalize()
    size = _TILES_ACROSS * float(np.linalg.norm(front[0, 1] - front[0, 0]))
    camera = view.getCameraNode()
    camera.orientation.setValue(*FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), towards).Q)
    if camera.getTypeId() == coin.SoOrthographicCamera.getClassTypeId():
        camera = coin.cast(camera, "SoOrthographicCamera")
        camera.height = size
    camera.focalDistance = 2 * size
    camera.position = tuple(middle + towards * 2 * size)


def shift(document: str, step: Any) -> None:
    """Move the cameras of all views of a document by a vector, mm."""
    if step.Length > 0:
        for view in views_of(document):
            camera = view.getCameraNode()
            camera.position = tuple(FreeCAD.Vector(*camera.position.getValue().getValue()) + step)
