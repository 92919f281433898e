# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a document keeps of its results' origins, as texts in properties: they compare, and a stale "valid" is
noticed, without the native module too."""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Mapping, Optional

from ..base.findings import Finding
from ..project.keys import Record
from .proxy import write


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
