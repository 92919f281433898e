# SPDX-License-Identifier: LGPL-2.1-or-later
"""What commands, panels and scripts do with designs in a document: works with and without a window.

Lengths are in mm. Everything raises CurveUpsError, with the document as it was, where it can't be done.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Callable, Mapping, Optional

import numpy as np

from ..base.errors import CurveUpsError
from ..base.native import translated
from ..project import saved_results
from ..project.keys import changes
from ..project.project import Made, Project, Results
from ..stages import BY_NAME, SETTLED, VERDICT
from . import live, properties, rebuild, status, target
from .design import DesignProxy
from .live import design_project_of, project_of, settings_of
from .parts import (KINDS, BodiesProxy, CutsProxy, LayoutProxy, VerificationProxy, edges_of, write_cuts,
                    write_figures, write_layout, write_verification)
from .proxy import SLOTS, Proxy, design_of, designs, show, type_of, write
from .status import Keys, digest_of_edges, read_keys, write_keys
from .target import is_target

__all__ = ["design_of", "design_project_of", "designs", "has_layout", "new_design",
           "project_of", "set_cuts", "set_running", "set_source", "settings_of", "state_of", "take",
           "visibility"]

# Pictures of membranes are most of a verification and are made anew where they are asked for.
_NOT_STORED = ("membranes",)


def new_design(document: Any, source: Any, label: str = "") -> Any:
    """A Design with nothing solved. `source`: a Part or Mesh object of the document, a file's path or a
    built-in target's name."""
    found = target.properties_for(source)
    obj = _add_objects(document)
    _write_source(obj.Target, found)
    obj.Label = label or (Path(source).stem if isinstance(source, (str, Path)) else f"{source.Label} design")
    obj.Proxy.refresh(obj)
    return obj


def design_with_results(document: Any, results: Results) -> Any:
    """A Design that holds a run's results, with its solids."""
    obj = _add_objects(document)
    properties.write_parameters(obj, results.parameters)
    source = results.get("source")
    if source is not None:
        obj.Target.KeepMesh = not source.remesh
        obj.Target.File, obj.Target.BuiltIn, obj.Target.Stamp = (
            source.path, source.built_in, target.stamp_for(source))
    take(obj, results)
    if "solids" in results:
        rebuild.take(obj, results)
    document.recompute()
    return obj


@dataclass(frozen=True)
class Stored:
    """Results as a document stores them: `made`, as read from `text`, and whether a new layout is among
    them."""

    made: Mapping[str, Made]
    text: str
    solved: bool


def to_store(before: Project, results: Results) -> Stored:
    """Results of a run to store in a document that holds `before` (live.stored); for any thread."""
    finished = before.latest("design")
    solved = "design" in results and (finished is None or "layout" in results)
    made = {**before.given(), **before.made()}
    made.update(_worth_keeping(results, made, solved))
    with translated(before.where):
        text = saved_results.to_text(made, _NOT_STORED)
    return Stored(saved_results.from_text(text, before.where), text, solved)


def take(obj: Any, results: Results, stored: Optional[Stored] = None) -> None:
    """A run's results become those of the Design and what is below it. To be called inside of the
    caller's transaction; solids follow (rebuild.py). `stored`: from `to_store`, where it is of what the
    Design holds now; made here where it is not given."""
    before = live.stored(obj)
    stored = stored or to_store(before, results)
    _complete(obj)
    keys = read_keys(obj)
    with obj.Proxy.many_changes():
        if "target" in results:
            for name, value in results["target"].fixes().items():  # L, where the mesh is taken as it is
                properties.write_parameter(obj, name, value)
        if "design" in results:
            _take_design(obj, results, stored.solved)
        elif "target" in results:
            _write_mesh(obj.Target, results["target"].V, results["target"].F)
        write_keys(obj, _keys_with(obj, results, keys, stored.solved))
        write(obj, "Results", stored.text)
    live.keep(obj, stored.made)
    obj.Proxy.refresh(obj)
    obj.touch()


def set_source(obj: Any, source: Any) -> None:
    """Another target for a Design: a Part or Mesh object, a file's path or a built-in's name. The results
    stay, out of date."""
    found = target.properties_for(source)
    if not target.is_target(obj.Target):
        obj.Target = _add_part(obj.Document, "Target")
    _write_source(obj.Target, found)
    obj.Proxy.refresh(obj)


def _write_source(obj: Any, found: Mapping[str, Any]) -> None:
    """found: target.properties_for a source."""
    for name, value in found.items():
        write(obj, name, value)


def set_cuts(obj: Any, edges: Any) -> None:
    """Other cuts for a Design, C x 2 vertices of its Target's mesh; the layout stays, out of date."""
    found = live.stored(obj).latest("target")
    if found is None:
        raise CurveUpsError("there are no tiles to cut between yet", obj.Label, "run Solve, or Cuts")
    edges = _edges_of(found, np.asarray(edges, int).reshape(-1, 2), obj.Label)
    _complete(obj)
    write_cuts(obj.Cuts, edges, found.V)
    obj.Proxy.refresh(obj)


def cuts_of(obj: Any) -> np.ndarray:
    """C x 2 vertices of the Target's mesh, as they are asked for. Raises CurveUpsError where they are no
    edges of it."""
    edges = edges_of(obj.Cuts) if obj.Cuts is not None else np.zeros((0, 2), np.int32)
    found = live.stored(obj).latest("target") if len(edges) else None
    return edges if found is None else _edges_of(found, edges, obj.Cuts.Label)


def _edges_of(target: Any, edges: np.ndarray, where: str) -> np.ndarray:
    """Edges whose vertices a target has."""
    if len(edges) and not (0 <= edges.min() and edges.max() < len(target.V)):
        raise CurveUpsError("a cut runs along no edge of the target", where, "pick the edges again")
    return edges


def has_layout(obj: Any) -> bool:
    """Whether a Design holds a layout, current or not. Commands ask several times a second: the states below
    read all results."""
    return status.is_solved(read_keys(obj))


def state_of(obj: Any) -> tuple[str, str]:
    """State (empty, current, out of date, invalid, running) and reason of a Design."""
    found = obj.Proxy.state(obj)
    return found.state, "; ".join(map(str, found.reasons))


def set_running(obj: Any, running: bool) -> None:
    """Says whether a command works on a Design just now; nothing else sets a state."""
    obj.Proxy.running = running
    obj.Proxy.refresh(obj)


def visibility(obj: Any, solids: bool) -> dict[str, bool]:
    """What is shown of a design without an overlay, by object: its solids or its target, where an overlay
    would lie upon them."""
    shown = {"Target": not solids, "Tiles": solids, "Support": False, "Anchors": solids}
    parts = {slot: part for slot in SLOTS if (part := getattr(obj, slot)) is not None}
    return {obj.Name: False, **{part.Name: shown.get(slot, True) for slot, part in parts.items()}}


def _worth_keeping(results: Results, before: Mapping[str, Made], solved: bool) -> dict[str, Made]:
    """What a run made. What it was given keeps the key that it had; a design that it was given is the one
    that is stored already."""
    found = {}
    for name, one in results.made.items():
        known = before.get(name)
        if one.result.lasting and (solved or name != "design" or known is None):
            found[name] = one if one.key or known is None else replace(one, key=known.key)
    return found


def _take_design(obj: Any, results: Results, solved: bool) -> None:
    design = results.design
    if solved:
        cuts = results["division"].given if "division" in results else design.cuts
        places = results["target"] if "target" in results else design
        write_cuts(obj.Cuts, cuts, places.V)
        write_layout(obj.Layout, results, design)
        _write_mesh(obj.Target, places.V, places.F)
    if VERDICT in results or solved:
        write_verification(obj.Verification, results.get(VERDICT))
    write_figures(obj, results, solved)


def _keys_with(obj: Any, results: Results, before: Keys, solved: bool) -> Keys:
    """What the document knows of its results' origins after a run. What had a say in the verdict and is not
    current any more has none in the next."""
    made = {name: replace(one.record, key=one.key or before.records.get(name, one.record).key)
            for name, one in results.made.items()
            if solved or name != "design" or name not in before.records}
    keys = replace(before, records={**before.records, **made})
    if VERDICT in results or solved:
        values = results.parameters
        kept = {name: one for name, one in keys.records.items()
                if name in made or name not in BY_NAME or not BY_NAME[name].judges
                or changes(name, keys.records, values, ("design",)) == ()}
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
    """Adds objects that results are written to where somebody deleted them."""
    for slot in ("Cuts", "Layout", "Verification"):
        if getattr(obj, slot) is None:
            setattr(obj, slot, _add_part(obj.Document, slot))


def _add_objects(document: Any) -> Any:
    """A Design and what is below it."""
    import Mesh  # noqa: F401  their types are unknown before
    import Part  # noqa: F401

    obj = document.addObject("App::FeaturePython", "Design")
    DesignProxy(obj)
    for slot in SLOTS:
        part = _add_part(document, slot)
        if hasattr(part, "Placement"):
            part.Visibility = False  # what has no shape would only be grey in the tree
        setattr(obj, slot, part)
    show(obj)
    return obj


def _add_part(document: Any, slot: str) -> Any:
    """The object of one of SLOTS."""
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
    """Attaches lost proxies, shows all objects of ours, and compares targets with their sources."""
    lost = [obj for obj in document.Objects if type_of(obj) in TYPES and obj.Proxy is None]
    for obj in lost:
        TYPES[type_of(obj)](obj)
    for obj in document.Objects:
        if is_target(obj):
            target.notice(obj)
        show(obj)
    for design in designs(document) if lost else ():
        design.Proxy.refresh(design)
