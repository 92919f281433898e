# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups export --set`: other geometry over the same layout, and what it says of what no longer holds."""

import json
import math

import pytest

UNJUDGED = "geometry changed since verification"


def read(folder):
    return tuple(json.loads((folder / f"{name}.json").read_text("utf-8")) for name in ("design", "report"))


@pytest.fixture(scope="module")
def bowl(curveups, cap, tmp_path_factory):
    """The small cap seen from inside: back faces are larger than front faces."""
    folder = tmp_path_factory.mktemp("bowl")
    ran = curveups("design", cap, "-o", folder, "--no-remesh", "--no-solids", "--set", "flip=on",
                   "--set", "run_verification=off")
    assert ran.status == 0, ran.err
    return folder


def test_parameters_of_the_target_are_refused(curveups, bowl, tmp_path):
    refused = curveups("export", bowl / "design.json", "-o", tmp_path, "--set", "maximum_deviation=1")
    assert refused.status == 2 and "can't change on export" in refused.err


@pytest.mark.parametrize("name, value, rise", [("H_body", 2.8, -0.2), ("H_pin", 0.8, -0.4)])
def test_other_heights_over_the_same_layout(curveups, printed, tmp_path, name, value, rise):
    ran = curveups("export", printed.folder / "design.json", "-o", tmp_path, "--set", f"{name}={value}")
    assert ran.status == 0 and UNJUDGED in ran.err
    design, report = read(tmp_path)
    assert report["valid"] is None and report["reasons"] == [UNJUDGED]
    assert report["solids"]["invalid"] == 0
    before = printed.json("design.json")
    assert design["parameters"] == {**before["parameters"], name: value}
    assert all(design[block] == before[block] for block in "VFTq")
    height = printed.json("report.json")["print"]["bbox_mm"][2]
    assert math.isclose(report["print"]["bbox_mm"][2], height + rise, abs_tol=1e-9)


def test_settings_of_files_change_no_geometry(curveups, printed, tmp_path):
    ran = curveups("export", printed.folder / "design.json", "-o", tmp_path, "--set", "mesh_deviation=0.2")
    assert ran.status == 0, ran.err
    _, report = read(tmp_path)
    assert report["valid"] is None and report["reasons"] == ["an export does not verify"]
    meshes, before = report["print"]["files"], printed.json("report.json")["print"]["files"]
    assert meshes["small-cap-tiles.stl"] < before["small-cap-tiles.stl"]
    assert meshes["small-cap-tiles.step"] == before["small-cap-tiles.step"]


def test_pins_that_get_too_small_are_warned_about(curveups, designed, tmp_path):
    ran = curveups("export", designed.folder / "design.json", "-o", tmp_path, "--set", "H_body=4")
    assert ran.status == 0, ran.err
    _, report = read(tmp_path)
    assert report["reasons"] == [UNJUDGED] and report["constraints"]["pin_sides_below_area"] == 24
    small = [w["tiles"] for w in report["warnings"] if "less than A_pin_min asks for" in w["what"]]
    assert sorted(tile for tiles in small for tile in tiles) == list(range(24))
    said = [line for line in ran.err.splitlines() if "less than A_pin_min asks for" in line]
    assert len(said) == 1 and said[0].endswith("(and 23 more of this kind)"), ran.err


def test_gaps_that_close_are_not_valid(curveups, bowl, tmp_path):
    """Thicker tiles reach further at the back: the files are written, and the verdict says why not."""
    ran = curveups("export", bowl / "design.json", "-o", tmp_path, "--set", "H_body=4")
    assert ran.status == 1, ran.err
    _, report = read(tmp_path)
    assert report["valid"] is False
    assert any("nearer than d_gap_min (T00001-T" in reason for reason in report["reasons"])
    assert report["constraints"]["max_gap_violation_mm"] > 0.1
    assert report["constraints"]["overlaps"] > 0 and report["solids"]["invalid"] == 0
    assert (tmp_path / "small-cap-print.step").exists()


@pytest.mark.parametrize("thickness, what", [(20, "pins of 12 tiles are turned inside out"),
                                             (45, "6 back faces vanish")])
def test_faces_turned_inside_out_stop_with_their_tiles(curveups, designed, tmp_path, thickness, what):
    ran = curveups("export", designed.folder / "design.json", "-o", tmp_path / "out",
                   "--set", f"H_body={thickness}")
    assert ran.status == 2 and len(ran.error_lines) == 1, ran.err
    assert what in ran.error_lines[0] and "T00001, T00002" in ran.error_lines[0], ran.err
    assert not (tmp_path / "out").exists()


def test_bodies_that_overlap_get_no_slab_but_all_other_files(curveups, designed, tmp_path):
    design = designed.json("design.json")
    design["T"][0] = [[x + 5, y] for x, y in design["T"][0]]
    (tmp_path / "moved.json").write_text(json.dumps(design))
    ran = curveups("export", tmp_path / "moved.json", "-o", tmp_path / "out")
    assert ran.status == 1, ran.err
    _, report = read(tmp_path / "out")
    assert report["valid"] is False and report["constraints"]["overlaps"] > 0
    assert report["solids"]["min_clearance_flat_mm"] == 0 and report["solids"]["invalid"] == 0
    loose = [w for w in report["warnings"] if w["what"] == "24 tiles are not held by the support"]
    assert [w["tiles"] for w in loose] == [list(range(24))]
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert {"small-cap-tiles.step", "small-cap-print.3mf", "small-cap.FCStd"} <= names
    assert not any(name.startswith("small-cap-support") for name in names)
