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
from ..targets.cad_files import GoOn, Read
from ..targets.cad_parts import Choice
from ..targets.target_files import read_target
from .following import Earlier
from .stage import Inputs, Job, Result, Stage


@dataclass(frozen=True)
class Source(Result):
    """Target as given by the user: a built-in name, a file, or an object of a document, triangulated by
    `read` (largest deviation in the object's own unit, choice of its faces). stamp: digest of the file's or
    object's state. remesh: False takes the mesh as it is. will_be_cut: closed surfaces are accepted. follows:
    earlier tiles to carry along; no input of which results are out of date when it changes."""

    # Without name and path: documents are copied together with their targets.
    read_later = ("built_in", "stamp", "remesh", "will_be_cut")
    name: str           # for titles; output.safe_name of it for files
    built_in: str = ""
    path: str = ""
    remesh: bool = True
    will_be_cut: bool = False
    stamp: str = ""
    read: Optional[Callable[[float, Choice, GoOn], Read]] = field(
        default=None, compare=False, metadata={"transient": True})
    follows: Optional[Earlier] = field(default=None, compare=False, metadata={"transient": True})


@dataclass(frozen=True)
class Surface(Result):
    """V (N x 3, mm) and F (M x 3, counter-clockwise from the front) as given."""

    read_later = ("V", "F", "notes", "wall", "creases")
    V: np.ndarray
    F: np.ndarray
    notes: tuple[str, ...] = ()    # on the chosen faces of a CAD part
    wall: Optional[float] = None   # thickness as drawn, mm; None: a sheet
    # Edges (E x 2 vertices) where a CAD part bends by more than crease_angle; None for other targets.
    creases: Optional[np.ndarray] = None


def _run(inputs: Inputs, job: Job) -> Surface:
    source, get = inputs["source"], inputs.parameters.get
    choice = Choice(get("skin"), get("faces"), get("open"), get("crease_angle"))
    scale = get("scale")
    # A fifth of the distance by which remeshing may move a vertex, in unscaled coordinates. FreeCAD takes six
    # times as long for half of it.
    deflection = 0.001 * get("L") / scale
    if source.built_in:
        mesh = Read(*native.builtin_target(source.built_in, min(max(deflection / 2, 1e-4), 1.0)))
    else:
        reading = partial(job, "reading the target")
        reading()
        mesh = (source.read(deflection, choice, reading) if source.read
                else read_target(Path(source.path), deflection, reading, choice))
    V = np.ascontiguousarray(mesh.V, float) * scale
    F = np.ascontiguousarray(mesh.F[:, ::-1] if get("flip") else mesh.F, np.int32)
    wall = None if mesh.wall is None else mesh.wall * scale
    return Surface(V, F, mesh.notes, wall, mesh.creases)


STAGE = Stage("surface", ("source",), frozenset({"target"}), _run,
              label="Reading the surface", commands=("solve",))


def find_source(target: str, **options: Any) -> Source:
    """Source for a TARGET of the command line; built-in names come first."""
    if target in dict(native.builtin_targets()):
        return Source(target, built_in=target, **options)
    return Source(plain_name(Path(target).stem), path=target, stamp=file_stamp(target), **options)


def file_stamp(path: str) -> str:
    """Digest of a file's content; empty where it can't be read."""
    try:
        return hashlib.sha256(Path(path).read_bytes()).hexdigest()
    except OSError:
        return ""
