# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files are written while solids are checked: the order, and what a run that breaks off leaves."""

import json
import threading
import time
import zipfile
from types import SimpleNamespace

import pytest

from curveups.report import files
from curveups.features import document_file
from curveups.base.errors import NOT_WRITTEN, CurveUpsError
from curveups.report.files import Writing
from curveups.base.native import native
from curveups.project.project import Project
from curveups.report.html import build_html
from curveups.stages import asked_by, solids
from curveups.stages.stage import Job

GOALS = asked_by("print")

# As the native module says it.
UNSOUND = SimpleNamespace(kind="unsound", tiles=[0], figures={"solids": [
    SimpleNamespace(kind="unsound.solid", tiles=[], figures={"body": "T00001", "why": "open"})]})


@pytest.fixture
def project(printed):
    return Project.of_design(native.read_design((printed.folder / "design.json").read_text("utf-8")))


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
        "print_formats": staticmethod(native.print_formats),
        "support_kind": staticmethod(native.support_kind)}))


def waits_for(place, seconds=30.0):
    wait_until(place.exists, seconds)


def wait_until(there, seconds=30.0):
    end = time.monotonic() + seconds
    while not there():
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.fixture
def documents(monkeypatch):
    """The paths under which documents were written, whole."""
    written, write = [], document_file.write_document

    def watched(results, path):
        software = write(results, path)
        written.append(path)
        return software

    monkeypatch.setattr(document_file, "write_document", watched)
    return written


@pytest.fixture
def pages(monkeypatch):
    """The pages that were made."""
    made = []

    def watched(*given):
        made.append(build_html(*given))
        return made[-1]

    monkeypatch.setattr(files, "build_html", watched)
    return made


def run(project, folder, job):
    with Writing(folder, job, document_file.write_document) as writing:
        results = project.run(GOALS, job, strict=True, watch=writing.watch, expect=writing.expect)
        return writing.end(results)


def test_print_files_come_while_solids_are_checked(project, monkeypatch, tmp_path):
    out, found = tmp_path / "out", {}

    def judge(job):
        waits_for(out / "small-cap-print.3mf")
        found["meanwhile"] = {path.name for path in out.iterdir() if not path.name.startswith(".")}
        waits_for(out / "small-cap-anchors.stl")
        return [("T00001", "open")], [UNSOUND]

    judged_by(monkeypatch, judge)
    assert run(project, out, Job()) is False
    first = found["meanwhile"]
    assert "design.json" in first and not first & {"report.json", "report.html", "small-cap.FCStd"}
    report = json.loads((out / "report.json").read_text("utf-8"))
    assert report["reasons"] == ["solids are not sound: T00001: open"] and report["valid"] is False
    assert set(report["print"]["files"]) == {path.name for path in out.iterdir()} - {"report.json"}


def test_document_and_page_are_made_while_solids_are_checked_and_wait(project, monkeypatch, tmp_path,
                                                                      documents, pages):
    out, plain = tmp_path / "out", tmp_path / "plain"
    with Writing(plain, Job(), document_file.write_document) as writing:
        assert writing.end(project.run(GOALS, strict=True)) is False
    documents.clear(), pages.clear()

    def judge(job):
        wait_until(lambda: pages)
        # The thread that writes has done all that it does beside the checks.
        wait_until(lambda: not any("_write_first" in thread.name for thread in threading.enumerate()))
        assert len(documents) == 1 and documents[0].parent == out and documents[0].exists()
        assert not {"report.json", "report.html", "small-cap.FCStd"} & {path.name for path in out.iterdir()}
        return [], []

    judged_by(monkeypatch, judge)
    assert run(project, out, Job()) is False
    assert len(documents) == len(pages) == 1
    assert {path.name for path in out.iterdir()} == {path.name for path in plain.iterdir()}
    for path in out.iterdir():
        if path.name != "report.json":
            assert path.read_bytes() == (plain / path.name).read_bytes(), path.name
    one, other = (json.loads((folder / "report.json").read_text("utf-8")) for folder in (out, plain))
    for report in (one, other):
        del report["stages"], report["peak_memory_mb"]
    assert one == other


def test_document_and_page_are_made_anew_where_the_checks_find_faults(project, monkeypatch, tmp_path,
                                                                      documents, pages):
    out, reason = tmp_path / "out", "solids are not sound: T00001: open"

    def judge(job):
        wait_until(lambda: pages)
        return [("T00001", "open")], [UNSOUND]

    judged_by(monkeypatch, judge)
    assert run(project, out, Job()) is False
    assert len(documents) == len(pages) == 2
    assert reason not in pages[0] and reason in (out / "report.html").read_text(encoding="utf-8")
    with zipfile.ZipFile(out / "small-cap.FCStd") as document:
        assert reason in document.read("Document.xml").decode()
    assert not [path.name for path in out.iterdir() if path.name.startswith(".")]


def test_a_stop_during_the_checks_leaves_no_document(project, monkeypatch, tmp_path, documents, pages):
    out, job = tmp_path / "out", Job()

    def judge(progress):
        wait_until(lambda: pages)
        job.stopped = True
        raise native.Cancelled

    judged_by(monkeypatch, judge)
    assert run(project, out, job) is True
    names = {path.name for path in out.iterdir()}
    assert "small-cap-print.3mf" in names and "small-cap.FCStd" not in names
    assert not [name for name in names if name.startswith(".")] and len(documents) == 1
    report = json.loads((out / "report.json").read_text("utf-8"))
    assert report["status"] == "stopped" and "not_covered" in report and len(pages) == 2


def test_documents_that_can_not_be_written_end_the_checks(project, monkeypatch, tmp_path):
    out, job = tmp_path / "out", Job()

    def fail(results, path):
        raise CurveUpsError("FreeCAD gave up")

    def judge(progress):
        wait_until(lambda: job.stopped)
        raise native.Cancelled

    monkeypatch.setattr(document_file, "write_document", fail)
    judged_by(monkeypatch, judge)
    with pytest.raises(CurveUpsError, match="FCStd could not be written: FreeCAD gave up") as caught:
        run(project, out, job)
    assert caught.value.status == NOT_WRITTEN
    names = {path.name for path in out.iterdir()}
    assert "small-cap-print.3mf" in names and not any("report" in name or name[0] == "." for name in names)


def test_checks_that_break_down_leave_nothing(project, monkeypatch, tmp_path, pages):
    out = tmp_path / "new" / "out"

    def judge(job):
        wait_until(lambda: pages)
        raise native.SolverFailure("OpenCASCADE gave up")

    judged_by(monkeypatch, judge)
    with pytest.raises(CurveUpsError, match="gave up"):
        run(project, out, Job())
    assert not out.parent.exists()


def test_files_that_can_not_be_written_end_the_checks(project, monkeypatch, tmp_path):
    out, job = tmp_path / "out", Job()
    (out / "small-cap-print.3mf" / "in the way").mkdir(parents=True)

    def judge(progress):
        wait_until(lambda: job.stopped)
        raise native.Cancelled

    judged_by(monkeypatch, judge)
    with pytest.raises(CurveUpsError, match="small-cap-print.3mf") as caught:
        run(project, out, job)
    assert caught.value.status == NOT_WRITTEN
