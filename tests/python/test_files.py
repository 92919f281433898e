# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of a folder belong together, whatever was there before and however a run ends."""

import json
import resource
import shutil
import signal
import subprocess

import pytest
from running import command, environment

from curveups.base.errors import NOT_WRITTEN, CurveUpsError
from curveups.base.native import native
from curveups.base.output import Folder, safe_name

OWN = {"small-cap-notes.txt", "other-tiles.step"}
BARE = {"design.json", "report.json", "report.html"}


@pytest.fixture
def used(printed, tmp_path):
    """A folder with all files of a run, and two of the user's own."""
    folder = tmp_path / "used"
    shutil.copytree(printed.folder, folder)
    for name in OWN:
        (folder / name).write_text("mine")
    return folder


def names(folder):
    return {path.name for path in folder.iterdir()}


def test_print_files_of_an_earlier_run_go(curveups, cap, used):
    assert "small-cap-tiles.step" in names(used) and "small-cap.FCStd" in names(used)
    ran = curveups("design", cap, "-o", used, "--no-remesh", "--no-solids")
    assert ran.status == 0, ran.err
    assert names(used) == BARE | OWN


def test_a_kind_that_is_switched_off_goes(curveups, used):
    before = names(used)
    ran = curveups("export", used / "design.json", "-o", used, "--set", "anchors=off")
    assert ran.status == 0, ran.err
    gone = {"small-cap-anchors.step", "small-cap-anchors.stl"}
    assert names(used) == before - gone
    listed = json.loads((used / "report.json").read_text("utf-8"))["print"]["files"]
    assert set(listed) == before - gone - OWN - {"report.json"}


def test_the_cuts_that_were_given_stay(curveups, cap, tmp_path):
    cuts = tmp_path / "small-cap-cuts.json"
    cuts.write_text('{ "edges": [[0, 1]] }')
    arguments = ("design", cap, "-o", tmp_path, "--no-remesh", "--no-solids")
    assert curveups(*arguments, "--cuts", cuts).status in (0, 1) and cuts.exists()
    assert curveups(*arguments).status == 0 and not cuts.exists()


def test_verifying_in_place_keeps_print_files_and_another_design_does_not(curveups, cap, used, tmp_path):
    before = names(used)
    assert curveups("verify", used / "design.json", "-o", used).status == 0
    assert names(used) == before
    other = tmp_path / "other"
    ran = curveups("design", cap, "-o", other, "--no-remesh", "--no-solids", "--set", "tau=2.9")
    assert ran.status in (0, 1), ran.err
    curveups("verify", other / "design.json", "-o", used)
    assert names(used) == BARE | OWN
    assert (used / "design.json").read_bytes() == (other / "design.json").read_bytes()


def test_a_design_that_breaks_off_while_writing_leaves_no_report(curveups, cap, used, monkeypatch):
    """Neither a report of the earlier run nor its print files stand beside the new design."""
    def broken(*_):
        raise RuntimeError("FreeCAD gave up")

    monkeypatch.setattr("curveups.cli.commands.write_document", broken)
    ran = curveups("design", cap, "-o", used, "--no-remesh", "--set", "tau=2.9")
    assert ran.status == NOT_WRITTEN and len(ran.error_lines) == 1, ran.err
    assert "small-cap.FCStd could not be written: FreeCAD gave up" in ran.error_lines[0]
    left = names(used)
    assert not left & {"report.json", "report.html", "small-cap.FCStd"} and "small-cap-print.3mf" in left
    assert not [name for name in left if name.startswith(".")]


def test_a_full_disk_leaves_whole_files_only(cap, designed, tmp_path):
    """design.json fits, the page with pictures does not."""
    limit = (designed.folder / "design.json").stat().st_size + 2000
    assert (designed.folder / "report.html").stat().st_size > limit

    def lower():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    done = subprocess.run(command("design", cap, "-o", tmp_path / "out", "--no-remesh", "--no-solids"),
                          env=environment(), capture_output=True, text=True, preexec_fn=lower)
    assert done.returncode == NOT_WRITTEN, done.stderr
    errors = [x for x in done.stderr.splitlines() if x.startswith("curveups: error: ")]
    assert len(errors) == 1 and "report.html" in errors[0] and "complete are design.json" in errors[0]
    assert names(tmp_path / "out") == {"design.json", "report.json"}
    assert (tmp_path / "out" / "design.json").read_bytes() == (designed.folder / "design.json").read_bytes()


def test_a_folder_that_can_not_be_made(curveups, cap, tmp_path):
    (tmp_path / "out").write_text("mine")
    for place in (tmp_path / "out", tmp_path / "out" / "deeper"):
        ran = curveups("design", cap, "-o", place, "--no-solids")
        assert ran.status == 2 and len(ran.err.splitlines()) == 1
    assert (tmp_path / "out").read_text("utf-8") == "mine"
    ran = curveups("design", cap, "-o", tmp_path / ("x" * 300), "--no-solids")
    assert ran.status == NOT_WRITTEN and "too long" in ran.error_lines[0], ran.err


@pytest.mark.parametrize("failure, word", [
    (CurveUpsError("the document's Tiles can't be computed", "cap", "see the report view"), "Tiles"),
    (MemoryError(), "MemoryError"), (OSError(28, "No space left on device"), "No space")])
def test_a_failure_names_complete_files_and_touches_nothing_else(tmp_path, failure, word):
    (tmp_path / "a.step").write_text("mine")
    folder = Folder(tmp_path)
    folder.write_text("design.json", "{}")

    def fail(path):
        path.write_text("half")
        path.with_name(f"{path.name}.beside").write_text("half")
        raise failure

    for name in ("a.step", "x/a.step", ""):
        with pytest.raises(CurveUpsError) as caught:
            folder.write(name, fail)
        if name == "a.step":
            assert caught.value.status == NOT_WRITTEN
            assert word in str(caught.value) and "complete are design.json" in str(caught.value)
    assert names(tmp_path) == {"a.step", "design.json"} and (tmp_path / "a.step").read_text("utf-8") == "mine"


def test_something_unexpected_between_files_has_status_4_and_a_stop_stays_a_stop(tmp_path):
    with pytest.raises(CurveUpsError, match="complete are design.json") as caught:
        with Folder(tmp_path) as folder:
            folder.write_text("design.json", "{}")
            raise KeyError("report")
    assert caught.value.status == NOT_WRITTEN

    def stop(path):
        raise native.Cancelled("stopped")

    with pytest.raises(native.Cancelled):
        Folder(tmp_path).write("cap.FCStd", stop)


def test_a_name_is_no_path(curveups, designed, tmp_path):
    """A design's name with a slash neither leaves the folder nor removes files that bear its end."""
    design = designed.json("design.json")
    design["name"] = "../x/turtle"
    (tmp_path / "design.json").write_text(json.dumps(design))
    (tmp_path / "turtle.FCStd").write_text("mine")
    out = tmp_path / "out"
    assert curveups("export", tmp_path / "design.json", "-o", out).status == 0
    assert (out / "x-turtle-tiles.step").stat().st_size > 1000
    assert json.loads((out / "design.json").read_bytes())["name"] == "../x/turtle"  # titles have it as it is
    assert names(tmp_path) == {"design.json", "out", "turtle.FCStd"}
    assert safe_name("...") == "target" and len(safe_name("x" * 300)) < 200
