# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface as its file or the built-in target has it, in mm after `scale`."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np

from ..cad_files import Read
from ..cad_parts import Choice
from ..native import native
from ..output import safe_name
from .stage import Inputs, Job, Result, Stage, digest


@dataclass(frozen=True)
class Source(Result):
    """Given by the user: a built-in target, a file, or an object of a document, which `read` makes
    triangles of (largest deviation in the object's own unit, what of it is wanted). `stamp` tells states of a file or an
    object apart. `remesh`: otherwise the mesh is taken as it is. `will_be_cut`: whether a closed surface
    makes sense."""

    name: str           # safe for file names
    built_in: str = ""
    path: str = ""
    remesh: bool = True
    will_be_cut: bool = False
    stamp: str = ""
    read: Optional[Callable[[float, Choice], Read]] = field(
        default=None, compare=False, metadata={"transient": True})

    @property
    def content(self) -> str:
        # Neither what it is called nor where it lies: a document is copied together with its target.
        return digest(self.built_in, self.stamp, self.remesh, self.will_be_cut)


@dataclass(frozen=True)
class Surface(Result):
    """V (N x 3, mm) and F (M x 3, counter-clockwise from the front): what the user gave."""

    V: np.ndarray
    F: np.ndarray
    notes: tuple[str, ...] = ()    # on what of a CAD part it is
    wall: Optional[float] = None   # how thick that is drawn, mm; None: as a sheet

    @property
    def content(self) -> str:
        return digest(self.V, self.F, *self.notes, *(() if self.wall is None else (self.wall,)))


def _run(inputs: Inputs, job: Job) -> Surface:
    source, get = inputs["source"], inputs.parameters.get
    # A tenth of what remeshing may move a vertex, in the target's own coordinates: they are scaled
    # afterwards.
    deflection = 0.0005 * get("L") / get("scale")
    choice = Choice(get("skin"), get("faces"), get("open"))
    if source.read:
        job("reading the target")
        found = source.read(deflection, choice)
    elif source.built_in:
        found = Read(*native.builtin_target(source.built_in, min(max(deflection, 1e-4), 1.0)))
    else:
        from .. import freecad_io  # only where FreeCAD is needed

        job("reading the target")
        found = freecad_io.read_target(Path(source.path), deflection, lambda: job("reading the target"),
                                       choice)
    V = np.ascontiguousarray(found.V, float) * get("scale")
    F = np.ascontiguousarray(found.F[:, ::-1] if get("flip") else found.F, np.int32)
    return Surface(V, F, found.notes, None if found.wall is None else found.wall * get("scale"))


STAGE = Stage("surface", ("source",), frozenset({"target"}), _run)


def find_source(target: str, **options: Any) -> Source:
    """The source that a TARGET of the command line names; built-in names come first."""
    if target in dict(native.builtin_targets()):
        return Source(safe_name(target), built_in=target, **options)
    return Source(safe_name(Path(target).stem), path=target, stamp=file_stamp(target), **options)


def file_stamp(path: str) -> str:
    """A digest of a file's content; empty where there is no such file or it can't be read."""
    try:
        if not Path(path).is_file():
            return ""
        found = hashlib.sha256()
        with open(path, "rb") as file:
            while piece := file.read(1 << 20):
                found.update(piece)
        return found.hexdigest()
    except (OSError, ValueError):  # ValueError: a null character in the name
        return ""
