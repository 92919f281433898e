# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that print shops and slicers ask for besides STEP, STL and 3MF: pieces on bridges as one shell, and
the print as PrusaSlicer's own project, whose parts have their extruder. PrusaSlicer takes materials of the
3MF standard for colours."""

from __future__ import annotations

import io
import struct
import zipfile
from typing import Any, Sequence
from xml.sax.saxutils import quoteattr

import numpy as np

from ..base.native import native
from ..stages.solids import KINDS
from .kit import Kit

_TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
_RELATIONS = """<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel-1"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
_MODEL = """<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:slic3rpe="http://schemas.slic3r.org/3mf/2017/06">
<metadata name="slic3rpe:Version3mf">1</metadata>
<resources><object id="1" type="model"><mesh><vertices>
{vertices}
</vertices><triangles>
{triangles}
</triangles></mesh></object></resources>
<build><item objectid="1"/></build>
</model>
"""
_CONFIG = """<?xml version="1.0" encoding="UTF-8"?>
<config><object id="1" instances_count="1"><metadata type="object" key="name" value={title}/>
{parts}</object></config>
"""
_PART = """<volume firstid="{first}" lastid="{last}"><metadata type="volume" key="name" value="{name}"/>
<metadata type="volume" key="volume_type" value="ModelPart"/>
<metadata type="volume" key="extruder" value="{extruder}"/></volume>
"""


def fused(kit: Kit, ending: str, model: Any = None) -> bytes:
    """Each piece as one closed shell; on bridges alone. model: the native PrintModel of a bed, where it
    is not that of the kit."""
    model = model or kit.model
    shell = kit.shell(model)
    return shell if ending == "stl" else _threemf(kit, [("print", shell, 1)])


def project(kit: Kit, model: Any = None) -> bytes:
    """The kinds of bodies as parts with their extruders: a soluble slab is of extruder 2. model: as of
    fused."""
    model = model or kit.model
    soluble = native.support_kind(kit.results.parameters).soluble
    parts = [(kind, kit.written(model, "stl", kind), 2 if kind == "support" and soluble else 1)
             for kind in KINDS if model.volumes[kind] > 0]
    return _threemf(kit, parts)


def _threemf(kit: Kit, parts: Sequence[tuple[str, bytes, int]]) -> bytes:
    """A 3MF of one object with PrusaSlicer's settings of parts. parts: their
    name, STL and extruder."""
    vertices: list[str] = []
    triangles: list[str] = []
    volumes = ""
    for name, data, extruder in parts:
        kit.go_on()
        points, corners = np.unique(_facets(data).reshape(-1, 3), axis=0, return_inverse=True)
        corners = corners.reshape(-1, 3) + len(vertices)
        first = len(triangles)
        triangles += ['<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(row) for row in corners.tolist()]
        vertices += ['<vertex x="%.9g" y="%.9g" z="%.9g"/>' % tuple(row) for row in points.tolist()]
        volumes += _PART.format(first=first, last=len(triangles) - 1, name=name, extruder=extruder)
    mesh = _MODEL.format(vertices="\n".join(vertices), triangles="\n".join(triangles))
    members = {"[Content_Types].xml": _TYPES.encode(), "_rels/.rels": _RELATIONS.encode(),
               "3D/3dmodel.model": mesh.encode(),
               "Metadata/Slic3r_PE_model.config":
                   _CONFIG.format(title=quoteattr(kit.title), parts=volumes).encode("utf-8")}
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as zipped:
        for name, content in members.items():
            zipped.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return archive.getvalue()


def _facets(data: bytes) -> np.ndarray:
    """Corners of an STL's facets, n x 3 x 3."""
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
    return np.frombuffer(data, facet, offset=84, count=struct.unpack_from("<I", data, 80)[0])["corners"]
