# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits materials and the printer's growth to measured coupons, with 95 % intervals, and writes files that
--config takes.

Every model is linear in what is fitted, so LAPACK's least squares (numpy) and Student's t (scipy) give values
and intervals in closed form. A solver of nonlinear problems would iterate to the same values. Forces of a
strip are nominal stresses times the cross-section of the sheet as it was: G (x - x^-2) for a narrow strip at
stretch x and G (x - x^-3) for a wide one (neo-Hooke); 2 (C1 + C2 / x) (x - x^-2) and 2 (C1 + C2) (x - x^-3)
(Mooney-Rivlin).
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.output import Folder
from ..report.data import to_text

FORMAT, VERSION = "curveups-calibration", 1
FILES = ("calibration.json", "material.json", "printer.json")
DAY = 1440.0  # minutes

# What a file may hold: lists of rows, and the numbers of a row with their ranges.
_FORCE, _STRETCH = (1e-6, 1e6), (1.001, 10.0)
_ROWS: Mapping[str, Mapping[str, tuple[float, float]]] = {
    "strip": {"stretch": _STRETCH, "force_n": _FORCE},
    "wide": {"stretch": _STRETCH, "force_n": _FORCE},
    "held": {"minutes": (1e-3, 1e6), "force_n": _FORCE},
    "friction": {"angle_deg": (0.1, 89.0)},
    "glue": {"force_n": _FORCE, "area_mm2": (1e-3, 1e6)},
    "peel": {"force_n": _FORCE, "width_mm": (1e-3, 1e4)},
    "gaps": {"nominal_mm": (0.01, 10.0), "measured_mm": (0.0, 10.0)},
    "bridges": {"force_n": _FORCE},
    "growth": {"nominal_mm": (1e-3, 1e4), "measured_mm": (1e-3, 1e4)}}
# Why no file takes the others.
_UNUSED: Mapping[str, str] = {
    **{f"mooney_rivlin_{one}": "no parameter takes it: membrane_model=mooney-rivlin has C1 = C2 = G / 4, "
                               "G the shear modulus" for one in ("c1", "c2")},
    "left_after_a_day": "no parameter takes it: set shear_modulus_front and _back to this share of the shear "
                        "modulus to see the piece a day after its sheets were stretched",
    "peel_strength": "no parameter takes it: compare it with glue.peel_max_n_per_mm of report.json",
    "gap_loss": "no parameter takes it: choose a d_gap_min that is larger",
    "bridge_strength": "no parameter takes it: a shop's prints are compared by it"}
_SHEET = {"width_mm": (0.1, 1e4), "wide_width_mm": (0.1, 1e4), "thickness_mm": (0.01, 10.0)}


@dataclass(frozen=True)
class Fitted:
    """low, high: where the value is with 95 % probability. points: measurements it rests on. misfit: standard
    deviation of what is left, over the mean measurement."""

    value: float
    low: float
    high: float
    points: int
    unit: str
    misfit: float


def read_measured(data: Mapping[str, Any], where: str) -> dict[str, Any]:
    """Numbers of sheets, and lists of rows as arrays by column. Raises CurveUpsError, naming the entry."""
    found: dict[str, Any] = {}
    for name, value in data.items():
        if isinstance(value, list):  # of a kit's file: what nobody measured
            value = [row for row in value if not (isinstance(row, dict) and None in row.values())]
        if name in ("format", "version", "about") or value is None or value == [] != data[name]:
            continue
        if name in _SHEET:
            found[name] = _number(name, value, _SHEET[name], where)
        elif name in _ROWS:
            found[name] = _rows(name, value, where)
        else:
            raise CurveUpsError(f"'{name}' is nothing that can be measured", where,
                                f"give one of {', '.join([*_SHEET, *_ROWS])}")
    for rows, sizes in (("strip", ("width_mm", "thickness_mm")), ("wide", ("wide_width_mm", "thickness_mm"))):
        for size in sizes:
            if rows in found and size not in found:
                raise CurveUpsError(f"{rows} needs {size}", where,
                                    f"add {size} of the sheet before it is stretched")
    if not found.keys() & _ROWS.keys():
        raise CurveUpsError("nothing is measured", where, f"give one of {', '.join(_ROWS)}")
    return found


def calibrate(measured: Mapping[str, Any]) -> dict[str, Fitted]:
    """What follows from the measurements, by name."""
    found: dict[str, Fitted] = {}
    stretch, stress, wide = _stresses(measured)
    if len(stress) > 1:
        shape = np.where(wide, stretch - stretch**-3, stretch - stretch**-2)
        found["shear_modulus"] = _fit(shape[:, None], stress, [1.0], "MPa")
        both = np.stack([2 * shape, np.where(wide, 2 * shape, 2 * shape / stretch)], axis=1)
        if len(stress) > 2 and np.linalg.cond(both) < 1e4:
            found["mooney_rivlin_c1"] = _fit(both, stress, [1.0, 0.0], "MPa")
            found["mooney_rivlin_c2"] = _fit(both, stress, [0.0, 1.0], "MPa")
    if "held" in measured:
        time, force = np.log10(measured["held"]["minutes"]), measured["held"]["force_n"]
        # The share that is left a day after the first reading, of the line through force over log time.
        first = float(time.min())
        line = np.stack([np.ones_like(time), time - first], axis=1)
        found["left_after_a_day"] = _ratio(line, force, [1.0, math.log10(DAY)], [1.0, 0.0])
    if "friction" in measured:
        found["friction_coefficient"] = _mean(np.tan(np.radians(measured["friction"]["angle_deg"])), "")
    if "glue" in measured:
        found["glue_strength"] = _mean(measured["glue"]["force_n"] / measured["glue"]["area_mm2"], "MPa")
    if "peel" in measured:
        found["peel_strength"] = _mean(measured["peel"]["force_n"] / measured["peel"]["width_mm"], "N/mm")
    if "gaps" in measured:
        rows = measured["gaps"]
        open_ones = rows["measured_mm"] > 0
        if open_ones.sum() > 1:
            found["gap_loss"] = _mean((rows["nominal_mm"] - rows["measured_mm"])[open_ones], "mm")
    if "bridges" in measured:
        found["bridge_strength"] = _mean(measured["bridges"]["force_n"], "N")
    if "growth" in measured:
        rows = measured["growth"]  # of two walls
        found["xy_compensation"] = _mean(0.5 * (rows["measured_mm"] - rows["nominal_mm"]), "mm")
    return found


def parameters(found: Mapping[str, Fitted], thickness: Optional[float] = None) -> dict[str, dict[str, float]]:
    """By file what --config takes. Glue counts with the low end of its interval, and what shrinks is no
    growth. thickness: of the sheet whose modulus was fitted, mm: forces go by their product."""
    material: dict[str, float] = {}
    if "shear_modulus" in found:
        for side in ("front", "back"):
            material[f"shear_modulus_{side}"] = found["shear_modulus"].value
            if thickness is not None:
                material[f"thickness_{side}"] = thickness
    if "friction_coefficient" in found:
        material["friction_coefficient"] = found["friction_coefficient"].value
    if "glue_strength" in found:
        material["glue_strength"] = found["glue_strength"].low
    printer: dict[str, float] = {}
    if "xy_compensation" in found:
        printer["xy_compensation"] = max(0.0, found["xy_compensation"].value)
    return {"material.json": material, "printer.json": printer}


def use(name: str) -> str:
    """What a design does with a value: where it goes, or that nothing takes it."""
    if name in _UNUSED:
        return _UNUSED[name]
    one = Fitted(1.0, 1.0, 1.0, 3, "", 0.0)
    file, taken = next((file, taken) for file, taken in parameters({name: one}, 1.0).items() if taken)
    return f"{file}: {', '.join(taken)}"


def write_calibration(found: Mapping[str, Fitted], path: Path, thickness: Optional[float] = None) -> None:
    """calibration.json, and the files with something in them. thickness: as of parameters."""
    with Folder(path) as folder:
        folder.remove(*FILES)
        for name, values in parameters(found, thickness).items():
            if values:
                folder.write_text(name, to_text(values))
        folder.write_text(FILES[0], to_text({"format": FORMAT, "version": VERSION,
                                             "fitted": {name: {**asdict(one), "use": use(name)}
                                                        for name, one in found.items()}}))


def said(found: Mapping[str, Fitted]) -> list[str]:
    """Two lines for each, for the command line: the value, and what a design does with it."""
    return [line for name, one in found.items() for line in (
        f"{name:<22}{one.value:.4g} {one.unit}".rstrip() + f" ({one.low:.4g} to {one.high:.4g}; "
        f"{one.points} measurements, misfit {100 * one.misfit:.1f} %)", f"  {use(name)}")]


def _stresses(measured: Mapping[str, Any]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Stretch, nominal stress (MPa) and whether the strip was wide."""
    parts = []
    for name, width in (("strip", "width_mm"), ("wide", "wide_width_mm")):
        if name in measured:
            rows = measured[name]
            section = measured[width] * measured["thickness_mm"]
            parts.append((rows["stretch"], rows["force_n"] / section,
                          np.full(len(rows["stretch"]), name == "wide")))
    if not parts:
        return np.zeros(0), np.zeros(0), np.zeros(0, bool)
    stretch, stress, wide = (np.concatenate(column) for column in zip(*parts))
    return stretch, stress, wide


def _fit(matrix: np.ndarray, values: np.ndarray, pick: Sequence[float], unit: str) -> Fitted:
    """One of the coefficients, or a sum of them."""
    solution, spread, covariance = _least_squares(matrix, values)
    weights = np.asarray(pick)
    return _with_interval(float(weights @ solution), math.sqrt(weights @ covariance @ weights),
                          len(values) - matrix.shape[1], len(values), unit, _share(spread, values))


def _ratio(matrix: np.ndarray, values: np.ndarray, above: Sequence[float], below: Sequence[float]) -> Fitted:
    """Of two sums of coefficients, with an interval to first order."""
    solution, spread, covariance = _least_squares(matrix, values)
    a, b = np.asarray(above), np.asarray(below)
    ratio = float(a @ solution / (b @ solution))
    slope = (a - ratio * b) / (b @ solution)
    return _with_interval(ratio, math.sqrt(slope @ covariance @ slope), len(values) - matrix.shape[1],
                          len(values), "", _share(spread, values))


def _mean(values: np.ndarray, unit: str) -> Fitted:
    return _fit(np.ones((len(values), 1)), values, [1.0], unit)


def _least_squares(matrix: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, float, np.ndarray]:
    """Coefficients, standard deviation of what is left, and the coefficients' covariance."""
    solution = np.linalg.lstsq(matrix, values, rcond=None)[0]
    left = values - matrix @ solution
    spread = math.sqrt(left @ left / (len(values) - matrix.shape[1]))
    return solution, spread, spread**2 * np.linalg.inv(matrix.T @ matrix)


def _with_interval(value: float, deviation: float, freedom: int, points: int, unit: str,
                   misfit: float) -> Fitted:
    from scipy.stats import t  # half a second, which other commands would pay

    reach = float(t.ppf(0.975, freedom)) * deviation
    return Fitted(value, value - reach, value + reach, points, unit, misfit)


def _share(spread: float, values: np.ndarray) -> float:
    """Of the mean measurement, 0 where all are."""
    mean = float(np.mean(np.abs(values)))
    return spread / mean if mean > 0 else 0.0


def _rows(name: str, rows: Any, where: str) -> dict[str, np.ndarray]:
    columns = _ROWS[name]
    if not isinstance(rows, list) or len(rows) < 3 or not all(isinstance(row, dict) for row in rows):
        raise CurveUpsError(f"{name} is no list of three or more measurements", where,
                            f"give objects with {' and '.join(columns)}")
    found = {}
    for column, limits in columns.items():
        found[column] = np.array([_number(f"{name}[{k}].{column}", row.get(column), limits, where)
                                  for k, row in enumerate(rows)])
    if name == "held" and np.ptp(np.log10(found["minutes"])) < 0.5:
        raise CurveUpsError("held has no times that are apart", where, "read the force over an hour or more")
    return found


def _number(name: str, value: Any, limits: tuple[float, float], where: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not limits[0] <= value <= limits[1]:
        raise CurveUpsError(f"{name} is no number from {limits[0]:g} to {limits[1]:g}", where,
                            "mend this measurement")
    return float(value)
