# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys: the inputs of each result, and which of them have changed since. Decides alone what is current.

Works on records of results, without the results and the native module, for documents too.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any, Collection, Iterable, Mapping, Optional

from ..stages import BY_NAME
from ..stages.stage import Stage

Key = Mapping[str, str]  # parameters and contents of upstream results, by name
Values = Any             # parameters: an object with get(name)


@dataclass(frozen=True)
class Record:
    """A result's key and digest without the result (else project.Made). fixes: parameters that it fixes for
    later stages."""

    key: Key = field(default_factory=dict)
    content: str = ""
    fixes: Mapping[str, Any] = field(default_factory=dict)


Records = Mapping[str, Any]  # of Record or project.Made


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
    fixed = fixed_parameters(stage.reads, records)
    known = SimpleNamespace(get=lambda name: fixed[name] if name in fixed else values.get(name))
    key = {name: repr(known.get(name)) for name in stage.parameters(known)}
    key.update({name: records[name].content for name in stage.reads})
    return key


def differences(record: Any, expected: Key) -> list[str]:
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

    def compare(name: str) -> bool:
        if name not in records or name in given:
            return name in records
        stage = BY_NAME[name]
        if not all(map(compare, stage.reads)):
            return False
        changed.update(dict.fromkeys(differences(records[name], key_of(stage, records, values))))
        return True

    if not compare(name):
        return None
    fixed = fixed_parameters((name,), records)  # the target fixes L after the surface was read for another
    return tuple(part for part in changed
                 if part not in fixed or not _same(repr(fixed[part]), repr(values.get(part))))


def _same(a: Optional[str], b: str) -> bool:
    if a == b:
        return True
    try:
        x, y = float(a or ""), float(b)
    except ValueError:
        return False
    return abs(x - y) <= 1e-12 * max(abs(x), abs(y))
