# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document of a run's results as a file, written without a window."""

from __future__ import annotations

import errno
import math
import re
import zipfile
import zlib
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator, Sequence
from xml.sax.saxutils import quoteattr

from ..base import freecad_session
from ..base.errors import CurveUpsError
from ..base.native import native
from ..project.project import Results
from . import document as documents
from .status import KINDS

Box = tuple[Sequence[float], Sequence[float]]  # least and largest corner, mm

# Places in FreeCAD's lists of display modes.
SHADED, MESH_FLAT_LINES = 1, 2
TWO_SIDE = 1

COMPRESSION = 3  # of zlib: half the time of its default, and shapes are a twentieth larger

# Class of the view of an object with a shape, as FreeCAD stores it. FreeCAD shows objects without one.
SHAPE_VIEW = 'module="curveups.window.viewproviders" class="ShapeView"'


@dataclass
class View:
    """View of an object. `colour`: sRGB, 0 to 255; None for an object without a shape."""

    name: str
    shown: bool
    colour: tuple[int, int, int] | None = None
    display_mode: int = SHADED


def finish_document(path: Path, views: Sequence[View], box: Box) -> None:
    """Add the views and a camera that sees `box` to a document without them. Raises OSError, also where
    FreeCAD has not saved the whole document, which raises nothing itself."""
    finished = path.with_name(path.name + ".finished")
    try:
        with zipfile.ZipFile(path) as old, zipfile.ZipFile(
                finished, "w", zipfile.ZIP_DEFLATED, compresslevel=COMPRESSION) as new:
            for entry in old.infolist():
                content = old.read(entry)
                if entry.filename == "Document.xml":
                    content = _without_materials(content.decode()).encode()
                new.writestr(entry.filename, content)
            new.writestr("GuiDocument.xml", _document(views, box))
        finished.replace(path)
    except (zipfile.BadZipFile, zlib.error, EOFError) as error:
        raise OSError(errno.EIO, "FreeCAD could not save the whole document (is the disk full?)",
                      str(path)) from error
    finally:
        finished.unlink(missing_ok=True)


def _without_materials(text: str) -> str:
    """Document.xml of FreeCAD 1.1 without default materials, whose colour comes before that of the view."""
    return re.sub(r'<Properties Count="(\d+)"((?:(?!</Properties>).)*?)'
                  r'<Property name="ShapeMaterial".*?</Property>\s*',
                  lambda match: f'<Properties Count="{int(match[1]) - 1}"{match[2]}', text, flags=re.DOTALL)


def _document(views: Sequence[View], box: Box) -> str:
    providers = "\n".join(_provider(view) for view in views)
    return ("<?xml version='1.0' encoding='utf-8'?>\n"
            '<Document SchemaVersion="1">\n'
            f'<ViewProviderData Count="{len(views)}">\n{providers}\n</ViewProviderData>\n'
            f"<Camera settings={quoteattr(_camera(box), {chr(10): '&#10;'})}/>\n</Document>\n")


def _provider(view: View) -> str:
    properties = []
    if view.colour is not None:
        red, green, blue = view.colour
        packed = red << 24 | green << 16 | blue << 8
        properties += [
            ("ShapeColor", "App::PropertyColor", f'<PropertyColor value="{packed}"/>'),
            ("DisplayMode", "App::PropertyEnumeration", f'<Integer value="{view.display_mode}"/>'),
            ("Lighting", "App::PropertyEnumeration", f'<Integer value="{TWO_SIDE}"/>'),
            ("Proxy", "App::PropertyPythonObject", f'<Python value="bnVsbA==" encoded="yes" {SHAPE_VIEW}/>')]
    shown = "true" if view.shown else "false"
    properties.append(("Visibility", "App::PropertyBool", f'<Bool value="{shown}"/>'))
    rows = "\n".join(f'<Property name="{name}" type="{kind}">{value}</Property>'
                     for name, kind, value in properties)
    return (f'<ViewProvider name="{view.name}" expanded="1">\n'
            f'<Properties Count="{len(properties)}" TransientCount="0">\n{rows}\n</Properties>\n'
            "</ViewProvider>")


def _camera(box: Box) -> str:
    """Camera that looks at the box obliquely from above (a print lies flat), wide enough for it."""
    from FreeCAD import Rotation, Vector

    size = math.dist(*box) or 1.0
    rotation = Rotation(Vector(0, 0, 1), 20) * Rotation(Vector(1, 0, 0), 38)  # turn about z, then tilt
    eye = (Vector(*box[0]) + Vector(*box[1])) / 2 + rotation.multVec(Vector(0, 0, size))
    return ("OrthographicCamera {\n"
            "  viewportMapping ADJUST_CAMERA\n"
            f"  position {eye.x:.6g} {eye.y:.6g} {eye.z:.6g}\n"
            f"  orientation {' '.join(f'{x:.8g}' for x in rotation.Axis)} {rotation.Angle:.8g}\n"
            f"  nearDistance 0\n  farDistance {2 * size:.6g}\n"
            f"  aspectRatio 1\n  focalDistance {size:.6g}\n  height {0.85 * size:.6g}\n}}\n")


# Drawing the solids of more tiles takes OpenCASCADE's meshing several seconds: the target is shown instead.
MOST_SHOWN = 800


def write_document(results: Results, path: Path) -> dict[str, str]:
    """Save the parametric document of a run's results to `path`. Return versions of software.

    The file has shapes (2500 tiles: 2 s, 17 MB), so that a FreeCAD without this workbench shows them too.
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
    V = results.design.V
    box = _print_box(results["solids"].model) if shown["Tiles"] else (V.min(axis=0), V.max(axis=0))
    finish_document(path, views, box)
    return {"freecad": freecad_session.version(freecad), "occt": part.OCC_VERSION}


@contextmanager
def _binary_shapes(freecad: Any) -> Iterator[None]:
    """Save shapes in binary: all their bits, in a third less time and space than as text."""
    preferences = freecad.ParamGet("User parameter:BaseApp/Preferences/Document")
    before = preferences.GetBool("SaveBinaryBrep", False)
    preferences.SetBool("SaveBinaryBrep", True)
    try:
        yield
    finally:
        preferences.SetBool("SaveBinaryBrep", before)


def _print_box(model: Any) -> Box:
    """Box of the print, which stands on z = 0, centred on the origin."""
    x, y, z = model.bbox
    return (-x / 2, -y / 2, 0.0), (x / 2, y / 2, z)
