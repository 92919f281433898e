# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD surfaces as triangles, through FreeCAD's Part, in a process of their own.

OpenCASCADE's readers of STEP and IGES crash on damaged files and its reader of BREP may never return:
a child process bears that, a time limit ends it, and stopping the work stops it. What it read is
counted against the file, since faces that can't be read are left out without a word.
"""

from __future__ import annotations

import collections
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Callable, Iterator, Optional

import numpy as np

from ..base import freecad_session
from ..base.errors import CurveUpsError, Stopped
from ..base.machine import claim_memory_of_blas, end_with_parent, keep_memory, memory_is_limited
from ..base.native import native, translated
from ..base.output import left_by_killed
from .brep_file import is_whole_brep
from .cad_creases import creases
from .cad_parts import Choice, choose
from .mesh_files import GoOn, Mesh

# Seconds for a file, for each MB of it, and at most: sound files of 10,000 faces have 9 MB (BREP) or 28
# (STEP) and take a tenth of that.
_TIME_LIMIT, _TIME_LIMIT_MB, _TIME_LIMIT_MOST = 60.0, 30.0, 600.0
_LOOK = 0.05        # seconds between looks at whether to go on
_AGAIN = "export it again"
_ASTRAY = 0.01      # of a face's size: its triangles end this near to its edges
_OTHER_AREA = 0.05  # by which their area may differ from the face's
# How far corners and edges of a file may lie from one another and from their faces, of the part's size,
# before that is said, and before the file counts as damaged. OpenCASCADE widens their tolerance so far in
# silence; those of sound files are 1e-7 mm, and a hundredth of a mm where programs calculate coarsely.
_APART, _DAMAGED = 1e-3, 1e-2

# What a file says of its faces. IGES: the directory's lines of trimmed (144) and bounded (143)
# surfaces and of faces (510), each of two lines that begin with the type; BREP: a line "Fa" a face.
_FACES = {
    ".step": re.compile(rb"=\s*(?:ADVANCED_FACE|FACE_SURFACE)\s*\("),
    ".iges": re.compile(rb"^ {5}(?:143|144|510)[ \d]{64}D *\d*[13579]\s*$", re.MULTILINE),
    ".brep": re.compile(rb"^Fa\s*$", re.MULTILINE),
}
# Strings and comments of a STEP file, where numbers are no references.
_WORDS = re.compile(rb"'[^']*'|/\*.*?\*/", re.DOTALL)
_SHELL = re.compile(rb"(?:OPEN|CLOSED)_SHELL\s*\(\s*'[^']*'\s*,\s*\(([#\d,\s]+)\)")
_SAME = {".stp": ".step", ".igs": ".iges", ".brp": ".brep"}
ENDINGS = (*_FACES, *_SAME)


@dataclass(frozen=True)
class Read:
    """A surface (V: N x 3, F: M x 3) and what there is to say of it. `wall`: how thick it is drawn, mm; None
    where it is drawn as a sheet. `creases`: as cad_creases has them; None of what is no CAD part."""

    V: np.ndarray
    F: np.ndarray
    notes: tuple[str, ...] = ()
    wall: Optional[float] = None
    creases: Optional[np.ndarray] = None


def read_cad(path: Path, deflection: float, go_on: GoOn = lambda _: True,
             choice: Choice = Choice()) -> Read:
    """What is chosen of a STEP, IGES or BREP file, mm; `deflection` is the largest distance of the triangles
    from its surface, mm. Raises CurveUpsError, and Stopped where `go_on` says so."""
    data = path.read_bytes()
    time_limit = min(_TIME_LIMIT + _TIME_LIMIT_MB * len(data) / 1e6, _TIME_LIMIT_MOST)
    ending = path.suffix.lower()
    kind = _SAME.get(ending, ending)
    if kind == ".iges" and not _is_whole_iges(data):
        raise CurveUpsError("the file is damaged: lines of it are missing", str(path), _AGAIN)
    if kind == ".brep" and not is_whole_brep(data):
        raise CurveUpsError("the file is damaged: it holds less than it announces", str(path), _AGAIN)
    announced = len(_FACES[kind].findall(data))
    if kind == ".step":
        lost = _lost_entities(data)
        if lost:
            raise CurveUpsError(f"the file is damaged: it has lost {len(lost)} of its entities (#{lost[0]})",
                                str(path), _AGAIN)
        # A shell may list a face whose definition can't be read.
        shells = b",".join(_SHELL.findall(data))
        announced = max(announced, len(set(re.findall(rb"#(\d+)", shells))))
    for left in left_by_killed(Path(tempfile.gettempdir()), "curveups-cad-*"):
        shutil.rmtree(left, ignore_errors=True)
    with tempfile.TemporaryDirectory(prefix=f".{os.getpid()}-curveups-cad-") as folder:
        answer = Path(folder) / "answer.npz"
        # Under a name of its own: FreeCAD's readers want UTF-8, and choose by the ending.
        copy = Path(folder) / f"part{ending}"
        copy.write_bytes(data)
        status = _run(copy, deflection, choice, answer, go_on, time_limit, path)
        if not answer.exists():
            failed = "FreeCAD's reader " + ("crashed" if status < 0 else "broke down")
            raise CurveUpsError(f"{failed}: too little memory, or a damaged file" if memory_is_limited()
                                else f"the file is damaged: {failed}", str(path), _AGAIN)
        with np.load(answer) as found:
            said = json.loads(str(found["said"]))
            V, F = found["V"], found["F"]
            sharp = found["creases"]
    if said["error"]:
        raise CurveUpsError(said["error"], str(path), said["remedy"])
    if said["faces"] < announced:
        raise CurveUpsError(f"only {said['faces']} of the file's {announced} faces could be read",
                            str(path), _AGAIN)
    return Read(V, F, tuple(said["notes"]), said["wall"], sharp)


def _lost_entities(data: bytes) -> list[int]:
    """Numbers that a STEP file refers to and does not define. FreeCAD's reader goes on without them: an edge
    that has lost its curve becomes another, and a cap the whole sphere."""
    text = _WORDS.sub(b"", data)
    defined = set(map(int, re.findall(rb"#(\d+)\s*=", text)))
    return sorted(set(map(int, re.findall(rb"#(\d+)", text))) - defined)


def _is_whole_iges(data: bytes) -> bool:
    """Whether the last line's counts of lines agree with the file."""
    found = collections.Counter(re.findall(rb"^.{72}([SGDP]) *\d+\s*$", data, re.MULTILINE))
    ends = re.findall(rb"^(.{32}).{40}T *\d+\s*$", data, re.MULTILINE)
    said = re.findall(rb"([SGDP]) *(\d+)", ends[-1]) if ends else []
    return len(said) == 4 and all(found[letter] == int(count) for letter, count in said)


def _run(path: Path, deflection: float, choice: Choice, answer: Path, go_on: GoOn,
         time_limit: float, where: Path) -> int:
    command = [freecad_session.python(), "-m", __name__, str(path), repr(deflection), str(answer),
               json.dumps(asdict(choice)), str(os.getpid())]
    child = subprocess.Popen(command, env=freecad_session.environment(), stdin=subprocess.DEVNULL,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + time_limit
    try:
        while True:
            try:
                return child.wait(_LOOK)
            except subprocess.TimeoutExpired:
                pass
            if not go_on(-1.0):
                raise Stopped
            if time.monotonic() > end:
                raise CurveUpsError(f"FreeCAD has not read the file within {time_limit:.0f} s", str(where),
                                    "simplify the part, or export it again or as a mesh")
    finally:
        child.kill()
        child.wait()


def triangles_of_mesh(mesh: Any) -> Mesh:
    """V and F of a Mesh of FreeCAD."""
    points, faces = mesh.Topology
    V = np.array([tuple(point) for point in points], float).reshape(-1, 3)
    return V, np.array(faces, np.int32).reshape(-1, 3)


def surface_of_shape(shape: Any, deflection: float, choice: Choice, where: str) -> Read:
    """What is chosen of a Shape of FreeCAD, as triangles; `where` names it in messages."""
    _, part = freecad_session.load("Part")
    with _freecads_errors(where):
        chosen = choose(shape, choice, where)
        whole = len(chosen.faces) == len(shape.Faces) and not chosen.notes
        V, F = triangles_of_shape(shape if whole else part.Compound(chosen.faces), deflection, where)
        sharp = creases(chosen.faces, V, choice.crease_angle)
    if chosen.opposite:
        other = triangles_of_shape(part.Compound(chosen.opposite), deflection, where)
        with translated(where):
            V = (V + native.closest_points(V, *other)) / 2
    return Read(V, F, tuple(chosen.notes), chosen.wall, sharp)


def triangles_of_shape(shape: Any, deflection: float, where: str) -> Mesh:
    """V and F of a Shape of FreeCAD; `where` names it in messages."""
    _, mesh_part = freecad_session.load("MeshPart")
    with _freecads_errors(where):
        size = shape.BoundBox.DiagonalLength
        mesh = mesh_part.meshFromShape(Shape=shape, LinearDeflection=max(deflection, 1e-5 * size),
                                       AngularDeflection=0.2)
        V, F = triangles_of_mesh(mesh)
        for fault, has_it in _FAULTS:
            faulty = [k for k, face in enumerate(shape.Faces, 1) if has_it(face, size)]
            if faulty:
                faces = f"{len(faulty)} of {len(shape.Faces)} faces (Face{faulty[0]})"
                raise CurveUpsError(fault.format(faces), where, "mend the surface, or export it as a mesh")
    return V, F


@contextmanager
def _freecads_errors(where: str) -> Iterator[None]:
    """FreeCAD raises its own types, bare RuntimeError, and TypeError for a surface of a kind that it does not
    know."""
    try:
        yield
    except (CurveUpsError, MemoryError):
        raise
    except Exception as error:
        raise CurveUpsError("FreeCAD can't make triangles of the surface", where,
                            "mend the surface, or export it as a mesh") from error


def _strays(face: Any, _: float) -> bool:
    """Whether the triangles of a face that OpenCASCADE finds unsound cover something else than what its edges
    bound: where an edge has lost its curve on the surface, or has another's, they end elsewhere, or are more
    than the face's area."""
    if face.isValid():
        return False
    near = _ASTRAY * face.BoundBox.DiagonalLength
    points, triangles = face.tessellate(near / 4)
    V, F = np.array([tuple(point) for point in points], float), np.array(triangles)
    area = np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1).sum() / 2
    if abs(area - face.Area) > _OTHER_AREA * area:
        return True
    sides = np.sort(F[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2))
    sides, count = np.unique(sides, axis=0, return_counts=True)
    rim = sides[count == 1]
    lines = [np.array([tuple(point) for point in edge.discretize(Deflection=near / 4)])
             for edge in face.Edges if not edge.Degenerated]
    ends = np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in lines])
    return bool(_distance(np.concatenate(lines), V[rim]).max() > near
                or _distance(V[np.unique(rim)], ends).max() > near)


def _distance(points: np.ndarray, segments: np.ndarray) -> np.ndarray:
    """Of points (N x 3) from the nearest of the segments (M x 2 x 3)."""
    triangles = np.concatenate([segments, segments[:, 1:]], axis=1).reshape(-1, 3)
    corners = np.arange(len(triangles), dtype=np.int32).reshape(-1, 3)
    return np.linalg.norm(native.closest_points(points, triangles, corners) - points, axis=1)


# What of a face FreeCAD makes triangles of, or makes none, and says nothing.
_FAULTS: tuple[tuple[str, Callable[[Any, float], bool]], ...] = (
    ("FreeCAD can't make triangles of {}", lambda face, size: not face.tessellate(size)[1]),
    ("the outlines of {} do not close", lambda face, _: not all(wire.isClosed() for wire in face.Wires)),
    ("the edges of {} do not bound them", _strays))


def _read(path: Path, deflection: float, choice: Choice) -> tuple[int, Read]:
    """In the child: how many faces there are, and what is chosen of them. Through Part, since the Import
    module crashes on coloured STEP files (0.20.2)."""
    _, part = freecad_session.load("Part")
    try:
        shape = part.read(str(path))
        faces = [] if shape.isNull() else shape.Faces
        apart, size = (shape.globalTolerance(1), shape.BoundBox.DiagonalLength) if faces else (0.0, 0.0)
    except MemoryError:
        raise
    except Exception as error:
        raise CurveUpsError("FreeCAD can't read the file", str(path), _AGAIN) from error
    if not faces:
        raise CurveUpsError("the file holds no surface", str(path), "export the surface itself")
    if apart > _DAMAGED * size:
        raise CurveUpsError(f"the file is damaged: edges and faces of it are {apart:.3g} mm apart", str(path),
                            _AGAIN)
    found = surface_of_shape(shape, deflection, choice, str(path))
    if apart > _APART * size:
        found = replace(found, notes=(*found.notes, f"edges and faces of the file are {apart:.3g} mm apart"))
    return len(faces), found


def _main(path: str, deflection: str, answer: str, choice: str) -> None:
    said: dict[str, Any] = {"error": "", "remedy": "", "faces": 0, "notes": [], "wall": None}
    found = Read(np.zeros((0, 3)), np.zeros((0, 3), np.int32))
    try:
        claim_memory_of_blas()
        said["faces"], found = _read(Path(path), float(deflection), Choice(**json.loads(choice)))
        said.update(notes=found.notes, wall=found.wall)
    except CurveUpsError as error:
        said.update(error=error.what, remedy=error.remedy)
    except MemoryError:
        said.update(error="the file needs more memory than there is", remedy="simplify the part")
    with open(answer + ".part", "wb") as file:  # whole, or not there
        np.savez(file, said=json.dumps(said), V=found.V, F=found.F,
                 creases=np.zeros((0, 2), np.int32) if found.creases is None else found.creases)
    os.replace(answer + ".part", answer)


if __name__ == "__main__":
    end_with_parent(int(sys.argv.pop()))
    keep_memory()
    _main(*sys.argv[1:])
