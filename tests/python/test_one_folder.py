# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a folder belong together, whatever was there before and however a run ends."""

import json
import os
import shutil
import signal
import subprocess
import time

import pytest
from running import command, environment

from curveups.report import files
from curveups.base.errors import NOT_WRITTEN, CurveUpsError
from curveups.base.output import Folder


@pytest.fixture
def used(printed, tmp_path):
    """A folder with all files of a run, and two of the user's own."""
    folder = tmp_path / "used"
    shutil.copytree(printed.folder, folder)
    (folder / "small-cap-notes.txt").write_text("mine")
    (folder / "other-tiles.step").write_text("of another name")
    return folder


def names(folder):
    return {path.name for path in folder.iterdir()}


OWN = {"small-cap-notes.txt", "other-tiles.step"}
BARE = {"design.json", "report.json", "report.html"}


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
    out = tmp_path / "out"
    out.mkdir()
    cuts = out / "small-cap-cuts.json"
    cuts.write_text('{ "edges": [[0, 1]] }')
    ran = curveups("design", cap, "-o", out, "--no-remesh", "--no-solids", "--cuts", cuts)
    assert ran.status in (0, 1) and cuts.exists(), ran.err
    ran = curveups("design", cap, "-o", out, "--no-remesh", "--no-solids")
    assert ran.status == 0 and not cuts.exists(), ran.err


def test_verifying_in_place_keeps_the_print_files(curveups, used):
    before = names(used)
    assert curveups("verify", used / "design.json", "-o", used).status == 0
    assert names(used) == before


def test_verifying_another_design_does_not(curveups, cap, used, tmp_path):
    other = tmp_path / "other"
    assert curveups("design", cap, "-o", other, "--no-remesh", "--no-solids", "--set", "L=8.1",
                    "tau=2.9").status in (0, 1)
    curveups("verify", other / "design.json", "-o", used)
    assert names(used) == BARE | OWN
    assert (used / "design.json").read_bytes() == (other / "design.json").read_bytes()


def test_killed_in_the_middle_of_writing(curveups, cap, used):
    """Neither a report of the earlier run nor its print files stand beside the new design."""
    (used / "design.json").write_text("of the earlier run")
    process = subprocess.Popen(command("design", cap, "-o", used, "--no-remesh", "--set", "tau=2.9"),
                               env=environment(), stderr=subprocess.PIPE, text=True)
    for line in process.stderr:
        if "writing" in line:
            break
    process.kill()
    process.wait()
    process.stderr.close()
    left = names(used)
    assert not left & {"report.json", "report.html"}
    assert (used / "design.json").read_text("utf-8") != "of the earlier run"
    whole = {name for name in left if not name.startswith(".")}
    assert "small-cap.FCStd" not in whole and whole - OWN <= {"design.json", "small-cap-print.3mf",
                                                              "small-cap-tiles.step"}
    # What it left half-written goes with the next run, whatever that writes.
    (used / f".{process.pid}-small-cap-anchors.step.part1").write_text("half")
    ran = curveups("design", cap, "-o", used, "--no-remesh", "--no-solids")
    assert ran.status == 0, ran.err
    assert names(used) == BARE | OWN


def test_something_unexpected_between_the_files_has_status_4(tmp_path):
    with pytest.raises(CurveUpsError) as caught:
        with Folder(tmp_path) as folder:
            folder.write_text("design.json", "{}")
            raise KeyError("report")
    assert caught.value.status == NOT_WRITTEN
    assert "complete are design.json" in caught.value.remedy


def test_a_report_that_can_not_be_removed_is_said(curveups, cap, tmp_path):
    (tmp_path / "report.json").mkdir()
    ran = curveups("design", cap, "-o", tmp_path, "--no-remesh", "--no-solids")
    assert ran.status == 4 and "report.json" in ran.error_lines[0], ran.err
    assert names(tmp_path) == {"report.json"}


@pytest.mark.parametrize("name", ["small-cap-tiles.stl", "design.json", "small-cap.FCStd"])
def test_pipes_and_devices_in_the_folder_stay(curveups, cap, tmp_path, name):
    """As root a rename replaced them, and a removal took them away."""
    os.mkfifo(tmp_path / name)
    ran = curveups("design", cap, "-o", tmp_path, "--no-remesh")
    assert ran.status == 4 and len(ran.error_lines) == 1, ran.err
    assert name in ran.error_lines[0] and "a device or a pipe has its name" in ran.error_lines[0]
    assert (tmp_path / name).is_fifo() and "report.json" not in names(tmp_path)


def not_ignored():
    """What tests are run by (nohup) may ignore signals, and its children then do."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


@pytest.mark.parametrize("number", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_signals_while_writing_keep_the_reports(printed, tmp_path, number):
    """Also a second one."""
    out = tmp_path / "out"
    process = subprocess.Popen(command("export", printed.folder / "design.json", "-o", out),
                               env=environment(), stderr=subprocess.PIPE, text=True, preexec_fn=not_ignored)
    said = ""
    for line in process.stderr:
        said += line
        if "writing" in line:
            break
    process.send_signal(getattr(signal, number))
    time.sleep(0.02)
    if process.poll() is None:
        process.send_signal(getattr(signal, number))
    said += process.stderr.read()
    assert process.wait(timeout=60) == 3, said
    assert BARE <= names(out) and "Traceback" not in said
    assert json.loads((out / "report.json").read_text("utf-8"))["status"] == "stopped"
    assert files.REPORTS[0] == "report.json"


def test_something_unexpected_after_the_files_is_not_nothing_written(cap, tmp_path, monkeypatch, capfd):
    from curveups import cli
    from curveups.cli import commands

    def broken(*_):
        raise KeyError("a figure of the summary")

    monkeypatch.setattr(commands, "_finish", broken)
    arguments = ["design", str(cap), "--no-remesh", "--no-solids", "--quiet", "-o"]
    assert cli.main([*arguments, str(tmp_path / "out")]) == NOT_WRITTEN
    assert BARE <= names(tmp_path / "out")
    monkeypatch.setattr(commands, "_project", broken)
    assert cli.main([*arguments, str(tmp_path / "none")]) == 2 and not (tmp_path / "none").exists()
