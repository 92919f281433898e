# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ordinary mistakes and failures halfway: the exit status and one line say what is the matter."""

import json
import threading
from types import SimpleNamespace

import numpy as np
import pytest
from running import dome

from curveups import cli
from curveups.features.document_file import write_document
from curveups.report import files
from curveups.targets import cad_files
from curveups.cli import main
from curveups.base.errors import CurveUpsError
from curveups.base.findings import Finding
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages import sheets, solids, suggestions, surface, verification
from curveups.stages.cut_request import CutRequest
from curveups.stages.design import FIGURES, Figures, relaxed_warnings, with_doubt
from curveups.stages.solids import Check
from curveups.stages.stage import Inputs, Job
from curveups.stages.surface import find_source
from curveups.project.project import Verdict, judge

BIG = "9" * 400


def one_line(capsys):
    lines = [line for line in capsys.readouterr().err.splitlines()
             if line.startswith("curveups: error: ") or "Traceback" in line]
    assert len(lines) == 1 and lines[0].startswith("curveups: error: "), lines
    return lines[0]


@pytest.mark.parametrize("option, text, word", [
    ("--config", '{"L": %s}' % BIG, "L can't"),
    ("--cuts", '{"polylines": [[[0, 0, 0], [%s, 0, 0]]]}' % BIG, "polyline")])
def test_numbers_beyond_all_bounds(cap, capsys, tmp_path, option, text, word):
    path = tmp_path / "given.json"
    path.write_text(text)
    assert main(["design", str(cap), "-o", str(tmp_path / "out"), option, str(path)]) == 2
    line = one_line(capsys)
    assert word in line and "given.json" in line
    assert not (tmp_path / "out").exists()


def test_what_nobody_thought_of_is_not_called_invalid(capsys, monkeypatch):
    def fail(*_):
        raise ZeroDivisionError("of all\nthings")

    monkeypatch.setattr(cli, "run", fail)
    assert main([]) == 2
    line = one_line(capsys)
    assert "ZeroDivisionError" in line and "of all things" in line and "report" in line
    monkeypatch.setenv("CURVEUPS_DEBUG", "1")
    assert main([]) == 2
    assert "Traceback" in capsys.readouterr().err


GOALS = ("figures", "deviation", "verification", "suggestions")


@pytest.fixture
def project_of_cap(tmp_path):
    (tmp_path / "cap.obj").write_text(dome(2))

    def make(**settings):
        values = native.Parameters()
        for name, value in settings.items():
            values.set(name, value)
        source = find_source(str(tmp_path / "cap.obj"), remesh=False)
        return Project("cap", values, {"source": source, "cut request": CutRequest()}, "cap")

    return make


class Replaced:
    """The native module with one function replaced."""

    def __init__(self, **functions):
        self.__dict__.update(functions)

    def __getattr__(self, name):
        return getattr(native, name)


def raising(error, first=0):
    """Raises from call number `first` on; before that it verifies."""
    calls = []

    def call(*arguments, **more):
        calls.append(1)
        if len(calls) > first:
            raise error
        return native.verify_design(*arguments, **more)

    return call


@pytest.mark.parametrize("error", [native.SolverFailure("no memory for the factor"), MemoryError()])
def test_a_verification_that_breaks_down_keeps_the_layout(project_of_cap, monkeypatch, tmp_path, error):
    monkeypatch.setattr(verification, "native", Replaced(verify_design=raising(error)))
    results = project_of_cap().run(GOALS)
    assert results.verdict.valid is False and not results.stopped
    assert any("could not be verified" in r and "memory" in r for r in map(str, results.verdict.reasons))
    files.write_files(results, tmp_path / "out", Job(), write_document)
    assert json.loads((tmp_path / "out" / "report.json").read_text("utf-8"))["valid"] is False
    assert native.read_design((tmp_path / "out" / "design.json").read_text("utf-8")).name == "cap"


def test_a_failure_where_a_verdict_was_asked_for_is_an_error(project_of_cap, monkeypatch):
    monkeypatch.setattr(verification, "native", Replaced(
        verify_design=raising(native.SolverFailure("no memory for the factor"))))
    with pytest.raises(CurveUpsError, match="no memory for the factor"):
        project_of_cap().run(("verification",), strict=True)


@pytest.mark.parametrize("error, stopped", [(native.SolverFailure("no memory"), False),
                                            (native.Cancelled("stopped"), True)])
def test_looking_for_cuts_that_breaks_down_is_a_warning(project_of_cap, monkeypatch, error, stopped):
    def fail(*_):
        raise error

    monkeypatch.setattr(suggestions, "native", Replaced(layout_figures=fail))
    results = project_of_cap().run(GOALS)
    assert results.stopped is stopped and results["verification"].judged
    assert [w.group for w in results.warnings() if w.group == "cuts"] == ([] if stopped else ["cuts"])


def test_cancelling_verification_is_a_stop(project_of_cap, monkeypatch):
    monkeypatch.setattr(verification, "native", Replaced(
        verify_design=raising(native.Cancelled("stopped"))))
    results = project_of_cap().run(GOALS)
    assert results.stopped and results.verdict.valid is None
    assert [str(one) for one in results.verdict.reasons] == ["stopped during verification"]


UNSETTLED = Finding.about("unsettled", iterations=7)


def judged(broken=(), unsettled=UNSETTLED, reasons=()):
    """The verdict on constraints and solids as given, of a design whose forces hold; and the warnings."""
    figures = with_doubt(Figures({}, tuple(broken)), unsettled)
    results = {"figures": figures, "verification": verification.Verification(valid=True),
               "check": Check(broken=tuple(reasons))}
    return judge(results), [str(w) for w in figures.warnings()]


def test_a_layout_that_did_not_settle_counts_only_with_a_violation():
    verdict, warned = judged()
    assert verdict.valid is True and ["did not converge" in what for what in warned] == [True]
    verdict, warned = judged(broken=[Finding.about("gap.somewhere", violation=0.1)])
    assert verdict.valid is False and any("did not converge" in str(reason) for reason in verdict.reasons)
    assert warned == []
    assert judged(unsettled=None) == (Verdict(True), [])


def test_a_reason_of_any_result_makes_a_design_not_valid():
    reason = Finding.about("bodies_meet", [3, 4], value=0.0, at=(3, 4))
    verdict, _ = judged(unsettled=None, reasons=[reason])
    assert verdict == Verdict(False, (reason,))


def bound(what="p_min", tile=4, start=0.6, end=0.35):
    return {"what": what, "tile": tile, "side": "back", "edge": 1, "from": start, "to": end}


def test_bounds_that_gave_way_are_told_and_a_printer_that_cannot_make_them_is_a_reason():
    """Warnings, one a kind, with the figures of the one relaxed most; report.json has all."""
    given = (bound(), bound(tile=7, end=0.45), bound("p_max", 2, 0.4, 0.7))
    said = list(map(Finding.entry, relaxed_warnings(given)))
    assert [entry["tiles"] for entry in said] == [[2], [4, 7]]
    assert "from 0.6 mm to 0.35 mm at the back of T00005" in said[1]["what"] and "2 edges" in said[1]["what"]
    fdm, polyjet = (solids.too_thin(given, solids.read_printer(name)) for name in ("fdm", "polyjet"))
    assert polyjet == () and len(fdm) == 1 and "T00005" in str(fdm[0]) and fdm[0].tiles == (4,)


def test_interfaces_that_were_shortened_and_gaps_that_bumps_narrow_are_told(project_of_cap, monkeypatch):
    design = project_of_cap().run(("design",))["design"]
    figures = native.evaluate_design(design.design)
    values = {name: getattr(figures, name) for name in dir(figures) if not name.startswith("_")}

    def told(**changes):
        monkeypatch.setattr("curveups.stages.design.native", Replaced(
            evaluate_design=lambda design: SimpleNamespace(**{**values, **changes})))
        found = FIGURES.run(Inputs(design.design.parameters, {"design": design}), Job())
        return {warning.group: warning.entry() for warning in found.warnings()}

    warned = told(shortened=[[3, 90]], flat_clearance_mm=0.45)
    assert warned["shortened"]["tiles"] == [3, 90] and "T00004-T00091" in warned["shortened"]["what"]
    assert "0.45 mm of 0.6 mm" in warned["flat_gap"]["what"]
    assert "flat_gap" not in told(flat_clearance_mm=0.6)


def test_what_the_surplus_membrane_asks_of_anchors():
    """A sheet stretched alike in both directions, on an anchor every 14 mm with a radius of 4."""
    values = native.Parameters()
    inputs = Inputs(values, {})
    found = sheets.ANCHORING.run(inputs, Job())
    block = found.report()["anchors"]
    tension = 0.72 * 0.5 * (1 - 3.0 ** -6)
    assert block["surplus_tension_n_per_mm"] == pytest.approx([tension] * 2)
    assert block["pull_n"] == pytest.approx([14 * tension] * 2)
    assert block["glue_shear_mpa"] == pytest.approx([14 * tension / (16 * np.pi)] * 2)
    assert found.warnings() == ()
    values.set("anchor_radius", 1.0)
    values.set("thickness_back", 2.0)
    said = sheets.ANCHORING.run(inputs, Job()).warnings()
    assert len(said) == 1 and "raise anchor_radius" in str(said[0])
    values.set("anchors", False)
    assert sheets.ANCHORING.run(inputs, Job()).report() == {}


def test_scaled_targets_are_divided_as_finely_as_their_tiles_ask(monkeypatch, tmp_path):
    """0.001 L in the print, whatever the file's unit."""
    given = []
    (tmp_path / "a.step").write_text("ISO")
    monkeypatch.setattr(surface, "read_target", lambda path, deflection, *_: given.append(deflection)
                        or cad_files.Read(*native.builtin_target("half-sphere", 1.0)))

    def read(target, scale):
        values = native.Parameters()
        values.set("L", 8.0)
        values.set("scale", scale)
        project = Project("a", values, {"source": find_source(target), "cut request": CutRequest()})
        return project.run(("surface",))["surface"]

    for scale in (1.0, 1000.0, 0.1):
        read(str(tmp_path / "a.step"), scale)
        assert given[-1] * scale == pytest.approx(0.008)
    faces = [len(read("half-sphere", scale).F) for scale in (1, 20, 1e6, 1e-6)]
    assert faces[0] < faces[1] <= faces[2] and faces[3] < faces[0]


def test_commands_run_in_any_thread(tmp_path, capfd):
    """Only the main thread can take signals."""
    status = []
    command = ["verify", str(tmp_path / "none.json")]
    thread = threading.Thread(target=lambda: status.append(main(command)))
    thread.start()
    thread.join()
    said = capfd.readouterr().err
    assert status == [2] and "none.json" in said and "unexpected" not in said, said
