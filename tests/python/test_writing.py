# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files are written while solids are checked: the order, and what a run that breaks off leaves."""

import json
import time

import pytest

from curveups.errors import NOT_WRITTEN, CurveUpsError
from curveups.files import Writing
from curveups.native import native
from curveups.project import Project
from curveups.stages import PRINTED, solids
from curveups.stages.stage import Job

GOALS = ("figures", *PRINTED)


@pytest.fixture
def project(printed):
    return Project.of_design(native.read_design((printed.folder / "design.json").read_text()))


class CheckedBy:
    """The print model with another way of judging its solids."""

    def __init__(self, model, judge):
        self._model, self.judge_solids = model, judge

    def __getattr__(self, name):
        return getattr(self._model, name)


def judged_by(monkeypatch, judge):
    made = native.make_print_model
    monkeypatch.setattr(solids, "native", type("Replaced", (), {
        "make_print_model": staticmethod(lambda *given: CheckedBy(made(*given), judge)),
        "print_formats": staticmethod(native.print_formats)}))


def waits_for(place, seconds=30.0):
    end = time.monotonic() + seconds
    while not place.exists():
        assert time.monotonic() < end, place
        time.sleep(0.01)


def run(project, folder, job):
    with Writing(folder, job) as writing:
        results = project.run(GOALS, job, strict=True, watch=writing.watch)
        return writing.end(results)


def test_print_files_come_while_solids_are_checked(project, monkeypatch, tmp_path):
    out, found = tmp_path / "out", {}

    def judge(job):
        waits_for(out / "small-cap-print.3mf")
        found["meanwhile"] = {path.name for path in out.iterdir() if not path.name.startswith(".")}
        waits_for(out / "small-cap-anchors.stl")
        return [("T00001", "open")], ["solids are not sound: T00001: open"]

    judged_by(monkeypatch, judge)
    assert run(project, out, Job()) is False
    first = found["meanwhile"]
    assert "design.json" in first and not first & {"report.json", "report.html", "small-cap.FCStd"}
    report = json.loads((out / "report.json").read_text())
    assert report["reasons"] == ["solids are not sound: T00001: open"] and report["valid"] is False
    assert set(report["print"]["files"]) == {path.name for path in out.iterdir()} - {"report.json"}


def test_checks_that_break_down_leave_nothing(project, monkeypatch, tmp_path):
    out = tmp_path / "new" / "out"

    def judge(job):
        waits_for(out / "design.json")
        raise native.SolverFailure("OpenCASCADE gave up")

    judged_by(monkeypatch, judge)
    with pytest.raises(CurveUpsError, match="gave up"):
        run(project, out, Job())
    assert not out.parent.exists()


def test_files_that_can_not_be_written_end_the_checks(project, monkeypatch, tmp_path):
    out, job = tmp_path / "out", Job()
    (out / "small-cap-print.3mf" / "in the way").mkdir(parents=True)

    def judge(progress):
        end = time.monotonic() + 30
        while not job.stopped:
            assert time.monotonic() < end
            time.sleep(0.01)
        raise native.Cancelled

    judged_by(monkeypatch, judge)
    with pytest.raises(CurveUpsError, match="small-cap-print.3mf") as caught:
        run(project, out, job)
    assert caught.value.status == NOT_WRITTEN
