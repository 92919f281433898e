# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the sheets of a kit are made from."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Callable

import numpy as np

from ..base.native import native
from ..project.project import Results


@dataclass
class Kit:
    """files: what is there so far, with bytes and SHA-256. go_on: called between pages; raises Stopped."""

    results: Results
    report: dict[str, Any]
    quantity: int = 1
    files: dict[str, dict[str, Any]] = field(default_factory=dict)
    go_on: Callable[[], object] = lambda: None

    @property
    def name(self) -> str:
        """Of files."""
        return self.results.name

    @property
    def title(self) -> str:
        """What every sheet says of the design, in any letters; one that should not be printed says so "
          "first."""
        return ("NOT VALID " if self.report["valid"] is False else "") + self.results.title

    @property
    def model(self) -> Any:
        """The native PrintModel."""
        return self.results["solids"].model

    @cached_property
    def shapes(self) -> Any:
        """The tiles' native TileShapes."""
        return native.tile_shapes(self.results.design)

    @cached_property
    def weak_tiles(self) -> np.ndarray:
        """Rows of F of the weakest contacts, ascending."""
        found = {tile for one in self.report.get("worst_contacts", ()) for tile in one["tiles"]}
        return np.array(sorted(found), int)
