# SPDX-License-Identifier: LGPL-2.1-or-later
"""SIGINT at every command: status 3, the best so far is written, every file whole."""

import io
import json
import re
import signal
import struct
import subprocess
import time
import zipfile

import pytest
from running import command, environment
from schema import check_design, check_report

from curveups.base.progress import Interrupt, Reporter

BARE = {"design.json", "report.json", "report.html"}


@pytest.fixture
def interrupted(curveups, monkeypatch):
    """Run a command and raise SIGINT once its progress says `word`."""
    def run(word, *arguments):
        tell, sent = Reporter.__call__, []

        def telling(self, what, fraction=-1.0):
            if word in what and not sent:
                sent.append(what)
                signal.raise_signal(signal.SIGINT)
                latest = time.monotonic() + 30
                while tell(self, what, fraction) and time.monotonic() < latest:
                    time.sleep(0.001)  # the main thread handles signals
            return tell(self, what, fraction)

        monkeypatch.setattr(Reporter, "__call__", telling)
        ran = curveups(*arguments)
        assert sent, f"'{word}' was not reached: {ran.err}"
        assert ran.status == 3 and "Traceback" not in ran.err, ran.err
        return ran.err

    return run


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


def check_stopped(folder, said):
    """Checks that the written files are whole and listed in the report; returns their names."""
    assert said.splitlines()[-1].startswith("stopped"), said
    report = json.loads((folder / "report.json").read_text("utf-8"))
    check_report(report)
    assert report["status"] == "stopped"
    names = {path.name for path in folder.iterdir()}
    for path in folder.iterdir():
        check_whole(path)
    if "print" in report:
        files = report["print"]["files"]
        assert set(files) == names - {"report.json"}
        assert all((folder / name).stat().st_size == size for name, size in files.items())
    else:
        assert names == BARE
    check_design(json.loads((folder / "design.json").read_text("utf-8")))
    return names


def test_stopping_a_program(tmp_path):
    """A signal of the system, at the layout."""
    out = tmp_path / "out"
    process = subprocess.Popen(command("design", "tower", "-o", out, "--no-solids"), env=environment(),
                               stderr=subprocess.PIPE, text=True)
    said = ""
    for line in process.stderr:
        said += line
        if "layout" in line:
            break
    process.send_signal(signal.SIGINT)
    said += process.stderr.read()
    assert process.wait(timeout=120) == 3, said
    assert check_stopped(out, said) == BARE


def test_stopping_a_design_before_its_files(interrupted, cap, tmp_path):
    said = interrupted("building solids", "design", cap, "-o", tmp_path, "--no-remesh")
    assert check_stopped(tmp_path, said) == BARE
    # Whatever was found valid before, nobody has looked at all solids.
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert any("solids" in text for text in report["not_covered"]) and report["valid"] is not True


def test_stopping_an_export_between_its_files(interrupted, designed, tmp_path):
    said = interrupted("-tiles.stl", "export", designed.folder / "design.json", "-o", tmp_path)
    names = check_stopped(tmp_path, said)
    # FreeCAD's document is written beside the bodies.
    assert len(names - BARE - {"small-cap.FCStd"}) == 6 and "small-cap-tiles.stl" not in names, names


def test_stopping_verify(interrupted, designed, tmp_path):
    interrupted("meshing membranes", "verify", designed.folder / "design.json", "-o", tmp_path)
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["status"] == "stopped" and report["valid"] is None
    assert report["reasons"] == ["stopped during verification"]


@pytest.mark.parametrize("asked", ["design", "check", "remesh"])
def test_stopping_where_there_is_nothing_yet(interrupted, tmp_path, asked):
    said = interrupted("remeshing", asked, "tower", "-o", tmp_path / "out", "--set", "L=5")
    assert said.splitlines()[-1] == "curveups: stopped", said
    assert not (tmp_path / "out").exists()


def test_stopping_a_kit(interrupted, printed, tmp_path):
    said = interrupted("small-cap-latex-front.pdf", "kit", printed.folder / "design.json", "-o", tmp_path)
    assert said.splitlines()[-1].startswith("stopped"), said
    kit = json.loads((tmp_path / "kit.json").read_text("utf-8"))
    assert kit["status"] == "stopped"
    there = {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()}
    assert there == {*kit["files"], "kit.json", "design.json"}
    assert all((tmp_path / name).stat().st_size == about["bytes"] for name, about in kit["files"].items())


def test_stopping_a_comparison_writes_nothing(interrupted, printed, tmp_path):
    design = printed.json("design.json")
    (tmp_path / "scan.xyz").write_text("".join("%g %g %g\n" % tuple(point) for point in design["V"]))
    interrupted("registering", "compare", printed.folder / "design.json", tmp_path / "scan.xyz",
                "-o", tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_second_signal_ends_at_once():
    with Interrupt() as interrupt:
        signal.raise_signal(signal.SIGINT)
        assert interrupt.requested
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_a_terminal_shows_a_bar_that_moves_where_the_end_is_not_known(monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    shown = Terminal()
    monkeypatch.setattr("sys.stderr", shown)
    bar = Reporter(Interrupt(), quiet=False)
    for now in range(4):
        monkeypatch.setattr("curveups.base.progress.time.monotonic", lambda: 100.0 + now)
        assert bar("reading the target", -1.0)
    assert bar("layout", 0.5) and "\r\033[K[" + "#" * 15 + "." * 15 + "]  50 % layout" in shown.getvalue()
    drawn = re.findall(r"\[(-*#-*)\] reading the target", shown.getvalue())
    assert len(set(drawn)) == 4 and {len(line) for line in drawn} == {Reporter.WIDTH}
