# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields: values that can colour tiles and contacts, by stages of a project.

A field is computed at its first use. To add one: a line in the function of its stage. Names and problems are
written as literals, and translated when they are shown.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, Callable, Mapping

import numpy as np

from ...base.native import native
from ...stages.feasibility import SAG

TILE, SIDE, CONTACT, MEMBRANE = "tile", "side", "contact", "membrane"


@dataclass(frozen=True)
class Field:
    """Values of every tile (M), of front and back of every tile (M x 2), of every contact (N), or of every
    triangle of the membranes, as `on` says.

    `unit`: as FreeCAD spells it, empty for ratios. `limit`: values on the `bad` side of it ("low", "high")
    are problems, marked by `mark`. `signed`: 0 is the middle. `part`: the object below the Design whose state
    is that of the values. `shape`: of the values if they can't be computed."""

    name: str
    unit: str
    on: str
    make: Callable[[], Any]
    bad: str = ""
    limit: Any = None
    mark: str = ""
    problem: str = ""
    signed: bool = False
    part: str = "Target"
    shape: tuple[int, ...] = (0,)

    @cached_property
    def values(self) -> np.ndarray:
        """Values; NaN if there is none, and all NaN if they can't be computed for this design."""
        try:
            return np.asarray(self.make(), float)
        except native.Error:
            return np.full(self.shape, np.nan)

    @cached_property
    def problems(self) -> np.ndarray:
        """Numbers of tiles or contacts beyond the limit."""
        if self.limit is None or not self.bad or self.on == MEMBRANE:
            return np.empty(0, int)
        slack = 1e-6 * max(1.0, abs(self.limit))
        with np.errstate(invalid="ignore"):  # values may be infinite
            over = self.values - self.limit
            beyond = over < -slack if self.bad == "low" else over > slack
        return np.flatnonzero(beyond.reshape(len(beyond), -1).any(axis=1))

    @cached_property
    def order(self) -> np.ndarray:
        """Numbers of tiles or contacts that have a value, the worst first."""
        values = self.worst
        known = np.flatnonzero(~np.isnan(values))
        keys = np.abs(values[known]) if self.signed else values[known]
        return known[np.argsort(keys if self.bad == "low" else -keys, kind="stable")]

    @cached_property
    def worst(self) -> np.ndarray:
        """Values by tile or contact: the worse of a tile's sides."""
        if self.values.ndim == 1:
            return self.values
        with np.errstate(invalid="ignore"):
            if self.bad == "low":
                return np.fmin.reduce(self.values, axis=1)
            return np.fmax.reduce(self.values, axis=1)

    @property
    def size(self) -> float:
        """Magnitude of the values."""
        low, high = self.automatic_range()
        return max(abs(low), abs(high))

    def automatic_range(self) -> tuple[float, float]:
        """Range of all but the hundredth of values at either end, about 0 if signed. Equal values get a range
        from half to half as much again, and zeros from 0 to 1."""
        values = self.values[np.isfinite(self.values)]
        if not len(values):
            return 0.0, 1.0
        low, high = map(float, np.percentile(values, (1, 99)))
        if self.signed:
            low, high = -max(abs(low), abs(high)), max(abs(low), abs(high))
        if high - low <= 1e-9 * max(abs(low), abs(high), 1e-9):
            half = abs(high) / 2
            low, high = (low - half, high + half) if half > 1e-9 else (-1.0 if self.signed else 0.0, 1.0)
        return low, high


def target_fields(V: np.ndarray, F: np.ndarray, cuts: np.ndarray, parameters: Any, contacts: np.ndarray,
                  judge: bool) -> list[Field]:
    """Fields of a target before any layout. judge: values beyond their limits are problems; with a layout
    they are not, since it has made room.

    Stretch has no limit: it is that of the start, scaled so that the median tile fits, and half of all tiles
    begin below the stretch that leaves their gaps."""
    figures = cache(lambda: native.target_figures(V, F, cuts, parameters))
    limits: dict[str, Any] = {"limit": _least_margin(parameters)} if judge else {}
    return [
        Field("Dihedral angle", "deg", CONTACT, lambda: _by_contact(figures(), "dihedral", contacts),
              signed=True, shape=(len(contacts),)),
        Field("Pin area margin", "mm^2", SIDE,
              lambda: figures().pin_area - parameters.get("A_pin_min"), "low",
              mark="diamond",
              problem="tiles with less space for pins than APinFloor, before Solve makes space",
              shape=(len(F), 2), **limits),
        Field("Conformal stretch", "", TILE, lambda: figures().stretch, "low", shape=(len(F),))]


def check_fields(check: Any, parameters: Any, contacts: np.ndarray) -> list[Field]:
    """Fields of a check (stages/feasibility.py): margins, after smoothing has made room for pins, and the
    number of obstacles of each tile."""
    count = len(check.F)
    tiles = [obstacle.tile for obstacle in check.blocked]
    return [
        Field("Dihedral margin", "deg", CONTACT,
              lambda: _by_contact(check, "dihedral_margin", contacts), "low", 0.0, shape=(len(contacts),)),
        Field("Pin area margin", "mm^2", SIDE, lambda: check.pin_area_margin, "low",
              _least_margin(parameters), shape=(count, 2)),
        Field("Membrane clearance", "mm", SIDE, lambda: check.membrane_clearance, "low",
              SAG * parameters.get("H_pin"), shape=(count, 2)),
        Field("Obstacles", "", TILE, lambda: np.bincount(tiles, minlength=count), "high", 0.5, "cross",
              problem="tiles that can't be made or are likely to fail", shape=(count,))]


def _least_margin(parameters: Any) -> float:
    """Margin over A_pin_min of the smallest pins of a valid design, mm2."""
    return float(parameters.get("A_pin_floor") - parameters.get("A_pin_min"))


def design_fields(design: Any, contacts: np.ndarray) -> list[Field]:
    """Fields of a layout without its membranes."""
    figures = cache(lambda: native.evaluate_design(design))
    get = design.parameters.get
    return [
        Field("Gap", "mm", CONTACT, lambda: _by_contact(figures(), "gap", contacts), "low", get("d_gap_min"),
              "square", problem="gaps below DGapMin", part="Layout", shape=(len(contacts),)),
        Field("Pin area", "mm^2", SIDE, lambda: figures().pin_area, "low", get("A_pin_floor"), "diamond",
              problem="tiles with pins below APinFloor", part="Layout", shape=(len(design.F), 2))]


def deviation_field(V: np.ndarray, F: np.ndarray, part: str, source_V: np.ndarray,
                    source_F: np.ndarray) -> Field:
    """Distances of the tiles' front faces from the surface before remeshing: the largest of corners, middles
    of edges, and centre."""
    def make() -> np.ndarray:
        corners = V[F]
        samples = np.concatenate([corners, (corners + np.roll(corners, 1, axis=1)) / 2,
                                  corners.mean(1, keepdims=True)], axis=1)
        distances = native.distances(samples.reshape(-1, 3), source_V, source_F)
        return np.reshape(distances, samples.shape[:2]).max(axis=1)

    return Field("Deviation", "mm", TILE, make, "high", part=part, shape=(len(F),))


def force_fields(verification: Any, contacts: np.ndarray, parameters: Any) -> list[Field]:
    """Fields of a verification."""
    arrays, blocks = verification.arrays, verification.blocks
    forces = blocks.get("contact_forces", {})
    f_min = forces.get("f_min")
    # Least squares may need more friction than other forces do: it is a problem only if no forces hold.
    holds = blocks.get("unilateral", {}).get("feasible", True)
    slipping = None if holds else parameters.get("friction_coefficient")
    fields = []
    if "contact_normal_min" in arrays:
        fields.append(Field("Normal force", "N", CONTACT,
                            lambda: aligned(arrays, "contact_normal_min", contacts), "low", f_min, "cross",
                            problem="contacts below f_min", part="Verification"))
    if "contact_friction_ratio" in arrays:
        fields.append(Field("Friction ratio", "", CONTACT,
                            lambda: aligned(arrays, "contact_friction_ratio", contacts), "high",
                            slipping, "triangle", problem="contacts may slip", part="Verification"))
    return fields


def path_fields(path: Any, contacts: np.ndarray) -> list[Field]:
    """Fields of the built piece (stages/actuation.py)."""
    still_open = {tuple(sorted(pair)) for pair in path.states[path.built]["open_contacts"]}
    return [Field("Distance of the built shape", "mm", TILE, lambda: path.deviation(path.built), "high",
                  part="Layout", shape=(len(path.design.F),)),
            Field("Open contacts", "", CONTACT,
                  lambda: [tuple(sorted(pair)) in still_open for pair in contacts.tolist()], "high", 0.5,
                  "cross",
                  problem="contacts that stay open", part="Layout")]


def friction_fields(settled: Any, count: int) -> list[Field]:
    """Fields of the friction needed (stages/settle.py), for `count` tiles."""
    needed = settled.friction_needed
    if not needed or needed["coefficient"] is None:
        return []
    return [Field("Friction needed most", "", TILE, lambda: np.isin(np.arange(count), needed["tiles"]),
                  "high", part="Verification", shape=(count,))]


def _by_contact(figures: Any, name: str, contacts: np.ndarray) -> np.ndarray:
    """Values of a contact each, in the order of `contacts`."""
    return aligned({"contact_tiles": figures.contacts, name: getattr(figures, name)}, name, contacts)


def aligned(arrays: Mapping[str, Any], name: str, contacts: np.ndarray) -> np.ndarray:
    """Values of arrays["contact_tiles"] in the order of `contacts` (N x 2 tiles); NaN if there is none."""
    def key(pairs: Any) -> np.ndarray:
        pairs = np.sort(np.asarray(pairs, np.int64).reshape(-1, 2), axis=1)
        return pairs[:, 0] << 32 | pairs[:, 1]

    values, known, wanted = np.asarray(arrays[name], float), key(arrays["contact_tiles"]), key(contacts)
    out = np.full(len(wanted), np.nan)
    _, to, at = np.intersect1d(wanted, known, return_indices=True)
    out[to] = values[at]
    return out
