# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys: the inputs of each result, and which of them have changed since. Decides alone what is current.

Works on records of results, without the results and the native module, for documents too.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Collection, Iterable, Mapping, Optional

from ..stages import BY_NAME
from ..stages.stage import Stage

Key = Mapping[str, str]  # parameters and contents of upstream results, by name
Values = Any             # parameters: an object with get(name)


@dataclass(frozen=True)
class Record:
    """A result's key and digest without the result. fixes: parameters that it fixes for later stages."""

    key: Key = field(default_factory=dict)
    content: str = ""
    fixes: Mapping[str, Any] = field(default_factory=dict)


Records = Mapping[str, Record]


def fixed_parameters(names: Iterable[str], records: Records) -> dict[str, Any]:
    """Parameters fixed by these results and their inputs."""
    values: dict[str, Any] = {}
    pending = [name for name in names if name in records]
    for name in pending:
        values.update(records[name].fixes)
        if name in BY_NAME:
            pending += [other for other in BY_NAME[name].reads if other in records and other not in pending]
    return values


def key_of(stage: Stage, records: Records, values: Values) -> dict[str, str]:
    """Key of a result of the stage if it were made now."""
    known = _Over(fixed_parameters(stage.reads, records), values)
    key = {name: repr(known.get(name)) for name in stage.parameters(known)}
    key.update({name: records[name].content for name in stage.reads})
    return key


def differences(record: Record, expected: Key) -> list[str]:
    """Names in `expected` that differ from the result's key. Values that the result itself fixed are equal,
    and so are numbers that lost their last digits in a document."""
    return [name for name, part in expected.items()
            if not _same(record.key.get(name), part)
            and not (name in record.fixes and _same(repr(record.fixes[name]), part))]


def changes(name: str, records: Records, values: Values,
            given: Collection[str] = ()) -> Optional[tuple[str, ...]]:
    """Names of parameters and results that changed since the result of a stage was made; empty where it is
    current, None where there is no result. given: results that are not made."""
    changed: dict[str, None] = {}
    if not _compare(name, records, values, given, changed):
        return None
    fixed = fixed_parameters((name,), records)  # the target fixes L after the surface was read for another
    return tuple(part for part in changed
                 if part not in fixed or not _same(repr(fixed[part]), repr(values.get(part))))


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
    """Values, except those that results have fixed."""

    def __init__(self, fixed: Mapping[str, Any], values: Values):
        self._fixed, self._values = fixed, values

    def get(self, name: str) -> Any:
        return self._fixed[name] if name in self._fixed else self._values.get(name)
