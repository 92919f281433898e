# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settled shape: on the command line, in the reports, and as a result of the project."""

import json

import pytest

from curveups.base.errors import NOT_VALID, VALID
from curveups.base.findings import Finding
from curveups.base.native import native
from curveups.project.project import Project
from curveups.project.saved_results import from_text, to_text
from curveups.stages import stages_of, settle
from curveups.stages.cut_request import CutRequest
from curveups.stages.settle import Settled
from curveups.stages.stage import Job
from curveups.stages.surface import find_source


@pytest.fixture(scope="module")
def cap_design(designed):
    return designed.folder / "design.json"


def project_of(path, **values):
    design = native.read_design(path.read_text("utf-8"))
    parameters = native.Parameters(design.parameters)
    for name, value in values.items():
        parameters.set(name, value)
    project = Project.of_design(design)
    project.parameters = parameters
    return project


def settled(path, **values):
    return project_of(path, **values).run(stages_of("verify"))


def test_a_design_says_whether_it_holds(printed):
    report = printed.json("report.json")
    assert report["valid"] is True and report["holds"] is True
    assert "24 tiles, valid, holds" in printed.ran.err
    block = report["settled"]
    assert block["converged"] and not block["open_contacts"] and block["normal_min"] > 0
    assert 0 < block["element_change"] <= 1e-3
    assert block["drift_mm"] <= block["hold_tolerance_mm"] == pytest.approx(0.01 * report_L(printed))
    assert block["holding_friction"] is None and block["friction_coefficient"] == 0.5
    scan = block["scan"]
    assert 0 < scan["mean_mm"] <= scan["rms_mm"] <= scan["p95_mm"] * 2
    assert scan["p95_mm"] <= scan["max_mm"] <= scan["hausdorff_mm"]
    assert report["margin"]["mode"] == "report" and report["margin"]["met"] is True
    stages = [stage["name"] for stage in report["stages"]]
    assert stages.index("verify") < stages.index("settle") < stages.index("check")
    page = (printed.folder / "report.html").read_text("utf-8")
    assert ">Valid, holds<" in page and "<h2>Settled shape</h2>" in page


def report_L(made):
    return made.json("design.json")["parameters"]["L"]


def test_the_picture_is_of_the_settled_shape(cap_design):
    found = settled(cap_design)["settle"]
    assert len(found.deviation) == 24
    [picture] = found.pictures()
    assert picture.heading == "Settled shape" and picture.data["values"] is found.deviation


def test_settling_changes_no_design_and_may_be_left_out(curveups, cap, designed, tmp_path):
    ran = curveups("design", cap, "-o", tmp_path, "--no-remesh", "--no-solids", "--set", "run_settling=off")
    assert ran.status == VALID and "valid, not settled" in ran.err
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["valid"] is True and report["holds"] is None
    assert not {"settled", "margin", "window"} & set(report)
    one, other = json.loads((tmp_path / "design.json").read_text("utf-8")), designed.json("design.json")
    assert all(one[name] == other[name] for name in ("V", "F", "T", "q", "cuts"))
    # Without verification nothing settles either.
    ran = curveups("design", cap, "-o", tmp_path, "--no-remesh", "--no-solids", "--set", "verify=off")
    assert "not judged, not settled" in ran.err
    assert json.loads((tmp_path / "report.json").read_text("utf-8"))["holds"] is None


def test_almost_no_friction_does_not_hold(curveups, tmp_path):
    """`valid` keeps its meaning; both are said."""
    ran = curveups("design", "half-sphere", "-o", tmp_path, "--no-solids", "--set", "L=14", "run_repair=off",
                   "friction_coefficient=0.01")
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["holds"] is False and "does not hold" in ran.err
    assert ran.status == (VALID if report["valid"] else NOT_VALID)
    block = report["settled"]
    assert block["drift_mm"] > block["hold_tolerance_mm"] and block["holding_friction"] is None
    said = [one for one in report["warnings"] if one["kind"] == "settled_drift"]
    assert said and said[0]["tiles"] and said[0]["remedy"], report["warnings"]
    assert f"  warning: {said[0]['what']}\n" in ran.err
    assert "does not hold" in (tmp_path / "report.html").read_text("utf-8")


def test_a_design_at_rest_on_a_table_holds(cap_design):
    found = settled(cap_design, gravity="resting")["settle"]
    assert found.holds is True and found.block["converged"]


def test_only_a_margin_that_is_required_counts_for_valid(cap_design):
    beyond = {"margin_mismatch": 90.0, "margin_friction": 0.01}
    reported, required, off = (settled(cap_design, margin=mode, **beyond)
                               for mode in ("report", "require", "off"))
    assert reported.verdict.valid is True and required.verdict.valid is False and off.verdict.valid is True
    assert reported["settle"].margin["met"] is required["settle"].margin["met"] is False
    assert off["settle"].margin["met"] is None and not off["settle"].warnings()
    assert {one.group for one in reported.warnings()} >= {"margin"}
    assert {one.group for one in required.verdict.reasons} == {"margin"}
    assert all(one.tiles and one.sentence() for one in required.verdict.reasons)
    assert reported["settle"].holds is required["settle"].holds is True
    met = settled(cap_design, margin="require", margin_mismatch=1.0, margin_friction=0.5)
    assert met.verdict.valid is True and met["settle"].margin["met"] is True


def test_a_required_margin_that_is_not_known_leaves_the_verdict_open(cap_design):
    verdict = settled(cap_design, margin="require", settle=False).verdict
    assert verdict.valid is None and verdict.holds is None and "margin" in str(verdict.reasons[0])


def test_the_window_says_how_far_and_what_fails_first(cap_design):
    results = settled(cap_design, window=True)
    window = {one["parameter"]: one for one in results["settle"].report()["window"]}
    assert set(window) == {"front_over_back", "friction_coefficient"}
    assert window["front_over_back"]["searched"] == [-30, 30]
    for one in window.values():
        for end, fails, searched in (("low", "fails_low", 0), ("high", "fails_high", 1)):
            assert (one[end] is None) == (one[fails] is None), one
            if one[end] is not None:
                assert one["searched"][0] <= one[end] <= one["searched"][1], one
                assert one[fails]["what"] and one[fails]["kind"].startswith("settled_"), one
    friction = window["friction_coefficient"]
    held = results["settle"].block["holding_friction"]
    assert friction["searched"] == [pytest.approx(0.1), pytest.approx(1.0)]
    assert held == (friction["low"] if friction["low"] is not None else pytest.approx(0.1))
    # Beyond its ends it does fail: that of friction, asked for alone.
    if friction["low"] is not None:
        below = settled(cap_design, friction_coefficient=0.5 * friction["low"])["settle"]
        assert below.holds is not True
    assert not settled(cap_design)["settle"].window


def test_a_stop_while_tiles_settle_keeps_the_verdict(cap_design):
    project, said = project_of(cap_design), []

    def progress(what, fraction):
        said.append(what)
        return what != "settle"

    results = project.run(stages_of("verify"), Job(progress))
    assert "settle" in said and results.stopped
    assert results.verdict.valid is True and results.verdict.holds is None
    # Nothing of it stays: asked again, the tiles settle.
    assert project.run(stages_of("verify")).verdict.holds is True


def test_what_was_stopped_leaves_a_required_margin_open(cap_design):
    job = Job(lambda what, _: what != "settle")
    results = project_of(cap_design, margin="require").run(stages_of("verify"), job)
    assert results.verdict.valid is None and "stopped" in str(results.verdict.reasons[0])


def test_tiles_that_can_not_settle_cost_no_verdict(cap_design, monkeypatch):
    class Broken:
        def __getattr__(self, name):
            return getattr(native, name)

        def settle_design(self, *_):
            raise native.SolverFailure("no memory for the factor")

    monkeypatch.setattr(settle, "native", Broken())
    results = settled(cap_design)
    assert results.verdict.valid is True and results.verdict.holds is None
    assert any("no memory" in str(one) for one in results.warnings())


def test_an_edit_asks_again_and_a_saved_result_does_not(cap_design):
    project = project_of(cap_design)
    made = project.run(stages_of("verify"))
    assert made["settle"].holds is True and project.out_of_date("settle") == ()
    text = to_text(project.made())
    known = from_text(text)["settle"].result
    assert json.dumps(known.report()) == json.dumps(made["settle"].report())
    assert (known.deviation == made["settle"].deviation).all()
    for name, value in (("friction_coefficient", 0.45), ("hold_tolerance", 0.5), ("bump_height", 0.3),
                        ("margin_mismatch", 5.0)):
        values = project.parameters
        before = values.get(name)
        values.set(name, value)
        project.parameters = values
        assert project.out_of_date("settle"), name
        values.set(name, before)
        project.parameters = values
        assert project.out_of_date("settle") == (), name


def test_the_sentences_of_what_fails_name_it():
    failure = Finding.about("settled_drift", [3], drift=0.2, most=0.07)
    found = Settled(False, {"open_contacts": []}, failure, {"mode": "report", "met": False})
    assert "drift by 0.2 mm" in str(found.warnings()[0]) and found.warnings()[0].remedy()


def test_a_target_that_is_solved_settles_too(cap):
    source = find_source(str(cap), remesh=False, will_be_cut=False)
    project = Project("cap", native.Parameters(), {"source": source, "cut request": CutRequest()}, str(cap))
    assert project.run(stages_of("solve", "settle")).verdict.holds is True
