# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL files, text and binary: every facet of the file, or an error.

FreeCAD's reader passes over lines that it can't read, and then takes corners of one facet for those of the
next. Vertices come in the order of their coordinates, as FreeCAD's do: cuts name them by number.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from .mesh_files import MOST_BYTES, GoOn, Mesh, few_enough

_FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_NUMBER = rb"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_POINT = rb"\s+" + rb"\s+".join([rb"(" + _NUMBER + rb")"] * 3) + rb"\s+"
# What a normal says is not used, and some write nan for a facet without area.
_TEXT_FACET = re.compile(
    rb"\s*facet\s+normal\s+\S+\s+\S+\s+\S+\s+outer\s+loop\s+" + (rb"vertex" + _POINT) * 3
    + rb"endloop\s+endfacet(?=\s)", re.IGNORECASE)
_SOLID = re.compile(rb"\s*(?:end\s*)?solid\b[^\r\n]*", re.IGNORECASE)


def read_stl(path: Path, go_on: GoOn) -> Mesh:
    """V (N x 3) and F (M x 3) of an STL file, equal corners merged."""
    if path.stat().st_size > MOST_BYTES:
        raise CurveUpsError("the file is too large", str(path), "simplify the mesh")
    data = path.read_bytes()
    text = data.removeprefix(b"\xef\xbb\xbf")
    is_text = text.lstrip()[:5].lower() == b"solid" and b"facet" in text[:2000].lower()
    corners = _from_text(text, path, go_on) if is_text else _from_bytes(data, path)
    few_enough(len(corners), path)
    if not np.isfinite(corners).all():
        raise CurveUpsError("a vertex is not finite", str(path), "repair the mesh")
    return _merged(corners.reshape(-1, 3) + np.float32(0), go_on)


def _merged(corners: np.ndarray, go_on: GoOn) -> Mesh:
    """As numpy's unique has rows, which takes three times as long."""
    order = np.arange(len(corners))
    for axis in (2, 1, 0):
        if not go_on(0.9 - 0.1 * axis):
            raise Stopped
        order = order[np.argsort(corners[order, axis], kind="stable")]
    sorted_corners = corners[order]
    begins = np.ones(len(corners), bool)
    begins[1:] = (sorted_corners[1:] != sorted_corners[:-1]).any(axis=1)
    F = np.empty(len(corners), np.int32)
    F[order] = np.cumsum(begins) - 1
    return sorted_corners[begins].astype(float), F.reshape(-1, 3)


def _from_bytes(data: bytes, path: Path) -> np.ndarray:
    if len(data) < 84:
        raise CurveUpsError("this is no STL file", str(path), "export it again")
    count = int.from_bytes(data[80:84], "little")
    if len(data) < 84 + _FACET.itemsize * count:
        raise CurveUpsError(f"the file ends early: {count} facets are announced", str(path),
                            "export it again")
    return np.frombuffer(data, _FACET, count, 84)["corners"]


def _from_text(text: bytes, path: Path, go_on: GoOn) -> np.ndarray:
    """Facet by facet, nothing passed over but the lines that begin and end a solid."""
    numbers: list[bytes] = []
    at, ended = 0, False
    while True:
        facet = _TEXT_FACET.match(text, at)
        if facet:
            if not len(numbers) % 45_000 and not go_on(0.7 * at / len(text)):
                raise Stopped
            numbers.extend(facet.groups())
            at, ended = facet.end(), False
            continue
        line = _SOLID.match(text, at)
        if not line:
            break
        at, ended = line.end(), line[0].lstrip()[:3].lower() == b"end"
    rest = text[at : at + 2000].strip()
    if rest:
        raise _not_read(text, at, rest, path)
    if not ended:
        raise CurveUpsError("the file ends early: there is no endsolid", str(path), "export it again")
    with np.errstate(over="ignore"):  # what is too large for a number is infinite, and refused
        return np.array(numbers, "S").astype(float).astype(np.float32).reshape(-1, 3, 3)


def _not_read(text: bytes, at: int, rest: bytes, path: Path) -> CurveUpsError:
    """Where the facet that can't be read begins."""
    at += len(text[at:]) - len(text[at:].lstrip())
    line = 1 + text.count(b"\n", 0, at)
    if re.search(rb"[\s][-+]?(nan|inf(inity)?)\b", rest, re.IGNORECASE):
        return CurveUpsError("a vertex is not finite", f"{path}, line {line}", "repair the mesh")
    if re.search(rb"endfacet\s", rest, re.IGNORECASE):
        return CurveUpsError("the facet that begins here can't be read", f"{path}, line {line}",
                             "export it again")
    return CurveUpsError("the file ends early, or a facet can't be read", f"{path}, line {line}",
                         "export it again")
