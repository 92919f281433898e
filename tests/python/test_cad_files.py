# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files that are damaged: a line and status 2, never a crash, never a surface with holes."""

import random
import re
import subprocess

import numpy as np
import pytest
from running import environment

from curveups.base import freecad_session
from curveups.targets import cad_files
from curveups.base.errors import CurveUpsError, Stopped

MOST_MUTATIONS = 12  # a file, of some 130 to 370 lines


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


@pytest.fixture(scope="module")
def spherical_cap(tmp_path_factory):
    """The lines of an eighth of a sphere, whose edges are circles. A string and a comment in it look like
    references."""
    path = tmp_path_factory.mktemp("cap") / "cap.step"
    script = f"""
from curveups.base import freecad_session
_, part = freecad_session.load("Part")
part.makeSphere(40).common(part.makeBox(60, 60, 60)).Faces[0].exportStep({str(path)!r})
"""
    subprocess.run([freecad_session.python(), "-c", script], env=environment(), check=True,
                   capture_output=True)
    text = path.read_text("utf-8")
    assert "'FreeCAD Model'" in text
    return text.replace("'FreeCAD Model'", "'of #98765'").replace("DATA;", "DATA; /* #4711 */").splitlines()


@pytest.mark.parametrize("ending", ["step", "iges", "brep"])
def test_whole_files(open_box, ending):
    found = cad_files.read_cad(open_box / f"box.{ending}", 0.1)
    V, F = found.V, found.F
    assert len(F) == 10
    sides = V[F][:, 1:] - V[F][:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum() / 2
    assert abs(area - (2 * 40 * 20 + 2 * 30 * 20 + 40 * 30)) < 1e-6


@pytest.mark.parametrize("ending", ["step", "iges", "brep"])
def test_no_deletion_of_a_line_loses_a_face(open_box, tmp_path, ending):
    lines = (open_box / f"box.{ending}").read_bytes().split(b"\n")
    path, refused = tmp_path / f"box.{ending}", 0
    for place in random.Random(1).sample(range(len(lines) - 1), MOST_MUTATIONS):
        path.write_bytes(b"\n".join(lines[:place] + lines[place + 1:]))
        try:
            F = cad_files.read_cad(path, 0.1, time_limit=20).F
        except CurveUpsError as error:
            refused += 1
            assert error.where == str(path) and error.remedy
        else:
            assert len(F) == 10, lines[place]
    assert refused > 0


def test_a_face_that_is_gone_is_missed(open_box, tmp_path):
    text = (open_box / "box.step").read_text("utf-8")
    (tmp_path / "box.step").write_text(re.sub(r"#\d+ = ADVANCED_FACE.*\n", "", text, count=1))
    with pytest.raises(CurveUpsError, match="damaged"):
        cad_files.read_cad(tmp_path / "box.step", 0.1)
    text = (open_box / "box.iges").read_text("utf-8")
    (tmp_path / "box.iges").write_text(text.replace(text.splitlines()[10] + "\n", ""))
    with pytest.raises(CurveUpsError, match="lines of it are missing"):
        cad_files.read_cad(tmp_path / "box.iges", 0.1)


def test_a_face_that_lost_an_edge_is_missed(open_box, tmp_path):
    """FreeCAD's triangles go on to where the edge's neighbours would meet, or anywhere."""
    lines = (open_box / "box.step").read_text("utf-8").splitlines()
    edges = [k for k, line in enumerate(lines) if "ORIENTED_EDGE(" in line]
    for place in edges[::7]:
        (tmp_path / "box.step").write_text("\n".join(lines[:place] + lines[place + 1:]))
        with pytest.raises(CurveUpsError, match="do not close|could be read|triangles|damaged"):
            cad_files.read_cad(tmp_path / "box.step", 0.1)


def test_what_a_step_file_has_lost_is_missed(spherical_cap, tmp_path):
    """Without one of its circles FreeCAD reads the whole sphere."""
    path = tmp_path / "cap.step"
    path.write_text("\n".join(spherical_cap))
    whole = cad_files.read_cad(path, 0.5)
    assert whole.V.min() > -1e-6
    for word in ("= CIRCLE(", "= EDGE_CURVE(", "= AXIS2_PLACEMENT_3D("):
        place = max(k for k, line in enumerate(spherical_cap) if word in line)
        path.write_text("\n".join(spherical_cap[:place] + spherical_cap[place + 1:]))
        with pytest.raises(CurveUpsError, match="lost 1 of its entities"):
            cad_files.read_cad(path, 0.5)


@pytest.fixture
def sleeper(monkeypatch):
    """A reader that never returns."""
    real, started = subprocess.Popen, []

    def start(command, **more):
        started.append(real(["sleep", "600"], **more))
        return started[-1]

    monkeypatch.setattr(cad_files.subprocess, "Popen", start)
    return started


def test_a_reader_that_does_not_return_is_ended(open_box, sleeper):
    asked = iter([True, True, True])
    with pytest.raises(CurveUpsError, match="within 1 s"):
        cad_files.read_cad(open_box / "box.brep", 0.1, time_limit=1.0)
    with pytest.raises(Stopped):
        cad_files.read_cad(open_box / "box.brep", 0.1, go_on=lambda: next(asked, False))
    assert len(sleeper) == 2 and all(process.poll() is not None for process in sleeper)


def test_damaged_file_on_the_command_line(curveups, open_box, tmp_path):
    text = (open_box / "box.step").read_text("utf-8")
    (tmp_path / "box.step").write_text(re.sub(r"#\d+ = ADVANCED_FACE.*\n", "", text, count=1))
    ran = curveups("design", tmp_path / "box.step", "-o", tmp_path / "out")
    assert ran.status == 2 and len(ran.error_lines) == 1 and "box.step" in ran.error_lines[0]
    assert not (tmp_path / "out").exists()
