# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays that are drawn of a project, at any stage of it. Without Coin."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Optional

import numpy as np

from ...base.native import native
from ...stages.actuation import moved
from .fields import (MEMBRANE, SIDE, TILE, Field, check_fields, design_fields, deviation_field, force_fields,
                     friction_fields, path_fields, target_fields)


SLOTS = 6  # of colour on a tile: front at edge 0, 1, 2, which the walls share, and back at edge 0, 1, 2


@dataclass(frozen=True)
class Topology:
    """Polygons of one prism (counter-clockwise from outside), and numbers of their normals and colours.
    `points`, `colours`: counts for a prism; with 0 colours all prisms share one. Its corners 0 to 2 are in
    front, 3 to 5 behind."""

    points: int
    colours: int
    polygons: tuple[tuple[int, ...], ...]
    normal: tuple[int, ...]
    colour: tuple[int, ...]

    def coordinate_index(self, count: int) -> np.ndarray:
        """Polygons of `count` prisms as Coin reads them."""
        return _index(self.polygons, self.points, count)

    def normal_index(self, count: int) -> np.ndarray:
        return (np.array(self.normal) + 5 * np.arange(count)[:, None]).astype(np.int32).ravel()

    def colour_index(self, count: int) -> np.ndarray:
        return (np.array(self.colour) + self.colours * np.arange(count)[:, None]).astype(np.int32).ravel()


_WALLS = ((1, 0, 3, 4), (2, 1, 4, 5), (0, 2, 5, 3))
# Front and back of a tile are three triangles about their middle, one at each edge: the value of a contact
# colours the third of both tiles beside it.
THIRDS = Topology(8, SLOTS, ((0, 1, 6), (1, 2, 6), (2, 0, 6), (4, 3, 7), (5, 4, 7), (3, 5, 7), *_WALLS),
                  (0, 0, 0, 1, 1, 1, 2, 3, 4), (0, 1, 2, 3, 4, 5, 0, 1, 2))
WHOLE = Topology(6, 0, ((0, 1, 2), (5, 4, 3), *_WALLS), (0, 1, 2, 3, 4), (0,) * 5)

_RIMS = ((0, 1, 2, 0, 3, 4, 5, 3), (1, 4), (2, 5))  # polylines along all edges of a prism


def line_index(count: int) -> np.ndarray:
    """Edges of `count` prisms of six points as Coin reads them."""
    return _index(_RIMS, 6, count)


def _index(parts: tuple[tuple[int, ...], ...], points: int, count: int) -> np.ndarray:
    """Corners of `parts` in each of `count` prisms; -1 ends a part."""
    flat = np.array([corner for part in parts for corner in (*part, -1)])
    return np.where(flat < 0, -1, flat + points * np.arange(count)[:, None]).astype(np.int32).ravel()


def normals(corners: np.ndarray) -> np.ndarray:
    """Outward normals (M x 5 x 3) of front, back and the walls at edges 0 to 2. Zero for a face without area:
    Coin wants numbers."""
    a, b, c, d, e, f = (corners[:, k] for k in range(6))
    across = np.stack([np.cross(b - a, c - a), np.cross(f - d, e - d), np.cross(a - b, e - b),
                       np.cross(b - c, f - c), np.cross(c - a, d - a)], axis=1)
    length = np.linalg.norm(across, axis=2, keepdims=True)
    return across / np.where(length > 0, length, 1)


def with_middles(corners: np.ndarray) -> np.ndarray:
    """Points of THIRDS, M x 8 x 3: corners, and the middles of front and back."""
    return np.concatenate([corners, corners[:, :3].mean(1, keepdims=True),
                           corners[:, 3:].mean(1, keepdims=True)], axis=1)


def pin_prisms(pins: np.ndarray) -> np.ndarray:
    """Prisms (2M x 6 x 3) of pins (M x 2 x 6 x 3: front and back, three corners of the base and three of the
    top). Their fronts point the way of the tile's front."""
    front, back = pins[:, 0], pins[:, 1]
    return np.concatenate([np.concatenate([front[:, 3:], front[:, :3]], axis=1), back])


def frames(corners: np.ndarray) -> np.ndarray:
    """Rotations (M x 3 x 3) whose columns are the first edge of a triangle, the normal's product with it, and
    the normal. `corners`: M x 3 x 3, a corner a row, not on one line."""
    along = corners[:, 1] - corners[:, 0]
    normal = np.cross(along, corners[:, 2] - corners[:, 0])
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    normal = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    return np.stack([along, np.cross(normal, along), normal], axis=2)


def axes_of(rotations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Axes (M x 3, of unit length) and angles (M, rad) of rotations (M x 3 x 3)."""
    axes = np.linalg.eigh(rotations + rotations.transpose(0, 2, 1))[1][:, :, 2]
    skew = rotations - rotations.transpose(0, 2, 1)
    sine = np.einsum("mk,mk->m", axes, skew[:, (2, 0, 1), (1, 2, 0)]) / 2
    return axes, np.arctan2(sine, (np.trace(rotations, axis1=1, axis2=2) - 1) / 2)


def part_of(axes: np.ndarray, angles: np.ndarray, t: float) -> np.ndarray:
    """Rotations (M x 3 x 3) by the share t of angles about axes, by Rodrigues' formula."""
    across = np.cross(np.eye(3), axes[:, None])
    sine, cosine = np.sin(t * angles)[:, None, None], np.cos(t * angles)[:, None, None]
    return np.eye(3) + sine * across + (1 - cosine) * (across @ across)


class Motion:
    """Rigid motions of M tiles. `flat`, `actuated`: their front corners, M x 3 x 3, mm.

    The rotation that is nearest to those of all tiles is applied to the whole, the rest to each tile."""

    def __init__(self, flat: np.ndarray, actuated: np.ndarray):
        self._from, to = flat.mean(1), actuated.mean(1)
        own = frames(actuated) @ frames(flat).transpose(0, 2, 1)
        area = np.linalg.norm(np.cross(flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]), axis=1)
        u, _, vt = np.linalg.svd(np.einsum("m,mij->ij", area, own))
        whole = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
        self._middle = np.average(self._from, axis=0, weights=area)
        self._shift = np.average(to, axis=0, weights=area) - self._middle
        self._whole = axes_of(whole[None])
        self._own = axes_of(whole.T @ own)
        self._step = (to - self._middle - self._shift) @ whole + self._middle - self._from

    def middle(self, t: float) -> np.ndarray:
        """Middle of all tiles, mm."""
        return self._middle + t * self._shift

    def move(self, points: np.ndarray, t: float) -> np.ndarray:
        """Positions at t of points on the tiles (M x K x 3, mm, in the flat layout)."""
        whole = part_of(*self._whole, t)[0]
        turned = (points - self._from[:, None]) @ part_of(*self._own, t).transpose(0, 2, 1)
        gathered = turned + (self._from + t * self._step - self._middle)[:, None]
        return gathered @ whole.T + self.middle(t)

    def blend(self, flat: np.ndarray, actuated: np.ndarray, t: float) -> np.ndarray:
        """Positions at t of points (K x 3, mm) that bend on the way, by both their ends."""
        inverse = (actuated - self.middle(1)) @ part_of(*self._whole, 1)[0] + self._middle
        return (flat + t * (inverse - flat) - self._middle) @ part_of(*self._whole, t)[0].T + self.middle(t)


NO_FIELD = "None"  # for plain tiles


@dataclass(frozen=True)
class Membrane:
    """A membrane between its pins: points (P x 3, mm), triangles (K x 3) and the larger principal stretch of
    each when actuated (K)."""

    flat: np.ndarray
    actuated: np.ndarray
    triangles: np.ndarray
    stretch: np.ndarray


@dataclass(frozen=True)
class Scene:
    """M tiles (M x 6 x 3, mm; see native.TileShapes) with their contacts (N x 2 tiles, and N x 2 edges of
    these). `flat` is None before there is a layout. The flat layout lies as it is printed: its lowest pins
    end at z = 0."""

    V: np.ndarray
    F: np.ndarray
    cuts: np.ndarray
    parameters: Any
    actuated: np.ndarray
    flat: Optional[np.ndarray]
    actuated_pins: np.ndarray          # M x 2 x 6 x 3, or empty
    flat_pins: np.ndarray
    contacts: np.ndarray
    sides: np.ndarray
    membranes: tuple[Membrane, ...] = ()
    fields: dict[str, Field] = field(default_factory=dict)

    @cached_property
    def motion(self) -> Optional[Motion]:
        return None if self.flat is None else Motion(self.flat[:, :3], self.actuated[:, :3])

    def tiles_at(self, t: float) -> np.ndarray:
        """Tiles between the flat layout (t = 0) and the target shape (1), M x 6 x 3."""
        if self.flat is None or self.motion is None or t >= 1:
            return self.actuated
        return self.flat if t <= 0 else self.motion.move(self.flat, t)

    def pins_at(self, t: float) -> np.ndarray:
        """Pins at t, M x 2 x 6 x 3."""
        if self.motion is None or t >= 1:
            return self.actuated_pins
        if t <= 0:
            return self.flat_pins
        return self.motion.move(self.flat_pins.reshape(-1, 12, 3), t).reshape(-1, 2, 6, 3)

    def membrane_at(self, membrane: Membrane, t: float) -> np.ndarray:
        """Points of a membrane at t, P x 3."""
        if self.motion is None or t >= 1:
            return membrane.actuated
        return membrane.flat if t <= 0 else self.motion.blend(membrane.flat, membrane.actuated, t)

    def slots(self, values_of: Field) -> np.ndarray:
        """Values of a field by slot of colour (M x 6, see prisms); NaN if there is none."""
        values = values_of.values
        if values_of.on == TILE:
            return np.repeat(values[:, None], SLOTS, axis=1)
        if values_of.on == SIDE:
            return np.repeat(values, 3, axis=1)
        thirds = np.full((len(self.F), 3), np.nan)
        for k in (0, 1):
            thirds[self.contacts[:, k], self.sides[:, k]] = values
        return np.hstack([thirds, thirds])

    def tile_values(self, values_of: Field, tile: int) -> list[float]:
        """Values of a field at a tile: its own, those of its two sides, or those of its contacts."""
        rows = tile if values_of.on in (TILE, SIDE) else (self.contacts == tile).any(axis=1)
        return [float(value) for value in np.atleast_1d(values_of.values[rows])]

    def places(self, values_of: Field, numbers: np.ndarray, corners: np.ndarray) -> np.ndarray:
        """Points (K x 3) for tiles or contacts by number, a little above the front faces. corners: of all
        tiles, M x 6 x 3."""
        if values_of.on in (TILE, SIDE):
            return self._above(corners[numbers], corners[numbers, :3].mean(1))
        middles = []
        for k in (0, 1):
            tiles, edges = self.contacts[numbers, k], self.sides[numbers, k]
            middle = (corners[tiles, edges] + corners[tiles, (edges + 1) % 3]) / 2
            middles.append(self._above(corners[tiles], middle))
        return (middles[0] + middles[1]) / 2

    def tiles_of(self, values_of: Field, number: int) -> list[int]:
        """Tiles of the value with that number."""
        return [number] if values_of.on in (TILE, SIDE) else [int(tile) for tile in self.contacts[number]]

    @staticmethod
    def _above(corners: np.ndarray, points: np.ndarray) -> np.ndarray:
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length = np.linalg.norm(normal, axis=1, keepdims=True)
        return points + 0.1 * normal / np.sqrt(np.where(length > 0, length, 1))

    def with_membranes(self, membranes: tuple[Membrane, ...]) -> "Scene":
        """The same scene with membranes and the field of their stretch."""
        stretch = Field("Membrane stretch", "", MEMBRANE,
                        lambda: np.concatenate([sheet.stretch for sheet in membranes]), "high",
                        part="Layout")
        return replace(self, membranes=membranes, fields={**self.fields, stretch.name: stretch})

    def posed(self, rows: np.ndarray) -> "Scene":
        """The same tiles in a frame of a path (M x 7), about the middle of the actuated ones."""
        tiles, pins = (moved(points.reshape(len(rows), -1, 3), rows)
                       for points in (self.actuated, self.actuated_pins))
        step = self.actuated.mean((0, 1)) - tiles.mean((0, 1))
        tiles, pins = tiles + step, (pins + step).reshape(self.actuated_pins.shape)
        return replace(self, actuated=tiles, flat=tiles, actuated_pins=pins, flat_pins=pins, membranes=())

    def moved(self, T: np.ndarray, q: np.ndarray) -> "Scene":
        """The same tiles in another layout (M x 3 x 2 and M x 2 x 3, mm), without fields of a layout."""
        shapes = native.tile_shapes_at(self.V, self.F, self.cuts, self.parameters, T, q)
        fields = {name: self.fields[name] for name in _OF_TARGET if name in self.fields}
        return replace(self, **shapes_of(shapes, self.parameters), membranes=(), fields=fields)


_OF_TARGET = ("Dihedral angle", "Pin area margin", "Conformal stretch")


def scene_of(project: Any) -> Optional[Scene]:
    """Scene of a Project; None if there is no target yet. Raises an error of the native module if the
    parameters allow no such tiles."""
    result = project.latest("design") or project.latest("layout")
    if result is None:
        return target_scene_of(project)
    return _of_design(project, result.design.with_parameters(project.parameters))


def path_scene_of(path: Any) -> Scene:
    """Scene of the design of a path from flat (stages/actuation.py), for `Scene.posed`."""
    shapes = native.tile_shapes(path.design)
    return _scene(path.design, shapes, path_fields(path, shapes.contacts))


def target_scene_of(project: Any) -> Optional[Scene]:
    """Scene of a Project's target, also if there is a layout."""
    parameters, target = project.parameters, project.latest("target")
    if target is None:
        return None
    names = ("feasibility", "pin smoothing", "target smoothing", "division")
    check, for_pins, smoothed, division = (_current(project, name) for name in names)
    V = next((result.V for result in (check, for_pins, smoothed) if result is not None), target.V)
    edges = np.empty((0, 2), np.int32) if division is None else division.edges
    try:
        shapes = shapes_of(native.tile_shapes_at(V, target.F, edges, parameters), parameters)
    except native.Error:
        if check is None:
            raise
        shapes = _plates(V, target.F, check.contacts)  # they show why there are no tiles
    contacts = shapes["contacts"]
    fields = check_fields(check, parameters, contacts) if check is not None else []
    fields += [*target_fields(V, target.F, edges, parameters, contacts, True),
               *_deviation(project, V, target.F, "Target")]
    return Scene(V, target.F, edges, parameters, **shapes, fields=_by_name(fields))


def _plates(V: np.ndarray, F: np.ndarray, contacts: np.ndarray) -> dict[str, Any]:
    """Front faces as thin plates without pins: members of a Scene, as of `shapes_of`."""
    front = V[F]
    across = np.cross(front[:, 1] - front[:, 0], front[:, 2] - front[:, 0])
    size = np.sqrt(np.linalg.norm(across, axis=1, keepdims=True))
    back = front - (_PLATE * across / size)[:, None]
    sides = np.empty((len(contacts), 2), int)
    for number, (a, b) in enumerate(contacts):
        for k, (tile, other) in enumerate(((a, b), (b, a))):
            shared = np.isin(F[tile], F[other])  # edge t is that of the corners t and t + 1
            sides[number, k] = int(np.argmax(shared & np.roll(shared, -1)))
    return {"actuated": np.concatenate([front, back], axis=1), "flat": None,
            "actuated_pins": np.empty((0, 2, 6, 3)), "flat_pins": np.empty((0, 2, 6, 3)),
            "contacts": np.asarray(contacts).reshape(-1, 2), "sides": sides}


_PLATE = 0.05  # thickness of a plate over about its edge


def _current(project: Any, name: str) -> Any:
    """A result of the target as it is; None if there is none."""
    return project.latest(name) if project.out_of_date(name) == () else None


def _of_design(project: Any, design: Any) -> Scene:
    shapes, parameters = native.tile_shapes(design), design.parameters
    fields: list[Field] = []
    for name in ("verification", "verification of the layout"):
        result = project.latest(name)
        result = getattr(result, "verification", result)
        if result is not None and result.judged and len(result.design.F) == len(design.F):
            fields += force_fields(result, shapes.contacts, parameters)
            break
    settled = project.latest("settle")
    if settled is not None and settled.design is not None and len(settled.design.F) == len(design.F):
        fields += friction_fields(settled, len(design.F))
    fields += design_fields(design, shapes.contacts)
    fields += _deviation(project, design.V, design.F, "Layout")
    fields += target_fields(design.V, design.F, design.cuts, parameters, shapes.contacts, False)
    return _scene(design, shapes, fields)


def _scene(design: Any, shapes: Any, fields: list[Field]) -> Scene:
    return Scene(design.V, design.F, design.cuts, design.parameters, **shapes_of(shapes, design.parameters),
                 fields=_by_name(fields))


def _by_name(fields: list[Field]) -> dict[str, Field]:
    """Fields by name; the first of a name counts."""
    named: dict[str, Field] = {}
    for known in fields:
        named.setdefault(known.name, known)
    return named


def _deviation(project: Any, V: np.ndarray, F: np.ndarray, part: str) -> list[Field]:
    """Field of deviation; none if the surface before remeshing is not known, as of a design file."""
    target = project.latest("target")
    return [] if target is None else [deviation_field(V, F, part, *target.given)]


def _height(parameters: Any) -> float:
    """Height of the front faces in the print, mm."""
    return parameters.get("H_body") + parameters.get("H_pin")


def shapes_of(shapes: Any, parameters: Any) -> dict[str, Any]:
    """Arrays of native.TileShapes as members of a Scene."""
    up = np.array([0, 0, _height(parameters)])
    known = bool(len(shapes.flat))
    return {"actuated": shapes.actuated, "flat": shapes.flat + up if known else None,
            "actuated_pins": shapes.actuated_pins, "flat_pins": shapes.flat_pins + up,
            "contacts": np.asarray(shapes.contacts), "sides": np.asarray(shapes.contact_sides)}


def membranes_of(design: Any, job: Any) -> tuple[Membrane, ...]:
    """Membranes of a native Design in equilibrium: seconds of work, for a worker's thread."""
    membranes, get = [], design.parameters.get
    top = _height(design.parameters) + get("H_pin")
    for side, z in zip(native.verify_design(design, job).membranes, (top, 0.0)):
        if len(side.triangles):
            flat = np.column_stack([side.flat, np.full(len(side.flat), z)])
            membranes.append(Membrane(flat, side.actuated, side.triangles, np.max(side.stretch, axis=1)))
    return tuple(membranes)
