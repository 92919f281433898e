# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a Design and what is below it are what its properties say.

Derived from records of what results were made from, each time anew: the records are texts in the
document, so that this works, and a stale "valid" is noticed, without the native module too.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from typing import Any, Mapping

from . import layout as layouts, properties, verification as verifications
from .target import is_target

EMPTY, CURRENT, OUT_OF_DATE, INVALID, RUNNING = "empty", "current", "out of date", "invalid", "running"
_OF_TARGET = ("L", "Scale", "Flip")
# What the fields of records are; a record with another is damaged, and none.
_KINDS: dict[str, Any] = {"parameters": dict, "reasons": list, "valid": (bool, type(None)), "design": str,
                          "cuts": str, "source": dict, "failure": str}
SPOILT = "the stored results are damaged or were changed by hand"
VERDICTS = {True: "valid", False: "not valid", None: "not judged"}


@dataclass(frozen=True)
class Status:
    """`parts`: (state, reason) by slot."""

    state: str
    verdict: str
    reasons: tuple[str, ...]
    parts: Mapping[str, tuple[str, str]]


def status_of(obj: Any, refused: str = "", running: bool = False) -> Status:
    """`refused`: why the properties' values can't be used, where they can't."""
    solved, judged = record(obj, "Solved"), record(obj, "Judged")
    now, then = properties.parameters_of(obj), solved.get("parameters", {})
    source = _source_changes(obj, solved)
    target = source + _changed(now, {name: then[name] for name in _OF_TARGET if name in then},
                               "the target was divided", "Solve")
    cuts = []
    if solved and _digest_of_cuts(obj) != solved.get("cuts", ""):
        cuts = [_remedied("the cuts changed since the layout was solved", "Solve")]
    lists = []
    if not layouts.is_intact(obj.Layout):
        lists.append(_remedied("the layout's lists were changed by hand", "Solve"))
    if solved and not are_intact(obj):
        lists.append(_remedied(SPOILT, "Solve"))
    layout = source + cuts + lists + _changed(now, then, "the layout was solved", "Solve")
    verification = _changed(now, judged.get("parameters", {}), "the design was judged", "Verify")
    if not verifications.is_intact(obj.Verification):
        verification.append(_remedied("the verification's lists were changed by hand", "Verify"))
    if not solved:
        lost = "what was said of the layout's making is damaged or gone" if getattr(
            obj, "Results", "") else "there is no layout yet"
        state, verdict, reasons = EMPTY, VERDICTS[None], [f"{lost}: Solve makes it"]
    else:
        state, verdict, reasons = _judgement(obj, judged, layout, verification)
    if refused:
        state, verdict, reasons = INVALID, VERDICTS[False], [refused]
    there = bool(solved)
    parts = {
        "Target": _part(there or (is_target(obj.Target) and obj.Target.Mesh.CountFacets > 0), target),
        "Cuts": _part(there or bool(_digest_of_cuts(obj)), cuts),
        "Layout": _part(there, layout),
        "Verification": _part(judged.get("valid") is not None, layout or verification),
        **{slot: _body(getattr(obj, slot), now, solved) for slot in ("Tiles", "Support", "Anchors")}}
    if parts["Verification"][0] == CURRENT and judged["valid"] is False:
        parts["Verification"] = (INVALID, "; ".join(judged["reasons"]))
    if running:
        state = RUNNING
    return Status(state, verdict, tuple(reasons), parts)


def record(obj: Any, name: str) -> dict[str, Any]:
    """One of the texts that say what was made from what; empty where nothing was made."""
    try:
        found = json.loads(getattr(obj, name, "") or "{}")
    except ValueError:
        return {}
    if not isinstance(found, dict) or not all(
            isinstance(value, _KINDS.get(name, object)) for name, value in found.items()):
        return {}
    return found if all(isinstance(line, str) for line in found.get("reasons", ())) else {}


def are_intact(obj: Any) -> bool:
    """Whether the text of the results is the one that was written."""
    written = getattr(obj, "ResultsDigest", "")
    return not written or written == digest_of_text(obj.Results)


def digest_of_text(text: str) -> str:
    """Tells texts apart."""
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def known_of_values(obj: Any) -> dict[str, Any]:
    """What is known of the design at the geometry as it is: reasons, or the failure to build it."""
    rebuilt = record(obj, "Rebuilt")
    if rebuilt.get("design") != record(obj, "Solved").get("design") or changed_names(
            properties.parameters_of(obj), rebuilt.get("parameters", {})):
        return {}
    return rebuilt


def changed_names(now: Mapping[str, Any], then: Mapping[str, Any]) -> list[str]:
    """Parameters that are not what they were."""
    return [name for name, value in then.items() if name not in now or not properties.same(now[name], value)]


def _judgement(obj: Any, judged: Mapping[str, Any], layout: list[str],
               verification: list[str]) -> tuple[str, str, list[str]]:
    known = known_of_values(obj)
    if known.get("failure"):
        return INVALID, VERDICTS[False], [known["failure"]]
    broken = list(known.get("reasons", ())) if verification else []
    if layout:
        return OUT_OF_DATE, OUT_OF_DATE, layout + broken
    if broken:
        return INVALID, VERDICTS[False], broken
    if verification and judged.get("valid") is not None:
        return OUT_OF_DATE, OUT_OF_DATE, verification
    valid = judged.get("valid")
    reasons = list(judged.get("reasons", ()))
    if valid is None and not reasons:
        reasons = ["it was not verified: Verify judges it"]
    return (INVALID if valid is False else CURRENT), VERDICTS[valid], reasons


def _changed(now: Mapping[str, Any], then: Mapping[str, Any], since: str, command: str) -> list[str]:
    names = changed_names(now, then)
    return [_remedied(f"{', '.join(names)} changed since {since}", command)] if names else []


def _remedied(text: str, command: str) -> str:
    return f"{text}: {command} brings it up to date"


def _source_changes(obj: Any, solved: Mapping[str, Any]) -> list[str]:
    if not solved:
        return []
    if obj.Target is None:
        return ["the target was deleted: choose another with Target"]
    if not is_target(obj.Target) or "source" not in solved:
        return []
    if solved["source"].get("object") and obj.Target.Source is None and not (
            obj.Target.File or obj.Target.BuiltIn):
        return ["the object that gave the target was deleted: choose another with Target"]
    if getattr(obj.Target, "Stamp", "") != solved["source"].get("stamp"):
        name = obj.Target.Source.Label if obj.Target.Source else obj.Target.File or obj.Target.BuiltIn
        return [_remedied(f"the target's source {name} changed since the layout was solved", "Solve")]
    return []


def _digest_of_cuts(obj: Any) -> str:
    return digest_of_edges(obj.Cuts.Edges) if obj.Cuts is not None else ""


def digest_of_edges(edges: Any) -> str:
    """A short text for a flat list of vertex pairs; empty for none."""
    return " ".join(str(int(v)) for v in edges)


def _part(there: bool, changes: list[str]) -> tuple[str, str]:
    if not there:
        return EMPTY, ""
    return (OUT_OF_DATE, "; ".join(changes)) if changes else (CURRENT, "")


def _body(body: Any, now: Mapping[str, Any], solved: Mapping[str, Any]) -> tuple[str, str]:
    built = record(body, "BuiltFrom") if body is not None else {}
    if not built:
        return EMPTY, ""
    if built.get("design") != solved.get("design"):
        return OUT_OF_DATE, _remedied("the layout changed since this was built", "BuildSolids")
    return _part(True, _changed(now, built.get("parameters", {}), "this was built",
                                "BuildSolids"))
