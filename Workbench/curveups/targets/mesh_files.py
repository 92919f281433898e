# SPDX-License-Identifier: LGPL-2.1-or-later
"""OBJ, OFF, STL, 3MF and PLY meshes as arrays, in the file's own precision and with its vertex numbers:
cuts name vertices by number. FreeCAD's Mesh has single precision, drops unused vertices and skips lines."""

from __future__ import annotations

import functools
import re
import struct
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path
from typing import Any, Callable, Iterator, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.native import native

Mesh = tuple[np.ndarray, np.ndarray]  # V (N x 3) and F (M x 3)

MOST_FACES = 5_000_000  # more are no work for tiles of a printable size
_3MF_UNITS = {"micron": 1e-3, "millimeter": 1.0, "centimeter": 10.0, "inch": 25.4,
              "foot": 304.8, "meter": 1000.0}
_STL_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def mesh_of(vertices: Sequence[Sequence[float]] | np.ndarray, polygons: Sequence[Sequence[int]],
            path: Path) -> Mesh:
    """Arrays of a file's vertices and polygons, which become triangles. Raises CurveUpsError."""
    V = np.array(vertices, float).reshape(-1, 3)
    if len(polygons) > MOST_FACES:
        raise CurveUpsError(f"the mesh has more than {MOST_FACES} faces", str(path), "simplify the mesh")
    fewest = min(map(len, polygons), default=3)
    if fewest < 3:
        raise CurveUpsError(f"a face has {fewest} corners", str(path), "repair the mesh")
    if any(min(polygon) < 0 or max(polygon) >= len(V) for polygon in polygons):
        raise CurveUpsError(f"a face names a vertex that is not there ({len(V)} are)", str(path),
                            "repair the mesh")
    return V, triangles_of(V, polygons)


def read_obj(path: Path) -> Mesh:
    """Vertices and faces of a Wavefront OBJ; all else is passed over."""
    vertices: list[list[float]] = []
    faces: list[list[int]] = []
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        text = file.read().replace("\\\n", " ")  # a line that goes on in the next
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if not words or words[0] not in ("v", "f"):
            continue
        try:
            if words[0] == "v":
                x, y, z = map(float, words[1:4])
                vertices.append([x, y, z])
            else:
                faces.append([_obj_index(word, len(vertices)) for word in words[1:]])
        except ValueError:
            raise CurveUpsError(f"'{line.strip()[:40]}' can't be read", f"{path}, line {number}",
                                "export the file again") from None
    return mesh_of(vertices, faces, path)


def _obj_index(word: str, count: int) -> int:
    """Row of a vertex: OBJ numbers them from 1, or backwards from the last one so far."""
    index = int(word.split("/")[0])
    if index == 0:
        raise ValueError(word)
    return index - 1 if index > 0 else count + index


def read_off(path: Path) -> Mesh:
    """Vertices and faces of an OFF file (ASCII); colours are passed over."""
    if re.match(rb"\s*(?:ST|C|N|4|n)*OFF\s+BINARY", path.read_bytes()[:80]):
        raise CurveUpsError("this is a binary OFF file", str(path), "save it as text, or as STL or PLY")
    lines = path.read_text(encoding="utf-8-sig", errors="replace").splitlines()
    rows = [(number, words) for number, line in enumerate(lines, 1) if (words := line.split("#")[0].split())]
    number = 1
    try:
        number, words = rows.pop(0)
        if words[0] != "OFF":
            raise CurveUpsError("this is no OFF file", str(path), "its first word has to be OFF")
        if len(words) == 1:
            number, words = rows.pop(0)
            words = ["OFF", *words]
        vertex_count, face_count = int(words[1]), int(words[2])
        vertices, faces = [], []
        for number, words in rows[:vertex_count]:
            x, y, z = map(float, words[:3])
            vertices.append((x, y, z))
        for number, words in rows[vertex_count:vertex_count + face_count]:
            corners = list(map(int, words[:1 + int(words[0])]))
            if len(corners) != 1 + corners[0]:
                raise ValueError(words)
            faces.append(corners[1:])
    except (ValueError, IndexError):
        raise CurveUpsError("the line can't be read", f"{path}, line {number}",
                            "export the file again") from None
    if len(faces) < face_count:
        raise CurveUpsError("the file ends early", str(path), "export the file again")
    return mesh_of(vertices, faces, path)


def read_stl(path: Path) -> Mesh:
    """Facets of an STL file, text or binary, equal corners merged. Vertices come in the order of their
    coordinates, as FreeCAD has them."""
    data = path.read_bytes()
    count = int.from_bytes(data[80:84], "little")
    if len(data) >= 84 + _STL_FACET.itemsize * count and not _is_text(data):
        corners = np.frombuffer(data, _STL_FACET, count, 84)["corners"]
    elif _is_text(data):
        points = re.findall(rb"^\s*vertex\s+(\S+)\s+(\S+)\s+(\S+)\s*$", data, re.MULTILINE | re.IGNORECASE)
        facets = len(re.findall(rb"^\s*endfacet\b", data, re.MULTILINE | re.IGNORECASE))
        if len(points) != 3 * facets or not re.search(rb"endsolid[^\r\n]*\s*$", data, re.IGNORECASE):
            raise CurveUpsError("a facet can't be read, or the file ends early", str(path),
                                "export the file again")
        try:
            corners = np.array(points, "S").astype(float).astype(np.float32)
        except ValueError as error:
            raise CurveUpsError(f"a facet can't be read: {error}", str(path),
                                "export the file again") from None
    else:
        raise CurveUpsError("this is no STL file, or it ends early", str(path), "export the file again")
    # Zeros of both signs are one.
    V, F = np.unique(corners.reshape(-1, 3) + np.float32(0), axis=0, return_inverse=True)
    return mesh_of(V, F.reshape(-1, 3).tolist(), path)


def _is_text(data: bytes) -> bool:
    start = data[:2000].removeprefix(b"\xef\xbb\xbf").lower()
    return start.lstrip().startswith(b"solid") and b"facet" in start


def read_3mf(path: Path) -> Mesh:
    """All objects of a 3MF's build, in millimetres."""
    try:
        with zipfile.ZipFile(path) as archive:
            root = ElementTree.fromstring(archive.read("3D/3dmodel.model"))
        unit = _3MF_UNITS[root.get("unit", "millimeter")]
        parts = list(_3mf_parts(root))
    except (zipfile.BadZipFile, ElementTree.ParseError, LookupError, ValueError, OverflowError,
            RecursionError) as error:
        raise CurveUpsError(f"this is no readable 3MF file: {error}", str(path),
                            "export the file again") from None
    offsets = np.cumsum([0, *(len(V) for V, _ in parts)])
    V = np.vstack([np.empty((0, 3)), *(V * unit for V, _ in parts)])
    F = np.vstack([np.empty((0, 3), int), *(F + offset for (_, F), offset in zip(parts, offsets))])
    return mesh_of(V, F.tolist(), path)


def _3mf_parts(root: ElementTree.Element) -> Iterator[Mesh]:
    """Meshes of the build, each where it stands."""
    space = root.tag[: root.tag.find("}") + 1]
    objects = {item.get("id"): item for item in root.iter(f"{space}object")}

    @functools.lru_cache(None)
    def own(identity: str) -> Mesh:
        V = [[float(v.get(axis, "")) for axis in "xyz"] for v in objects[identity].iter(f"{space}vertex")]
        F = [[int(t.get(f"v{k}", "")) for k in "123"] for t in objects[identity].iter(f"{space}triangle")]
        return np.array(V, float).reshape(-1, 3), np.array(F, int).reshape(-1, 3)

    def place(identity: str, at: np.ndarray) -> Iterator[Mesh]:
        V, F = own(identity)
        mirrored = np.linalg.det(at[:3]) < 0  # outsides stay outside
        yield V @ at[:3] + at[3], F[:, ::-1] if mirrored else F
        for part in objects[identity].iter(f"{space}component"):
            inner = _transform(part)
            yield from place(part.get("objectid", ""),
                             np.vstack([inner[:3] @ at[:3], inner[3] @ at[:3] + at[3]]))

    for item in root.iter(f"{space}item"):
        yield from place(item.get("objectid", ""), _transform(item))


def _transform(element: ElementTree.Element) -> np.ndarray:
    """3MF's row-vector transform as a 4 x 3 matrix."""
    text = element.get("transform", "1 0 0 0 1 0 0 0 1 0 0 0")
    return np.array([float(word) for word in text.split()]).reshape(4, 3)


def triangles_of(V: np.ndarray, polygons: Sequence[Sequence[int]]) -> np.ndarray:
    """M x 3: fans of the convex polygons; the others divided in their plane, where a fan would reach
    outside. Polygons that cross themselves there become fans: what is wrong with them is checked later.
    Corners are rows of V (N x 3), three or more of each polygon, which keep their order."""
    if all(len(polygon) == 3 for polygon in polygons):
        return np.array(polygons, np.int32).reshape(-1, 3)
    concave = _concave(V, polygons)
    triangles: list[tuple[int, int, int]] = []
    for number, corners in enumerate(polygons):
        divided = native.triangulate_polygon(V[list(corners)]) if number in concave else []
        triangles.extend((corners[a], corners[b], corners[c]) for a, b, c in divided)
        if not divided:
            triangles.extend((corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1))
    return np.array(triangles, np.int32).reshape(-1, 3)


@np.errstate(over="ignore", invalid="ignore")  # what overflows is too large for a target
def _concave(V: np.ndarray, polygons: Sequence[Sequence[int]]) -> set[int]:
    """Numbers of the polygons that turn against their normal somewhere."""
    sizes = np.array([len(polygon) for polygon in polygons])
    concave: set[int] = set()
    for size in np.unique(sizes[sizes > 3]):
        numbers = np.nonzero(sizes == size)[0]
        corners = V[np.array([polygons[number] for number in numbers])]
        sides = np.roll(corners, -1, axis=1) - corners
        # Newell's normal, and the turn at every corner.
        normal = np.cross(corners - corners[:, :1], sides).sum(axis=1)
        turns = np.einsum("pcx,px->pc", np.cross(sides, np.roll(sides, -1, axis=1)), normal)
        least = -1e-9 * np.einsum("px,px->p", normal, normal)
        concave.update(numbers[(turns < least[:, None]).any(axis=1)].tolist())
    return concave


# Letters of the module struct.
_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f",
          "double": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I",
          "float32": "f", "float64": "d"}
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_Take = Callable[[str, int], Any]  # so many numbers of this type, from where the last ended


def read_ply(path: Path) -> Mesh:
    """Vertices and faces of a PLY file; other elements are passed over."""
    try:
        header, data = path.read_bytes().split(b"end_header", 1)
        data = data[data.index(b"\n") + 1:]
        order, elements = "", dict[str, tuple[int, list[tuple[str, str, str]]]]()
        properties: list[tuple[str, str, str]] = []
        for line in header.decode("ascii", "replace").splitlines():
            words = line.split()
            if words[:1] == ["format"]:
                order = _ORDERS[words[1]]
            elif words[:1] == ["element"]:  # number of rows; name, type and type of the count (of lists)
                properties = []
                elements[words[1]] = int(words[2]), properties
            elif words[:2] == ["property", "list"]:
                properties.append((words[4], _TYPES[words[3]], _TYPES[words[2]]))
            elif words[:1] == ["property"]:
                properties.append((words[2], _TYPES[words[1]], ""))
        take = _binary(data, order) if order else _text(data)
        rows = {element: [{name: take(kind, take(count, 1)[0] if count else 1)
                           for name, kind, count in properties} for _ in range(number)]
                for element, (number, properties) in elements.items()}
        V = np.array([[row[axis][0] for axis in "xyz"] for row in rows["vertex"]], float)
        polygons = [list(map(int, row.get("vertex_indices", row.get("vertex_index"))))
                    for row in rows["face"]]
    except (ValueError, LookupError, TypeError, struct.error) as error:
        raise CurveUpsError(f"this is no readable PLY file, or it ends early: {error}", str(path),
                            "export the file again") from None
    return mesh_of(V, polygons, path)


def _text(text: bytes) -> _Take:
    words = iter(text.split())

    def take(kind: str, count: int) -> Any:
        numbers = [(float if kind in "fd" else int)(word) for _, word in zip(range(count), words)]
        if len(numbers) < count:
            raise ValueError(f"{count - len(numbers)} numbers are missing")
        return numbers

    return take


def _binary(data: bytes, order: str) -> _Take:
    at = 0

    def take(kind: str, count: int) -> Any:
        nonlocal at
        numbers = struct.unpack_from(f"{order}{count}{kind}", data, at)
        at += struct.calcsize(f"{order}{count}{kind}")
        return numbers

    return take
