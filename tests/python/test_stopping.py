# SPDX-License-Identifier: LGPL-2.1-or-later
"""SIGINT at every kind of work: status 3, the best so far is written, every file whole."""

import io
import json
import re
import signal
import struct
import subprocess
import time
import zipfile

import pytest
from running import command, dome, environment
from schema import check_design, check_report

from curveups.base.progress import Interrupt, Reporter


def interrupted(word, *arguments, wait=0.0):
    """Runs a command and sends SIGINT once its progress says `word`; status and what it said."""
    process = subprocess.Popen(command(*arguments), env=environment(), stderr=subprocess.PIPE, text=True)
    said = ""
    for line in process.stderr:
        said += line
        if word in line:
            break
    else:
        pytest.fail(f"'{word}' was not reached:\n{said}")
    time.sleep(wait)
    process.send_signal(signal.SIGINT)
    said += process.stderr.read()
    return process.wait(timeout=120), said


def check_whole(path):
    """A file that was cut short does not pass."""
    assert not path.name.startswith("."), path
    if path.suffix == ".json":
        json.loads(path.read_text("utf-8"))
    elif path.suffix == ".html":
        assert path.read_text(encoding="utf-8").rstrip().endswith("</html>")
    elif path.suffix == ".step":
        assert path.read_text("utf-8").rstrip().endswith("END-ISO-10303-21;")
    elif path.suffix == ".stl":
        data = path.read_bytes()
        assert len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0]
    else:
        with zipfile.ZipFile(path) as archive:
            assert archive.testzip() is None


def check_stopped(folder, status, said):
    """What was written is whole and the report knows it; returns the names of the files."""
    assert status == 3, said
    assert "Traceback" not in said and said.splitlines()[-1].startswith("stopped"), said
    report = json.loads((folder / "report.json").read_text("utf-8"))
    check_report(report)
    assert report["status"] == "stopped"
    names = {path.name for path in folder.iterdir()}
    assert {"design.json", "report.json", "report.html"} <= names
    for path in folder.iterdir():
        check_whole(path)
    if "print" in report:
        files = report["print"]["files"]
        assert set(files) == names - {"report.json"}
    else:
        files = report.get("unchecked_files", {})
        assert set(files) == names - {"design.json", "report.json", "report.html"}
        assert not files or report["valid"] is not True
        page = (folder / "report.html").read_text(encoding="utf-8")
        assert all(name in page for name in files)
    assert all((folder / name).stat().st_size == size for name, size in files.items())
    check_design(json.loads((folder / "design.json").read_text("utf-8")))
    return names


def test_stopping_the_layout_keeps_the_best_so_far(tmp_path):
    out = tmp_path / "out"
    status, said = interrupted("layout", "design", "tower", "-o", out, "--no-solids", wait=0.05)
    assert check_stopped(out, status, said) == {"design.json", "report.json", "report.html"}


@pytest.mark.parametrize("word", ["building solids", "meshing membranes", "front membrane"])
def test_stopping_before_the_files(tmp_path, word):
    (tmp_path / "dome.obj").write_text(dome(7))
    out = tmp_path / "out"
    status, said = interrupted(word, "design", tmp_path / "dome.obj", "-o", out, "--no-remesh")
    assert check_stopped(out, status, said) == {"design.json", "report.json", "report.html"}
    # Whatever was found valid before, nobody has looked at all solids.
    report = json.loads((out / "report.json").read_text("utf-8"))
    assert ("print" in report) != any("solids" in text for text in report.get("not_covered", ()))


def test_a_stop_at_any_time_leaves_no_file_that_no_report_lists(laid_out, tmp_path):
    for turn in range(12):
        out = tmp_path / f"out-{turn}"
        status, said = interrupted("writing", "export", laid_out, "-o", out, wait=0.03 * turn)
        if status == 3:
            check_stopped(out, status, said)


def test_stopping_the_checks_keeps_the_files_that_are_there(tmp_path):
    (tmp_path / "dome.obj").write_text(dome(7))
    out = tmp_path / "out"
    status, said = interrupted("checking solids", "design", tmp_path / "dome.obj", "-o", out, "--no-remesh")
    check_stopped(out, status, said)
    assert not (out / "dome.FCStd").exists()
    report = json.loads((out / "report.json").read_text("utf-8"))
    assert ("print" in report) != any("solids" in text for text in report.get("not_covered", ()))


@pytest.fixture(scope="module")
def laid_out(curveups, tmp_path_factory):
    """The design of a dome that is large enough to be interrupted."""
    folder = tmp_path_factory.mktemp("laid-out")
    (folder / "dome.obj").write_text(dome(7))
    ran = curveups("design", folder / "dome.obj", "-o", folder, "--no-remesh", "--no-solids", "--set",
                   "run_verification=off")
    assert ran.status == 0, ran.err
    return folder / "design.json"


@pytest.mark.parametrize("number, ending", [(0, "-print.3mf"), (1, "-tiles.step"), (4, "-print.step"),
                                            (6, "-tiles.stl")])
def test_stopping_an_export(laid_out, tmp_path, number, ending):
    """`number`: how many of the print's files come before."""
    out = tmp_path / "out"
    status, said = interrupted(ending, "export", laid_out, "-o", out)
    names = check_stopped(out, status, said)
    # Files after it may have been complete before the signal was sent and seen; not all of them.
    assert number <= len(names) - 3 and "dome.FCStd" not in names, names


def test_stopping_verify(laid_out, tmp_path):
    out = tmp_path / "out"
    status, said = interrupted("meshing membranes", "verify", laid_out, "-o", out)
    assert status == 3, said
    report = json.loads((out / "report.json").read_text("utf-8"))
    assert report["status"] == "stopped" and report["valid"] is None
    assert report["reasons"] == ["stopped during verification"]


def test_stopping_where_there_is_nothing_yet(tmp_path):
    status, said = interrupted("remeshing", "design", "tower", "-o", tmp_path / "out", "--set", "L=3")
    assert status == 3 and said.splitlines()[-1] == "curveups: stopped", said
    assert not (tmp_path / "out").exists()


def test_the_bar_of_work_whose_end_is_not_known_moves(monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    shown = Terminal()
    monkeypatch.setattr("sys.stderr", shown)
    bar = Reporter(Interrupt(), quiet=False)
    for now in range(4):
        monkeypatch.setattr("curveups.base.progress.time.monotonic", lambda: 100.0 + now)
        assert bar("reading the target", -1.0)
    drawn = re.findall(r"\[(-*#-*)\] reading the target", shown.getvalue())
    assert len(set(drawn)) == 4 and {len(one) for one in drawn} == {Reporter.WIDTH}


@pytest.mark.parametrize("word", ["small-cap-print.step", "small-cap-latex-front.pdf"])
def test_stopping_a_kit(printed, tmp_path, word):
    out = tmp_path / "out"
    status, said = interrupted(word, "kit", printed.folder / "design.json", "-o", out)
    assert status == 3 and "Traceback" not in said and said.splitlines()[-1].startswith("stopped"), said
    found = json.loads((out / "kit.json").read_text("utf-8"))
    assert found["status"] == "stopped"
    there = {str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()}
    assert there == {*found["files"], "kit.json", "design.json"}
    assert all((out / name).stat().st_size == about["bytes"] for name, about in found["files"].items())


def test_stopping_a_comparison_writes_nothing(printed, tmp_path):
    design = json.loads((printed.folder / "design.json").read_text("utf-8"))
    (tmp_path / "scan.xyz").write_text("".join("%g %g %g\n" % tuple(point) for point in design["V"]))
    out = tmp_path / "out"
    status, said = interrupted("registering", "compare", printed.folder / "design.json",
                               tmp_path / "scan.xyz", "-o", out)
    assert status == 3 and said.splitlines()[-1] == "curveups: stopped", said
    assert not out.exists()
