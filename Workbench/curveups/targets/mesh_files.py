# SPDX-License-Identifier: LGPL-2.1-or-later
"""OBJ, OFF and 3MF meshes as arrays, in double precision and with the file's own vertex numbers.

FreeCAD's Mesh drops unused vertices of an OBJ, skips lines that it can't read (a vertex with a NaN
shifts every index behind it) and, in 0.20, does not read 3MF. Cuts name vertices by number, so meshes
are read by own code: STL and PLY in files of their own, CAD formats through FreeCAD (cad_files).
"""

from __future__ import annotations

import functools
import itertools
import math
import xml.etree.ElementTree as ElementTree
import zipfile
import zlib
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Sequence, TypeVar

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from .polygons import triangles_of

Mesh = tuple[np.ndarray, np.ndarray]
GoOn = Callable[[float], bool]  # told how much is read (0 to 1, negative where unknown); whether to go on
_Item = TypeVar("_Item")

# A target of more faces than this is no work for tiles of a printable size.
MOST_FACES = 5_000_000
MOST_BYTES = 2_000_000_000
MOST_3MF_BYTES = 600_000_000  # unpacked; what XML becomes in memory is ten times as large
MOST_OBJECTS = 20_000  # of a 3MF's build, each as often as it is named
_3MF_UNITS = {"micron": 1e-3, "millimeter": 1.0, "centimeter": 10.0, "inch": 25.4,
              "foot": 304.8, "meter": 1000.0}


def watched(items: Iterable[_Item], go_on: GoOn, read: Callable[[int], float],
            stride: int = 5000) -> Iterator[_Item]:
    """The items; `read`: how much of a file is read after so many. Raises Stopped."""
    for number, item in enumerate(items):
        if not number % stride and not go_on(read(number)):
            raise Stopped
        yield item


def read_obj(path: Path, go_on: GoOn) -> Mesh:
    """Vertices and faces of a Wavefront OBJ; polygons become triangles, all else is passed over."""
    vertices: list[tuple[float, float, float]] = []
    faces: list[list[int]] = []
    for number, line in _continued(_lines(path, go_on)):
        words = line.split()
        if not words:
            continue
        where = f"{path}, line {number}"
        if words[0] == "v":
            vertices.append(_vertex(words[1:], where))
        elif words[0] == "f":
            faces.append([_obj_index(word, len(vertices), where) for word in words[1:]])
            require_corners(faces[-1:], where)
    return _arrays(vertices, faces, path)


def read_off(path: Path, go_on: GoOn) -> Mesh:
    """Vertices and faces of an OFF file (ASCII, no colours needed)."""
    rows = ((number, words) for number, line in _lines(path, go_on)
            if (words := line.split("#")[0].split()))
    nothing: list[str] = []
    number, words = next(rows, (1, nothing))
    if not words or words[0] != "OFF":
        raise CurveUpsError("this is no OFF file", f"{path}, line {number}",
                            "its first word has to be OFF")
    counts = words[1:] or next(rows, (number, nothing))[1]
    try:
        vertex_count, face_count = int(counts[0]), int(counts[1])
    except (IndexError, ValueError):
        raise CurveUpsError("the numbers of vertices and faces are missing",
                            f"{path}, line {number}", "export the file again") from None
    vertices: list[tuple[float, float, float]] = []
    faces: list[list[int]] = []
    for number, words in rows:
        where = f"{path}, line {number}"
        if len(vertices) < vertex_count:
            vertices.append(_vertex(words, where))
        elif len(faces) < face_count:
            corners = _integers(words, where)
            if len(corners) < corners[0] + 1 or corners[0] < 0:
                raise CurveUpsError("a face has fewer corners than it says", where,
                                    "export the file again")
            faces.append(corners[1 : corners[0] + 1])
    if len(vertices) < vertex_count or len(faces) < face_count:
        raise CurveUpsError("the file ends early", str(path), "export the file again")
    require_corners(faces, str(path))
    return _arrays(vertices, faces, path)


def read_3mf(path: Path, go_on: GoOn) -> Mesh:
    """All objects of a 3MF's build (or all objects, where nothing is built), in millimetres."""
    try:
        with zipfile.ZipFile(path) as archive:
            entry = archive.getinfo(_model_part(archive))
            if entry.file_size > MOST_3MF_BYTES:
                raise CurveUpsError("the 3MF model is too large", str(path), "simplify the mesh")
            parser = ElementTree.XMLParser()
            with archive.open(entry) as model:
                for piece in watched(iter(lambda: model.read(1 << 16), b""), go_on,
                                     lambda count: 0.5 * (count << 16) / max(entry.file_size, 1), stride=1):
                    parser.feed(piece)
            root = parser.close()
    except (zipfile.BadZipFile, LookupError, ValueError, zlib.error, EOFError, RuntimeError,
            ElementTree.ParseError) as error:
        # LookupError and ValueError: an encoding that is not known, or that the parser does not take;
        # RuntimeError: encrypted, or compressed in a way that zipfile does not know.
        raise CurveUpsError(f"this is no readable 3MF file: {error}", str(path),
                            "export the file again") from None
    namespace = root.tag[: root.tag.find("}") + 1]
    unit = _3MF_UNITS.get(root.get("unit", "millimeter"))
    if unit is None:
        raise CurveUpsError(f"unknown unit '{root.get('unit')}'", str(path),
                            "export in millimetres")
    parts_v, parts_f, offset, count = [np.empty((0, 3))], [np.empty((0, 3), np.int32)], 0, 0
    try:
        for vertices, faces in _3mf_meshes(root, namespace, go_on):
            if len(faces) and (faces.min() < 0 or faces.max() >= len(vertices)):
                raise CurveUpsError("a face names a vertex that is not there", str(path),
                                    "export the file again")
            parts_v.append(vertices * unit)
            parts_f.append(faces + offset)
            offset += len(vertices)
            count += len(faces)
            few_enough(max(count, offset // 3), path)
    except (LookupError, ValueError, TypeError, OverflowError, RecursionError) as error:
        raise CurveUpsError(f"broken 3MF model: {error}", str(path),
                            "export the file again") from None
    return np.vstack(parts_v), np.vstack(parts_f).astype(np.int32)


def _model_part(archive: zipfile.ZipFile) -> str:
    names = [name for name in archive.namelist() if name.lower().endswith(".model")]
    if not names:
        raise KeyError("it holds no model")
    return min(names, key=lambda name: (name.lower() != "3d/3dmodel.model", name))


def _3mf_meshes(root: Any, namespace: str, go_on: GoOn) -> Iterator[Mesh]:
    """The meshes of the build, each as often as it is there."""
    objects = {item.get("id"): item for item in root.iter(namespace + "object")}
    visits = 0

    def halfway(elements: Iterable[Any]) -> Iterator[Any]:
        return watched(elements, go_on, lambda _: 0.5)

    @functools.lru_cache(None)
    def own(identity: str) -> Mesh:
        mesh = objects[identity]
        vertices = np.array([[float(v.get(axis)) for axis in "xyz"]
                             for v in halfway(mesh.iter(namespace + "vertex"))]).reshape(-1, 3)
        faces = np.array([[int(t.get(corner)) for corner in ("v1", "v2", "v3")]
                          for t in halfway(mesh.iter(namespace + "triangle"))], int).reshape(-1, 3)
        return vertices, faces

    def collect(identity: str, transform: np.ndarray, depth: int) -> Iterator[Mesh]:
        # Ten components of ten of ten ... are few lines and endless work.
        nonlocal visits
        visits += 1
        if depth > 16 or visits > MOST_OBJECTS:
            raise ValueError("components are nested too deeply")
        vertices, faces = own(identity)
        yield _placed(vertices, transform), faces
        for part in objects[identity].iter(namespace + "component"):
            yield from collect(part.get("objectid"),
                               _compose(_transform(part.get("transform")), transform), depth + 1)

    build = [(item.get("objectid"), item.get("transform")) for item in root.iter(namespace + "item")]
    for identity, transform in build or [(identity, None) for identity in objects]:
        yield from collect(identity, _transform(transform), 0)


def _transform(text: str | None) -> np.ndarray:
    """3MF's row-vector transform as a 4 x 3 matrix."""
    if text is None:
        return np.vstack([np.eye(3), np.zeros(3)])
    return np.array([float(word) for word in text.split()]).reshape(4, 3)


@np.errstate(all="ignore")  # what overflows is no number, which is noticed
def _placed(points: np.ndarray, transform: np.ndarray) -> np.ndarray:
    return points @ transform[:3] + transform[3]


@np.errstate(all="ignore")
def _compose(inner: np.ndarray, outer: np.ndarray) -> np.ndarray:
    return np.vstack([inner[:3] @ outer[:3], _placed(inner[3], outer)])


def _lines(path: Path, go_on: GoOn) -> Iterator[tuple[int, str]]:
    size = path.stat().st_size
    if size > MOST_BYTES:
        raise CurveUpsError("the file is too large", str(path), "simplify the mesh")
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        yield from enumerate(watched(file, go_on, lambda _: file.buffer.tell() / max(size, 1)), 1)


def _vertex(words: list[str], where: str) -> tuple[float, float, float]:
    try:
        x, y, z = (float(word) for word in words[:3])
    except ValueError:
        raise CurveUpsError("a vertex does not have three numbers", where,
                            "export the file again") from None
    if not (math.isfinite(x) and math.isfinite(y) and math.isfinite(z)):
        raise CurveUpsError("a vertex is not finite", where, "repair the mesh")
    return x, y, z


def _integers(words: list[str], where: str) -> list[int]:
    try:
        # Colours may follow the corners.
        count = int(words[0])
        return [int(word) for word in words[: max(count, 0) + 1]]
    except ValueError:
        raise CurveUpsError("a face has a corner that is no number", where,
                            "export the file again") from None


def _obj_index(word: str, count: int, where: str) -> int:
    """OBJ numbers vertices from 1, or backwards from the last one so far."""
    try:
        index = int(word.split("/")[0])
    except ValueError:
        raise CurveUpsError(f"a face has the corner '{word[:20]}'", where,
                            "export the file again") from None
    if index == 0 or -index > count:
        raise CurveUpsError(f"a face names the vertex {index}, which is not there", where,
                            "repair the mesh")
    return index - 1 if index > 0 else count + index


def _continued(lines: Iterator[tuple[int, str]]) -> Iterator[tuple[int, str]]:
    """A line that ends with a backslash goes on in the next; a comment does not (one may end with a folder
    of Windows)."""
    begun: list[str] = []
    first = 0
    for number, line in lines:
        first = first or number
        text = line.rstrip()
        if text.endswith("\\") and not (begun or [text])[0].lstrip().startswith("#"):
            begun.append(text[:-1])
            continue
        yield first, " ".join((*begun, line))
        begun, first = [], 0
    if begun:
        yield first, " ".join(begun)


def require_corners(faces: Sequence[Sequence[int]], where: str) -> None:
    """Raises CurveUpsError where a face has fewer than three corners."""
    for face in faces:
        if len(face) < 3:
            raise CurveUpsError(f"a face has {len(face)} corners", where, "repair the mesh")


def require_within(faces: Sequence[Sequence[int]], count: int, path: Path) -> None:
    """Raises CurveUpsError where a face names a vertex that is not among the `count`."""
    try:
        named = np.fromiter(itertools.chain.from_iterable(faces), np.int64)
    except OverflowError:
        named = np.array([count])
    if named.size and (named.min() < 0 or named.max() >= count):
        raise CurveUpsError(f"a face names a vertex that is not there ({count} are)",
                            str(path), "repair the mesh")


def few_enough(count: int, path: Path) -> None:
    """Raises CurveUpsError for more faces than there can be tiles from."""
    if count > MOST_FACES:
        raise CurveUpsError(f"the mesh has more than {MOST_FACES} faces", str(path), "simplify the mesh")


def _arrays(vertices: list, faces: list[list[int]], path: Path) -> Mesh:
    few_enough(len(faces), path)
    require_within(faces, len(vertices), path)
    V = np.array(vertices, float).reshape(-1, 3)
    F = triangles_of(V, faces)
    few_enough(len(F), path)
    return V, F
