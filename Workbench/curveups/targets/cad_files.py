# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD surfaces as triangles, through FreeCAD's Part, in a process of their own: OpenCASCADE's readers crash
on damaged files, its reader of BREP may never return, and FreeCAD keeps Python's lock while it makes
triangles, so that a window would stand still."""

from __future__ import annotations

import json
import pickle
import re
import subprocess
import tempfile
import time
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Callable, Iterator, Optional

import numpy as np

from ..base import freecad_session
from ..base.errors import CurveUpsError, Stopped
from ..base.native import native, translated
from .cad_creases import creases
from .cad_parts import Choice, choose
from .mesh_files import Mesh

GoOn = Callable[[float], bool]

_TIME_LIMIT = 300.0  # seconds; sound files of 10,000 faces take a tenth of that
# How a file ends, and its faces: the readers leave out faces that they can't read in silence. IGES: the
# directory's lines of trimmed (144) and bounded (143) surfaces and of faces (510), each of two lines that
# begin with the type; BREP: a line "Fa" a face, a reference to the shape at the end.
_FORMATS = {
    ".step": (rb"END-ISO-10303-21\s*;\s*\Z", rb"=\s*(?:ADVANCED_FACE|FACE_SURFACE)\s*\("),
    ".iges": (rb"T *\d+\s*\Z", rb"(?m)^ {5}(?:143|144|510)[ \d]{64}D *\d*[13579]\s*$"),
    ".brep": (rb"[-+ie]\d+ \d+\s*\Z", rb"(?m)^Fa\s*$"),
}
_SAME = {".stp": ".step", ".igs": ".iges", ".brp": ".brep"}
ENDINGS = (*_FORMATS, *_SAME)
_SHAPE = ".bin"  # a Shape as FreeCAD's exportBinary writes it


@dataclass(frozen=True)
class Read:
    """A surface (V: N x 3, F: M x 3) and notes on it. `wall`: how thick it is drawn, mm; None where it is
    drawn as a sheet. `creases`: as cad_creases has them; None of a mesh."""

    V: np.ndarray
    F: np.ndarray
    notes: tuple[str, ...] = ()
    wall: Optional[float] = None
    creases: Optional[np.ndarray] = None


def read_cad(path: Path, deflection: float, go_on: GoOn = lambda _: True,
             choice: Choice = Choice()) -> Read:
    """The chosen part of a STEP, IGES or BREP file, mm; `deflection` is the largest distance of the triangles
    from its surface, mm. Raises CurveUpsError, and Stopped where `go_on` says so."""
    ending = path.suffix.lower()
    end, face = _FORMATS[_SAME.get(ending, ending)]
    data = path.read_bytes()
    if not re.search(end, data[-200:]):
        raise CurveUpsError("the file ends early, or is none of its format", str(path),
                            "export the file again")
    answer = _answer(path, deflection, choice, str(path), go_on)
    if answer is None:
        raise CurveUpsError("the file is damaged: FreeCAD's reader crashed", str(path),
                            "export the file again")
    count, surface = answer
    announced = len(re.findall(face, data))
    if count < announced:
        raise CurveUpsError(f"only {count} of the file's {announced} faces could be read", str(path),
                            "export the file again")
    return surface


def read_shape(shape: Any, deflection: float, go_on: GoOn, choice: Choice, where: str) -> Read:
    """The chosen part of a Shape of FreeCAD; `where` names it in messages. As read_cad."""
    with tempfile.TemporaryDirectory(prefix="curveups-cad-") as folder, _freecads_errors(where):
        path = Path(folder) / f"shape{_SHAPE}"
        shape.exportBinary(str(path))
        answer = _answer(path, deflection, choice, where, go_on)
    if answer is None:
        raise _no_triangles(where)
    return answer[1]


def _answer(path: Path, deflection: float, choice: Choice, where: str, go_on: GoOn
            ) -> Optional[tuple[int, Read]]:
    """Number of faces in a file, and its surface, as a child process reads them; None where that crashes."""
    with tempfile.TemporaryDirectory(prefix="curveups-cad-") as folder:
        answer = Path(folder) / "answer"
        _run(path, deflection, choice, answer, where, go_on)
        if not answer.exists():
            return None
        count, surface = pickle.loads(answer.read_bytes())
    if not isinstance(surface, Read):
        what, remedy = surface
        raise CurveUpsError(what, where, remedy)
    return count, surface


def _run(path: Path, deflection: float, choice: Choice, answer: Path, where: str, go_on: GoOn) -> None:
    """Reads the file in a child process."""
    command = [freecad_session.python(), "-c", f"import sys, {__name__} as here; here._main(*sys.argv[1:])",
               str(path), repr(deflection), str(answer), json.dumps(asdict(choice))]
    child = subprocess.Popen(command, env=freecad_session.environment(), stdin=subprocess.DEVNULL,
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + _TIME_LIMIT
    try:
        while child.poll() is None:
            time.sleep(0.02)
            if not go_on(-1.0):
                raise Stopped
            if time.monotonic() > end:
                raise CurveUpsError(f"FreeCAD has not made triangles within {_TIME_LIMIT:.0f} s", where,
                                    "simplify the part, or export it again or as a mesh")
    finally:
        child.kill()
        child.wait()


def triangles_of_mesh(mesh: Any) -> Mesh:
    """V and F of a Mesh of FreeCAD."""
    points, faces = mesh.Topology
    V = np.array([tuple(point) for point in points], float).reshape(-1, 3)
    return V, np.array(faces, np.int32).reshape(-1, 3)


def _surface_of_shape(shape: Any, deflection: float, choice: Choice, where: str) -> Read:
    """Triangles of the chosen part of a Shape of FreeCAD; `where` names it in messages."""
    _, part = freecad_session.load("Part")
    with _freecads_errors(where):
        chosen = choose(shape, choice, where)
        V, F = _triangles(part.Compound(chosen.faces), deflection, where)
        sharp = creases(chosen.faces, V, choice.crease_angle)
        if chosen.opposite:
            other = _triangles(part.Compound(chosen.opposite), deflection, where)
            with translated(where):
                V = (V + native.closest_points(V, *other)[0]) / 2
    return Read(V, F, tuple(chosen.notes), chosen.wall, sharp)


def _triangles(shape: Any, deflection: float, where: str) -> Mesh:
    """V and F of a Shape of FreeCAD; `where` names it in messages."""
    _, mesh_part = freecad_session.load("MeshPart")
    size = shape.BoundBox.DiagonalLength
    mesh = mesh_part.meshFromShape(Shape=shape, LinearDeflection=max(deflection, 1e-5 * size),
                                   AngularDeflection=0.2)
    missing = [k for k, face in enumerate(shape.Faces, 1) if not face.tessellate(size)[1]]
    if missing:
        faces = f"{len(missing)} of {len(shape.Faces)} faces (Face{missing[0]})"
        raise CurveUpsError(f"FreeCAD can't make triangles of {faces}", where,
                            "mend the surface, or export it as a mesh")
    return triangles_of_mesh(mesh)


@contextmanager
def _freecads_errors(where: str) -> Iterator[None]:
    """FreeCAD raises its own types, bare RuntimeError, and TypeError for a surface of a kind that it does not
    know."""
    try:
        yield
    except (CurveUpsError, Stopped, MemoryError):
        raise
    except Exception as error:
        raise _no_triangles(where) from error


def _no_triangles(where: str) -> CurveUpsError:
    return CurveUpsError("FreeCAD can't make triangles of the surface", where,
                         "mend the surface, or export it as a mesh")


def _main(path: str, deflection: str, answer: str, choice: str) -> None:
    """Writes the child's answer: the number of faces, and a Read or an error with its remedy. Through Part,
    since the Import module crashes on coloured STEP files (0.20.2)."""
    count = 0
    try:
        _, part = freecad_session.load("Part")
        try:
            shape = part.Shape()
            if path.endswith(_SHAPE):
                shape.importBinary(path)
            else:
                shape = part.read(path)
            count = 0 if shape.isNull() else len(shape.Faces)
        except Exception as error:  # of FreeCAD's own types
            raise CurveUpsError("FreeCAD can't read the file", path, "export the file again") from error
        if not count:
            raise CurveUpsError("the file holds no surface", path, "export the surface itself")
        surface = _surface_of_shape(shape, float(deflection), Choice(**json.loads(choice)), path)
    except CurveUpsError as error:
        Path(answer).write_bytes(pickle.dumps((count, (error.what, error.remedy))))
    else:
        Path(answer).write_bytes(pickle.dumps((count, surface)))
