# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Target object: the source of the surface, and its division into tiles."""

from __future__ import annotations

import os
from functools import lru_cache
from pathlib import Path
from typing import Any, Callable

from ..base.errors import CurveUpsError
from ..base.native import native
from ..base.output import plain_name
from ..stages.stage import digest
from ..stages.surface import Source, file_stamp
from ..targets import cad_files
from ..targets.cad_files import GoOn, Read
from ..targets.cad_parts import Choice
from ..targets.target_files import require_readable
from .proxy import HIDDEN, OUTPUT, READ_ONLY, add, add_part_properties, type_of, write

TYPE = "CurveUps::Target"


def make_target(obj: Any) -> None:
    """Make a plain mesh object a Target. Its mesh is the division into tiles. It has no proxy: the Design
    depends on it, and is recomputed after it."""
    add_part_properties(obj, TYPE)
    add(obj, "Link", "Source", "Target",
        "The Part or Mesh object that gives the surface. Takes effect with Solve.")
    add(obj, "File", "File", "Target", "The file that gives the surface. Takes effect with Solve.")
    add(obj, "String", "BuiltIn", "Target", "The built-in target that this is.", READ_ONLY)
    add(obj, "Bool", "KeepMesh", "Target",
        "Takes the source's triangles as tiles, as they are. Takes effect with Solve.")
    add(obj, "String", "Stamp", "Target", "Tells states of the source apart.", READ_ONLY | HIDDEN | OUTPUT)


def is_target(obj: Any) -> bool:
    """True for a Target, which knows its source."""
    return obj is not None and type_of(obj) == TYPE


def write_stamp(obj: Any) -> None:
    """Store the state of the source in the Target's Stamp. A file that is not on this machine has not
    changed."""
    stamp = _stamp_of_object(obj.Source) if obj.Source else obj.BuiltIn or _stamp_of_file(obj.File)
    if stamp:
        write(obj, "Stamp", _stamp(stamp, obj.KeepMesh))


def properties_for(source: Any) -> dict[str, Any]:
    """Properties of a Target with one source: a Part or Mesh object, a file's path or a built-in's name.
    Raises CurveUpsError where it is none of these."""
    values: dict[str, Any] = {"Source": None, "File": "", "BuiltIn": ""}
    if not isinstance(source, (str, Path)):
        values["Source"] = require_surface(source)
    elif str(source) in dict(native.builtin_targets()):
        values["BuiltIn"] = str(source)
    else:
        require_readable(Path(source))
        values["File"] = str(Path(source).absolute())
    return values


def source_of(obj: Any, known: Source | None) -> Source:
    """Source of the project; `known` where it has not changed, so that nothing is made anew."""
    # The cuts decide whether a closed surface makes sense: they can be made later.
    options: dict[str, Any] = {"remesh": not obj.KeepMesh, "will_be_cut": True}
    if known is not None and obj.Stamp == stamp_for(known):
        if known.read is not None or obj.Source is None:
            return known
        options["will_be_cut"] = known.will_be_cut  # of a reopened document: it lacks the reader alone
    if obj.Source is not None:
        return Source(plain_name(obj.Source.Label), stamp=_stamp_of_object(obj.Source),
                      read=_reader(require_surface(obj.Source)), **options)
    if obj.BuiltIn:
        return Source(obj.BuiltIn, built_in=obj.BuiltIn, **options)
    if obj.File:
        return Source(plain_name(Path(obj.File).stem), path=obj.File, stamp=_stamp_of_file(obj.File),
                      **options)
    raise CurveUpsError("there is no target", obj.Label, "choose a surface with the Target command")


def stamp_for(source: Source) -> str:
    """Stamp of a Target that has this source."""
    return _stamp(source.stamp or source.built_in, not source.remesh)


def _stamp(of_source: str, keep_mesh: bool) -> str:
    return f"{of_source} as it is" if of_source and keep_mesh else of_source


def require_surface(obj: Any) -> Any:
    """Return `obj`. Raises CurveUpsError where it has no surface."""
    if not (hasattr(obj, "Mesh") and obj.Mesh.CountFacets or hasattr(obj, "Shape") and obj.Shape.Faces):
        raise CurveUpsError("this has no surface", getattr(obj, "Label", str(obj)),
                            "choose a Mesh or Part object with faces, or a file")
    return obj


def _stamp_of_file(path: str) -> str:
    try:
        file = os.stat(path)
    except (OSError, ValueError):
        return ""
    return _digest_of_file(path, file.st_size, file.st_mtime_ns)


@lru_cache(maxsize=16)
def _digest_of_file(path: str, size: int, changed: int) -> str:
    """Digest of a file, read again when its size or its date changes: every recompute needs it."""
    return file_stamp(path)


def _stamp_of_object(obj: Any) -> str:
    """Digest of figures that any edit changes: triangulations and digits of files do not count."""
    if hasattr(obj, "Mesh"):
        mesh = obj.Mesh
        box = mesh.BoundBox
        figures = [mesh.CountPoints, mesh.CountFacets, mesh.Area, mesh.Volume, box.XMin, box.YMin, box.ZMin,
                   box.XMax, box.YMax, box.ZMax]
    elif hasattr(obj, "Shape") and not obj.Shape.isNull():
        shape = obj.Shape
        figures = [len(shape.Faces), len(shape.Edges), shape.Area, shape.Length]
        figures += [x for face in shape.Faces for x in (face.Area, *face.CenterOfMass)]
        figures += [x for vertex in shape.Vertexes for x in (vertex.X, vertex.Y, vertex.Z)]
    else:
        return ""
    # Eight digits, and nothing below a millionth of the whole: the last ones differ after reopening.
    size = max(1.0, *(abs(x) for x in figures))
    return digest(*(f"{0.0 if abs(x) < 1e-9 * size else x:.8g}" for x in figures))


def _reader(obj: Any) -> Callable[[float, Choice, GoOn], Read]:
    """Return a function that makes triangles of the object as it is now, on any thread: it has a copy."""
    label = obj.Label
    if hasattr(obj, "Mesh"):
        mesh = obj.Mesh.copy()
        return lambda *_: Read(*cad_files.triangles_of_mesh(mesh))
    shape = obj.Shape.copy()
    return lambda deflection, choice, go_on: cad_files.read_shape(shape, deflection, go_on, choice, label)
