# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that a BREP text file holds as much as it announces. FreeCAD's reader believes the counts: at the
end of a file that was cut off it waits for ever, and where a curve is missing it takes what follows for it.

The format is that of OpenCASCADE's page "BRep Format", versions 1 to 3."""

from __future__ import annotations

import re

# How many numbers follow the kind: curves in the plane and in space, surfaces.
_CURVES = {2: {1: 4, 2: 7, 3: 8, 4: 7, 5: 8}, 3: {1: 6, 2: 13, 3: 14, 4: 13, 5: 14}}
_SURFACES = {1: 12, 2: 13, 3: 14, 4: 13, 5: 14}
_HEADER = re.compile(rb"^CASCADE Topology V([123])", re.MULTILINE)


def is_whole_brep(data: bytes) -> bool:
    """Whether the sections of a file hold what they announce; of another format, yes."""
    header = _HEADER.search(data)
    if not header:
        return True
    try:
        _Words(data[header.end():], int(header[1])).pass_file()
    except (ValueError, IndexError, KeyError, RecursionError):
        return False
    return True


class _Words:
    """The words of a file behind its header. What is no number where a count is due is a ValueError, a kind
    that there is not a KeyError, and the file's end an IndexError."""

    def __init__(self, data: bytes, version: int):
        self._words = data[data.index(b"\n"):].split()
        self._version = version
        self._at = 0

    def pass_file(self) -> None:
        for name, pass_one in (("Locations", self._location), ("Curve2ds", lambda: self._curve(2)),
                               ("Curves", lambda: self._curve(3)), ("Polygon3D", self._polygon),
                               ("PolygonOnTriangulations", self._polygon_on_triangles),
                               ("Surfaces", self._surface), ("Triangulations", self._triangles),
                               ("TShapes", self._shape)):
            self._expect(name.encode())
            for _ in range(self._count()):
                pass_one()
        self._reference()

    def _word(self) -> bytes:
        self._at += 1
        return self._words[self._at - 1]

    def _expect(self, *words: bytes) -> bytes:
        found = self._word()
        if found not in words:
            raise ValueError(found)
        return found

    def _count(self) -> int:
        count = int(self._word())
        if count < 0:
            raise ValueError(count)
        return count

    def _numbers(self, count: int) -> None:
        self._pass(count, float)

    def _indices(self, count: int) -> None:
        self._pass(count, int)

    def _pass(self, count: int, kind: type) -> None:
        end = self._at + count
        if end > len(self._words):
            raise IndexError(end)
        for word in self._words[self._at:end]:
            kind(word)
        self._at = end

    def _location(self) -> None:
        if self._expect(b"1", b"2") == b"1":
            self._numbers(12)
            return
        while self._count():
            self._numbers(1)

    def _curve(self, width: int) -> None:
        kind = self._count()
        if kind == 6:
            rational, degree = self._count(), self._count()
            self._numbers((degree + 1) * (width + rational))
        elif kind == 7:
            rational, _, _, poles, knots = (self._count() for _ in range(5))
            self._numbers(poles * (width + rational) + 2 * knots)
        elif kind in (8, 9):
            self._numbers(2 if kind == 8 else 1 if width == 2 else 4)
            self._curve(width)
        else:
            self._numbers(_CURVES[width][kind])

    def _surface(self) -> None:
        kind = self._count()
        if kind in (6, 7):
            self._numbers(3 if kind == 6 else 6)
            self._curve(3)
        elif kind == 8:
            u_rational, v_rational, u, v = (self._count() for _ in range(4))
            self._numbers((u + 1) * (v + 1) * (3 + (u_rational or v_rational)))
        elif kind == 9:
            u_rational, v_rational, _, _, _, _, u, v, u_knots, v_knots = (self._count() for _ in range(10))
            self._numbers(u * v * (3 + (u_rational or v_rational)) + 2 * (u_knots + v_knots))
        elif kind in (10, 11):
            self._numbers(4 if kind == 10 else 1)
            self._surface()
        else:
            self._numbers(_SURFACES[kind])

    def _polygon(self) -> None:
        nodes, with_parameters = self._count(), self._count()
        self._numbers(1 + nodes * (3 + with_parameters))

    def _polygon_on_triangles(self) -> None:
        nodes = self._count()
        self._numbers(nodes)
        self._expect(b"p")
        self._numbers(1)
        self._numbers(nodes * self._count())

    def _triangles(self) -> None:
        nodes, triangles, with_uv = (self._count() for _ in range(3))
        with_normals = self._count() if self._version == 3 else 0
        self._numbers(1 + nodes * (3 + 2 * with_uv + 3 * with_normals) + 3 * triangles)

    def _shape(self) -> None:
        kind = self._expect(b"Ve", b"Ed", b"Wi", b"Fa", b"Sh", b"So", b"CS", b"Co")
        if kind == b"Ve":
            self._numbers(4)
            self._points_of_vertex()
        elif kind == b"Ed":
            self._numbers(1)
            self._indices(3)
            while used := self._count():
                self._curve_of_edge(used)
        elif kind == b"Fa":
            self._indices(1)
            self._numbers(1)
            self._indices(4 if self._words[self._at + 2] == b"2" else 2)
        if len(self._word()) != 7:
            raise ValueError("flags")
        while self._words[self._at] != b"*":
            self._reference()
        self._at += 1

    def _points_of_vertex(self) -> None:
        while True:
            self._numbers(1)
            kind = self._count()
            if kind == 0:
                return
            self._numbers(kind == 3)
            self._indices({1: 2, 2: 3, 3: 2}[kind])

    def _curve_of_edge(self, kind: int) -> None:
        if kind == 3:
            self._indices(1)
        if kind in (3, 4):
            self._at += 1  # how smooth a seam is, behind its second curve: 6CN
        self._indices({1: 2, 2: 3, 3: 2, 4: 4, 5: 2, 6: 3, 7: 4}[kind])
        if kind < 4:
            self._numbers(2 + 4 * (self._version == 2 and kind > 1))

    def _reference(self) -> None:
        """A part of a shape: its orientation and number, and its place."""
        word = self._word()
        if word[:1] not in b"+-ie" or int(word[1:]) < 1:
            raise ValueError(word)
        self._indices(1)
