# SPDX-License-Identifier: LGPL-2.1-or-later
"""Data from which the sheets of a kit are drawn."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Callable, Mapping, Optional

import numpy as np

from ..base.errors import Stopped
from ..base.language import ENGLISH, Language
from ..base.native import native
from ..project.project import Results
from ..report.exports import File, doubtful
from ..stages.cut_request import sides_of_edges
from ..stages.solids import read_printer
from .beds import Beds, bed_name, beds
from .former import Former
from .ring import rings

MOST_NAMED = 12  # pairs of tiles that a step names


@dataclass
class Kit:
    """names: names of the print's files; named: gives those of its beds and shells. files: written so far,
    with bytes and SHA-256. go_on: called between pages; raises Stopped. say: the language of sheets."""

    results: Results
    report: dict[str, Any]
    quantity: int = 1
    names: Mapping[File, str] = field(default_factory=dict)
    named: Callable[[File], str] = lambda file: ".".join(file)
    files: dict[str, dict[str, Any]] = field(default_factory=dict)
    go_on: Callable[[], object] = lambda: None
    say: Language = ENGLISH
    pictures: dict[str, bytes] = field(default_factory=dict)  # drawn for steps of the assembly
    beds: Optional[Beds] = None  # of a print that does not fit one

    @property
    def name(self) -> str:
        """Name of the design, as its files have it."""
        return self.results.name

    @property
    def title(self) -> str:
        """Title of the design on every sheet, in any letters; says first that it is not valid."""
        return doubtful(self.results.title, self.report["valid"])

    @property
    def whole(self) -> list[str]:
        """The names of the 3MF and the STEP of all that is printed, where files have names; of beds, those of
        the 3MF of the first and the last."""
        if self.beds:
            return [self.named((bed_name(number), "3mf")) for number in (0, len(self.beds.places) - 1)]
        return [self.names[key] for ending in ("3mf", "step") if (key := ("print", ending)) in self.names]

    @cached_property
    def borders(self) -> dict[str, Any]:
        """How pieces lie to one another, for report and kit.json: pairs of tiles (rows of F) of two pieces
        that lie side by side in shape, and of each two pieces some that lie far apart."""
        design = self.results.design
        V, F = np.asarray(design.V), np.asarray(design.F)
        piece = np.asarray(native.pieces_of_faces(V, F, design.cuts))
        sides = sides_of_edges(F)
        middles: dict[tuple[int, ...], dict[tuple[int, ...], np.ndarray]] = {}  # by pieces and tiles
        for a, b in np.sort(design.cuts, axis=1).tolist():
            pair = tuple(tile for tile, _ in sides.get((a, b), ()))
            between = tuple(sorted({int(piece[tile]) for tile in pair}))
            if len(between) == 2:
                middles.setdefault(between, {})[pair] = V[[a, b]].mean(0)
        most = max(1, min(4, MOST_NAMED // max(1, len(middles))))
        named = [pair for _, pairs in sorted(middles.items()) for pair in _far_apart(pairs, most)]
        return {"pairs": sorted(list(pair) for pairs in middles.values() for pair in pairs),
                "named": [list(pair) for pair in named]}

    @property
    def model(self) -> Any:
        """The native PrintModel."""
        return self.results["bodies"].model

    @property
    def prints(self) -> list[Any]:
        """The native PrintModel of each bed."""
        return [self.model] if self.beds is None else list(map(self.beds.bed, range(len(self.beds.places))))

    def written(self, model: Any, ending: str, kind: str, title: str = "") -> bytes:
        """A file of a native PrintModel; title: by default the kit's. Raises Stopped, native.Cancelled."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"print.{ending}"
            model.write(ending, kind, str(path), self.asked, title or self.title)
            return path.read_bytes()

    def asked(self, *_: Any) -> bool:
        """Progress of native work: False stops it."""
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

    def divide(self) -> None:
        """Divide the print among beds where it does not fit one. Raises native.Cancelled."""
        self.beds = beds(self.results.design, self.model, self.printer, self.shapes, self.asked)

    @cached_property
    def formers(self) -> list[Former]:
        """Former of each piece."""
        return Former.of(self.results.design, self.results.parameters, self.report["area"])

    @cached_property
    def shapes(self) -> Any:
        """The tiles' native TileShapes."""
        return native.tile_shapes(self.results.design)


def _far_apart(places: Mapping[tuple[int, ...], np.ndarray], count: int) -> list[tuple[int, ...]]:
    """At most `count` keys: the first, then always the key farthest from those before."""
    keys = sorted(places)
    points = np.array([places[key] for key in keys])
    chosen = [0]
    while len(chosen) < min(count, len(keys)):
        away = np.linalg.norm(points[:, None] - points[chosen], axis=2).min(1)
        chosen.append(int(away.argmax()))
    return [keys[k] for k in chosen]
