# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document of a run's results as a file, written without a window."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator

import numpy as np

from ..base import freecad_session
from ..base.errors import CurveUpsError
from ..base.native import native
from ..project.project import Results
from . import document as documents
from .bodies import KINDS
from .gui_document import MESH_FLAT_LINES, SHADED, Box, View, finish_document

# Showing the solids of more tiles takes OpenCASCADE's meshing several seconds: the target is shown
# instead of them until they are asked for.
MOST_SHOWN = 800


def write_document(results: Results, path: Path) -> dict[str, str]:
    """The parametric document of a run's results, saved to `path`; returns versions of software.

    Shapes are kept in the file (2500 tiles: 2 s, 17 MB), so that a FreeCAD without this workbench
    shows them too.
    """
    freecad, part, _ = freecad_session.load("Part", "Mesh")

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
            document.FileName, document.Label = str(path), results.title  # saveAs would label it by its file
            document.save()
    finally:
        freecad.closeDocument(document.Name)
    # As in STEP and 3MF, the target in the colour of its tiles.
    colours = {name: native.COLOURS[kind] for name, kind in {**KINDS, "Target": "tiles"}.items()}
    views = [View(name, value, colours.get(name), MESH_FLAT_LINES if name == "Target" else SHADED)
             for name, value in shown.items()]
    box = _print_box(results["solids"].model) if shown["Tiles"] else _box(results.design.V)
    finish_document(path, views, box)
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
