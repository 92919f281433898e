# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the surface of a file or a built-in target, in mm after `scale`."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np

from ..base.native import native
from ..base.output import plain_name
from ..targets.cad_files import Read
from ..targets.cad_parts import Choice
from ..targets.target_files import read_target
from .stage import Inputs, Job, Result, Stage, digest


@dataclass(frozen=True)
class Source(Result):
    """Given by the user: a built-in target, a file, or an object of a document, which `read` makes
    triangles of (largest deviation in the object's own unit, what of it is wanted). `stamp` tells states of
    a file or an object apart. `remesh`: otherwise the mesh is taken as it is. `will_be_cut`: whether a closed
    surface makes sense."""

    name: str           # as titles have it; files are named by output.safe_name of it
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
    # Sides of faces (E x 2 vertices) where a CAD part bends by more than crease_angle; None of what is none.
    creases: Optional[np.ndarray] = None

    @property
    def content(self) -> str:
        sharp = () if self.creases is None or not len(self.creases) else (self.creases,)
        return digest(self.V, self.F, *self.notes, *(() if self.wall is None else (self.wall,)), *sharp)


def _run(inputs: Inputs, job: Job) -> Surface:
    source, get = inputs["source"], inputs.parameters.get
    choice = Choice(get("skin"), get("faces"), get("open"), get("crease_angle"))

    def read(scale: float) -> Read:
        # A tenth of what remeshing may move a vertex, in the target's own coordinates: they are scaled
        # afterwards.
        deflection = 0.0005 * get("L") / scale
        if source.built_in:
            return Read(*native.builtin_target(source.built_in, min(max(deflection, 1e-4), 1.0)))
        job("reading the target")
        if source.read:
            return source.read(deflection, choice)
        return read_target(Path(source.path), deflection, partial(job, "reading the target"), choice)

    scale = get("scale")
    found = read(scale)
    V = np.ascontiguousarray(found.V, float) * scale
    F = np.ascontiguousarray(found.F[:, ::-1] if get("flip") else found.F, np.int32)
    wall = None if found.wall is None else found.wall * scale
    return Surface(V, F, found.notes, wall, found.creases)


STAGE = Stage("surface", ("source",), frozenset({"target"}), _run,
              label="Reading the surface", asked_by=("solve",))


def find_source(target: str, **options: Any) -> Source:
    """The source that a TARGET of the command line names; built-in names come first."""
    if target in dict(native.builtin_targets()):
        return Source(target, built_in=target, **options)
    return Source(plain_name(Path(target).stem), path=target, stamp=file_stamp(target), **options)


def file_stamp(path: str) -> str:
    """A digest of a file's content; empty where it can't be read."""
    try:
        return hashlib.sha256(Path(path).read_bytes()).hexdigest()
    except OSError:
        return ""
