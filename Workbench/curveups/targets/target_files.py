# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads target files of every format."""

from __future__ import annotations

from pathlib import Path
from typing import Callable

import numpy as np

from ..base.errors import CurveUpsError
from .cad_files import ENDINGS, GoOn, Read, read_cad
from .cad_parts import Choice
from .mesh_files import Mesh, read_3mf, read_obj, read_off, read_ply, read_stl

_MESHES: dict[str, Callable[[Path], Mesh]] = {".obj": read_obj, ".off": read_off, ".3mf": read_3mf,
                                              ".stl": read_stl, ".ply": read_ply}
FORMATS = "an OBJ, STL, PLY, OFF, 3MF, STEP, IGES or BREP"


def read_target(path: Path, deflection: float, go_on: GoOn = lambda _: True,
                choice: Choice = Choice()) -> Read:
    """The surface in a file, lengths in the file's own unit (CAD formats: mm).

    `go_on` may stop the reading of CAD files, of which `deflection` is the largest distance of the triangles
    from the surface, mm, and `choice` the part that is the surface. Raises CurveUpsError, and Stopped.
    """
    require_readable(path)
    ending = path.suffix.lower()
    try:
        surface = (read_cad(path, deflection, go_on, choice) if ending in ENDINGS
                   else Read(*_MESHES[ending](path)))
    except OSError as error:
        raise CurveUpsError(f"the file can't be read: {error.strerror or error}", str(path),
                            "check its name and permissions") from error
    if len(surface.F) == 0:
        raise CurveUpsError("the file holds no faces", str(path),
                            "export it again, as a surface of triangles")
    if not np.isfinite(surface.V).all():
        raise CurveUpsError("a vertex is not finite", str(path), "repair the mesh")
    return surface


def require_readable(path: Path) -> None:
    """Raises CurveUpsError where a target can't be in this file, before anything of it is read."""
    if not path.exists():
        raise CurveUpsError("no such target", str(path),
                            "give a file, or a built-in name from 'curveups targets'")
    if not path.is_file():
        raise CurveUpsError("the target is no file", str(path), f"give {FORMATS} file")
    if path.suffix.lower() not in (*_MESHES, *ENDINGS):
        raise CurveUpsError(f"unknown format '{path.suffix or path.name}'", str(path), f"give {FORMATS} file")
