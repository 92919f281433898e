# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divides a print that is too large for its printer's bed. The first of these that fits is taken: the whole
print turned, its pieces side by side, the print with fewer anchors, parts cut along gaps between tiles. Parts
butt in a frame, where the first membrane is glued over all of them.

Coordinates are those of the print: x and y in mm.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence

import numpy as np

from ..base.native import native
from ..stages.solids import KINDS, fits_bed

TURNS = np.arange(0.0, 180.0, 1.0)  # degrees that are tried
BESIDE = 5.0                        # mm between pieces on a bed
FIT = 0.2                           # mm that the frame's pocket is wider on each side
MOST_PARTS = 64

Place = tuple[float, float, float]  # x, y (mm) after the turn (degrees)
Asked = Callable[..., bool]         # a native progress: False stops the work


@dataclass(frozen=True)
class Beds:
    """model: native PrintModel that has the parts. places: the place of each part on its bed, one mapping a
    bed. opening: mm between parts. left_out: number of anchors without room. seams: largest number of seams
    in a row."""

    model: Any
    places: Sequence[Mapping[int, Place]]
    opening: float = 0.0
    left_out: int = 0
    seams: int = 0
    _made: dict[int, Any] = field(default_factory=dict, compare=False)

    @property
    def position_error(self) -> float:
        """Largest distance of a part from its place in the frame, mm."""
        return 2 * FIT + self.seams * self.opening if self.seams else 0.0

    def bed(self, number: int) -> Any:
        """The native PrintModel of a bed, from 0."""
        if number not in self._made:
            self._made[number] = self.model.only_pieces({part: list(place) for part, place
                                                         in self.places[number].items()})
        return self._made[number]

    def figures(self, printer: Mapping[str, Any]) -> dict[str, Any]:
        """Block of kit.json."""
        return {"bed_mm": printer["bed_mm"], "parts": sum(map(len, self.places)), "opening_mm": self.opening,
                "frame_fit_mm": FIT, "position_error_mm": self.position_error,
                "anchors_left_out": self.left_out,
                "beds": [{"parts": [part + 1 for part in places],
                          "bbox_mm": [float(x) for x in self.bed(number).bbox],
                          "bodies": self.bed(number).body_count}
                         for number, places in enumerate(self.places)]}


def bed_name(number: int) -> str:
    """Part of file names, for a bed from 0."""
    return f"bed-{number + 1:02}"


def beds(design: Any, model: Any, printer: dict[str, Any], shapes: Any, asked: Asked) -> Optional[Beds]:
    """Division of a print; None if it fits as it is, or is too high. model: its native PrintModel; shapes:
    native TileShapes. Raises native.Cancelled once `asked` says to stop."""
    bed = printer["bed_mm"]
    if fits_bed(model.bbox, printer) or model.bbox[2] > bed[2] or not max(bed) > 0:
        return None
    for places in (_on_one(model, bed), _packed(model, bed)):
        if places:
            return Beds(model, places)
    return _fewer_anchors(design, model, bed, shapes, asked) or _cut(design, model, printer, shapes, asked)


def _on_one(model: Any, bed: Sequence[float]) -> Optional[list[dict[int, Place]]]:
    """Places of all pieces as they stand, on one bed."""
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
    beds_so_far: list[dict[int, Place]] = []
    x = y = high = np.inf
    for piece in sorted(sizes, key=lambda places: (-sizes[places][0][1], places)):
        (width, height), turn = sizes[piece]
        if x + width > bed[0]:
            x, y, high = 0.0, y + high + BESIDE, 0.0
        if y + height > bed[1]:
            beds_so_far.append({})
            x = y = high = 0.0
        corner = np.array([x + width / 2, y + height / 2]) - np.array(bed[:2]) / 2
        beds_so_far[-1][piece] = (turn[0] + corner[0], turn[1] + corner[1], turn[2])
        x, high = x + width + BESIDE, max(high, float(height))
    return [{piece: (float(a), float(b), float(c)) for piece, (a, b, c) in places.items()}
            for places in beds_so_far]


def _made(asked: Asked, design: Any, **given: Any) -> Any:
    """A native PrintModel; None where there is none, for instance where no slab can be cut so."""
    try:
        return native.make_print_model(design, asked, **given)
    except (native.TopologyError, native.SolverFailure):
        return None


def _fewer_anchors(design: Any, model: Any, bed: Sequence[float], shapes: Any, asked: Asked
                   ) -> Optional[Beds]:
    """Print whose anchors and slab end at the bed, where all tiles with the slab's margin have room there."""
    if not model.volumes["anchors"]:
        return None
    tiles = np.asarray(shapes.flat)[..., :2].reshape(-1, 2)
    room = [side - 2 * native.SUPPORT_MARGIN for side in bed[:2]]
    turn = _best_turn(tiles, room)
    if turn is None:
        return None
    half = np.array(bed[:2]) / 2
    region = (np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * half - turn[:2]) @ turned(-turn[2]).T
    fewer = _made(asked, design, region=[*region])
    on_one = fewer and _on_one(fewer, bed)
    if not on_one:
        return None
    anchors = model.bodies("anchors")
    return Beds(fewer, on_one, left_out=len(anchors) - len(fewer.bodies("anchors")))


def _cut(design: Any, model: Any, printer: Mapping[str, Any], shapes: Any, asked: Asked) -> Optional[Beds]:
    """The fewest parts that fit, each on a bed of its own or with others."""
    bed, opening = printer["bed_mm"], 2 * printer["growth_mm"]
    loose = set(model.loose_tiles)  # of the whole print as well
    for parts, seams in _divisions(design, bed, shapes, asked):
        divided = _made(asked, design, part_of_tile=parts.tolist(), opening=opening)
        places = divided and loose.issuperset(divided.loose_tiles) and _packed(divided, bed)
        if places:
            return Beds(divided, places, opening, seams=seams)
    return None


def _divisions(design: Any, bed: Sequence[float], shapes: Any, asked: Asked
               ) -> Iterator[tuple[np.ndarray, int]]:
    """The part of each tile, and the largest number of seams in a row: grids over each piece, those with the
    fewest cells first."""
    pieces = np.asarray(native.pieces_of_faces(design.V, design.F, design.cuts))
    corners = np.asarray(shapes.flat)[..., :2]
    contacts = np.asarray(shapes.contacts).reshape(-1, 2)
    rim = _rim(design.parameters)
    grids = [(x, y) for x in range(1, MOST_PARTS + 1) for y in range(1, MOST_PARTS // x + 1)]
    for columns, rows in sorted(grids, key=lambda grid: (grid[0] * grid[1], abs(grid[0] - grid[1]))):
        if not asked():
            raise native.Cancelled
        parts = np.zeros(len(corners), int)
        for piece in range(int(pieces.max()) + 1):
            own = pieces == piece
            parts[own] = parts.max() + 1 + _grid(corners[own], columns, rows, bed, rim)
        parts = _joined(parts, contacts)
        if all(_fits(corners[parts == part], corners[pieces == pieces[parts == part][0]], bed, rim)
               for part in range(int(parts.max()) + 1)):
            yield parts, columns + rows - 2


def _fits(part: np.ndarray, piece: np.ndarray, bed: Sequence[float], rim: float) -> bool:
    """True if the tiles of a part (tiles x corners x 2) fit the bed, with the rim where their piece ends."""
    low, high = part.min((0, 1)), part.max((0, 1))
    low = low - np.where(low - piece.min((0, 1)) < rim, rim, 1.0)
    high = high + np.where(piece.max((0, 1)) - high < rim, rim, 1.0)
    return bool((np.sort(high - low) <= np.sort(bed[:2])).all())


def _grid(corners: np.ndarray, columns: int, rows: int, bed: Sequence[float], rim: float) -> np.ndarray:
    """The cell of each tile of a piece; all are in one cell where the piece fits the bed."""
    if _fits(corners, corners, bed, rim):
        return np.zeros(len(corners), int)
    middles = corners.mean(1)
    share = (middles - middles.min(0)) / np.maximum(np.ptp(middles, axis=0), 1e-9)
    column, row = np.minimum((share * (columns, rows)).astype(int), (columns - 1, rows - 1)).T
    return np.asarray(column * rows + row)


def _joined(parts: np.ndarray, contacts: np.ndarray) -> np.ndarray:
    """Make parts connected and number them from 0: a smaller component of a part joins the neighbouring part
    with which it has most contacts."""
    parts = parts.copy()
    while True:
        component = _components(parts, contacts)
        sizes = np.bincount(component)
        for smaller in np.argsort(sizes, kind="stable"):
            part = parts[component == smaller][0]
            inside = component[contacts] == smaller
            across = inside.sum(1) == 1
            if sizes[smaller] < sizes[np.unique(component[parts == part])].max() and across.any():
                neighbours = parts[contacts[across][~inside[across]]]
                parts[component == smaller] = np.bincount(neighbours).argmax()
                break
        else:
            return np.asarray(np.unique(component, return_inverse=True)[1])


def _components(parts: np.ndarray, contacts: np.ndarray) -> np.ndarray:
    from scipy.sparse import coo_matrix  # which other commands would pay
    from scipy.sparse.csgraph import connected_components

    inner = contacts[parts[contacts[:, 0]] == parts[contacts[:, 1]]]
    graph = coo_matrix((np.ones(len(inner)), (inner[:, 0], inner[:, 1])), shape=(len(parts),) * 2)
    return np.asarray(connected_components(graph, directed=False)[1])


def _rim(parameters: Any) -> float:
    """Reach of anchors and slab beyond the tiles, mm."""
    get = parameters.get
    anchors = native.ANCHOR_DISTANCE + 2 * get("anchor_radius") if get("anchors") else 0.0
    return float(anchors + native.SUPPORT_MARGIN)


def _points(model: Any) -> dict[int, np.ndarray]:
    """Points of each piece's bodies, seen from above."""
    points_of: dict[int, list[np.ndarray]] = {}
    for kind in KINDS:
        if model.volumes[kind] > 0:
            points, faces, body = model.mesh(kind)
            piece = np.array([printed.piece for printed in model.bodies(kind)])[body]
            for number in np.unique(piece):
                points_of.setdefault(int(number), []).append(points[np.unique(faces[piece == number])][:, :2])
    return {piece: np.concatenate(parts) for piece, parts in sorted(points_of.items())}


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
