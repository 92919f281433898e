# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts as users draw them: along shortest paths of a mesh's edges, from one click to the next. Works without
FreeCAD."""

from __future__ import annotations

from typing import Optional, Sequence

import numpy as np

from ..base.native import native
from ..stages.cut_request import interior_edges

Edge = tuple[int, int]  # vertices, ascending


class CutPaths:
    """Paths on a mesh: V (N x 3, mm), F (M x 3)."""

    def __init__(self, V: np.ndarray, F: np.ndarray):
        self.V, self.F = np.asarray(V, float), np.asarray(F, np.int32)
        self.interior = interior_edges(self.F)

    def reach(self, edge: Sequence[int], tip: Optional[int] = None) -> tuple[list[Edge], int]:
        """Edges that a click on an edge cuts, and the vertex from which the next click goes on: the edge and,
        with a `tip`, the shortest path from it. Edges of the rim can't be cut; paths end there."""
        a, b = (int(v) for v in edge)
        if tip is None:
            return self._cuttable([(a, b)]), b
        if tip in (a, b):
            return self._cuttable([(a, b)]), b if tip == a else a
        paths = {v: self._path(tip, v) for v in (a, b)}
        near, far = sorted((a, b), key=lambda v: self.length(paths[v]))
        path, last = self._cuttable(paths[near]), self._cuttable([(a, b)])
        return [*path, *last], far if last else near

    def length(self, edges: Sequence[Edge]) -> float:
        """Length of edges, mm."""
        if not len(edges):
            return 0.0
        ends = self.V[np.asarray(edges, int)]
        return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())

    def _path(self, start: int, end: int) -> list[Edge]:
        if start == end:
            return []
        path = native.shortest_edge_path(self.V, self.F, self.V[[start, end]])
        return list(zip(map(int, path), map(int, path[1:])))

    def _cuttable(self, edges: Sequence[Edge]) -> list[Edge]:
        ascending = [(min(edge), max(edge)) for edge in edges]
        return [edge for edge in ascending if edge in self.interior]


def groups(edges: Sequence[Sequence[int]]) -> list[list[Edge]]:
    """Connected groups of edges, in the order of their first ones."""
    pending = [(min(map(int, edge)), max(map(int, edge))) for edge in edges]
    connected: list[list[Edge]] = []
    while pending:
        group = [pending.pop(0)]
        reached = set(group[0])
        while True:
            touching = [edge for edge in pending if reached.intersection(edge)]
            if not touching:
                break
            group += touching
            reached.update(*touching)
            pending = [edge for edge in pending if edge not in touching]
        connected.append(group)
    return connected
