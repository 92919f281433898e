# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files that are damaged: a line and status 2, never a crash, never a surface with holes."""

import random
import re
import subprocess
from types import SimpleNamespace

import numpy as np
import pytest
from running import environment

from curveups.base import freecad_session
from curveups.base.errors import CurveUpsError, Stopped
from curveups.base.machine import is_running
from curveups.targets import cad_files
from curveups.targets.brep_file import is_whole_brep
from curveups.targets.cad_parts import Choice

MOST_MUTATIONS = 12  # a file, of some 130 to 370 lines


@pytest.fixture(autouse=True)
def impatient(monkeypatch):
    monkeypatch.setattr(cad_files, "_TIME_LIMIT_MOST", 30.0)


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
            F = cad_files.read_cad(path, 0.1).F
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


def changed(path, lines, word, number):
    """The file, in which a number of the last line with a word is another."""
    place = max(k for k, line in enumerate(lines) if word in line)
    last = list(re.finditer(r"[-+]?\d+\.\d*(?:E[-+]?\d+)?", lines[place]))[-1]
    line = lines[place][:last.start()] + repr(float(last[0]) + number) + lines[place][last.end():]
    path.write_text("\n".join((*lines[:place], line, *lines[place + 1:])))
    return path


def test_edges_and_faces_of_a_file_that_lie_apart_are_noticed(spherical_cap, open_box, tmp_path):
    """A radius that was changed, or a corner: FreeCAD reads another shape, and says nothing."""
    box = (open_box / "box.step").read_text("utf-8").splitlines()
    corner = max(line.split("#")[-1].rstrip(");") for line in box if "VERTEX_POINT(" in line)
    for word, lines, number in (("= CIRCLE(", spherical_cap, 5.0),
                                ("= SPHERICAL_SURFACE(", spherical_cap, 3.0),
                                (f"#{corner} = CARTESIAN_POINT(", box, 8.0)):
        with pytest.raises(CurveUpsError, match="mm apart|do not bound"):
            cad_files.read_cad(changed(tmp_path / "a.step", lines, word, number), 0.5)
    little = cad_files.read_cad(changed(tmp_path / "a.step", spherical_cap, "= CIRCLE(", 0.2), 0.5)
    assert any("edges and faces of the file are 0.2" in note for note in little.notes), little.notes


@pytest.fixture
def sleeper(monkeypatch):
    """A reader that never returns."""
    real, started = subprocess.Popen, []

    def start(command, **more):
        started.append(real(["sleep", "600"], **more))
        return started[-1]

    monkeypatch.setattr(cad_files.subprocess, "Popen", start)
    return started


def test_a_reader_that_does_not_return_is_ended(open_box, sleeper, monkeypatch):
    monkeypatch.setattr(cad_files, "_TIME_LIMIT_MOST", 1.0)
    asked = iter([True, True, True])
    with pytest.raises(CurveUpsError, match="within 1 s"):
        cad_files.read_cad(open_box / "box.brep", 0.1)
    with pytest.raises(Stopped):
        cad_files.read_cad(open_box / "box.brep", 0.1, go_on=lambda _: next(asked, False))
    assert len(sleeper) == 2 and all(process.poll() is not None for process in sleeper)


@pytest.fixture(scope="module")
def curved(tmp_path_factory):
    """A folder of BREP files with surfaces, curves, places and triangles of all kinds."""
    folder = tmp_path_factory.mktemp("curved")
    script = f"""
from curveups.base import freecad_session
freecad, part = freecad_session.load("Part")
V = freecad.Vector
lid = part.makeCylinder(10, 20).fuse(part.makeCone(10, 5, 10, V(0, 0, 20))).removeSplitter()
wave = part.BSplineCurve()
wave.interpolate([V(0, 0, 0), V(10, 5, 0), V(20, -5, 3), V(30, 0, 0)])
bow = part.BezierCurve()
bow.setPoles([V(0, 0, 0), V(5, 9, 0), V(10, 0, 4)])
bow.setWeight(2, 3.0)
boxes = [part.makeBox(1, 1, 1, V(k, 0, 0)) for k in range(3)]
boxes[1].Placement = freecad.Placement(V(3, 3, 3), freecad.Rotation(V(1, 1, 0), 30))
placed = part.makeCompound(boxes)
placed.Placement = freecad.Placement(V(3, 0, 3), freecad.Rotation(V(1, 0, 0), 30))
meshed = part.makeTorus(20, 5)
meshed.tessellate(1)
shapes = dict(
    cylinder=part.Shell(lid.Faces[:-1]), ball=part.makeSphere(20).toNurbs(), torus=part.makeTorus(20, 5),
    meshed=meshed, swept=wave.toShape().extrude(V(0, 0, 10)),
    turned=wave.toShape().revolve(V(0, -20, 0), V(1, 0, 0), 200), bow=bow.toShape().extrude(V(0, 0, 10)),
    patch=part.BezierSurface().toShape(),
    offset=part.OffsetCurve(wave, 2.0, V(0, 0, 1)).toShape().extrude(V(0, 0, 5)),
    ellipse=part.Ellipse(V(0, 0, 0), 10, 5).toShape().extrude(V(1, 0, 10)),
    parabola=part.Parabola().toShape(-5, 5).extrude(V(0, 0, 10)),
    hyperbola=part.Hyperbola(V(0, 0, 0), 3, 2).toShape(-1, 1).extrude(V(0, 0, 10)),
    placed=part.makeCompound([placed, boxes[0]]))
for name, shape in shapes.items():
    shape.exportBrep(f"{folder}/" + name + ".brep")
"""
    subprocess.run([freecad_session.python(), "-c", script], env=environment(), check=True,
                   capture_output=True)
    return folder


def area_of(path):
    found = cad_files.read_cad(path, 0.1)
    sides = found.V[found.F][:, 1:] - found.V[found.F][:, :1]
    return np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum() / 2


def test_brep_files_that_are_cut_off_are_refused_before_they_are_read(curved, tmp_path, monkeypatch):
    monkeypatch.setattr(cad_files.subprocess, "Popen", None)  # FreeCAD's reader waits for their ends for ever
    files = sorted(curved.glob("*.brep"))
    assert len(files) == 13
    for file in files:
        data = file.read_bytes()
        assert is_whole_brep(data), file.name
        path = tmp_path / file.name
        # Behind the header, up to the words of the last line, which name the shape.
        for share in np.linspace(0.1, 1, 20, endpoint=False):
            path.write_bytes(data[:int(share * len(data.rstrip()))])
            with pytest.raises(CurveUpsError, match="less than it announces"):
                cad_files.read_cad(path, 0.1)


def test_counts_and_numbers_of_brep_files_are_looked_at(curved):
    data = (curved / "cylinder.brep").read_bytes()
    assert is_whole_brep(data)
    count = re.search(rb"TShapes (\d+)", data)
    for wrong in (b"TShapes 3", b"TShapes -1", b"TShapes 99999999999999999999", b"TShapes 1.5", b"TShapes x"):
        assert not is_whole_brep(data.replace(count[0], wrong))
    assert not is_whole_brep(data.replace(b"Surfaces", b"Surface"))
    assert not is_whole_brep(data.replace(b"Curves 5", b"Curves 5\n" + b"8 0 1 " * 5000))
    edge = re.search(rb"\n2  \d+ \d+ 0 ", data)[0]
    assert not is_whole_brep(data.replace(edge, edge.replace(b" 0 ", b" 0.5 "), 1))
    assert is_whole_brep(b"no text of OpenCASCADE")  # FreeCAD says so


def test_a_brep_file_without_one_curve_on_a_surface_keeps_its_shape_or_is_refused(curved, tmp_path):
    lines = (curved / "cylinder.brep").read_bytes().split(b"\n")
    path = tmp_path / "cylinder.brep"
    whole = area_of(curved / "cylinder.brep")
    begin = lines.index(b"Curves 5")
    curves = [k for k in range(begin) if lines[k].startswith((b"1 ", b"2 "))]
    uses = [k for k in range(begin, len(lines)) if re.match(rb"[23]  \d+ \d", lines[k])]
    assert len(curves) > 5 and len(uses) > 5
    refused = 0
    for place in (*curves[::3], *uses):
        path.write_bytes(b"\n".join(lines[:place] + lines[place + 1:]))
        try:
            assert abs(area_of(path) - whole) < 1e-3 * whole, lines[place]
        except CurveUpsError as error:
            assert error.remedy, lines[place]
            refused += 1
    assert refused > 5


def test_curves_that_are_not_those_of_their_faces_are_noticed(curved, tmp_path):
    """Numbers of a file that reads: FreeCAD covers another part of the surface, whose area it gives."""
    text = (curved / "cylinder.brep").read_text("utf-8")
    path, whole = tmp_path / "cylinder.brep", area_of(curved / "cylinder.brep")
    uses = list(re.finditer(r"\n2  (\d+) (\d+) 0 ", text))
    refused = 0
    for one, other in zip(uses, uses[1:]):
        path.write_text(text[:one.start(1)] + other[1] + text[one.end(1):])
        try:
            assert abs(area_of(path) - whole) < 1e-2 * whole
        except CurveUpsError as error:
            assert str(path) == error.where
            refused += "do not bound" in error.what or "triangles" in error.what
    assert refused > 2


def test_the_time_limit_follows_the_size_of_the_file(open_box, sleeper, monkeypatch, tmp_path):
    monkeypatch.setattr(cad_files, "_TIME_LIMIT", 0.0)
    monkeypatch.setattr(cad_files, "_TIME_LIMIT_MB", 100.0)
    large = tmp_path / "large.step"
    large.write_bytes((open_box / "box.step").read_bytes() + b"\n" * 10_000)
    with pytest.raises(CurveUpsError, match="within [12] s"):
        cad_files.read_cad(large, 0.1)


def test_a_reader_ends_with_a_killed_program_and_the_next_run_tidies_up(open_box, tmp_path):
    environ = environment(TMPDIR=str(tmp_path))
    # The child stands still before it reads, so that it outlives its parent where nothing ends it.
    script = f"""
import subprocess, sys
from pathlib import Path
from curveups.targets import cad_files
real = subprocess.Popen
def start(command, **more):
    asleep = "import sys, time; from curveups.base.machine import end_with_parent;" \\
             "end_with_parent(int(sys.argv[-1])); print('ready', flush=True); time.sleep(600)"
    child = real([command[0], "-c", asleep, command[-1]], **{{**more, "stdout": None}})
    print(child.pid, flush=True)
    return child
cad_files.subprocess.Popen = start
cad_files.read_cad(Path({str(open_box / "box.brep")!r}), 0.1)
"""
    program = subprocess.Popen([freecad_session.python(), "-c", script], env=environ, stdout=subprocess.PIPE,
                               text=True)
    child, ready = int(program.stdout.readline()), program.stdout.readline()
    assert ready == "ready\n" and is_running(child)
    program.kill()
    program.wait()
    assert program.stdout.read() == ""  # the child holds the other end of the pipe, too
    left, = tmp_path.iterdir()
    assert left.name.startswith(f".{program.pid}-curveups-cad-")
    again = "from pathlib import Path; from curveups.targets import cad_files; " \
            f"cad_files.read_cad(Path({str(open_box / 'box.brep')!r}), 0.1)"
    subprocess.run([freecad_session.python(), "-c", again], env=environ, check=True)
    assert list(tmp_path.iterdir()) == []


def test_damaged_file_on_the_command_line(curveups, open_box, tmp_path):
    text = (open_box / "box.step").read_text("utf-8")
    (tmp_path / "box.step").write_text(re.sub(r"#\d+ = ADVANCED_FACE.*\n", "", text, count=1))
    ran = curveups("design", tmp_path / "box.step", "-o", tmp_path / "out")
    assert ran.status == 2 and len(ran.error_lines) == 1 and "box.step" in ran.error_lines[0]
    assert not (tmp_path / "out").exists()


def test_a_surface_of_a_kind_that_freecad_does_not_know_is_refused():
    """In a damaged file. It broke the process that reads down, and the window with it."""
    class Face:
        @property
        def Surface(self):
            raise TypeError("undefined surface type")

    shape = SimpleNamespace(Solids=[], Shells=[], Faces=[Face()], isNull=lambda: False)
    with pytest.raises(CurveUpsError, match="can't make triangles of the surface") as refused:
        cad_files.surface_of_shape(shape, 0.5, Choice(faces="Face1", open="largest"), "somewhere")
    assert isinstance(refused.value.__cause__, TypeError)
