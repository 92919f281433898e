# SPDX-License-Identifier: LGPL-2.1-or-later
"""Display of a design: the overlay flat or actuated, or its solids. For commands, macros, scripts."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from ...base.errors import CurveUpsError
from ...base.native import native
from ..overlays import overlay_of
from ..qt import QtCore, translate

_BODIES = ("Tiles", "Support", "Anchors")
_FOLDING, _FRAME = 500, 30          # ms: from flat to actuated, and between two pictures
_MOST_FOLDED = 4000                 # tiles; more are put there at once


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
        _Fold(overlay, t)


class _Fold(QtCore.QObject):
    """Animation that folds an overlay's tiles. Another one ends it."""

    def __init__(self, overlay: Any, t: float):
        super().__init__(FreeCADGui.getMainWindow())
        self._overlay, self._start, self._end = overlay, overlay.morph(), t
        self._clock = QtCore.QElapsedTimer()
        self._clock.start()
        overlay.folding = self
        self._timer = self.startTimer(_FRAME)

    def timerEvent(self, event: Any) -> None:
        share = min(1.0, self._clock.elapsed() / _FOLDING)
        if self._overlay.folding is not self or self._overlay.scene is None:
            share = 1.0
        else:
            smooth = share * share * (3 - 2 * share)
            try:
                self._overlay.set_morph(self._start + smooth * (self._end - self._start))
            except ReferenceError:  # the design is gone
                share = 1.0
        if share >= 1.0:
            self.killTimer(self._timer)
            self.deleteLater()
