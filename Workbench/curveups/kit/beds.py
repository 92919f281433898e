# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divides a print that is too large for its printer's bed: first by how it is turned, then into pieces one
beside the other, then by which anchors it has, and last into parts, cut along gaps between tiles. Parts butt
in a frame, where the first membrane is glued over all of them.

All places are those of the print: x and y in mm.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence

import numpy as np

from ..base.native import native
from ..stages.solids import KINDS, fits_bed

TURNS = np.arange(0.0, 180.0, 1.0)  # degrees that are tried
CUT_TURNS = TURNS[::15]
BESIDE = 5.0                        # mm between pieces on a bed
FIT = 0.2                           # mm that the frame's pocket is wider on each side
MOST_PARTS = 64

Place = tuple[float, float, float]  # x, y (mm) after the turn (degrees)
Asked = Callable[..., bool]         # a native progress: whether to go on


@dataclass(frozen=True)
class Beds:
    """model: native PrintModel, by whose parts the beds go. places: of each bed its parts with their places
    there. opening: mm between parts. left_out: anchors for which there was no room. seams: how many of them
    add up in a row, at most."""

    model: Any
    places: Sequence[Mapping[int, Place]]
    opening: float = 0.0
    left_out: int = 0
    seams: int = 0
    _made: dict[int, Any] = field(default_factory=dict, compare=False)

    @property
    def position_error(self) -> float:
        """mm by which a part may be off its place in the frame, at most."""
        return 2 * FIT + self.seams * self.opening if self.seams else 0.0

    def bed(self, number: int) -> Any:
        """The native PrintModel of a bed, from 0."""
        if number not in self._made:
            self._made[number] = self.model.only_pieces({part: list(place) for part, place
                                                         in self.places[number].items()})
        return self._made[number]

    def figures(self, printer: Mapping[str, Any]) -> dict[str, Any]:
        """For kit.json."""
        return {"bed_mm": printer["bed_mm"], "parts": sum(map(len, self.places)), "opening_mm": self.opening,
                "frame_fit_mm": FIT, "position_error_mm": self.position_error,
                "anchors_left_out": self.left_out,
                "beds": [{"parts": [part + 1 for part in places], **_figures(self.bed(number))}
                         for number, places in enumerate(self.places)]}


def bed_name(number: int) -> str:
    """In names of files, of a bed from 0."""
    return f"bed-{number + 1:02}"


def _figures(model: Any) -> dict[str, Any]:
    return {"bbox_mm": [float(x) for x in model.bbox],
            "bodies": sum(len(model.piece_of_bodies(kind)) for kind in KINDS)}


def beds(design: Any, model: Any, printer: dict[str, Any], shapes: Any, asked: Asked) -> Optional[Beds]:
    """None where the print fits as it is, or is too high. model: its native PrintModel; shapes: native
    TileShapes. Raises native.Cancelled once `asked` says to stop."""
    bed = printer["bed_mm"]
    if fits_bed(model.bbox, printer) or model.bbox[2] > bed[2] or not max(bed) > 0:
        return None
    for found in (_on_one(model, bed), _packed(model, bed)):
        if found:
            return Beds(model, found)
    return _fewer_anchors(design, model, bed, shapes, asked) or _cut(design, model, printer, shapes, asked)


def _on_one(model: Any, bed: Sequence[float]) -> Optional[list[dict[int, Place]]]:
    """All as it stands on one bed."""
    turn = _best_turn(np.concatenate([*_points(model).values()]), bed)
    return None if turn is None else [{piece: turn for piece in range(model.piece_count)}]


def _packed(model: Any, bed: Sequence[float]) -> Optional[list[dict[int, Place]]]:
    """Pieces side by side, in rows, on as many beds as it takes; None where one is too large for any."""
    sizes: dict[int, tuple[np.ndarray, Place]] = {}
    for piece, points in _points(model).items():
        turn = _best_turn(points, bed)
        if turn is None:
            return None
        sizes[piece] = (np.ptp(points @ turned(turn[2]).T, axis=0), turn)
    found: list[dict[int, Place]] = []
    x = y = high = np.inf
    for piece in sorted(sizes, key=lambda one: (-sizes[one][0][1], one)):
        (width, height), turn = sizes[piece]
        if x + width > bed[0]:
            x, y, high = 0.0, y + high + BESIDE, 0.0
        if y + height > bed[1]:
            found.append({})
            x = y = high = 0.0
        corner = np.array([x + width / 2, y + height / 2]) - np.array(bed[:2]) / 2
        found[-1][piece] = (turn[0] + corner[0], turn[1] + corner[1], turn[2])
        x, high = x + width + BESIDE, max(high, float(height))
    return [{piece: (float(a), float(b), float(c)) for piece, (a, b, c) in one.items()} for one in found]


def _made(asked: Asked, design: Any, **given: Any) -> Any:
    """A native PrintModel; None where there is none, for instance where no slab can be cut so."""
    try:
        return native.make_print_model(design, asked, **given)
    except (native.TopologyError, native.SolverFailure):
        return None


def _fewer_anchors(design: Any, model: Any, bed: Sequence[float], shapes: Any, asked: Asked
                   ) -> Optional[Beds]:
    """With anchors and slab within the bed, where all tiles with the slab's margin have room there."""
    if not model.volumes["anchors"]:
        return None
    tiles = np.asarray(shapes.flat)[..., :2].reshape(-1, 2)
    room = [side - 2 * native.SUPPORT_MARGIN for side in bed[:2]]
    turn = _best_turn(tiles, room)
    if turn is None:
        return None
    half = np.array(bed[:2]) / 2
    region = (np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * half - turn[:2]) @ turned(-turn[2]).T
    made = _made(asked, design, region=[*region])
    on_one = made and _on_one(made, bed)
    if not on_one:
        return None
    anchors = model.piece_of_bodies("anchors")
    return Beds(made, on_one, left_out=len(anchors) - len(made.piece_of_bodies("anchors")))


def _cut(design: Any, model: Any, printer: Mapping[str, Any], shapes: Any, asked: Asked) -> Optional[Beds]:
    """The fewest parts that fit, each on a bed of its own or with others."""
    bed, opening = printer["bed_mm"], 2 * printer["growth_mm"]
    loose = set(model.loose_tiles)  # of the whole print as well
    for parts, seams in _divisions(design, bed, shapes, asked):
        made = _made(asked, design, part_of_tile=parts.tolist(), opening=opening)
        found = made and loose.issuperset(made.loose_tiles) and _packed(made, bed)
        if found:
            return Beds(made, found, opening, seams=seams)
    return None


def _divisions(design: Any, bed: Sequence[float], shapes: Any, asked: Asked
               ) -> Iterator[tuple[np.ndarray, int]]:
    """The part of each tile, and how many seams lie in a row at most; the fewest parts first."""
    pieces = np.asarray(native.pieces_of_faces(design.V, design.F, design.cuts))
    middles = np.asarray(shapes.flat)[..., :2].mean(1)
    contacts = np.asarray(shapes.contacts).reshape(-1, 2)
    reach = _rim(design.parameters)
    counts = range(1, MOST_PARTS)
    ways = sorted(((x, y) for x in counts for y in counts if x * y <= MOST_PARTS),
                  key=lambda way: (way[0] * way[1], abs(way[0] - way[1])))
    for columns, rows in ways:
        for turn in CUT_TURNS:
            if not asked():
                raise native.Cancelled
            parts = np.zeros(len(middles), int)
            first = 0
            for piece in range(int(pieces.max()) + 1):
                own = pieces == piece
                parts[own] = first + _grid(middles[own] @ turned(turn).T, columns, rows, bed, reach)
                first = int(parts[own].max()) + 1
            parts = _joined(_smooth(parts, contacts), contacts)
            corners = np.asarray(shapes.flat)[..., :2] @ turned(turn).T
            if all(_has_room(corners[parts == part].reshape(-1, 2),
                             corners[pieces == pieces[parts == part][0]].reshape(-1, 2), bed, reach)
                   for part in range(int(parts.max()) + 1)):
                yield parts, columns + rows - 2


def _grid(middles: np.ndarray, columns: int, rows: int, bed: Sequence[float], reach: float) -> np.ndarray:
    """Cells of tiles; of a piece that fits one cell all is one."""
    low, size = middles.min(0), np.ptp(middles, axis=0)
    counts = [1 if size[axis] + 2 * reach < bed[axis] else count
              for axis, count in enumerate((columns, rows))]
    share = (middles - low) / np.maximum(size, 1e-9)
    cell = [np.minimum((count * share[:, axis]).astype(int), count - 1) for axis, count in enumerate(counts)]
    return np.asarray(cell[0] * counts[1] + cell[1])


def _smooth(parts: np.ndarray, contacts: np.ndarray) -> np.ndarray:
    """Tiles that hang on their part by one contact go where they have two."""
    parts = parts.copy()
    beside: list[list[int]] = [[] for _ in parts]
    for a, b in contacts.tolist():
        beside[a].append(b)
        beside[b].append(a)
    for _ in range(len(parts)):
        moved = False
        for tile, others in enumerate(beside):
            counts = np.bincount(parts[others]) if others else np.zeros(1, int)
            best = int(counts.argmax())
            if best != parts[tile] and counts[best] >= 2:
                parts[tile], moved = best, True
        if not moved:
            break
    return parts


def _joined(parts: np.ndarray, contacts: np.ndarray) -> np.ndarray:
    """Parts in one, numbered from 0: what a cut leaves apart joins the neighbour with most contacts."""
    parts = parts.copy()
    while True:
        group = _components(parts, contacts)
        sizes = np.bincount(group)
        largest = {part: max(set(group[parts == part]), key=lambda one: (sizes[one], -one))
                   for part in set(parts.tolist())}
        lost = [one for one in range(len(sizes)) if one not in largest.values()]
        beside = [(one, parts[np.where(group[contacts[:, 0]] == one, contacts[:, 1], contacts[:, 0])[
            (group[contacts] == one).sum(1) == 1]]) for one in lost]
        moved = [(one, np.bincount(others).argmax()) for one, others in beside if len(others)]
        if not moved:
            return np.asarray(np.unique(parts, return_inverse=True)[1])
        one, part = moved[0]
        parts[group == one] = part


def _components(parts: np.ndarray, contacts: np.ndarray) -> np.ndarray:
    from scipy.sparse import coo_matrix  # which other commands would pay
    from scipy.sparse.csgraph import connected_components

    inner = contacts[parts[contacts[:, 0]] == parts[contacts[:, 1]]]
    graph = coo_matrix((np.ones(len(inner)), (inner[:, 0], inner[:, 1])), shape=(len(parts),) * 2)
    return np.asarray(connected_components(graph, directed=False)[1])


def _has_room(corners: np.ndarray, piece: np.ndarray, bed: Sequence[float], reach: float) -> bool:
    """Whether a part's corners fit the bed, with the rim where the piece ends."""
    low, high = corners.min(0), corners.max(0)
    low = low - np.where(low - piece.min(0) < reach, reach, 1.0)
    high = high + np.where(piece.max(0) - high < reach, reach, 1.0)
    return bool((np.sort(high - low) <= np.sort(bed[:2])).all())


def _rim(parameters: Any) -> float:
    """mm that anchors and slab reach beyond the tiles."""
    get = parameters.get
    anchors = native.ANCHOR_DISTANCE + 2 * get("anchor_radius") if get("anchors") else 0.0
    return float(anchors + native.SUPPORT_MARGIN)


def _points(model: Any) -> dict[int, np.ndarray]:
    """Points of each piece's bodies, seen from above."""
    found: dict[int, list[np.ndarray]] = {}
    for kind in KINDS:
        if model.volumes[kind] > 0:
            points, faces, body = model.mesh(kind)
            piece = np.asarray(model.piece_of_bodies(kind))[body]
            for one in np.unique(piece):
                found.setdefault(int(one), []).append(points[np.unique(faces[piece == one])][:, :2])
    return {piece: np.concatenate(parts) for piece, parts in sorted(found.items())}


def _best_turn(points: np.ndarray, bed: Sequence[float]) -> Optional[Place]:
    """The move and turn that bring points to the middle of the bed, with the least height there; None where
    none fits."""
    from scipy.spatial import ConvexHull

    hull = points[ConvexHull(points).vertices]
    best: Optional[tuple[float, Place]] = None
    for turn in TURNS:
        placed = hull @ turned(turn).T
        low, high = placed.min(0), placed.max(0)
        fits = (high - low <= np.array(bed[:2]) + 1e-6).all()
        if fits and (best is None or high[1] - low[1] < best[0] - 1e-6):
            x, y = map(float, -(low + high) / 2)
            best = float(high[1] - low[1]), (x, y, float(turn))
    return best[1] if best else None


def turned(degrees: float) -> np.ndarray:
    """The matrix of a turn in the plane."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s], [s, c]])
