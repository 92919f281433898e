# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions of commands, panels and scripts on designs in a document, with and without a window.

Lengths are in mm. A function raises CurveUpsError where it can't be done, and leaves the document as it was.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Callable, Mapping

import numpy as np

from ..base.errors import CurveUpsError
from ..base.native import translated
from ..project import saved_results
from ..project.keys import changes
from ..project.project import Made, Results
from ..stages import BY_NAME, SETTLED, VERDICT
from . import properties, status, target
from .design import DesignProxy, design_project_of, project_of, settings_of, stored, take_solids
from .parts import (BodiesProxy, CutsProxy, LayoutProxy, VerificationProxy, edges_of, forget_settled,
                    write_cuts, write_figures, write_layout, write_verification)
from .proxy import SLOTS, Proxy, design_of, designs, show, type_of, write
from .status import KINDS, Keys, digest_of_edges, read_keys, write_keys
from .target import is_target

__all__ = ["design_of", "design_project_of", "designs", "has_layout", "new_design",
           "project_of", "set_cuts", "set_running", "set_source", "settings_of", "take", "visibility"]


def new_design(document: Any, source: Any, label: str = "") -> Any:
    """Make a Design with nothing solved. `source`: a Part or Mesh object of the document, a file's path or a
    built-in target's name."""
    values = target.properties_for(source)
    obj = _add_objects(document)
    obj.Label = label or (Path(source).stem if isinstance(source, (str, Path)) else f"{source.Label} design")
    _write_source(obj, values)
    return obj


def design_with_results(document: Any, results: Results) -> Any:
    """Make a Design that holds a run's results, with its solids."""
    obj = _add_objects(document)
    properties.write_parameters(obj, results.parameters)
    source = results.get("source")
    if source is not None:
        obj.Target.KeepMesh = not source.remesh
        obj.Target.File, obj.Target.BuiltIn, obj.Target.Stamp = (
            source.path, source.built_in, target.stamp_for(source))
    take(obj, results)
    if "solids" in results:
        take_solids(obj, results)
    document.recompute()
    return obj


def take(obj: Any, results: Results) -> None:
    """Store a run's results in the Design and the objects below it, inside of the caller's transaction; a
    recompute makes the solids."""
    before = stored(obj)
    finished = before.latest("design")
    solved = "design" in results and (finished is None or "layout" in results)
    made = {**before.given(), **before.made()}
    made.update(_worth_keeping(results, made, solved))
    with translated(before.where):
        text = saved_results.to_text(made)
    _complete(obj)
    keys = read_keys(obj)
    if "target" in results:
        tiling, followed = results["target"].tiling, results["target"].followed
        write(obj, "Tiling", str(tiling) if tiling else "")
        if followed and followed.cuts is not None and "cut request" in results:
            write_cuts(obj.Cuts, results["cut request"].edges, results["target"].V)
        for name, value in results["target"].fixes().items():  # L, where the mesh is taken as it is
            properties.write_parameter(obj, name, value)
    if "design" in results:
        _take_design(obj, results, solved)
    elif "target" in results:
        _write_mesh(obj.Target, results["target"].V, results["target"].F)
    write_keys(obj, _keys_with(obj, results, keys, solved))
    write(obj, "Results", text)
    if not status.refresh(obj).settled:
        forget_settled(obj)
    obj.touch()


def take_settled(obj: Any, results: Results) -> None:
    """Store the settled forces of a run of the stored design. This is no step of undo."""
    settled = replace(results, made={SETTLED: results.made[SETTLED]})
    take(obj, settled)
    if status.status_of(obj).settled:  # not after an undo of the run
        write_figures(obj, settled, False)
    obj.purgeTouched()


def set_source(obj: Any, source: Any) -> None:
    """Give a Design another target: a Part or Mesh object, a file's path or a built-in's name. The results
    stay, out of date."""
    values = target.properties_for(source)
    if not is_target(obj.Target):
        obj.Target = _add_part(obj.Document, "Target")
    _write_source(obj, values)


def _write_source(obj: Any, values: Mapping[str, Any]) -> None:
    """values: target.properties_for a source."""
    for name, value in values.items():
        write(obj.Target, name, value)
    target.write_stamp(obj.Target)
    status.refresh(obj)


def set_cuts(obj: Any, edges: Any) -> None:
    """Give a Design other cuts, C x 2 vertices of its Target's mesh; the layout stays, out of date."""
    divided = stored(obj).latest("target")
    if divided is None:
        raise CurveUpsError("there are no tiles to cut between yet", obj.Label, "run Solve, or Cuts")
    edges = _edges_of(divided, np.asarray(edges, int).reshape(-1, 2), obj.Label)
    _complete(obj)
    write_cuts(obj.Cuts, edges, divided.V)
    status.refresh(obj)


def cuts_of(obj: Any) -> np.ndarray:
    """Cuts of a Design, C x 2 vertices of the Target's mesh. Raises CurveUpsError where they are no edges of
    it."""
    edges = edges_of(obj.Cuts) if obj.Cuts is not None else np.zeros((0, 2), np.int32)
    divided = stored(obj).latest("target") if len(edges) else None
    return edges if divided is None else _edges_of(divided, edges, obj.Cuts.Label)


def _edges_of(divided: Any, edges: np.ndarray, where: str) -> np.ndarray:
    if len(edges) and not (0 <= edges.min() and edges.max() < len(divided.V)):
        raise CurveUpsError("a cut runs along no edge of the target", where, "pick the edges again")
    return edges


def has_layout(obj: Any) -> bool:
    """True where a Design holds a layout, current or not. Commands read it several times a second: states
    compare all results."""
    return status.is_solved(read_keys(obj))


def set_running(obj: Any, running: bool) -> None:
    """Say that a command begins or ends to work on a Design."""
    obj.Proxy.running = running
    status.refresh(obj)


def visibility(obj: Any, solids: bool) -> dict[str, bool]:
    """Objects of a design that are shown without an overlay: its solids or its target, where an overlay would
    lie upon them."""
    shown = {"Target": not solids, "Tiles": solids, "Support": False, "Anchors": solids}
    parts = {slot: part for slot in SLOTS if (part := getattr(obj, slot)) is not None}
    return {obj.Name: False, **{part.Name: shown.get(slot, True) for slot, part in parts.items()}}


def _worth_keeping(results: Results, before: Mapping[str, Made], solved: bool) -> dict[str, Made]:
    """Results to store of a run. Given results keep the keys that they had; a design that was given is stored
    already."""
    kept = {}
    for name, made in results.made.items():
        known = before.get(name)
        if made.result.lasting and (solved or name != "design" or known is None):
            kept[name] = made if made.key or known is None else replace(made, key=known.key)
    return kept


def _take_design(obj: Any, results: Results, solved: bool) -> None:
    design = results.design
    if solved:
        cuts = results["division"].given if "division" in results else design.cuts
        surface = results["target"] if "target" in results else design
        write_cuts(obj.Cuts, cuts, surface.V)
        write_layout(obj.Layout, results, design)
        _write_mesh(obj.Target, surface.V, surface.F)
    if VERDICT in results or solved:
        write_verification(obj.Verification, results.get(VERDICT))
    write_figures(obj, results, solved)


def _keys_with(obj: Any, results: Results, before: Keys, solved: bool) -> Keys:
    """Keys of a document after a run. A new verdict drops outdated results of the last one."""
    made = {name: replace(result.record, key=result.key or before.records.get(name, result.record).key)
            for name, result in results.made.items()
            if solved or name != "design" or name not in before.records}
    keys = replace(before, records={**before.records, **made})
    if VERDICT in results or solved:
        kept = {name: record for name, record in keys.records.items()
                if name in made or name not in BY_NAME or not BY_NAME[name].judges
                or changes(name, keys.records, results.parameters, ("design",)) == ()}
        verdict = results.verdict
        keys = replace(keys, records=kept, valid=verdict.valid, reasons=tuple(verdict.reasons))
    if SETTLED in made:
        keys = replace(keys, holds=results[SETTLED].holds)
    if solved or "design" not in before.records:
        linked = is_target(obj.Target) and obj.Target.Source is not None
        keys = replace(keys, stamp=getattr(obj.Target, "Stamp", ""), linked=linked,
                       cuts=digest_of_edges(obj.Cuts.Edges))
    return keys


def _write_mesh(obj: Any, V: np.ndarray, F: np.ndarray) -> None:
    import Mesh

    if obj is not None:
        placement = obj.Placement
        points = list(map(tuple, np.asarray(V, float).tolist()))
        obj.Mesh = Mesh.Mesh([[points[v] for v in face] for face in F.tolist()])
        obj.Placement = placement
        obj.purgeTouched()


def _complete(obj: Any) -> None:
    """Add objects for results where somebody deleted them."""
    for slot in ("Cuts", "Layout", "Verification"):
        if getattr(obj, slot) is None:
            setattr(obj, slot, _add_part(obj.Document, slot))


def _add_objects(document: Any) -> Any:
    """Add a Design and the objects below it."""
    import Mesh  # noqa: F401  their types are unknown before
    import Part  # noqa: F401

    obj = document.addObject("App::FeaturePython", "Design")
    DesignProxy(obj)
    for slot in SLOTS:
        part = _add_part(document, slot)
        if hasattr(part, "Placement"):
            part.Visibility = False  # an object without a shape would only be grey in the tree
        setattr(obj, slot, part)
    show(obj)
    return obj


def _add_part(document: Any, slot: str) -> Any:
    """Add the object of one of SLOTS."""
    kind, make = _PARTS[slot]
    obj = document.addObject(f"{kind}::FeaturePython", slot)
    make(obj)
    if slot in KINDS:
        obj.Kind = KINDS[slot]
    show(obj)
    return obj


_PARTS: dict[str, tuple[str, Callable[[Any], object]]] = {
    "Target": ("Mesh", target.make_target), "Cuts": ("App", CutsProxy), "Layout": ("App", LayoutProxy),
    "Verification": ("App", VerificationProxy), **{slot: ("Part", BodiesProxy) for slot in KINDS}}


TYPES: dict[str, type[Proxy]] = {proxy.TYPE: proxy for proxy in (
    DesignProxy, CutsProxy, LayoutProxy, VerificationProxy, BodiesProxy)}


def opened(document: Any) -> None:
    """Attach lost proxies and views, and compare targets with their sources."""
    for obj in document.Objects:
        if type_of(obj) in TYPES and obj.Proxy is None:
            TYPES[type_of(obj)](obj)
        elif is_target(obj):
            target.write_stamp(obj)
        show(obj)
    for design in designs(document):
        status.refresh(design)
