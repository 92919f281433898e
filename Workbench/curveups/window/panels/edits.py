# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records the edits since a panel opened, to take them back at once."""

from __future__ import annotations

from typing import Any, Iterable

import FreeCADGui

from ...features.actions import transaction
from ...features.properties import same, value_of
from ..macro import assign, named
from .preferences import plain


class Edits:
    """Of parameters of a Design, by the names of their properties; expressions are edits too."""

    def __init__(self, design: Any, names: Iterable[str]):
        self._design = design
        self._values = {name: plain(getattr(design, name)) for name in names}
        self._numbers = {name: value_of(design, name) for name in self._values}
        self._expressions = self._bound()

    def edited(self) -> list[str]:
        """Names of what is not as it was."""
        bound = self._bound()
        return [name for name, number in self._numbers.items()
                if bound.get(name) != self._expressions.get(name)
                or not same(value_of(self._design, name), number)]

    def revert(self, title: str) -> None:
        """All is as it was: one step of undo."""
        names = self.edited()
        if not names:
            return
        with transaction(self._design.Document, title):
            for name in names:
                FreeCADGui.doCommand(f"{named(self._design)}.setExpression({name!r}, "
                                     f"{self._expressions.get(name)!r})")
                assign(self._design, name, self._values[name])
            self._design.Document.recompute()

    def _bound(self) -> dict[str, str]:
        return {path: text for path, text in self._design.ExpressionEngine if path in self._values}
