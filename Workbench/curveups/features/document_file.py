# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document of a run's results as a file, written without a window."""

from __future__ import annotations

import errno
import math
import zipfile
import zlib
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator, Mapping, Sequence
from xml.etree import ElementTree

from ..base import freecad_session
from ..base.errors import CurveUpsError
from ..base.native import native
from ..project.project import Results
from . import document as documents
from .status import KINDS

Box = tuple[Sequence[float], Sequence[float]]  # least and largest corner, mm

COMPRESSION = 3  # of zlib: half the time of its default, and shapes are a twentieth larger

# GuiDocument.xml as FreeCAD writes it. Display modes and lighting are places in FreeCAD's lists; Lighting is
# "Two side".
SHADED, MESH_FLAT_LINES = 1, 2
_SHAPE = """<Property name="ShapeColor" type="App::PropertyColor"><PropertyColor value="{colour}"/></Property>
<Property name="DisplayMode" type="App::PropertyEnumeration"><Integer value="{mode}"/></Property>
<Property name="Lighting" type="App::PropertyEnumeration"><Integer value="1"/></Property>
<Property name="Proxy" type="App::PropertyPythonObject"><Python value="bnVsbA==" encoded="yes"
 module="curveups.window.viewproviders" class="ShapeView"/></Property>
"""
_VIEW = """<ViewProvider name="{name}" expanded="1">
<Properties Count="{count}" TransientCount="0">
{shape}<Property name="Visibility" type="App::PropertyBool"><Bool value="{shown}"/></Property>
</Properties>
</ViewProvider>
"""
_DOCUMENT = """<?xml version='1.0' encoding='utf-8'?>
<Document SchemaVersion="1">
<ViewProviderData Count="{count}">
{views}</ViewProviderData>
<Camera settings="{camera}"/>
</Document>
"""
_CAMERA = """OrthographicCamera {{
  viewportMapping ADJUST_CAMERA
  position {position}
  orientation {orientation}
  nearDistance 0
  farDistance {far:.6g}
  aspectRatio 1
  focalDistance {size:.6g}
  height {height:.6g}
}}
"""


def finish_document(path: Path, shown: Mapping[str, bool], box: Box) -> None:
    """Add views of objects, `shown` or not, and a camera that sees `box` to a document without them. Raises
    OSError, also where FreeCAD has not saved the whole document, which raises nothing itself."""
    finished = path.with_name(path.name + ".finished")
    try:
        with zipfile.ZipFile(path) as old, zipfile.ZipFile(
                finished, "w", zipfile.ZIP_DEFLATED, compresslevel=COMPRESSION) as new:
            for entry in old.infolist():
                content = old.read(entry)
                if entry.filename == "Document.xml":
                    content = _without_materials(content)
                new.writestr(entry.filename, content)
            new.writestr("GuiDocument.xml", _gui_document(shown, box))
        finished.replace(path)
    except (zipfile.BadZipFile, zlib.error, EOFError) as error:
        raise OSError(errno.EIO, "FreeCAD could not save the whole document (is the disk full?)",
                      str(path)) from error
    finally:
        finished.unlink(missing_ok=True)


def _without_materials(content: bytes) -> bytes:
    """Document.xml of FreeCAD 1.1 without default materials, whose colour comes before that of the view."""
    if b"ShapeMaterial" not in content:
        return content
    root = ElementTree.fromstring(content)
    for properties in root.iter("Properties"):
        for material in properties.findall("Property[@name='ShapeMaterial']"):
            properties.remove(material)
            properties.set("Count", str(int(properties.get("Count", "1")) - 1))
    return bytes(ElementTree.tostring(root, encoding="utf-8", xml_declaration=True))


def _gui_document(shown: Mapping[str, bool], box: Box) -> str:
    # As in STEP and 3MF, the target in the colour of its tiles.
    kinds, views = {**KINDS, "Target": "tiles"}, ""
    for name, visible in shown.items():
        shape = ""
        if name in kinds:
            red, green, blue = native.COLOURS[kinds[name]]
            shape = _SHAPE.format(colour=red << 24 | green << 16 | blue << 8,
                                  mode=MESH_FLAT_LINES if name == "Target" else SHADED)
        views += _VIEW.format(name=name, count=5 if shape else 1, shape=shape, shown=str(visible).lower())
    return _DOCUMENT.format(count=len(shown), views=views, camera=_camera(box).replace("\n", "&#10;"))


def _camera(box: Box) -> str:
    """Camera that looks at the box obliquely from above (a print lies flat), wide enough for it."""
    from FreeCAD import Rotation, Vector

    size = math.dist(*box) or 1.0
    rotation = Rotation(Vector(0, 0, 1), 20) * Rotation(Vector(1, 0, 0), 38)  # turn about z, then tilt
    eye = (Vector(*box[0]) + Vector(*box[1])) / 2 + rotation.multVec(Vector(0, 0, size))
    return _CAMERA.format(position=" ".join(f"{x:.6g}" for x in eye), far=2 * size, size=size,
                          orientation=" ".join(f"{x:.8g}" for x in (*rotation.Axis, rotation.Angle)),
                          height=0.85 * size)


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
        with _plain_saving(freecad):
            document.FileName, document.Label = str(path), results.title  # saveAs would label it by its file
            document.save()
    finally:
        freecad.closeDocument(document.Name)
    V = results.design.V
    box = _print_box(results["bodies"].model) if shown["Tiles"] else (V.min(axis=0), V.max(axis=0))
    finish_document(path, shown, box)
    return {"freecad": freecad_session.version(freecad), "occt": part.OCC_VERSION}


@contextmanager
def _plain_saving(freecad: Any) -> Iterator[None]:
    """Save shapes in binary: all their bits, in a third less time and space than as text; and without
    compression, which follows with the views."""
    preferences = freecad.ParamGet("User parameter:BaseApp/Preferences/Document")
    binary, level = preferences.GetBool("SaveBinaryBrep", False), preferences.GetInt("CompressionLevel", 3)
    preferences.SetBool("SaveBinaryBrep", True)
    preferences.SetInt("CompressionLevel", 0)
    try:
        yield
    finally:
        preferences.SetBool("SaveBinaryBrep", binary)
        preferences.SetInt("CompressionLevel", level)


def _print_box(model: Any) -> Box:
    """Box of the print, which stands on z = 0, centred on the origin."""
    x, y, z = model.bbox
    return (-x / 2, -y / 2, 0.0), (x / 2, y / 2, z)
