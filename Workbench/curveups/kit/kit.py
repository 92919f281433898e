# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the sheets of a kit are made from."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np

from ..base.errors import Stopped
from ..base.language import ENGLISH, Language
from ..base.native import native
from ..project.project import Results
from ..report.exports import doubtful, plain
from ..stages.solids import read_printer
from .beds import Beds, beds
from .ring import rings
from .underside import Underside


@dataclass
class Kit:
    """files: what is there so far, with bytes and SHA-256. go_on: called between pages; raises Stopped. say:
    the language of sheets."""

    results: Results
    report: dict[str, Any]
    quantity: int = 1
    files: dict[str, dict[str, Any]] = field(default_factory=dict)
    go_on: Callable[[], object] = lambda: None
    say: Language = ENGLISH
    coupons: dict[str, Any] = field(default_factory=dict)  # native PrintModels that were made, by name
    _shell: Optional[tuple[Any, bytes]] = None  # the last that was made, of its model

    @property
    def name(self) -> str:
        """Of files."""
        return self.results.name

    @property
    def title(self) -> str:
        """What every sheet says of the design, in any letters, and first whether it is not valid."""
        return doubtful(self.plain_title, self.report["valid"])

    @property
    def plain_title(self) -> str:
        return plain(self.results)

    @property
    def has_bridges(self) -> bool:
        """Whether breakaway bridges join the tiles of the print."""
        support = native.support_kind(self.results.parameters)
        return bool(support.bodies) and not support.soluble

    @property
    def model(self) -> Any:
        """The native PrintModel."""
        return self.results["solids"].model

    def written(self, model: Any, ending: str, kind: str) -> bytes:
        """A file of a native PrintModel. Raises Stopped, native.Cancelled."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"print.{ending}"
            model.write(ending, kind, str(path), self._asked)
            return path.read_bytes()

    def _asked(self, *_: Any) -> bool:
        """For native work: whether it goes on."""
        try:
            self.go_on()
        except Stopped:
            return False
        return True

    @cached_property
    def printer(self) -> dict[str, Any]:
        """The printer's file."""
        return read_printer(self.results.parameters.get("printer"))

    @cached_property
    def rings(self) -> dict[str, Any]:
        """Sizes and strength of the stretching rings."""
        return rings(self.report["sheets"], self.report["print"]["bbox_mm"][2], self.printer["bed_mm"])

    @cached_property
    def beds(self) -> Optional[Beds]:
        """What goes on which bed, where one has no room for all. Raises native.Cancelled."""
        design = self.results.design.with_parameters(self.results.parameters)
        return beds(design, self.model, self.printer, self.shapes, self._asked)

    @cached_property
    def undersides(self) -> list[Underside]:
        """What ribs and former of each piece are made from."""
        return Underside.of(self.results.design, self.results.parameters, self.report["area"])

    def shell(self, model: Any) -> bytes:
        """The STL of a native PrintModel, each piece as one closed shell."""
        if self._shell is None or self._shell[0] is not model:
            self._shell = model, self.written(model, "stl", "fused")
        return self._shell[1]

    @cached_property
    def shapes(self) -> Any:
        """The tiles' native TileShapes."""
        return native.tile_shapes(self.results.design)

    @cached_property
    def weak_tiles(self) -> np.ndarray:
        """Rows of F of the weakest contacts, ascending."""
        found = {tile for one in self.report.get("worst_contacts", ()) for tile in one["tiles"]}
        return np.array(sorted(found), int)
