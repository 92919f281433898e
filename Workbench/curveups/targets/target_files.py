# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads target files of every format."""

from __future__ import annotations

from pathlib import Path
from typing import Callable

import numpy as np

from ..base.errors import CurveUpsError
from . import mesh_files
from .cad_files import ENDINGS, Read, read_cad
from .cad_parts import Choice
from .mesh_files import GoOn, Mesh
from .ply_file import read_ply
from .stl_file import read_stl

FORMATS = "an OBJ, STL, PLY, OFF, 3MF, STEP, IGES or BREP"


def read_target(path: Path, deflection: float, go_on: GoOn = lambda _: True,
                choice: Choice = Choice()) -> Read:
    """The surface in a file, lengths in the file's own unit (CAD formats: mm).

    `go_on` may stop the reading. Of CAD files: `deflection` is the largest distance of the triangles from the
    surface, mm; `choice` says what of the part is the surface. Raises CurveUpsError, and Stopped.
    """
    require_readable(path)
    try:
        if path.stat().st_size == 0:
            raise CurveUpsError("the file is empty", str(path), "export it again")
        if path.suffix.lower() in ENDINGS:
            found = read_cad(path, deflection, go_on, choice)
        else:
            found = Read(*_MESHES[path.suffix.lower()](path, go_on))
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
    if path.suffix.lower() not in (*_MESHES, *ENDINGS):
        raise CurveUpsError(f"unknown format '{path.suffix or path.name}'", str(path),
                            f"give {FORMATS} file")


def _unreadable(path: Path, error: Exception) -> CurveUpsError:
    return CurveUpsError(f"the file can't be read: {getattr(error, 'strerror', None) or error}", str(path),
                         "check its name and permissions")


_MESHES: dict[str, Callable[[Path, GoOn], Mesh]] = {
    ".obj": mesh_files.read_obj, ".off": mesh_files.read_off, ".3mf": mesh_files.read_3mf, ".stl": read_stl,
    ".ply": read_ply,
}
