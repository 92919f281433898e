# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything that passes through FreeCAD without a window: target files and documents."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Iterator, Union

import numpy as np

from . import freecad_session, mesh_files
from .cad_files import ENDINGS, Read, read_cad
from .cad_parts import Choice
from .errors import CurveUpsError
from .gui_document import MESH_FLAT_LINES, SHADED, Box, View, finish_document
from .mesh_files import Mesh
from .native import native
from .ply_file import read_ply
from .stl_file import read_stl
from .thumbnail import thumbnail

if TYPE_CHECKING:
    from .project import Results

# Showing the solids of more tiles takes OpenCASCADE's meshing several seconds: the target is shown
# instead of them until they are asked for.
MOST_SHOWN = 800

FORMATS = "an OBJ, STL, PLY, OFF, 3MF, STEP, IGES or BREP"


def read_target(path: Path, deflection: float, go_on: Callable[[], bool] = lambda: True,
                choice: Choice = Choice()) -> Read:
    """The surface in a file, lengths in the file's own unit (CAD formats: mm).

    Of CAD files: `deflection` is the largest distance of the triangles from the surface, mm; `go_on` may
    stop the reading; `choice` says what of the part is the surface.
    """
    require_readable(path)
    reader = _READERS[path.suffix.lower()]
    try:
        if path.stat().st_size == 0:
            raise CurveUpsError("the file is empty", str(path), "export it again")
        read = reader(path, deflection, go_on, choice)
        found = read if isinstance(read, Read) else Read(*read)
    except OSError as error:
        raise _unreadable(path, error) from error
    except MemoryError:
        raise CurveUpsError("the file needs more memory than there is", str(path),
                            "simplify the mesh") from None
    if len(found.F) == 0:
        raise CurveUpsError("the file holds no faces", str(path),
                            "export it again, as a surface of triangles")
    if not np.isfinite(found.V).all():
        raise CurveUpsError("a vertex is not finite", str(path), "repair the mesh")
    return found


def require_readable(path: Path) -> None:
    """Raises CurveUpsError where a target can't be in this file, before anything of it is read."""
    try:
        there, file = path.exists(), path.is_file()
    except (OSError, ValueError) as error:
        raise _unreadable(path, error) from error
    if not there:
        raise CurveUpsError("no such target", str(path),
                            "give a file, or a built-in name from 'curveups targets'")
    if not file:
        raise CurveUpsError("the target is no file", str(path), f"give {FORMATS} file")
    if path.suffix.lower() not in _READERS:
        raise CurveUpsError(f"unknown format '{path.suffix or path.name}'", str(path),
                            f"give {FORMATS} file")


def _unreadable(path: Path, error: Exception) -> CurveUpsError:
    return CurveUpsError(f"the file can't be read: {getattr(error, 'strerror', None) or error}", str(path),
                         "check its name and permissions")


_READERS: dict[str, Callable[..., Union[Mesh, Read]]] = {
    ".obj": lambda path, *_: mesh_files.read_obj(path),
    ".off": lambda path, *_: mesh_files.read_off(path),
    ".3mf": lambda path, *_: mesh_files.read_3mf(path),
    ".stl": lambda path, *_: read_stl(path),
    ".ply": lambda path, *_: read_ply(path),
    **{ending: read_cad for ending in ENDINGS},
}


def write_document(results: Results, path: Path) -> dict[str, str]:
    """The parametric document of a run's results, saved to `path`; returns versions of software.

    Shapes are kept in the file (2500 tiles: 2 s, 17 MB), so that a FreeCAD without this workbench
    shows them too.
    """
    freecad, part, _ = freecad_session.load("Part", "Mesh")
    from .features import document as documents
    from .features.bodies import KINDS

    # A name that FreeCAD would take for another document's file is no harm: it is never shown.
    document = freecad.newDocument("CurveUps", hidden=True, temp=True)
    try:
        design = documents.design_with_results(document, results)
        broken = [obj.Name for obj in document.Objects if "Invalid" in obj.State]
        if broken:
            raise CurveUpsError(f"the document's {broken[0]} can't be computed", results.name,
                                "see FreeCAD's report view")
        shown = documents.visibility(design, solids=len(results.design.F) <= MOST_SHOWN)
        for name, value in shown.items():
            document.getObject(name).Visibility = value
        with _binary_shapes(freecad):
            document.saveAs(str(path))
    finally:
        freecad.closeDocument(document.Name)
    # As in STEP and 3MF, the target in the colour of its tiles.
    colours = {name: native.COLOURS[kind] for name, kind in {**KINDS, "Target": "tiles"}.items()}
    views = [View(name, value, colours.get(name), MESH_FLAT_LINES if name == "Target" else SHADED)
             for name, value in shown.items()]
    V, F = results.design.V, results.design.F
    finish_document(path, results.title, views,
                    _print_box(results["solids"].model) if shown["Tiles"] else _box(V),
                    thumbnail(V, F, native.COLOURS["tiles"]))
    return {"freecad": freecad_session.version(freecad), "occt": part.OCC_VERSION}


@contextmanager
def _binary_shapes(freecad: Any) -> Iterator[None]:
    """Shapes saved in binary: all bits of them, in a third less time and space than as text."""
    preferences = freecad.ParamGet("User parameter:BaseApp/Preferences/Document")
    before = preferences.GetBool("SaveBinaryBrep", False)
    preferences.SetBool("SaveBinaryBrep", True)
    try:
        yield
    finally:
        preferences.SetBool("SaveBinaryBrep", before)


def _print_box(model: Any) -> Box:
    """The print stands on z = 0, centred on the origin."""
    x, y, z = model.bbox
    return (-x / 2, -y / 2, 0.0), (x / 2, y / 2, z)


def _box(V: np.ndarray) -> Box:
    return V.min(axis=0), V.max(axis=0)
