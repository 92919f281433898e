# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface as its file or the built-in target has it, in mm after `scale`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..native import native
from ..output import safe_name
from .stage import Inputs, Job, Result, Stage, digest


@dataclass(frozen=True)
class Source(Result):
    """Given by the user: a built-in target or a file. `remesh`: otherwise the mesh is taken as it is.
    `will_be_cut`: whether a closed surface makes sense."""

    name: str           # safe for file names
    built_in: str = ""
    path: str = ""
    remesh: bool = True
    will_be_cut: bool = False

    @property
    def content(self) -> str:
        stamp = ""
        if self.path and os.path.exists(self.path):
            found = os.stat(self.path)
            stamp = f"{found.st_size} {found.st_mtime_ns}"
        return digest(self.name, self.built_in, self.path, stamp, self.remesh, self.will_be_cut)


@dataclass(frozen=True)
class Surface(Result):
    """V (N x 3, mm) and F (M x 3, counter-clockwise from the front): what the user gave."""

    V: np.ndarray
    F: np.ndarray

    @property
    def content(self) -> str:
        return digest(self.V, self.F)


def _run(inputs: Inputs, job: Job) -> Surface:
    source, get = inputs["source"], inputs.parameters.get
    # A tenth of what remeshing may move a vertex, in the target's own coordinates: they are scaled
    # afterwards.
    deflection = 0.0005 * get("L") / get("scale")
    if source.built_in:
        V, F = native.builtin_target(source.built_in, min(max(deflection, 1e-4), 1.0))
    else:
        from .. import freecad_io  # only where FreeCAD is needed

        job("reading the target")
        V, F = freecad_io.read_target(Path(source.path), deflection)
    V = np.ascontiguousarray(V, float) * get("scale")
    F = np.ascontiguousarray(F[:, ::-1] if get("flip") else F, np.int32)
    return Surface(V, F)


STAGE = Stage("surface", ("source",), frozenset({"target"}), _run)


def find_source(target: str, **options: Any) -> Source:
    """The source that a TARGET of the command line names; built-in names come first."""
    if target in dict(native.builtin_targets()):
        return Source(safe_name(target), built_in=target, **options)
    return Source(safe_name(Path(target).stem), path=target, **options)
