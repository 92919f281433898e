# SPDX-License-Identifier: LGPL-2.1-or-later
"""Display of a design, for commands, macros and scripts: the overlay flat or actuated, or its solids; 3D
views and their cameras."""

from __future__ import annotations

import weakref
from contextlib import suppress
from typing import Any, Optional

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin

from ...base.errors import CurveUpsError
from ...base.native import native
from ..overlays import overlay_of
from ..qt import QtCore, translate

_BODIES = ("Tiles", "Support", "Anchors")
_FOLDING = 500       # ms from flat to actuated
_MOST_FOLDED = 4000  # tiles; more are put there at once
_TILES_ACROSS = 12   # of a view that looks at one tile


def show_flat(design: Any) -> None:
    """Show the tiles as they are printed."""
    _show_overlay(design, 0.0)


def show_actuated(design: Any) -> None:
    """Show the tiles in the target shape."""
    _show_overlay(design, 1.0)


def show_solids(design: Any) -> None:
    """Show the bodies of the print instead of the overlay. Raises CurveUpsError where there are none."""
    tiles = design.Tiles
    if tiles is None or not tiles.Shape.Solids:
        raise CurveUpsError(translate("CurveUps_ShowSolids", "there are no solids yet"), design.Label,
                            translate("CurveUps_ShowSolids", "run Build Solids"))
    for body in (design.Tiles, design.Anchors):  # the support would hide the tiles' back faces
        if body is not None:
            view = body.ViewObject
            if view.DisplayMode == "Flat Lines":  # never shown yet; edges of small tiles are black all over
                view.DisplayMode = "Shaded"
                _colour(view, tuple(part / 255 for part in native.COLOURS[body.Kind]))
            view.Visibility = True
    design.ViewObject.Visibility = False


def _colour(view: Any, rgb: tuple) -> None:
    if hasattr(view, "ShapeColor"):
        view.ShapeColor = rgb
    else:  # since FreeCAD 1.0
        material = view.ShapeAppearance[0]
        material.DiffuseColor = rgb
        view.ShapeAppearance = (material,)


def uncover(design: Any) -> bool:
    """Show the overlay, with one figure, and nothing that lies upon it. True where that changed anything."""
    parts = [getattr(design, slot, None) for slot in (*_BODIES, "Target")]
    wanted = [(part.ViewObject, "Visibility", False) for part in parts if part is not None]
    wanted += [(design.ViewObject, "Visibility", True), (design.ViewObject, "Both", False)]
    others = [(view, name, value) for view, name, value in wanted
              if view is not None and getattr(view, name) != value]
    for view, name, value in others:
        setattr(view, name, value)
    return bool(others)


def _show_overlay(design: Any, t: float) -> None:
    uncover(design)
    overlay = overlay_of(design)
    overlay.refresh()  # a path may be shown
    if overlay.scene is None or overlay.scene.flat is None or len(overlay.scene.F) > _MOST_FOLDED:
        overlay.set_morph(t)
    else:
        _fold(overlay, t)


def _fold(overlay: Any, t: float) -> None:
    """Fold an overlay's tiles from where they are to t."""
    picture = weakref.proxy(overlay)  # the animation is Qt's, and must not keep what is closed
    animation = QtCore.QVariantAnimation(FreeCADGui.getMainWindow())
    animation.setDuration(_FOLDING)
    animation.setEasingCurve(QtCore.QEasingCurve.InOutQuad)
    animation.setStartValue(overlay.morph())
    animation.setEndValue(t)

    def show(value: float) -> None:
        with suppress(ReferenceError):  # the design is gone
            if picture.scene is not None:
                picture.set_morph(value)

    animation.valueChanged.connect(show)
    animation.start(QtCore.QAbstractAnimation.DeleteWhenStopped)


def views_of(document: str) -> list:
    """All 3D views of a document; none of one that is being closed."""
    try:
        gui = FreeCADGui.getDocument(document)
    except NameError:
        return []
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
