# SPDX-License-Identifier: LGPL-2.1-or-later
"""What results were made from, and what of it has changed since: the one place that says what is current.

Works on records of results, without the results and without the native module: documents ask it too.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Collection, Iterable, Mapping, Optional

from ..stages import BY_NAME
from ..stages.stage import Stage

Key = Mapping[str, str]  # what a result was made from: parameters and upstream results by name
Values = Any             # parameters: whatever has get(name)


@dataclass(frozen=True)
class Record:
    """What is known of a result without the result. content: what later stages know it by. settles:
    parameters that it decides for them."""

    key: Key = field(default_factory=dict)
    content: str = ""
    settles: Mapping[str, Any] = field(default_factory=dict)


Records = Mapping[str, Record]


def settled(names: Iterable[str], records: Records) -> dict[str, Any]:
    """Parameters that these results, and those that they were made from, decide."""
    values: dict[str, Any] = {}
    pending = [name for name in names if name in records]
    for name in pending:
        values.update(records[name].settles)
        if name in BY_NAME:
            pending += [other for other in BY_NAME[name].reads if other in records and other not in pending]
    return values


def key_of(stage: Stage, records: Records, values: Values) -> dict[str, str]:
    """What a result of the stage would be made from now."""
    known = _Over(settled(stage.reads, records), values)
    key = {name: repr(known.get(name)) for name in stage.parameters(known)}
    key.update({name: records[name].content for name in stage.reads})
    return key


def differences(record: Record, expected: Key) -> list[str]:
    """Names of what is not what the result was made from. A value that the result itself decided is the same,
    and so is one that lost its last digits in a document."""
    return [name for name, part in expected.items()
            if not _same(record.key.get(name), part)
            and not (name in record.settles and _same(repr(record.settles[name]), part))]


def changes(name: str, records: Records, values: Values,
            given: Collection[str] = ()) -> Optional[tuple[str, ...]]:
    """What has changed since the result of a stage was made: names of parameters and of results that it
    reads, none where it is current. None where there is no result. given: results that are not made."""
    changed: dict[str, None] = {}
    if not _compare(name, records, values, given, changed):
        return None
    decided = settled((name,), records)  # the target decides on L after the surface was read for another
    return tuple(part for part in changed
                 if part not in decided or not _same(repr(decided[part]), repr(values.get(part))))


def _compare(name: str, records: Records, values: Values, given: Collection[str],
             changed: dict[str, None]) -> bool:
    record = records.get(name)
    if record is None:
        return False
    if name in given:
        return True
    stage = BY_NAME[name]
    if not all(_compare(upstream, records, values, given, changed) for upstream in stage.reads):
        return False
    changed.update(dict.fromkeys(differences(record, key_of(stage, records, values))))
    return True


def _same(a: Optional[str], b: str) -> bool:
    if a == b:
        return True
    try:
        x, y = float(a or ""), float(b)
    except ValueError:
        return False
    return abs(x - y) <= 1e-12 * max(abs(x), abs(y))


class _Over:
    """Values, but for those that results have settled."""

    def __init__(self, settled: Mapping[str, Any], values: Values):
        self._settled, self._values = settled, values

    def get(self, name: str) -> Any:
        return self._settled[name] if name in self._settled else self._values.get(name)
