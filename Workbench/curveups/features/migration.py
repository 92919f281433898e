# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of earlier versions, brought into today's shape when they are opened.

The first kept the layout as the text of design.json in a property of that name, called parameters as the
command line does (H_body), and their bodies pointed at the design instead of the other way round. Those of
0.1.0 stored the origins of their results as four texts: Solved, Judged, Rebuilt and BuiltFrom of each body.
"""

from __future__ import annotations

import json
import re
from dataclasses import replace
from typing import Any, Callable, Iterable, Iterator

import FreeCAD

from ..base.errors import CurveUpsError
from ..base.findings import Finding
from ..base.native import native, problem, translated
from ..project.project import Project
from ..stages import VERDICT
from . import document as documents, live, properties, rebuild, status, target
from .bodies import KINDS, BodiesProxy, add_keys
from .keys import Keys, read_keys, write_keys
from .proxy import Proxy, is_old


def migrate(document: Any) -> list[Any]:
    """The designs that were changed. Those that can't be read stay as they are, and the report view says
    why."""
    found = [obj for obj in document.Objects if is_old(obj)]
    for obj in found:
        reason = problem()
        try:
            if reason is not None:
                raise reason
            with translated(obj.Label):
                if "Solved" in obj.PropertiesList:
                    _convert(obj)
                    continue
                design = native.read_design(obj.Layout)
        except CurveUpsError as error:
            FreeCAD.Console.PrintError(f"{obj.Label} is of an older version and stays as it is: {error}\n")
            continue
        _migrate(obj, design)
    return [obj for obj in found if not is_old(obj)]


def _migrate(obj: Any, design: Any) -> None:
    touched = "Touched" in obj.State
    verdict = json.loads(obj.SolvedVerdict or "{}")
    names = {row.name: properties.property_name(row.name) for row in properties.rows()}
    old = {name: _value(obj, row) for row in properties.rows() if (name := row.name) in obj.PropertiesList}
    own = [(path, text) for path, text in obj.ExpressionEngine]
    for path, _ in own:
        obj.setExpression(path, None)
    bodies = {body.Kind: body for body in obj.InList if getattr(body, "Design", None) == obj}
    for body in bodies.values():
        body.Design = None  # FreeCAD 1.1 would count it among those that depend on the Design still
        body.removeProperty("Design")
    for name in (*old, "Layout", "SolvedVerdict", "Verdict", "Reasons"):
        obj.removeProperty(name)
    parts = {slot: bodies[kind] for slot, kind in KINDS.items() if kind in bodies}
    surface = obj.Document.getObject("Target")
    if surface is not None and surface.TypeId == "Mesh::Feature" and not target.is_target(surface):
        target.make_target(surface)
        parts["Target"] = surface
    for body in bodies.values():
        BodiesProxy(body)
    documents.make_design(obj, parts)
    properties.write_parameters(obj, design.parameters)
    documents.take(obj, Project.of_design(design, obj.Label).run(("figures",)))
    keys = read_keys(obj)
    judged = rebuild.expected(keys, design.parameters, (VERDICT,))
    write_keys(obj, replace(keys, records={**keys.records, **judged}, valid=verdict.get("valid"),
                            reasons=tuple(map(Finding.read, verdict.get("reasons", ())))))
    for name, value in old.items():
        if not properties.same(value, design.parameters.get(name)):
            properties.write_parameter(obj, name, value)
    if not touched:
        _as_built(obj, bodies.values())
    _rename_expressions(obj, names, own)


def _convert(obj: Any) -> None:
    """Of a Design of 0.1.0, whose results carry their keys already."""
    solved, judged = (_record(obj, name) for name in ("Solved", "Judged"))
    bodies = [body for slot in KINDS if (body := getattr(obj, slot)) is not None]
    built = all(_record(body, "BuiltFrom").get("design") == solved.get("design") for body in bodies)
    Proxy.onDocumentRestored(obj.Proxy, obj)
    for body in bodies:
        add_keys(body)
    if solved:
        project = live.stored(obj)
        records = {name: one.record for name, one in {**project.made(), **project.given()}.items()}
        source = solved.get("source", {})
        reasons = tuple(map(Finding.read, judged.get("reasons", ())))
        write_keys(obj, Keys(records, judged.get("valid"), reasons,
                             source.get("stamp", ""), bool(source.get("object")), solved.get("cuts", ""),
                             getattr(obj, "ResultsDigest", "")))
        if built and status.status_of(obj).state != status.OUT_OF_DATE:
            _as_built(obj, bodies)
    for name in ("Solved", "Judged", "Rebuilt", "ResultsDigest"):
        if name in obj.PropertiesList:
            obj.removeProperty(name)
    for body in bodies:
        body.removeProperty("BuiltFrom")


def _record(obj: Any, name: str) -> dict[str, Any]:
    try:
        found = json.loads(getattr(obj, name, "") or "{}")
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _as_built(obj: Any, bodies: Iterable[Any]) -> None:
    """The solids are those of the design and values as they are."""
    keys = rebuild.expected(read_keys(obj), properties.values_of(obj), ("bodies",))
    for body in bodies:
        write_keys(body, Keys(keys))


def _value(obj: Any, row: Any) -> Any:
    """Of a property that is called as its parameter."""
    value = getattr(obj, row.name)
    return value.getValueAs(properties.UNITS.get(row.unit, row.unit)).Value if hasattr(
        value, "getValueAs") else value


def _rename_expressions(obj: Any, names: dict[str, str], own: list[tuple[str, str]]) -> None:
    """Expressions on the design's properties, and those of other objects and sheets that read them."""
    words = "|".join(map(re.escape, names))
    here = re.compile(rf"(?<![\w.#>])(\.?)({words})\b")
    there = re.compile(rf"((?<![\w.])(?:{re.escape(obj.Name)}|<<{re.escape(obj.Label)}>>)\.)({words})\b")

    def rename(match: re.Match) -> str:
        return match[1] + names[match[2]]

    for path, text in own:
        _try(obj, lambda: obj.setExpression(names.get(path, path), here.sub(rename, there.sub(rename, text))))
    for other in obj.Document.Objects:
        for path, text in getattr(other, "ExpressionEngine", ()) if other != obj else ():
            if there.search(text):
                _try(other, lambda: other.setExpression(path, there.sub(rename, text)))
        for cell in _cells(other):
            text = other.getContents(cell)
            if text.startswith("=") and there.search(text):
                _try(other, lambda: other.set(cell, there.sub(rename, text)))


def _cells(obj: Any) -> Iterator[str]:
    if obj.TypeId == "Spreadsheet::Sheet":
        yield from re.findall(r'address="([A-Z]+[0-9]+)"', obj.cells.Content)


def _try(obj: Any, change: Callable[[], Any]) -> None:
    try:
        change()
    except Exception as error:  # FreeCAD's own types: one expression must not cost the document
        FreeCAD.Console.PrintError(f"{obj.Label}: an expression could not be renamed: {error}\n")
