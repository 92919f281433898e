# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files are read in a process of their own: a damaged one is refused, never a crash, never a hang."""

import re
import subprocess

import numpy as np
import pytest
from running import environment

from curveups.base import freecad_session
from curveups.base.errors import CurveUpsError, Stopped
from curveups.targets import cad_files


@pytest.fixture(scope="module")
def open_box(tmp_path_factory):
    """A box without a lid, 40 x 30 x 20 mm, in the three formats: 5 faces, 10 triangles."""
    folder = tmp_path_factory.mktemp("cad")
    script = f"""
from curveups.base import freecad_session
_, part = freecad_session.load("Part")
shell = part.Shell(part.makeBox(40, 30, 20).Faces[:5])
shell.exportStep({str(folder / "box.step")!r})
shell.exportIges({str(folder / "box.iges")!r})
shell.exportBrep({str(folder / "box.brep")!r})
"""
    subprocess.run([freecad_session.python(), "-c", script], env=environment(), check=True,
                   capture_output=True)
    return folder


@pytest.mark.parametrize("ending", ["step", "iges", "brep"])
def test_whole_files(open_box, ending):
    read = cad_files.read_cad(open_box / f"box.{ending}", 0.1)
    assert len(read.F) == 10
    sides = read.V[read.F][:, 1:] - read.V[read.F][:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum() / 2
    assert abs(area - (2 * 40 * 20 + 2 * 30 * 20 + 40 * 30)) < 1e-6


@pytest.mark.parametrize("ending", ["step", "iges", "brep"])
def test_files_that_end_early_are_refused_before_they_are_read(open_box, tmp_path, ending, monkeypatch):
    """OpenCASCADE's reader of BREP waits for their ends for ever."""
    monkeypatch.setattr(cad_files.subprocess, "Popen", None)
    data = (open_box / f"box.{ending}").read_bytes()
    path = tmp_path / f"box.{ending}"
    path.write_bytes(data[:len(data) * 2 // 3])
    with pytest.raises(CurveUpsError, match="ends early") as refused:
        cad_files.read_cad(path, 0.1)
    assert refused.value.where == str(path)


def test_a_face_that_can_not_be_read_is_missed(open_box, tmp_path):
    """FreeCAD passes over it in silence."""
    text = (open_box / "box.step").read_text("utf-8")
    plane = re.findall(r"#\d+ = PLANE.*\n", text)[1]
    (tmp_path / "box.step").write_text(text.replace(plane, ""))
    with pytest.raises(CurveUpsError, match="only 4 of the file's 5 faces could be read"):
        cad_files.read_cad(tmp_path / "box.step", 0.1)


@pytest.mark.parametrize("program, word", [(["sleep", "600"], "within 0 s"), (["false"], "reader crashed")])
def test_a_reader_that_does_not_return_or_crashes(open_box, monkeypatch, program, word):
    real, started = subprocess.Popen, []

    def start(command, **more):
        started.append(real(program, **more))
        return started[-1]

    monkeypatch.setattr(cad_files.subprocess, "Popen", start)
    monkeypatch.setattr(cad_files, "_TIME_LIMIT", 0.2)
    with pytest.raises(CurveUpsError, match=word):
        cad_files.read_cad(open_box / "box.brep", 0.1)
    if program[0] == "sleep":
        with pytest.raises(Stopped):
            cad_files.read_cad(open_box / "box.brep", 0.1, go_on=lambda _: False)
    assert all(process.poll() is not None for process in started)
