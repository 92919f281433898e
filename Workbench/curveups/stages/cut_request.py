# SPDX-License-Identifier: LGPL-2.1-or-later
"""Given cuts: vertex pairs of the remeshed target, or polylines in mm."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.native import native, translated
from .stage import Result, Row, digest
from .suggestions import CutSearch


@dataclass(frozen=True)
class CutRequest(Result):
    """Cuts of a file (`where`) and those accepted of a search."""

    edges: np.ndarray = field(default_factory=lambda: np.zeros((0, 2), np.int32))
    polylines: tuple[np.ndarray, ...] = ()
    where: str = ""
    suggested: int = 0                       # number of cuts to search for besides
    accepted: Optional[CutSearch] = None     # the search whose cuts are among the edges
    divided: bool = False                    # the edges include borders of all pieces

    def __bool__(self) -> bool:
        return len(self.edges) > 0 or len(self.polylines) > 0

    @property
    def content(self) -> str:
        return digest(self.edges, *self.polylines, self.suggested, *(["divided"] if self.divided else []))

    def rows(self, seconds: float) -> Sequence[Row]:
        return self.accepted.rows(self.accepted.seconds) if self.accepted else ()

    def accept(self, search: CutSearch) -> "CutRequest":
        """The request with the cuts of a search, in their order."""
        edges = np.vstack([search.before, *(cut.edges for cut in search.cuts)]).astype(np.int32)
        return replace(self, edges=edges, polylines=(), suggested=0, accepted=search)


def read_cuts(path: Path) -> CutRequest:
    """Reads `{ "edges": [[a,b],...] }` or `{ "polylines": [[[x,y,z],...],...] }`."""
    data = read_json_object(path)
    where = str(path)
    unknown = set(data) - {"edges", "polylines"}
    if unknown or not data:
        what = f"unknown field '{sorted(unknown)[0]}'" if unknown else "there are no cuts"
        raise CurveUpsError(what, where, "give edges or polylines")
    return CutRequest(_edges(data.get("edges", []), where),
                      tuple(_polylines(data.get("polylines", []), where)), where)


def resolve_cuts(request: CutRequest, V: np.ndarray, F: np.ndarray) -> np.ndarray:
    """Mesh edges to cut, C x 2, each once and in ascending order. Raises CurveUpsError."""
    edges = [tuple(sorted(edge)) for edge in request.edges.tolist()]
    interior = interior_edges(F)
    for edge in edges:
        if edge not in interior:
            raise CurveUpsError(f"{edge[0]}-{edge[1]} is no interior edge of the mesh",
                                request.where,
                                "take vertex numbers from what 'curveups remesh' writes")
    size = float(np.ptp(V, axis=0).max())
    for number, line in enumerate(request.polylines):
        edges += _snap(line, number, V, F, size, request.where)
    chosen = sorted(set(edges) & interior)
    if request and not chosen:
        raise CurveUpsError("no cut runs along an interior edge", request.where,
                            "move the cut inside the surface")
    return np.array(chosen, np.int32).reshape(-1, 2)


def read_json_object(path: Path) -> dict:
    """Object of a JSON file. Raises CurveUpsError."""
    def refuse(text: str) -> None:
        raise ValueError(f"{text} is no number")

    try:
        data = json.loads(path.read_text(encoding="utf-8-sig"), parse_constant=refuse)
    except OSError as error:
        raise CurveUpsError(f"the file can't be read: {error.strerror}", str(path),
                            "check its name and permissions") from None
    except (ValueError, RecursionError) as error:
        raise CurveUpsError(f"this is no JSON: {error}", str(path), "mend the file") from None
    if not isinstance(data, dict):
        raise CurveUpsError("the file does not hold a JSON object", str(path), "put everything in braces")
    return data


def _edges(rows: Any, where: str) -> np.ndarray:
    good = isinstance(rows, list) and all(
        isinstance(row, list) and len(row) == 2
        and all(type(v) is int and 0 <= v < 2**31 for v in row) for row in rows)
    if not good:
        raise CurveUpsError("edges is no list of pairs of vertex numbers", where, "give [[a,b],...]")
    return np.array(rows, np.int32).reshape(-1, 2)


def _polylines(rows: Any, where: str) -> list[np.ndarray]:
    lines = []
    for row in rows if isinstance(rows, list) else [None]:
        try:
            line = np.array(row, float)
        except (TypeError, ValueError, OverflowError):
            line = np.zeros(0)
        if line.ndim != 2 or line.shape[1] != 3 or len(line) < 2 or not np.isfinite(line).all():
            raise CurveUpsError("a polyline has to have two or more points of three numbers",
                                where, "give [[[x,y,z],...],...] in mm")
        lines.append(line)
    return lines


def _snap(line: np.ndarray, number: int, V: np.ndarray, F: np.ndarray, size: float,
          where: str) -> list[tuple[int, int]]:
    """Edges of the shortest path through the vertices nearest to the points."""
    used = V[np.unique(F)]
    for point in line:
        distance = float(np.linalg.norm(used - point, axis=1).min())
        if distance > 0.5 * size:
            raise CurveUpsError(
                f"polyline {number + 1} has a point {distance:.3g} mm away from the target",
                where, "give the points in mm, on the surface")
    with translated(f"{where}, polyline {number + 1}"):
        path = native.shortest_edge_path(V, F, line)
    return [(min(pair), max(pair)) for pair in zip(path, path[1:])]


def interior_edges(F: np.ndarray) -> set[tuple[int, int]]:
    """Edges of two faces, each as its two vertices in ascending order."""
    pairs, faces = mesh_edges(F)
    return {(int(a), int(b)) for a, b in pairs[faces == 2]}


def mesh_edges(F: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Edges, each once as its vertices in ascending order (E x 2), and the number of faces at each."""
    sides = np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    pairs, faces = np.unique(sides, axis=0, return_counts=True)
    return pairs, faces


def sides_of_edges(F: np.ndarray) -> dict[tuple[int, int], list[tuple[int, int]]]:
    """Tiles at each edge (its vertices, the lower first), each with its side (0 to 2) there."""
    sides: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for tile, face in enumerate(np.asarray(F).tolist()):
        for k in range(3):
            a, b = face[k], face[(k + 1) % 3]
            sides.setdefault((min(a, b), max(a, b)), []).append((tile, k))
    return sides
