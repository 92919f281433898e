# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coupons of a kit: bodies that other programs find sound, with the sizes that the sheet names, and a file
that `curveups calibrate` takes once it is filled in."""

import json
import math
import subprocess
from types import SimpleNamespace

import ezdxf
import numpy as np
import pytest

from curveups.base.language import ENGLISH
from curveups.base.native import native
from curveups.kit import coupon_sheet, coupons
from running import by_admesh

NAMES = ("friction-bumps", "friction-dimples", "friction-bare", "glue", "gaps", "growth", "clamps")
BODIES = {"friction-bumps": 2, "friction-dimples": 2, "friction-bare": 2, "glue": 6, "gaps": 1, "growth": 3,
          "clamps": 8}


@pytest.fixture(scope="module")
def folder(kit):
    return kit.folder / "coupons"


def parameters(**values):
    found = native.Parameters()
    for name, value in values.items():
        found.set(name, value)
    return found


def coupon(name, of):
    return next(one for one in coupons.wanted(of) if one.name == name)


@pytest.mark.parametrize("name", NAMES)
def test_admesh_finds_every_body_closed_and_whole(folder, name):
    found = by_admesh(folder / f"small-cap-{name}-tiles.stl")
    assert found["Total disconnected facets"] == 0 and found["Number of parts"] == BODIES[name]
    volume = coupon(name, parameters()).model(parameters()).volumes["tiles"]
    assert found["Volume"] == pytest.approx(volume, rel=1e-3)
    step = (folder / f"small-cap-{name}.step").read_text("utf-8")
    support = name not in ("gaps", "growth", "clamps")
    assert step.count("MANIFOLD_SOLID_BREP(") == BODIES[name] + support
    assert (folder / f"small-cap-{name}-support.stl").exists() == support


@pytest.mark.parametrize("support", ["soluble", "breakaway", "none"])
@pytest.mark.parametrize("bumps", ["bumps", "dimples", "none"])
def test_every_kind_of_print_has_sound_coupons(support, bumps):
    own = parameters(support=support, bumps=bumps)
    found = coupons.wanted(own)
    assert ("bridges" in {one.name for one in found}) == (support == "breakaway")
    assert [one.name for one in found if not one.own(own)] == [
        f"friction-{name}" for name, kind in (("bumps", "bumps"), ("dimples", "dimples"), ("bare", "none"))
        if kind != bumps]
    for one in found:
        model = one.model(own)
        assert not model.loose_tiles and model.bbox.max() < 160, one.name
        assert not model.judge_solids()[0], one.name


def test_the_comb_has_the_gaps_that_it_names_and_holds_together():
    """Half-way up its teeth, a line across meets them and the gaps in turn, wider from the left to the right;
    in the bar it meets nothing but material."""
    model = coupon("gaps", parameters()).model(parameters())
    points, faces, body = model.mesh("tiles")
    assert set(body) == {0} and model.volumes["support"] == 0

    def widths(y):
        a = points[faces].reshape(-1, 3)  # walls are upright: lines from above
        b = points[np.roll(faces, -1, axis=1)].reshape(-1, 3)
        there = (abs(a[:, 0] - b[:, 0]) < 1e-9) & (np.minimum(a, b)[:, 1] < y) & (y < np.maximum(a, b)[:, 1])
        return np.diff(np.unique(a[there, 0].round(9)))

    teeth = widths(-5.0)
    assert teeth[1::2] == pytest.approx(coupons.GAPS) and (teeth[::2] == pytest.approx(coupons.TOOTH))
    assert len(widths(points[:, 1].max() - 1.0)) == 1
    assert model.bbox[2] == pytest.approx(2 * parameters().get("H_pin") + parameters().get("H_body"))


def test_pins_of_the_glue_coupon_have_the_area_that_is_entered():
    glue = coupon("glue", parameters())
    areas = glue.model(parameters()).glued_areas["front"]
    rows = glue.rows(parameters())["glue"]
    assert areas["pins"] == pytest.approx(sum(row["area_mm2"] for row in rows), rel=1e-4)
    for row in glue.rows(parameters())["peel"]:  # an equilateral triangle of this side has that area
        assert row["width_mm"] ** 2 * math.sqrt(3) / 4 == pytest.approx(rows[0]["area_mm2"], rel=1e-3)


def test_walls_that_slide_are_as_long_as_the_sketch_has_them():
    V, F = coupons.sliding()
    a, b, c = V[F[0]]
    foot, wall = c - a, b - a
    assert math.degrees(math.acos(foot @ wall / np.linalg.norm(foot) / np.linalg.norm(wall))) == \
        pytest.approx(coupons.FOOT_ANGLE)
    assert np.linalg.norm(wall) == coupons.WALL and {0, 1} == set(F[0]) & set(F[1])


def test_growth_blocks_and_strips_have_the_sizes_in_the_file(folder):
    model = coupon("growth", parameters()).model(parameters())
    points, faces, body = model.mesh("tiles")
    sizes = [float(size) for k in range(3) for size in np.ptp(points[faces[body == k]][..., :2], axis=(0, 1))]
    data = json.loads((folder / "small-cap-MEASURED.json").read_text("utf-8"))
    assert sizes == pytest.approx([row["nominal_mm"] for row in data["growth"]])
    space = ezdxf.readfile(folder / "small-cap-strips.dxf").modelspace()
    boxes = [np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="cut"]')]
    assert sorted(np.ptp(box[:, 0]) for box in boxes) == [data["width_mm"], data["wide_width_mm"]]
    lines = [np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="control"]')]
    apart = {round(float(b[0, 1] - a[0, 1]), 6) for a, b in zip(lines[::2], lines[1::2])}
    assert apart == {5 * data["width_mm"], data["wide_width_mm"] / 5}


def filled(data):
    """A file as somebody fills it in, of latex of 0.6 MPa, walls of 0.4, glue of 0.8 MPa, walls that grow by
    0.04 mm and gaps that close by 0.15."""
    section = {"strip": data["width_mm"] * 0.5, "wide": data["wide_width_mm"] * 0.5}
    data["thickness_mm"] = 0.5
    for k, row in enumerate(data["friction"]):
        row["angle_deg"] = math.degrees(math.atan(0.4)) + 0.1 * (k - 2)
    for row in data["glue"]:
        row["force_n"] = 0.8 * row["area_mm2"]
    for row in data["peel"]:
        row["force_n"] = 0.3 * row["width_mm"]
    for row in data["growth"]:
        row["measured_mm"] = row["nominal_mm"] + 0.08
    for row in data["gaps"]:
        row["measured_mm"] = max(0.0, row["nominal_mm"] - 0.25)
    for name, power in (("strip", -2), ("wide", -3)):
        for row in data[name]:
            row["force_n"] = 0.6 * section[name] * (row["stretch"] - row["stretch"] ** power)
    return data


def test_the_file_of_the_kit_is_calibrated_once_it_is_filled_in(curveups, folder, tmp_path):
    data = filled(json.loads((folder / "small-cap-MEASURED.json").read_text("utf-8")))
    (tmp_path / "measured.json").write_text(json.dumps(data))  # nobody waited for the creep: it stays null
    ran = curveups("calibrate", tmp_path / "measured.json", "-o", tmp_path / "out")
    assert ran.status == 0, ran.err
    found = json.loads((tmp_path / "out" / "calibration.json").read_text("utf-8"))["fitted"]
    values = {name: one["value"] for name, one in found.items()}
    assert values["shear_modulus"] == pytest.approx(0.6) and "left_after_a_day" not in values
    assert values["friction_coefficient"] == pytest.approx(0.4, rel=1e-3)
    assert values["glue_strength"] == pytest.approx(0.8) and values["peel_strength"] == pytest.approx(0.3)
    assert values["gap_loss"] == pytest.approx(0.25)
    assert values["xy_compensation"] == pytest.approx(0.04)


def test_an_empty_file_is_refused_and_so_is_a_list_of_two(curveups, folder, tmp_path):
    refused = curveups("calibrate", folder / "small-cap-MEASURED.json", "-o", tmp_path / "no")
    assert refused.status == 2 and "nothing is measured" in refused.err and not (tmp_path / "no").exists()
    data = json.loads((folder / "small-cap-MEASURED.json").read_text("utf-8"))
    for row in data["friction"][:2]:
        row["angle_deg"] = 25.0
    (tmp_path / "two.json").write_text(json.dumps(data))
    refused = curveups("calibrate", tmp_path / "two.json", "-o", tmp_path / "no")
    assert refused.status == 2 and "friction is no list of three" in refused.err


def test_the_sheet_of_glue_asks_for_what_pins_and_anchors_need_where_that_is_known():
    def said(report):
        kit = SimpleNamespace(report=report, results=SimpleNamespace(parameters=parameters()), say=ENGLISH)
        return coupon_sheet.said(kit, coupon("glue", parameters()))

    anchors = {"anchors": {"glue_shear_mpa": [0.31, 0.43]}}
    assert "asks for 0.43 MPa" in said(anchors)
    both = said({**anchors, "glue": {"shear_max_mpa": 0.6514, "peel_max_n_per_mm": 0.1066}})
    assert "asks for 0.66 MPa" in both and "peels with up to 0.11 N/mm" in both
    assert "MPa" not in said({})


def test_the_sheet_names_files_and_numbers_of_this_design(folder):
    said = subprocess.run(["pdftotext", "-layout", folder / "small-cap-coupons.pdf", "-"], check=True,
                          capture_output=True, encoding="utf-8").stdout
    text = " ".join(said.split())
    assert all(f"small-cap-{name}.step" in text for name in NAMES)
    assert text.count("leave these slopes out") == 2 and "112.5, 150, 187.5, 225 mm" in text
    assert "no parameter of a design takes the constants of Mooney-Rivlin" in text
    assert "What a day leaves goes into no design by itself" in text
    data = json.loads((folder / "small-cap-MEASURED.json").read_text("utf-8"))
    fields = {field for rows in data.values() if isinstance(rows, list) for field in rows[0]}
    assert all(field in text for field in fields)
