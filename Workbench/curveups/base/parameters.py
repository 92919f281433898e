# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameter table as data. The native module's build writes it from the one table in
native/curveups/design/parameter_table.cpp, so that documents know their parameters without the module."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Mapping

from .errors import CurveUpsError
from .native import native

_FILE = Path(__file__).with_name("parameters.json")
_SOLIDS, _PHYSICS = {"tiles", "bodies", "support"}, {"physics", "settle"}


@dataclass(frozen=True)
class Parameter:
    """A row. type: "number", "switch", "choice", or the kind of a text without choices. readers: parts of the
    engine that read it. minimum and maximum: closed range of a number. basic: shown first. keeps_layout: a
    change needs no new layout."""

    name: str
    unit: str
    group: str
    meaning: str
    readers: frozenset[str]
    type: str
    default: Any
    minimum: float
    maximum: float
    choices: tuple[str, ...]
    basic: bool
    keeps_layout: bool

    @property
    def level(self) -> str:
        """basic, advanced, or switch (a stage runs or not: commands of the window decide that)."""
        return "switch" if self.group == "Stages" else "basic" if self.basic else "advanced"

    @property
    def effect(self) -> str:
        """Consequence of a change: layout (a new one), rebuild (solids, at once), verify, or files (the next
        export)."""
        if not self.keeps_layout:
            return "layout"
        return "rebuild" if self.readers & _SOLIDS else "verify" if self.readers & _PHYSICS else "files"


@lru_cache(maxsize=None)
def table() -> tuple[Parameter, ...]:
    """Every parameter, in the order in which they are shown. Raises CurveUpsError where nothing is built."""
    try:
        rows = json.loads(_FILE.read_text(encoding="utf-8"))
    except OSError as error:
        raise CurveUpsError("the parameter table is missing", str(_FILE), "run tools/setup") from error
    for row in rows:
        row.update(readers=frozenset(row["readers"]), choices=tuple(row["choices"]))
    return tuple(Parameter(**row) for row in rows)


@lru_cache(maxsize=None)
def parameter(name: str) -> Parameter:
    """The row of one parameter. Raises KeyError for an unknown name."""
    return {row.name: row for row in table()}[name]


def with_values(parameters: Any, values: Mapping[str, Any]) -> Any:
    """A copy of native Parameters with other values of some."""
    changed = native.Parameters(parameters)
    for name, value in values.items():
        changed.set(name, value)
    return changed


def without_switches(design: Any) -> Any:
    """Parameters of a native Design, if any, but for stages, which commands choose."""
    defaults = native.Parameters()
    return with_values(design.parameters, {
        row.name: defaults.get(row.name) for row in table() if row.level == "switch"}) if design else defaults
