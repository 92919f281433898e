# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a Design and what is below it are what its properties say: a view of the project, through the keys
that the document stores (keys.py). Works without the native module."""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Iterable, Mapping, Optional, Sequence

from ..base.findings import Finding
from ..base.parameters import parameter
from ..project.keys import Record, changes
from ..project.project import HOLDS
from ..stages import BY_NAME, RISEN, SETTLED, label_of
from . import properties
from .proxy import write
from .target import is_target


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
    """Into a property of an object."""
    data = {one.name: getattr(keys, one.name) for one in dataclasses.fields(keys)}
    data.update(records={stage: dataclasses.asdict(one) for stage, one in keys.records.items()},
                reasons=[one.data for one in keys.reasons])
    write(obj, name, json.dumps(data, sort_keys=True))


def read_keys(obj: Any, name: str = "Keys") -> Keys:
    """NONE where there are none, or they are of another version."""
    return _keys_of(getattr(obj, name, ""))


@lru_cache(maxsize=64)
def _keys_of(text: Any) -> Keys:
    """States ask dozens of times for each change, and reasons may name every tile."""
    data = json.loads(text or "{}")
    try:
        records = {stage: Record(**one) for stage, one in data.pop("records", {}).items()}
        reasons = tuple(map(Finding.read, data.pop("reasons", ())))
        return Keys(records, reasons=reasons, **data)
    except (LookupError, TypeError):
        return NONE


def digest_of_edges(edges: Any) -> str:
    """A short text for a flat list of vertex pairs; empty for none."""
    return " ".join(str(int(v)) for v in edges)


EMPTY, CURRENT, OUT_OF_DATE, INVALID, RUNNING = "empty", "current", "out of date", "invalid", "running"
VERDICTS = {True: "valid", False: "not valid", None: "not judged"}
_CHANGED = Record(content="changed")  # what was given, and is not what it was
GIVEN = ("source", "cut request")  # results that are not made


@dataclass(frozen=True)
class Status:
    """`parts`: (state, reason) by slot; `kit` and `actuation`: those of the fabrication kit and of the path
    from flat."""

    state: str
    verdict: str
    holds: str
    reasons: tuple[Finding, ...]
    parts: Mapping[str, tuple[str, str]]
    kit: tuple[str, str]
    actuation: tuple[str, str]


def status_of(obj: Any, refused: Optional[Finding] = None, running: bool = False) -> Status:
    """`refused`: why the properties' values can't be used, where they can't."""
    keys, values = read_keys(obj), properties.values_of(obj)
    solved = is_solved(keys)
    source = _source_changes(obj, keys)
    cuts = [Finding("changed.cuts")] if solved and _edges(obj) != keys.cuts else []
    records = {**keys.records, **({"source": _CHANGED} if source else {}),
               **({"cut request": _CHANGED} if cuts else {})}
    target = source + _changed("changed.divided", changes("target", records, values, GIVEN))
    of_layout = [name for name in changes("design", records, values, GIVEN) or ()
                 if _is_result(name) or not parameter(name).keeps_layout]
    layout = source + cuts + _changed("changed.solved", of_layout)
    verification = verdict_changes(keys, values)
    if not solved:
        state, verdict, reasons = EMPTY, VERDICTS[None], [Finding("no_layout")]
    else:
        state, verdict, reasons = _judgement(obj, keys, values, layout, verification)
    if refused:
        state, verdict, reasons = INVALID, VERDICTS[False], [refused]
    parts = {
        "Target": _part(solved or has_tiles(obj), target),
        "Cuts": _part(solved or bool(_edges(obj)), cuts),
        "Layout": _part(solved, layout),
        "Verification": _part(keys.valid is not None, layout or verification),
        **{slot: _built(body_changes(read_keys(getattr(obj, slot)), keys, values))
           for slot in ("Tiles", "Support", "Anchors")}}
    if parts["Verification"][0] == CURRENT and keys.valid is False:
        parts["Verification"] = (INVALID, "; ".join(map(str, keys.reasons)))
    if running:
        state = RUNNING
    kit = body_changes(read_keys(obj, "KitKeys"), keys, values, of_files=True)
    risen = changes(RISEN, keys.records, values, ("design",))
    # Any edit leaves open whether the shape holds by settled forces.
    settled = not (layout or verification or refused) and changes(SETTLED, records, values, ("design",)) == ()
    return Status(state, verdict, HOLDS[keys.holds if settled else None], tuple(reasons), parts,
                  _built(kit, layout),
                  _built(None if risen is None else _changed("changed.risen", risen), layout))


def is_solved(keys: Keys) -> bool:
    """Whether there is a layout."""
    return "design" in keys.records


def has_tiles(obj: Any) -> bool:
    """Whether the Target of a Design has been made into tiles."""
    return is_target(obj.Target) and obj.Target.Mesh.CountFacets > 0


def known_of_values(obj: Any, keys: Keys, values: Mapping[str, Any]) -> Keys:
    """What is known of the design at the geometry as it is: reasons, or the failure to build it."""
    found = read_keys(obj, "RebuiltKeys")
    return NONE if body_changes(found, keys, values) else found


def body_changes(built: Keys, keys: Keys, values: Mapping[str, Any], of_files: bool = False
                 ) -> Optional[list[Finding]]:
    """What has changed since bodies were built, and with `of_files` written; None where none were."""
    if not built.records or "design" not in keys.records:
        return None
    records = {**built.records, "design": keys.records["design"]}
    names: dict[str, None] = {}
    for stage in built.records:
        names.update(dict.fromkeys(changes(stage, records, values, ("design",)) or ()))
    if "design" in names:
        return [Finding("changed.layout")]
    rebuilt = tuple(name for name in names if not _is_result(name)
                    and (of_files or parameter(name).effect != "files"))
    return _changed("changed.built", rebuilt)


def verdict_changes(keys: Keys, values: Mapping[str, Any]) -> list[Finding]:
    """What has changed since the design was judged."""
    names: dict[str, None] = {}
    for stage, record in keys.records.items():
        made_from = {name: text.strip("'") for name, text in record.key.items()}
        if stage in BY_NAME and any(map(BY_NAME[stage].contributes, (values, made_from))):
            found = changes(stage, keys.records, values, ("design",)) or ()
            names.update((name, None) for name in found if not _is_result(name))
    return _changed("changed.judged", tuple(names))


def _judgement(obj: Any, keys: Keys, values: Mapping[str, Any], layout: list[Finding],
               verification: list[Finding]) -> tuple[str, str, list[Finding]]:
    known = known_of_values(obj, keys, values)
    if known.failed:
        return INVALID, VERDICTS[False], list(known.reasons)
    broken = list(known.reasons) if verification else []
    if layout:
        return OUT_OF_DATE, OUT_OF_DATE, layout + broken
    if broken:
        return INVALID, VERDICTS[False], broken
    if verification and keys.valid is not None:
        return OUT_OF_DATE, OUT_OF_DATE, verification
    reasons = list(keys.reasons)
    if keys.valid is None and not reasons:
        reasons = [Finding("unjudged")]
    return (INVALID if keys.valid is False else CURRENT), VERDICTS[keys.valid], reasons


def _is_result(name: str) -> bool:
    return name in BY_NAME or name in GIVEN


def _changed(kind: str, names: Optional[Iterable[str]]) -> list[Finding]:
    """Of parameters, or else of results; what was given has sentences of its own."""
    others = [name for name in names or () if name not in GIVEN]
    known = [properties.property_name(name) for name in others
             if not _is_result(name) and parameter(name).level != "switch"]
    known = known or [label_of(name) for name in others if name in BY_NAME]
    return [Finding.about(kind, names=", ".join(known))] if known else []


def _source_changes(obj: Any, keys: Keys) -> list[Finding]:
    if "design" not in keys.records and "target" not in keys.records:
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


def _part(there: bool, changed: list[Finding]) -> tuple[str, str]:
    if not there:
        return EMPTY, ""
    return (OUT_OF_DATE, "; ".join(map(str, changed))) if changed else (CURRENT, "")


def _built(changed: Optional[list[Finding]], before: Sequence[Finding] = ()) -> tuple[str, str]:
    """State of what is made from a layout, and why. changed: None where it is not there; before: changes
    of the layout."""
    return _part(changed is not None, [*before, *(changed or ())])
