# SPDX-License-Identifier: LGPL-2.1-or-later
"""The overlay of one Design: it follows the document, the user and the solver.

Properties of the view provider keep the user's choices, so that they outlive selection and reopening;
`view_changed` follows them.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, Iterable, Optional, Sequence

import FreeCAD
import FreeCADGui
import numpy as np

from ...base.errors import CurveUpsError, tile_name
from ...base.native import translated
from ...features.document import design_project_of, project_of
from ..notice import errors_shown, words_of
from ..overlays import overlays
from ..qt import QtCore, translate
from ..run import LIVE, Task
from ..units import short, user_unit
from . import colours, picture, showing
from .fields import MEMBRANE, Field
from .legend import Content, Legend, arrange
from .picture import Picture
from .scene import NO_FIELD, Scene, membranes_of, scene_of, target_scene_of

AUTOMATIC = "Automatic"
_GROUP = "Overlay"
_PROPERTIES = (
    ("App::PropertyString", "Field", "What tiles are coloured by; empty: the first that there is."),
    ("App::PropertyEnumeration", "ColourMap", "Colours of the field; Automatic: by whether it has a sign."),
    ("App::PropertyMap", "Ranges", "Ranges of fields that were chosen: least and largest value."),
    ("App::PropertyBool", "Pins", "Shows the pins."),
    ("App::PropertyBool", "Membranes", "Shows both membranes, once they have been computed."),
    ("App::PropertyBool", "Both", "Shows the tiles flat and actuated side by side."),
    ("App::PropertyFloatConstraint", "Morph", "From 0, flat as printed, to 1, the target shape."),
)


class Overlay:
    """Drawn by `node`, which is a display mode of the view provider."""

    def __init__(self, view: Any):
        self.object, self._document = view.Object, view.Object.Document.Name
        self._view = view
        self.scene: Optional[Scene] = None
        self.note = ""                      # why the present design can't be drawn
        self.selected: list[int] = []       # tiles
        self._hovered: list[int] = []
        self._shown: Optional[picture.State] = None  # of what the scene was made from
        self._iterating = ""  # note on an iterate that is drawn
        self._waiting = False
        self.shows_target = False           # the target before any layout, though there may be one
        self.observers: list[Callable[[], None]] = []  # called when the picture has changed
        self.closed = False
        self._picture, self.legend = Picture(), Legend()
        self.node = self._picture.node
        self.node.addChild(self.legend.node)
        self._add_properties()

    def _add_properties(self) -> None:
        view = self._view
        for kind, name, meaning in _PROPERTIES:
            if name in view.PropertiesList:
                continue
            view.addProperty(kind, name, _GROUP, meaning)
            if name == "ColourMap":
                view.ColourMap = [AUTOMATIC, *colours.NAMES]
            elif name == "Morph":
                view.Morph = (0.0, 0.0, 1.0, 0.05)
        if "SelectionStyle" in view.PropertiesList:
            view.SelectionStyle = "BoundBox"  # otherwise a selected design loses all its colours

    def close(self) -> None:
        """Let go of a design that was deleted."""
        self.scene, self._shown, self.closed = None, None, True
        self._show_legend(None)
        self._tell()

    # The document.

    def show_design(self) -> None:
        """Draw the present design. Where that fails the last picture stays, and the legend says why."""
        self._waiting, self._iterating = False, ""
        try:
            project = project_of(self.object)
            if project.latest("design") is not None and not self.shows_target:
                project = design_project_of(self.object)
            shown = picture.State(project, self.shows_target)
            if shown.same(self._shown) and not self.note:
                self._colour()  # its age may be another
                return
            with translated(self.object.Label):
                scene = (target_scene_of if self.shows_target else scene_of)(project)
        except CurveUpsError as error:
            self.note = words_of(error.what) + (f" ({words_of(error.remedy)})" if error.remedy else "")
            self.explain()
            return
        self.note, self._shown = "", shown
        self._take(scene)

    def show_target(self, shown: bool) -> None:
        """Draw the target without its layout, with the margins of its tiles where it was checked; or with
        False the design again."""
        self.shows_target = shown
        self.refresh()

    def set_iterate(self, T: np.ndarray, q: np.ndarray, scene: Optional[Scene] = None,
                    note: str = "") -> None:
        """Draw an iterate of a solver (M x 3 x 2 and M x 2 x 3, mm) until `show_design`. An iterate of other
        tiles than those of the scene, by default the present one, is left out. note: for the legend."""
        scene = scene or self.scene
        if scene is None or len(T) != len(scene.F):
            return
        with translated(self.object.Label):
            scene = scene.moved(np.asarray(T, float), np.asarray(q, float))
        self._shown = None
        self._iterating = note or translate("CurveUps_Overlay", "present state of the solver")
        self._take(scene)

    def show_scene(self, scene: Optional[Scene]) -> None:
        """Draw any scene, until `show_design`."""
        self._shown = None
        self._take(scene)

    def data_changed(self, name: str) -> None:
        """Follow a property of the Design."""
        if name == "Placement":
            self._picture.place(self.placement())
        elif name == "Label":
            self._arrange_legends()
        elif name not in ("Label2", "Visibility", "ExpressionEngine", "Proxy"):
            # A run ends with results, or with a state that is no longer "running".
            if name == "Results" or name == "Status" and self.object.Status != "running":
                self._iterating = ""
            self._tell()
            self.refresh()

    def refresh(self) -> None:
        """Draw the design in the next turn of the event loop, once for many changes."""
        if not self._waiting:
            self._waiting = True
            QtCore.QTimer.singleShot(0, self._refresh)

    def _refresh(self) -> None:
        self._waiting = False
        try:
            if not self._iterating and (self._view.Visibility or self.observers):
                self.show_design()
        except ReferenceError:  # deleted meanwhile
            pass
        except Exception as error:  # of a timer: FreeCAD would print it as a traceback
            self.note = str(error)
            self.explain()

    def view_changed(self, name: str) -> None:
        """Follow a property of the view provider."""
        if name == "Visibility":
            self._arrange_legends()
            if self._view.Visibility:
                self.refresh()
        if self.scene is None:
            return
        if name == "Membranes" and self._view.Membranes and not self.scene.membranes:
            self._compute_membranes()
        if name in ("Morph", "Pins", "Membranes", "Both"):
            self._draw()
        if name in ("Field", "ColourMap", "Ranges", "Membranes"):
            self._colour()

    def _compute_membranes(self) -> None:
        """Start a run that computes the membranes, and draw them until the design changes. They are stored
        nowhere: they are most of a verification, and seldom looked at."""
        if self.scene is None or self.scene.flat is None or self._iterating:
            return

        def draw(_: Any, membranes: Any) -> None:
            if self.scene is not None and membranes and not self._iterating:
                self._take(self.scene.with_membranes(membranes))

        title = translate("CurveUps_Overlay", "Membranes")
        with errors_shown(title):
            project = design_project_of(self.object)
            design = project.latest("design").design.with_parameters(project.parameters)
            LIVE.start(self.object, Task(title, lambda job: membranes_of(design, job), draw))

    # The user.

    def fields(self) -> list[str]:
        """Names of the present fields that can colour tiles."""
        return list(self.scene.fields) if self.scene else []

    def field(self) -> Optional[Field]:
        """Field that colours the tiles."""
        if self.scene is None or self._view.Field == NO_FIELD:
            return None
        return self.scene.fields.get(self._view.Field) or next(iter(self.scene.fields.values()), None)

    def set_field(self, name: str) -> None:
        """Colour by a field; "None": tiles are plain. A field that does not exist yet shows once it does."""
        self._view.Field = name

    def age(self, field: Optional[Field]) -> str:
        """Reason why a field, or without one the tiles, is not of the present design; empty where it is."""
        return "" if self._iterating else picture.age(self.object, field, self.scene)

    def range(self) -> tuple[float, float]:
        """Range of the present field, in its unit."""
        field = self.field()
        if field is None:
            return 0.0, 1.0
        try:
            low, high = map(float, self._view.Ranges[field.name].split())
            if low < high:
                return low, high
        except (KeyError, ValueError):
            pass
        return field.automatic_range()

    def set_range(self, ends: Optional[tuple[float, float]]) -> None:
        """Set the range of the present field; None for the automatic one."""
        field = self.field()
        if field is None:
            return
        ranges = dict(self._view.Ranges)
        ranges.pop(field.name, None)
        if ends is not None:
            ranges[field.name] = " ".join(repr(float(end)) for end in ends)
        self._view.Ranges = ranges

    def morph(self) -> float:
        """State of the drawn tiles, from 0, flat, to 1, actuated."""
        return self._picture.t

    def set_morph(self, t: float) -> None:
        """Fold to a state, 0 flat to 1 actuated. Cameras follow, so that the tiles stay in sight."""
        before = self._picture.t
        self._view.Morph = min(1.0, max(0.0, float(t)))
        if self.scene is not None and self.scene.motion is not None:
            step = self.scene.motion.middle(self._picture.t) - self.scene.motion.middle(before)
            showing.shift(self.object.Document.Name, self.placement().Rotation.multVec(FreeCAD.Vector(*step)))

    def select_tiles(self, tiles: Iterable[int]) -> None:
        """Select tiles by number (0 is T00001) in FreeCAD, and no others of the design."""
        document = self.object.Document.Name
        FreeCADGui.Selection.clearSelection(document)
        for tile in tiles:
            FreeCADGui.Selection.addSelection(document, self.object.Name, tile_name(tile))

    def look_at(self, tiles: Sequence[int]) -> None:
        """Turn the camera to tiles, head on."""
        showing.look_at(self.object.Document.Name, self._picture.corners[list(tiles), :3], self.placement())

    # Selection.

    def tile_of(self, picked: Any) -> int:
        """Tile of a SoPickedPoint; -1 where it is on none."""
        return self._picture.tile_of(picked)

    def mark_selected(self, tiles: Sequence[int], hovered: Sequence[int]) -> None:
        """Colour tiles that are selected or below the mouse, in every figure."""
        count, before = len(self.scene.F) if self.scene else 0, self.selected
        self.selected = [tile for tile in tiles if tile < count]
        self._hovered = [tile for tile in hovered if tile < count]
        self._colour_figures()
        if self.selected != before:
            self._tell()

    def values_of(self, tile: int) -> list[tuple[str, str]]:
        """Names of fields with a tile's values, in the user's units."""
        if self.scene is None:
            return []
        values = []
        for field in self.scene.fields.values():
            if field.on != MEMBRANE:
                factor, unit = user_unit(field.unit, field.size)
                numbers = ", ".join(short(x * factor) for x in self.scene.tile_values(field, tile))
                values.append((translate("CurveUps_Fields", field.name), f"{numbers} {unit}".rstrip()))
        return values

    def figures(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Corners of the drawn figures (M x 6 x 3, mm) and their offsets from the design, for picking."""
        return [] if self.scene is None else self._picture.figures()

    def placement(self) -> Any:
        """Placement of the Design."""
        return getattr(self.object, "Placement", None) or FreeCAD.Placement()

    # Drawing.

    def _take(self, scene: Optional[Scene]) -> None:
        other = self.scene is None or scene is None or len(self.scene.F) != len(scene.F)
        self.scene = scene
        if other:
            self.selected, self._hovered = [], []
        if scene is None:
            self._show_legend(None)
            return
        self._colour_figures()  # first: faces would point beyond the colours
        self._draw()
        self.explain()

    def _draw(self) -> None:
        scene, view = self.scene, self._view
        assert scene is not None
        self._picture.draw(scene, view.Morph, view.Pins, view.Membranes, view.Both)
        self._picture.place(self.placement())
        self._mark()
        self._tell()

    def _colour(self) -> None:
        self._colour_figures()
        self._mark()
        self.explain()

    def _colouring(self) -> picture.Colouring:
        field, name = self.field(), self._view.ColourMap
        if name == AUTOMATIC:
            name = colours.SIGNED if field is not None and field.signed else colours.NAMES[0]
        return picture.Colouring(field, name, *self.range(), bool(self.age(field)))

    def _colour_figures(self) -> None:
        if self.scene is not None:
            self._picture.colour(self.scene, self._colouring(), self.selected, self._hovered)

    def _tell(self) -> None:
        for observer in list(self.observers):
            observer()

    def _problems(self) -> list[Field]:
        fields = self.scene.fields.values() if self.scene else ()
        return [field for field in fields if field.mark and len(field.problems) and not self.age(field)]

    def _mark(self) -> None:
        if self.scene is not None:
            self._picture.mark(self.scene, self._problems())

    def explain(self) -> None:
        """Write the legend, in the user's units."""
        self._tell()
        colouring, notes = self._colouring(), []
        field, age = colouring.field, self.age(colouring.field)
        if self._iterating:
            notes.append(self._iterating)
        elif self.scene is not None and (field is not None or age):
            notes.append(picture.origin_of(field, self.scene))
        if age:
            notes.append(age)
        if self.note:
            notes.append(translate("CurveUps_Overlay", "not the present state: {why}", why=self.note))
        marks = tuple((marked.mark, f"{translate('CurveUps_Fields', marked.problem)}: {len(marked.problems)}")
                      for marked in self._problems())
        content = Content(self.object.Label, has_bar=False, notes=tuple(notes), marks=marks)
        if field is not None:
            content = replace(content, title=translate("CurveUps_Fields", field.name), unit=field.unit,
                              colour_map=colouring.map_name, low=colouring.low, high=colouring.high,
                              has_bar=True, faded=colouring.faded)
        self._show_legend(content if content.has_bar or notes or marks else None)

    def _show_legend(self, content: Optional[Content]) -> None:
        self.legend.show(content)
        self._arrange_legends()

    def _arrange_legends(self) -> None:
        """Arrange the legends of all designs of the document, which share its views."""
        arrange({overlay.object.Label: overlay.legend for overlay in overlays(self._document)
                 if overlay.legend.content is not None and overlay.visible()})

    def visible(self) -> bool:
        """True where it is shown in its views."""
        try:
            return not self.closed and bool(self._view.Visibility)
        except ReferenceError:  # the design is going
            return False
