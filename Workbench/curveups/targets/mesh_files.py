# SPDX-License-Identifier: LGPL-2.1-or-later
"""OBJ, OFF, STL and 3MF meshes as arrays, in the file's own precision and with its vertex numbers: cuts name
vertices by number. FreeCAD's Mesh has single precision, drops unused vertices and skips lines in silence."""

from __future__ import annotations

import functools
import re
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path
from typing import Iterator, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from .polygons import triangles_of

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
        yield V @ at[:3] + at[3], F
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
