# SPDX-License-Identifier: LGPL-2.1-or-later
"""The overlay of one Design: what its view shows, and how that follows document, user and solver.

What the user chose is kept in properties of the view provider, so that it outlives selection and
reopening; `view_changed` follows them, whoever sets them.
"""

from __future__ import annotations

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
from . import cameras, colours, picture
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
        self.note = ""                      # why it can't be drawn as the design is now
        self.selected: list[int] = []       # tiles
        self._hovered: list[int] = []
        self._shown: Optional[picture.State] = None  # what the scene was made from
        self._iterating = False
        self._aged: list[str] = []          # what the legend says of that
        self._waiting = False
        self.shows_target = False           # the target before any layout, though there may be one
        self.observers: list[Callable[[], None]] = []  # called when what is shown has changed
        self.folding: Any = None                       # what moves the tiles just now
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
        """The design is gone."""
        self.scene, self._shown, self.closed = None, None, True
        self._show_legend(None)
        self._tell()

    # What follows the document.

    def show_design(self) -> None:
        """Draws the design as it is now. Where it can't be drawn the last picture stays, and the legend
        says why."""
        self._waiting = self._iterating = False
        try:
            project = project_of(self.object)
            if project.latest("design") is not None and not self.shows_target:
                project = design_project_of(self.object)
            shown = picture.State(project, self.shows_target)
            if shown.same(self._shown) and not self.note:
                if self._ages() != self._aged:
                    self._colour()
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
        """Draws the target as it is before any layout, with the margins of its tiles where it was checked,
        until it is told not to."""
        self.shows_target = shown
        self.refresh()

    def set_iterate(self, T: np.ndarray, q: np.ndarray, scene: Optional[Scene] = None) -> None:
        """Draws a layout that a solver has at hand (M x 3 x 2 and M x 2 x 3, mm) until `show_design`. One of
        other tiles than those of the scene, by default the one that is shown, is left out."""
        scene = scene or self.scene
        if scene is None or len(T) != len(scene.F):
            return
        with translated(self.object.Label):
            scene = scene.moved(np.asarray(T, float), np.asarray(q, float))
        self._shown, self._iterating = None, True
        self._take(scene)

    def show_scene(self, scene: Optional[Scene]) -> None:
        """Draws any scene, until `show_design`."""
        self._shown = None
        self._take(scene)

    def data_changed(self, name: str) -> None:
        """A property of the Design has changed."""
        if name == "Placement":
            self._picture.place(self.placement())
        elif name == "Label":
            self._arrange_legends()
        elif name not in ("Label2", "Visibility", "ExpressionEngine", "Proxy"):
            # A run ends with results, or with a state that is no longer "running".
            if name == "Results" or name == "Status" and self.object.Status != "running":
                self._iterating = False
            self._tell()
            self.refresh()

    def refresh(self) -> None:
        """Draws the design once those who are at work on the document are through."""
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
        """A property of the view provider has changed."""
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
        """Starts their run, and draws them until the design changes. They are stored nowhere: most of a
        verification, and seldom looked at."""
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

    # What the user chooses.

    def fields(self) -> list[str]:
        """Names of what tiles can be coloured by as things stand."""
        return list(self.scene.fields) if self.scene else []

    def field(self) -> Optional[Field]:
        """What tiles are coloured by."""
        if self.scene is None or self._view.Field == NO_FIELD:
            return None
        return self.scene.fields.get(self._view.Field) or next(iter(self.scene.fields.values()), None)

    def set_field(self, name: str) -> None:
        """Colours by a field; "None": tiles are plain. A field that there is not yet shows once there is."""
        self._view.Field = name

    def age(self, one: Optional[Field]) -> str:
        """Says that what a field shows, or without one the tiles, is not of the design as it stands; empty
        where it is."""
        return "" if self._iterating else picture.age(self.object, one, self.scene)

    def _ages(self) -> list[str]:
        """Of all that may be shown."""
        return [self.age(None), *map(self.age, self.scene.fields.values() if self.scene else ())]

    def range(self) -> tuple[float, float]:
        """Of the field that is shown, in its unit."""
        one = self.field()
        if one is None:
            return 0.0, 1.0
        try:
            low, high = (float(text) for text in self._view.Ranges[one.name].split())
            if low < high:
                return low, high
        except (KeyError, ValueError):
            pass
        return one.automatic_range()

    def set_range(self, ends: Optional[tuple[float, float]]) -> None:
        """Of the field that is shown; None for the automatic one."""
        one = self.field()
        if one is None:
            return
        ranges = dict(self._view.Ranges)
        ranges.pop(one.name, None)
        if ends is not None:
            ranges[one.name] = " ".join(repr(float(end)) for end in ends)
        self._view.Ranges = ranges

    def morph(self) -> float:
        """Where the tiles are drawn, from 0, flat, to 1, actuated."""
        return self._picture.t

    def set_morph(self, t: float) -> None:
        """Folds: 0 is flat, 1 actuated. Cameras go along, so that the tiles stay in sight."""
        before = self._picture.t
        self._view.Morph = min(1.0, max(0.0, float(t)))
        if self.scene is not None and self.scene.motion is not None:
            step = self.scene.motion.middle(self._picture.t) - self.scene.motion.middle(before)
            cameras.shift(self.object.Document.Name, self.placement().Rotation.multVec(FreeCAD.Vector(*step)))

    def select_tiles(self, tiles: Iterable[int]) -> None:
        """Selects tiles by number (0 is T00001) in FreeCAD, and no others of the design."""
        document = self.object.Document.Name
        FreeCADGui.Selection.clearSelection(document)
        for tile in tiles:
            FreeCADGui.Selection.addSelection(document, self.object.Name, tile_name(tile))

    def look_at(self, tiles: Sequence[int]) -> None:
        """Turns the camera to tiles, head on."""
        cameras.look_at(self.object.Document.Name, self._picture.corners[list(tiles), :3], self.placement())

    # What FreeCAD's selection says.

    def tile_of(self, picked: Any) -> int:
        """The tile that a SoPickedPoint is on; -1 where it is none."""
        return self._picture.tile_of(picked)

    def mark_selected(self, tiles: Sequence[int], hovered: Sequence[int]) -> None:
        """Lights tiles up, in every figure."""
        count = len(self.scene.F) if self.scene else 0
        changed = [tile for tile in tiles if tile < count] != self.selected
        self.selected = [tile for tile in tiles if tile < count]
        self._hovered = [tile for tile in hovered if tile < count]
        if changed:
            self._colour_figures()
            self._tell()
        self._outline()

    def values_of(self, tile: int) -> list[tuple[str, str]]:
        """Names of fields with a tile's values as the user reads them."""
        if self.scene is None:
            return []
        found = []
        for one in self.scene.fields.values():
            if one.on != MEMBRANE:
                factor, unit = user_unit(one.unit, one.size)
                values = ", ".join(short(x * factor) for x in self.scene.tile_values(one, tile))
                found.append((translate("CurveUps_Fields", one.name), f"{values} {unit}".rstrip()))
        return found

    def figures(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Corners of what is drawn (M x 6 x 3, mm) and its place beside the design's, for picking."""
        return [] if self.scene is None else self._picture.figures()

    def placement(self) -> Any:
        """Where the Design stands."""
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
        self._outline()
        self._tell()

    def _colour(self) -> None:
        self._colour_figures()
        self._mark()
        self.explain()

    def _colour_map(self, one: Optional[Field]) -> str:
        name = self._view.ColourMap
        if name != AUTOMATIC:
            return name
        return colours.SIGNED if one is not None and one.signed else colours.NAMES[0]

    def _colour_figures(self) -> None:
        scene, one = self.scene, self.field()
        if scene is not None:
            name, ends, faded = self._colour_map(one), self.range(), bool(self.age(one))
            self._picture.colour_tiles(scene, one, name, ends, self.selected, faded)
            self._picture.colour_sheets(scene, one, name, ends, faded)

    def _tell(self) -> None:
        for observer in list(self.observers):
            observer()

    def _problems(self) -> list[Field]:
        fields = self.scene.fields.values() if self.scene else ()
        return [one for one in fields if one.mark and len(one.problems) and not self.age(one)]

    def _mark(self) -> None:
        if self.scene is not None:
            self._picture.mark(self.scene, self._problems())

    def _outline(self) -> None:
        self._picture.outline(self.selected, self._hovered)

    def explain(self) -> None:
        """Writes the legend, in the user's units."""
        self._tell()
        self._aged = self._ages()
        one, notes = self.field(), []
        if self._iterating:
            notes.append(translate("CurveUps_Overlay", "present state of the solver"))
        elif self.scene is not None and (one is not None or self.age(one)):
            notes.append(picture.origin_of(one, self.scene))
        if self.age(one):
            notes.append(self.age(one))
        if self.note:
            notes.append(translate("CurveUps_Overlay", "not the present state: {why}", why=self.note))
        marks = tuple((field.mark, f"{translate('CurveUps_Fields', field.problem)}: {len(field.problems)}")
                      for field in self._problems())
        if one is None:
            title = self.object.Label
            self._show_legend(Content(title, has_bar=False, notes=tuple(notes), marks=marks)
                              if notes or marks else None)
            return
        low, high = self.range()
        self._show_legend(Content(translate("CurveUps_Fields", one.name), one.unit, self._colour_map(one),
                                  low, high, True, bool(self.age(one)), tuple(notes), marks))

    def _show_legend(self, content: Optional[Content]) -> None:
        self.legend.show(content)
        self._arrange_legends()

    def _arrange_legends(self) -> None:
        """All designs of a document have theirs in the same views."""
        arrange({one.object.Label: one.legend for one in overlays(self._document)
                 if one.legend.content is not None and one.visible()})

    def visible(self) -> bool:
        """Whether it is shown in its views."""
        try:
            return not self.closed and bool(self._view.Visibility)
        except ReferenceError:  # the design is going
            return False
