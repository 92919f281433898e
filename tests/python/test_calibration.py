# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups calibrate`: what made measurements with noise are fitted to."""

import json
import math

import numpy as np
import pytest
from curveups.base.errors import CurveUpsError
from curveups.base.native import native
from curveups.kit.calibration import _ROWS, _SHEET, calibrate, parameters, read_measured, use
from running import ROOT

G, C1, C2, LEFT, FRICTION, GLUE, GROWTH, PEEL = 0.31, 0.12, 0.05, 0.8, 0.52, 0.9, 0.06, 0.3
LOSS, BRIDGE = 0.25, 12.0
STRIP, WIDE = np.linspace(1.2, 3.2, 11), np.linspace(1.2, 2.8, 7)
MINUTES = np.array([1, 2, 5, 10, 30, 60, 120, 300.0])
COMB = np.repeat([0.2, 0.3, 0.4, 0.5, 0.6], 2)  # whose narrowest gaps are closed
THICK = 0.46
SHEET = {"width_mm": 20, "wide_width_mm": 120, "thickness_mm": THICK}


def rows(**columns):
    return [dict(zip(columns, map(float, values))) for values in zip(*columns.values())]


def strips(narrow, wide, sigma, seed):
    """Forces of nominal stresses, which scatter by sigma (MPa)."""
    noise, section = np.random.default_rng(seed), THICK * SHEET["width_mm"]
    return {**SHEET,
            "strip": rows(stretch=STRIP,
                          force_n=section * (narrow(STRIP) + noise.normal(0, sigma, len(STRIP)))),
            "wide": rows(stretch=WIDE,
                         force_n=6 * section * (wide(WIDE) + noise.normal(0, sigma, len(WIDE))))}


def neo_hooke(seed, sigma=0.02):
    return strips(lambda x: G * (x - x**-2), lambda x: G * (x - x**-3), sigma, seed)


def mooney_rivlin(seed, sigma=0.01):
    return strips(lambda x: 2 * (C1 + C2 / x) * (x - x**-2), lambda x: 2 * (C1 + C2) * (x - x**-3),
                  sigma, seed)


def others(seed):
    noise = np.random.default_rng(seed)
    angles = np.degrees(np.arctan(FRICTION + 0.03 * noise.normal(size=12)))
    force = 5 * (1 - (1 - LEFT) * np.log10(MINUTES) / math.log10(1440)) + noise.normal(0, 0.03, len(MINUTES))
    area = np.full(8, 25.0)
    nominal = np.array([5, 10, 20, 40, 5, 10, 20, 40.0])
    return {"friction": rows(angle_deg=angles), "held": rows(minutes=MINUTES, force_n=force),
            "gaps": rows(nominal_mm=COMB, measured_mm=(COMB - LOSS + noise.normal(0, 0.02, 10)).clip(0)),
            "bridges": rows(force_n=BRIDGE + noise.normal(size=8)),
            "glue": rows(force_n=area * (GLUE + 0.05 * noise.normal(size=8)), area_mm2=area),
            "growth": rows(nominal_mm=nominal, measured_mm=nominal + 2 * GROWTH + noise.normal(0, 0.04, 8)),
            "peel": rows(force_n=8.0 * (PEEL + 0.02 * noise.normal(size=8)), width_mm=np.full(8, 8.0))}


SHAPE = np.concatenate([STRIP - STRIP**-2, WIDE - WIDE**-3])
BOTH = np.stack([2 * SHAPE, np.concatenate([2 * (STRIP - STRIP**-2) / STRIP, 2 * (WIDE - WIDE**-3)])], axis=1)
LINE = np.stack([np.ones(len(MINUTES)), np.log10(MINUTES)], axis=1)
# The least deviation that an unbiased estimate can have (Cramer and Rao), by the noise that was made.
LEAST_BOTH = 0.01 * np.sqrt(np.diag(np.linalg.inv(BOTH.T @ BOTH)))
SLOPE = (np.array([1, math.log10(1440)]) - LEFT * np.array([1, 0])) / 5
CASES = [("shear_modulus", neo_hooke, G, 0.02 / np.linalg.norm(SHAPE)),
         ("mooney_rivlin_c1", mooney_rivlin, C1, LEAST_BOTH[0]),
         ("mooney_rivlin_c2", mooney_rivlin, C2, LEAST_BOTH[1]),
         ("left_after_a_day", others, LEFT, 0.03 * math.sqrt(SLOPE @ np.linalg.inv(LINE.T @ LINE) @ SLOPE)),
         ("friction_coefficient", others, FRICTION, 0.03 / math.sqrt(12)),
         ("glue_strength", others, GLUE, 0.05 / math.sqrt(8)),
         ("peel_strength", others, PEEL, 0.02 / math.sqrt(8)),
         ("gap_loss", others, LOSS, 0.02 / math.sqrt(8)),
         ("bridge_strength", others, BRIDGE, 1 / math.sqrt(8)),
         ("xy_compensation", others, GROWTH, 0.02 / math.sqrt(8))]


@pytest.mark.parametrize("name, measure, truth, least", CASES, ids=[case[0] for case in CASES])
def test_intervals_hold_the_truth_and_are_hardly_wider_than_they_must(name, measure, truth, least):
    fitted = [calibrate(read_measured(measure(seed), "made"))[name] for seed in range(100)]
    assert 90 <= sum(one.low <= truth <= one.high for one in fitted) <= 99
    assert np.mean([one.high - one.low for one in fitted]) <= 1.5 * 2 * 1.96 * least
    assert np.mean([one.value for one in fitted]) == pytest.approx(truth, abs=3 * least / 10 + 1e-9)


def test_every_value_that_can_be_fitted_is_a_case():
    made = {**mooney_rivlin(1), **others(1)}
    assert set(calibrate(read_measured(made, "made"))) == {case[0] for case in CASES}
    assert made.keys() == {*_SHEET, *_ROWS}


def test_files_are_what_config_takes(curveups, cap, tmp_path):
    path = tmp_path / "measured.json"
    path.write_text(json.dumps({"about": "sheet B", **neo_hooke(1), **others(1)}), encoding="utf-8")
    ran = curveups("calibrate", path, "-o", tmp_path / "out")
    assert ran.status == 0, ran.err
    found = json.loads((tmp_path / "out" / "calibration.json").read_text("utf-8"))["fitted"]
    assert found["shear_modulus"]["low"] < G < found["shear_modulus"]["high"]
    assert all(f"{name} " in ran.out and one["use"] in ran.out for name, one in found.items())
    values = native.Parameters()
    for name in ("material.json", "printer.json"):
        for key, value in json.loads((tmp_path / "out" / name).read_text("utf-8")).items():
            values.set(key, value)
    assert values.get("shear_modulus_back") == found["shear_modulus"]["value"]
    assert values.get("thickness_front") == values.get("thickness_back") == THICK
    assert values.get("glue_strength") == found["glue_strength"]["low"] < GLUE
    ran = curveups("design", cap, "-o", tmp_path / "design", "--no-remesh", "--no-solids", "--config",
                   tmp_path / "out" / "material.json", "--config", tmp_path / "out" / "printer.json",
                   "--set", "verify=off")
    assert ran.status == 0, ran.err


def test_each_value_says_what_takes_it_or_that_nothing_does():
    """And the page marks the same ones."""
    found = calibrate(read_measured({**mooney_rivlin(1), **others(1)}, "made"))
    page = (ROOT / "resources" / "docs" / "kit.md").read_text("utf-8")
    unused = {"mooney_rivlin_c1", "mooney_rivlin_c2", "left_after_a_day", "peel_strength", "gap_loss",
              "bridge_strength"}
    for name in found:
        made = parameters({name: found[name]}, THICK)
        taken = {file: list(values) for file, values in made.items() if values}
        assert (name in unused) == (not taken), name
        if taken:
            (file, names), = taken.items()
            assert use(name) == f"{file}: {', '.join(names)}"
        else:
            assert use(name).startswith("no parameter takes it")
        assert f"`{name}` *" not in page or not taken, name
    assert all(f"{said} * |" in page for said in ("Mooney-Rivlin", "after a day", "narrower",
                                                  "`peel_strength`", "`bridge_strength`"))


def test_what_was_not_measured_stays_out(curveups, tmp_path):
    path = tmp_path / "measured.json"
    path.write_text(json.dumps({"friction": rows(angle_deg=[27, 28, 29])}), encoding="utf-8")
    (tmp_path / "printer.json").write_text("{}", encoding="utf-8")
    assert curveups("calibrate", path, "-o", tmp_path).status == 0
    assert json.loads((tmp_path / "material.json").read_text("utf-8")).keys() == {"friction_coefficient"}
    assert not (tmp_path / "printer.json").exists()
    small = {"growth": rows(nominal_mm=[9, 9, 9], measured_mm=[8.8, 8.9, 8.9])}
    shrunk = calibrate(read_measured(small, ""))
    assert shrunk["xy_compensation"].value < 0
    assert parameters(shrunk)["printer.json"] == {"xy_compensation": 0}


def test_a_printer_that_adds_nothing_has_no_growth():
    exact = calibrate(read_measured({"growth": rows(nominal_mm=[9, 9, 9], measured_mm=[9, 9, 9])}, ""))
    assert (exact["xy_compensation"].value, exact["xy_compensation"].misfit) == (0, 0)


@pytest.mark.parametrize("data, said", [
    ({}, "nothing is measured"), ({"colour": 3}, "'colour'"), ({"friction": []}, "friction is no list"),
    ({"friction": rows(angle_deg=[27, 28])}, "three or more"),
    ({"friction": [{"angle_deg": 27}, {"angle_deg": True}, {"angle_deg": 3}]}, "friction[1].angle_deg"),
    ({"friction": [{"angle_deg": 27}, {}, {"angle_deg": 3}]}, "friction[1].angle_deg"),
    ({"glue": rows(force_n=[1, 2, 3], area_mm2=[1, 0, 1])}, "glue[1].area_mm2"),
    ({"strip": rows(stretch=[1.5, 2, 3], force_n=[1, 2, 3])}, "strip needs width_mm"),
    ({"held": rows(minutes=[1, 1.1, 1.2], force_n=[3, 3, 3])}, "held has no times")])
def test_bad_measurements_are_named(data, said):
    with pytest.raises(CurveUpsError) as refused:
        read_measured(data, "measured.json")
    assert said in str(refused.value)
