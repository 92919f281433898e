# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLY files, text and binary: every vertex and face that the header announces, or an error.

FreeCAD's reader leaves out faces that it can't read and takes a number from the next line where one can't
be read. Vertices keep the file's numbers, unused ones too, and the precision of their type.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterable, Optional

import numpy as np

from ..base.errors import CurveUpsError
from .mesh_files import MOST_BYTES, GoOn, Mesh, few_enough, require_corners, require_within, watched
from .polygons import triangles_of

_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
          "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
          "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8"}
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_AGAIN = "export it again"


@dataclass
class _Property:
    name: str
    type: str
    count_type: Optional[str] = None  # of a list


@dataclass
class _Element:
    name: str
    count: int
    properties: list[_Property] = field(default_factory=list)


def read_ply(path: Path, go_on: GoOn) -> Mesh:
    """Vertices and faces of a PLY file; polygons become triangles, other elements are passed over."""
    if path.stat().st_size > MOST_BYTES:
        raise CurveUpsError("the file is too large", str(path), "simplify the mesh")
    data = path.read_bytes()
    data = data.removeprefix(b"\xef\xbb\xbf")
    try:
        order, elements, at = _header(data)
        body: Any = _Bytes(data, at, order, go_on) if order else _Lines(data[at:], go_on)
        V, polygons = np.zeros((0, 3)), None
        for element in elements:
            columns = body.read(element)
            if element.name == "vertex":
                with np.errstate(invalid="ignore"):  # of a signalling NaN
                    V = np.stack([columns[axis] for axis in "xyz"], axis=1).astype(float)
                V = V.reshape(element.count, 3)
            elif element.name == "face":
                polygons = columns.get("vertex_indices", columns.get("vertex_index"))
        if polygons is None:
            raise ValueError("it has no faces with vertex_indices")
    except (ValueError, LookupError, OverflowError) as error:
        what = str(error) if not isinstance(error, KeyError) else f"vertices have no {error}"
        raise CurveUpsError(f"this is no readable PLY file: {what}", str(path), _AGAIN) from None
    if not np.isfinite(V).all():
        raise CurveUpsError("a vertex is not finite", str(path), "repair the mesh")
    few_enough(len(polygons), path)
    if any(not isinstance(corner, int) for polygon in polygons[:1] for corner in polygon):
        raise CurveUpsError("faces name vertices by what is no whole number", str(path), _AGAIN)
    require_corners(polygons, str(path))
    require_within(polygons, len(V), path)
    F = triangles_of(V, polygons)
    few_enough(len(F), path)
    return V, F


def _header(data: bytes) -> tuple[str, list[_Element], int]:
    """Order of bytes ('' for text), elements, and where the header ends."""
    end = data.find(b"end_header")
    first, *lines = data[: max(end, 0)].decode("ascii", "replace").splitlines() or [""]
    if first.strip() != "ply" or end < 0:
        raise ValueError("it has no header")
    order, elements = None, []
    for line in lines:
        words = line.split()
        if not words or words[0] in ("comment", "obj_info"):
            continue
        if words[0] == "format" and len(words) > 1 and words[1] in _ORDERS:
            order = _ORDERS[words[1]]
        elif words[0] == "element" and len(words) == 3 and 0 <= int(words[2]) < 1 << 40:
            elements.append(_Element(words[1], int(words[2])))
        elif words[0] == "property" and elements and len(words) == 3:
            elements[-1].properties.append(_Property(words[2], _TYPES[words[1]]))
        elif words[0] == "property" and elements and len(words) == 5 and words[1] == "list":
            elements[-1].properties.append(_Property(words[4], _TYPES[words[3]], _TYPES[words[2]]))
        else:
            raise ValueError(f"its header has the line '{line.strip()[:60]}'")
    if order is None:
        raise ValueError("its header names no format")
    newline = data.find(b"\n", end)
    return order, elements, newline + 1 if newline >= 0 else len(data)


class _Lines:
    """The body of a text file: a line for each entry."""

    def __init__(self, text: bytes, go_on: GoOn):
        self._rows = [line for line in text.splitlines() if line.strip()]
        self._at = 0
        self._go_on = go_on

    def read(self, element: _Element) -> dict[str, Any]:
        rows = self._rows[self._at : self._at + element.count]
        if len(rows) < element.count:
            raise ValueError(f"it ends early: {element.count} of {element.name} are announced")
        asked = watched(rows, self._go_on, lambda count: (self._at + count - element.count) / len(self._rows))
        self._at += element.count
        if not any(one.count_type for one in element.properties):
            return self._table(element, asked)
        out: dict[str, list] = {one.name: [] for one in element.properties}
        for row in asked:
            words = row.split()
            at = 0
            for one in element.properties:
                end = at + 1
                if one.count_type:
                    at, end = end, end + _count(words[at] if at < len(words) else b"")
                if end > len(words):
                    raise ValueError(f"a {element.name} has too few numbers: {_shown(row)}")
                kind = float if one.type[0] == "f" else int
                found = [kind(word) for word in words[at:end]]
                out[one.name].append(found if one.count_type else found[0])
                at = end
            if at < len(words):
                raise ValueError(f"a {element.name} has too many numbers: {_shown(row)}")
        return out

    @staticmethod
    def _table(element: _Element, rows: Iterable[bytes]) -> dict[str, Any]:
        table, width = [], len(element.properties)
        for row in rows:
            words = row.split()
            if len(words) != width:
                raise ValueError(f"a {element.name} does not have {width} numbers: {_shown(row)}")
            try:
                table.append([float(word) for word in words])
            except ValueError as error:
                raise ValueError(f"a {element.name} has what is no number: {error}") from None
        numbers = np.array(table).reshape(-1, width)
        with np.errstate(over="ignore"):
            return {one.name: numbers[:, k].astype(one.type) if one.type[0] == "f" else numbers[:, k]
                    for k, one in enumerate(element.properties)}


class _Bytes:
    """The body of a binary file."""

    def __init__(self, data: bytes, at: int, order: str, go_on: GoOn):
        self._data, self._at, self._order, self._go_on = data, at, order, go_on

    def read(self, element: _Element) -> dict[str, Any]:
        if element.count == 0:
            return {one.name: [] for one in element.properties}
        # Lists of one length, as nearly all files have them, are a table.
        table = self._table(element)
        return table if table is not None else self._entries(element)

    def _table(self, element: _Element) -> Optional[dict[str, Any]]:
        at, lists = self._at, []
        parts: list[Any] = []
        for k, one in enumerate(element.properties):
            if one.count_type:
                length = _count(self._number(one.count_type, at))
                lists.append((f"n{k}", length))
                parts.append((f"n{k}", self._order + one.count_type))
                parts.append((f"p{k}", self._order + one.type, (length,)))
            else:
                parts.append((f"p{k}", self._order + one.type))
            at = self._at + np.dtype(parts).itemsize
        kind = np.dtype(parts)
        end = self._at + kind.itemsize * element.count
        if end > len(self._data):
            if not lists:
                raise ValueError(f"it ends early: {element.count} of {element.name} are announced")
            return None
        found = np.frombuffer(self._data, kind, element.count, self._at)
        if any((found[name] != length).any() for name, length in lists):
            return None
        self._at = end
        return {one.name: found[f"p{k}"].tolist() if one.count_type else found[f"p{k}"]
                for k, one in enumerate(element.properties)}

    def _entries(self, element: _Element) -> dict[str, Any]:
        if element.count > len(self._data) - self._at:  # a list is a byte or more
            raise ValueError(f"it ends early: {element.count} of {element.name} are announced")
        out: dict[str, list] = {one.name: [] for one in element.properties}
        for _ in watched(range(element.count), self._go_on, lambda _: self._at / len(self._data)):
            for one in element.properties:
                if not one.count_type:
                    out[one.name].append(self._number(one.type, self._at))
                    self._at += np.dtype(one.type).itemsize
                    continue
                length = _count(self._number(one.count_type, self._at))
                self._at += np.dtype(one.count_type).itemsize
                kind = np.dtype(self._order + one.type)
                if self._at + length * kind.itemsize > len(self._data):
                    raise ValueError(f"it ends early: {element.count} of {element.name} are announced")
                out[one.name].append(np.frombuffer(self._data, kind, length, self._at).tolist())
                self._at += length * kind.itemsize
        return out

    def _number(self, kind: str, at: int) -> Any:
        size = np.dtype(kind).itemsize
        if at + size > len(self._data):
            raise ValueError("it ends early")
        return np.frombuffer(self._data, self._order + kind, 1, at)[0].item()


def _count(number: Any) -> int:
    count = int(number)
    if not 0 <= count <= 1_000_000:
        raise ValueError(f"a list has {count} entries")
    return count


def _shown(row: bytes) -> str:
    return "'" + row[:60].decode("ascii", "replace") + "'"
