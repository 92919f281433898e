# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the files of all bodies as somebody else would: STEP through OpenCASCADE, meshes facet by facet."""

from __future__ import annotations

import zipfile
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

from step_rules import wrong_step_files


def read_back(folder: Path, report: dict, check: bool = False, solids: bool = True) -> list[str]:
    """Faults of the files of a finished design; `check`: BRepCheck on every solid as well;
    without `solids` the meshes alone are read (a tenth of the time)."""
    from curveups.base import freecad_session

    _, part, mesh = freecad_session.load("Part", "Mesh")
    volumes = {"tiles": report["print"]["tile_volume_cm3"],
               "support": report["print"]["support_volume_cm3"],
               "anchors": report["print"]["anchor_volume_cm3"]}

    def step(kind: str, count: int, volume: float | None, check: bool) -> list[str]:
        if not solids:
            return []
        found = part.read(str(folder / f"{report['name']}-{kind}.step")).Solids
        return [f"{kind}.step {what}" for what in _wrong_solids(found, count, volume, check)]

    wrong, bodies = [], 0
    for kind, volume in volumes.items():
        if not volume:
            continue
        facets = mesh.Mesh(str(folder / f"{report['name']}-{kind}.stl"))
        if not facets.isSolid():
            wrong.append(f"{kind}.stl is not watertight")
        if facets.hasSelfIntersections():
            wrong.append(f"{kind}.stl intersects itself")
        components = facets.countComponents()
        if kind == "tiles" and components != report["tiles"]:
            wrong.append(f"tiles.stl has {components} components")
        bodies += components
        wrong += step(kind, components, 1000 * volume, check)
    if bodies != report["print"]["bodies"]:
        wrong.append(f"the STL files have {bodies} components")
    wrong += step("print", bodies, 1000 * sum(volumes.values()), False)  # the others' bodies again
    wrong += step("actuated", report["tiles"], None, check)
    if solids:
        wrong += wrong_step_files(sorted(folder.glob(f"{report['name']}-*.step")))
    return wrong + _wrong_3mf(folder / f"{report['name']}-print.3mf", bodies)


def _wrong_solids(solids: list, count: int, expected: float | None, check: bool) -> list[str]:
    wrong = [] if len(solids) == count else [f"has {len(solids)} solids, not {count}"]
    if not all(solid.isClosed() for solid in solids):
        wrong.append("has open solids")
    if check and not all(solid.isValid() for solid in solids):
        wrong.append("has invalid solids")
    volume = sum(solid.Volume for solid in solids)
    if expected is not None and abs(volume - expected) > 1e-9 * expected:
        wrong.append(f"holds {volume:.9f} mm3, not {expected:.9f}")
    return wrong


def _wrong_3mf(path: Path, bodies: int) -> list[str]:
    """Objects with a mesh in a 3MF: one a body, each with its own name, every edge between two triangles."""
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    names, leaky = set(), 0
    with zipfile.ZipFile(path) as archive, archive.open("3D/3dmodel.model") as model:
        for _, item in ElementTree.iterparse(model):
            if item.tag != space + "object" or item.find(space + "mesh") is None:
                continue
            names.add(item.get("name"))
            edges: Counter[tuple[str | None, str | None]] = Counter()
            for triangle in item.iter(space + "triangle"):
                a, b, c = (triangle.get(corner) for corner in ("v1", "v2", "v3"))
                edges.update(((a, b), (b, c), (c, a)))
            leaky += not edges or any(count != 1 or edges[b, a] != 1
                                      for (a, b), count in list(edges.items()))
            item.clear()
    return ([f"3mf has {len(names)} names, not {bodies}"] if len(names) != bodies else []) + (
        [f"{leaky} objects of the 3mf are not watertight"] if leaky else [])
