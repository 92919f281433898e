# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of a Design and of the objects below it: one comparison of the properties with the keys that the
document stores of its results (keys.py). Works without the native module.

`refresh` alone sets a state. A recompute calls it, and so does whatever writes results.
"""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Iterable, Mapping, Optional, Sequence

from ..base.errors import CurveUpsError
from ..base.findings import Finding, Style, refused
from ..base.native import native, problem
from ..base.parameters import parameter
from ..project.keys import Record, changes
from ..project.project import HOLDS, VERDICTS
from ..stages import BY_NAME, RISEN, SETTLED, label_of
from . import properties
from .proxy import write
from .target import is_target

KINDS = {"Tiles": "tiles", "Support": "support", "Anchors": "anchors"}  # of bodies, by slot


@dataclass(frozen=True)
class Keys:
    """records: of results by their stage. valid and reasons: the verdict of the run that ended with them;
    holds: whether the shape does, by settled forces.
    stamp, linked and cuts: the source, whether it is an object, and the cuts that were asked for.
    failed: whether no solids can be made, for these reasons."""

    records: Mapping[str, Record] = field(default_factory=dict)
    valid: Optional[bool] = None
    reasons: tuple[Finding, ...] = ()
    stamp: str = ""
    linked: bool = False
    cuts: str = ""
    failed: bool = False
    holds: Optional[bool] = None


NONE = Keys()


def write_keys(obj: Any, keys: Keys, name: str = "Keys") -> None:
    """Store keys in a property of an object."""
    data = {part.name: getattr(keys, part.name) for part in dataclasses.fields(keys)}
    data.update(records={stage: dataclasses.asdict(record) for stage, record in keys.records.items()},
                reasons=[reason.data for reason in keys.reasons])
    write(obj, name, json.dumps(data, sort_keys=True))


def read_keys(obj: Any, name: str = "Keys") -> Keys:
    """Keys in a property of an object; NONE where there are none, or they are of another version."""
    return _keys_of(getattr(obj, name, ""))


@lru_cache(maxsize=64)
def _keys_of(text: Any) -> Keys:
    """Keys as an object. Commands read them several times a second, and reasons may name every tile."""
    data = json.loads(text or "{}")
    try:
        records = {stage: Record(**record) for stage, record in data.pop("records", {}).items()}
        reasons = tuple(map(Finding.read, data.pop("reasons", ())))
        return Keys(records, reasons=reasons, **data)
    except (LookupError, TypeError):
        return NONE


def digest_of_edges(edges: Any) -> str:
    """A short text for a flat list of vertex pairs; empty for none."""
    return " ".join(str(int(v)) for v in edges)


EMPTY, CURRENT, OUT_OF_DATE, INVALID, RUNNING = "empty", "current", "out of date", "invalid", "running"
GIVEN = ("source", "cut request")  # results that are not made
_CHANGED = Record(content="changed")  # stands for a given result that is not the stored one
_NAMED = Style(properties.named)


@dataclass(frozen=True)
class Status:
    """`settled`: settled forces are those of the present values. `parts`: (state, reason) by slot; `kit` and
    `actuation`: those of the fabrication kit and of the path from flat. `to_build`: solids are missing or out
    of date, and no reason is known why they can't be built."""

    state: str
    verdict: str
    holds: str
    settled: bool
    reasons: tuple[Finding, ...]
    parts: Mapping[str, tuple[str, str]]
    kit: tuple[str, str]
    actuation: tuple[str, str]
    to_build: bool


def refresh(obj: Any) -> Status:
    """Write the states of a Design and of the objects below it. New reasons of an invalid design go to the
    report view."""
    import FreeCAD

    now = status_of(obj)
    reasons = [reason.sentence(_NAMED) for reason in now.reasons]
    if now.state == INVALID and reasons != obj.Reasons:
        for reason in reasons:
            FreeCAD.Console.PrintError(f"{obj.Label}: {reason}\n")
    for name, value in (("Verdict", now.verdict), ("Holds", now.holds), ("Reasons", reasons),
                        ("Status", now.state), ("Kit", _line(now.kit)), ("Actuation", _line(now.actuation))):
        write(obj, name, value)
        if ("Hidden" in obj.getEditorMode(name)) == bool(value):
            obj.setEditorMode(name, [] if value else ["Hidden"])
    for slot, (state, reason) in now.parts.items():
        part = getattr(obj, slot)
        if part is not None and {"Status", "Reason"} <= set(part.PropertiesList):
            write(part, "Status", state)
            write(part, "Reason", reason)
    return now


def status_of(obj: Any) -> Status:
    """Compare the properties of a Design, edits that wait for a recompute included, with what its results
    were made from."""
    keys, values = read_keys(obj), properties.values_of(obj)
    solved, wrong = is_solved(keys), _refused(obj)
    source = _source_changes(obj, keys)
    cuts = [Finding("changed.cuts")] if solved and _edges(obj) != keys.cuts else []
    records = {**keys.records, **({"source": _CHANGED} if source else {}),
               **({"cut request": _CHANGED} if cuts else {})}
    target = source + _changed("changed.divided", changes("target", records, values, GIVEN))
    of_layout = [name for name in changes("design", records, values, GIVEN) or ()
                 if _is_result(name) or not parameter(name).keeps_layout]
    layout = source + cuts + _changed("changed.solved", of_layout)
    judged = _verdict_changes(keys, values)
    bodies = {slot: body_changes(read_keys(getattr(obj, slot)), keys, values) for slot in KINDS}
    built = read_keys(obj, "RebuiltKeys")
    known = NONE if body_changes(built, keys, values) else built

    if wrong:
        state, verdict, reasons = INVALID, VERDICTS[False], [wrong]
    elif not solved:
        state, verdict, reasons = EMPTY, VERDICTS[None], [Finding("no_layout")]
    else:
        state, verdict, reasons = _judgement(keys, known, layout, judged)

    verification = _part(keys.valid is not None, layout or judged)
    if verification[0] == CURRENT and keys.valid is False:
        verification = INVALID, "; ".join(map(str, keys.reasons))
    parts = {
        "Target": _part(solved or has_tiles(obj), target),
        "Cuts": _part(solved or bool(_edges(obj)), cuts),
        "Layout": _part(solved, layout),
        "Verification": verification,
        **{slot: _built(changed) for slot, changed in bodies.items()}}
    kit = body_changes(read_keys(obj, "KitKeys"), keys, values, of_files=True)
    risen = changes(RISEN, keys.records, values, ("design",))
    # Any edit leaves open whether the shape holds by settled forces.
    settled = not (layout or judged or wrong) and changes(SETTLED, records, values, ("design",)) == ()
    return Status(
        RUNNING if obj.Proxy.running else state, verdict, HOLDS[keys.holds if settled else None], settled,
        tuple(reasons), parts, _built(kit, layout),
        _built(None if risen is None else _changed("changed.risen", risen), layout),
        solved and not wrong and not known.failed and any(
            getattr(obj, slot) is not None and changed != [] for slot, changed in bodies.items()))


def awaits_settling(obj: Any) -> bool:
    """True where the verdict is current and settled forces are unknown."""
    now = status_of(obj)
    return not now.settled and now.parts["Verification"][0] in (CURRENT, INVALID)


def is_solved(keys: Keys) -> bool:
    """True where there is a layout."""
    return "design" in keys.records


def has_tiles(obj: Any) -> bool:
    """True where the Target of a Design has been divided into tiles."""
    return is_target(obj.Target) and obj.Target.Mesh.CountFacets > 0


def body_changes(built: Keys, keys: Keys, values: Mapping[str, Any], of_files: bool = False
                 ) -> Optional[list[Finding]]:
    """Changes since bodies were built, and with `of_files` written; None where none were."""
    if not built.records or not is_solved(keys):
        return None
    records = {**built.records, "design": keys.records["design"]}
    names: dict[str, None] = {}
    for stage in built.records:
        names.update(dict.fromkeys(changes(stage, records, values, ("design",)) or ()))
    if "design" in names:
        return [Finding("changed.layout")]
    return _changed("changed.built", [name for name in names if not _is_result(name)
                                      and (of_files or parameter(name).effect != "files")])


def _refused(obj: Any) -> Optional[Finding]:
    """Reason why the properties' values can't be used; None where they can, or it is not known."""
    if problem() is not None:
        return None
    try:
        properties.read_parameters(obj, native.Parameters())
    except CurveUpsError as error:
        return refused(error)
    return None


def _verdict_changes(keys: Keys, values: Mapping[str, Any]) -> list[Finding]:
    """Changes since the design was judged."""
    names: dict[str, None] = {}
    for stage, record in keys.records.items():
        made_from = {name: text.strip("'") for name, text in record.key.items()}
        if stage in BY_NAME and any(map(BY_NAME[stage].contributes, (values, made_from))):
            changed = changes(stage, keys.records, values, ("design",)) or ()
            names.update((name, None) for name in changed if not _is_result(name))
    return _changed("changed.judged", names)


def _judgement(keys: Keys, known: Keys, layout: list[Finding], judged: list[Finding]
               ) -> tuple[str, str, list[Finding]]:
    """State, verdict and reasons of a solved design. known: of its solids at the present values, or NONE.
    layout, judged: changes since then."""
    if known.failed:
        return INVALID, VERDICTS[False], list(known.reasons)
    broken = list(known.reasons) if judged else []
    if layout:
        return OUT_OF_DATE, OUT_OF_DATE, layout + broken
    if broken:
        return INVALID, VERDICTS[False], broken
    if judged and keys.valid is not None:
        return OUT_OF_DATE, OUT_OF_DATE, judged
    reasons = list(keys.reasons)
    if keys.valid is None and not reasons:
        reasons = [Finding("unjudged")]
    return (INVALID if keys.valid is False else CURRENT), VERDICTS[keys.valid], reasons


def _is_result(name: str) -> bool:
    return name in BY_NAME or name in GIVEN


def _changed(kind: str, names: Optional[Iterable[str]]) -> list[Finding]:
    """A finding that names changed parameters, or else changed results; given results have sentences of their
    own."""
    others = [name for name in names or () if name not in GIVEN]
    called = [properties.property_name(name) for name in others
              if not _is_result(name) and parameter(name).level != "switch"]
    called = called or [label_of(name) for name in others if name in BY_NAME]
    return [Finding.about(kind, names=", ".join(called))] if called else []


def _source_changes(obj: Any, keys: Keys) -> list[Finding]:
    if not is_solved(keys) and "target" not in keys.records:
        return []
    if obj.Target is None:
        return [Finding("no_target")]
    if not is_target(obj.Target) or "source" not in keys.records:
        return []
    if keys.linked and obj.Target.Source is None and not (obj.Target.File or obj.Target.BuiltIn):
        return [Finding("no_target.source")]
    if getattr(obj.Target, "Stamp", "") != keys.stamp:
        name = obj.Target.Source.Label if obj.Target.Source else obj.Target.File or obj.Target.BuiltIn
        return [Finding.about("changed.source", name=name)]
    return []


def _edges(obj: Any) -> str:
    return digest_of_edges(obj.Cuts.Edges) if obj.Cuts is not None else ""


def _part(exists: bool, changed: Sequence[Finding]) -> tuple[str, str]:
    if not exists:
        return EMPTY, ""
    return (OUT_OF_DATE, "; ".join(map(str, changed))) if changed else (CURRENT, "")


def _built(changed: Optional[list[Finding]], before: Sequence[Finding] = ()) -> tuple[str, str]:
    """State and reason of what is made from a layout. changed: None where it was not made; before: changes of
    the layout."""
    return _part(changed is not None, [*before, *(changed or ())])


def _line(part: tuple[str, str]) -> str:
    """State and reason; nothing of what was never made."""
    return "" if part[0] == EMPTY else ": ".join(filter(None, part))
