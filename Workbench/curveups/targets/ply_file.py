# SPDX-License-Identifier: LGPL-2.1-or-later
"""PLY files, text and binary. Vertices keep the file's numbers and their precision."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any, Callable, NamedTuple

import numpy as np

from ..base.errors import CurveUpsError
from .mesh_files import Mesh, mesh_of

# Letters of the module struct.
_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f",
          "double": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I",
          "float32": "f", "float64": "d"}
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_Take = Callable[[str, int], Any]  # so many numbers of this type, from where the last ended


class _Element(NamedTuple):
    """`properties`: name, type, and the type of the count before a list, or ''."""

    name: str
    rows: int
    properties: list[tuple[str, str, str]]


def read_ply(path: Path) -> Mesh:
    """Vertices and faces of a PLY file; other elements are passed over."""
    try:
        data = path.read_bytes()
        order, elements, start = _header(data)
        take = _binary(data, start, order) if order else _text(data[start:])
        rows = {element.name: _rows(element, take) for element in elements}
        V = np.array([[row[axis][0] for axis in "xyz"] for row in rows["vertex"]], float)
        polygons = [list(map(int, row.get("vertex_indices", row.get("vertex_index"))))
                    for row in rows["face"]]
    except (ValueError, LookupError, TypeError, struct.error) as error:
        raise CurveUpsError(f"this is no readable PLY file, or it ends early: {error}", str(path),
                            "export the file again") from None
    return mesh_of(V, polygons, path)


def _header(data: bytes) -> tuple[str, list[_Element], int]:
    """Order of bytes ('' for text), elements, and where the header ends."""
    end = data.index(b"end_header")
    order, elements = "", list[_Element]()
    for line in data[:end].decode("ascii", "replace").splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            order = _ORDERS[words[1]]
        elif words[:1] == ["element"]:
            elements.append(_Element(words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1].properties.append((words[4], _TYPES[words[3]], _TYPES[words[2]]))
        elif words[:1] == ["property"]:
            elements[-1].properties.append((words[2], _TYPES[words[1]], ""))
    return order, elements, data.index(b"\n", end) + 1


def _text(text: bytes) -> _Take:
    words = iter(text.split())

    def take(kind: str, count: int) -> Any:
        numbers = [(float if kind in "fd" else int)(word) for _, word in zip(range(count), words)]
        if len(numbers) < count:
            raise ValueError(f"{count - len(numbers)} numbers are missing")
        return numbers

    return take


def _binary(data: bytes, at: int, order: str) -> _Take:
    def take(kind: str, count: int) -> Any:
        nonlocal at
        numbers = struct.unpack_from(f"{order}{count}{kind}", data, at)
        at += struct.calcsize(f"{order}{count}{kind}")
        return numbers

    return take


def _rows(element: _Element, take: _Take) -> list[dict[str, Any]]:
    """Numbers of each row by property."""
    return [{name: take(kind, take(count, 1)[0] if count else 1) for name, kind, count in element.properties}
            for _ in range(element.rows)]
