# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads target files of every format."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Union

import numpy as np

from ..base.errors import CurveUpsError
from . import mesh_files
from .cad_files import ENDINGS, Read, read_cad
from .cad_parts import Choice
from .mesh_files import Mesh
from .ply_file import read_ply
from .stl_file import read_stl

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
