# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids that FreeCAD's Part reads of bodies, and OpenCASCADE's check of a sample of them."""

import re
import sys
import threading

import pytest

from curveups.base import freecad_session
from curveups.base.errors import CurveUpsError
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages import solids
from curveups.stages.stage import Job


@pytest.fixture(scope="module")
def design(printed):
    return native.read_design((printed.folder / "design.json").read_text("utf-8"))


def print_of(design, **values):
    parameters = native.Parameters(design.parameters)
    for name, value in values.items():
        parameters.set(name, value)
    return native.make_print_model(design.with_parameters(parameters))


def points_in(text):
    """Coordinates of the vertices in a BREP."""
    rows = re.findall(rb"^Ve\s+1e-07\s+(\S+) (\S+) (\S+)", text, re.M)
    return sorted(tuple(map(float, row)) for row in rows)


@pytest.mark.parametrize("support", ["soluble", "breakaway"])
@pytest.mark.parametrize("bumps", ["bumps", "dimples", "none"])
def test_solids_of_all_bodies_are_sound_and_share_edges_and_vertices(design, bumps, support):
    model = print_of(design, bumps=bumps, support=support)
    bodies = model.bodies("print") + model.bodies("actuated")
    for body, solid in zip(bodies, solids.part_solids(bodies, Job())):
        assert solid.ShapeType == "Solid" and solid.isValid() and solid.isClosed()
        solid.check()  # raises
        assert solid.Volume == pytest.approx(body.volume, rel=1e-9)
        kinds = [face.Surface.TypeId.removeprefix("Part::Geom") for face in solid.Faces]
        assert kinds.count("Plane") == body.faces
        # An edge lies between two faces: all but a cap's seam and its apex, and a cylinder's seam.
        alone = 2 * kinds.count("Sphere") + kinds.count("Cylinder")
        assert sum(len(face.Edges) for face in solid.Faces) == 2 * len(solid.Edges) - alone
        text, = native.brep_texts([body])
        assert sorted(tuple(vertex.Point) for vertex in solid.Vertexes) == points_in(text)


def test_step_files_hold_the_same_solids(design, tmp_path):
    _, part = freecad_session.load("Part")
    model, path = print_of(design, support="soluble"), str(tmp_path / "a.step")
    for kind in ("print", "actuated"):
        model.write("step", kind, path)
        bodies = model.bodies(kind)
        written = part.read(path).Solids
        assert len(written) == len(bodies)
        for body, solid, other in zip(bodies, solids.part_solids(bodies, Job()), written):
            assert other.isValid() and other.Volume == pytest.approx(body.volume, rel=1e-9)
            assert other.CenterOfMass.distanceToPoint(solid.Solids[0].CenterOfMass) < 1e-7


def test_slabs_stay_out_of_the_sample_unless_all_is_checked(design):
    model = print_of(design, support="soluble")
    slab, = model.bodies("support")
    names = [body.name for body in model.bodies("print")]
    unsound, sample = solids.check_solids(model, False, Job())
    assert unsound == [] and slab.name not in sample
    assert sum(name.startswith("T") for name in sample) == 16 and set(sample) < set(names)
    assert solids.check_solids(model, True, Job()) == ([], names)


def test_nothing_counts_as_checked_without_freecad(design, monkeypatch):
    def fail(*_):
        raise CurveUpsError("FreeCAD can't be loaded")

    monkeypatch.setattr(freecad_session, "load", fail)
    parameters = native.Parameters(design.parameters)
    parameters.set("check_all", True)
    project = Project.of_design(design.with_parameters(parameters))
    check = project.run(("check",))["check"]
    assert check.solids_block["checked_by_opencascade"] == [] and check.solids_block["invalid"] == 0
    with pytest.raises(CurveUpsError, match="can't be loaded"):
        project.run(("solids",), strict=True)


def test_opencascade_finds_damage(design, monkeypatch):
    model = print_of(design)
    body, other = model.bodies("tiles")[:2]
    (text,), (others,) = native.brep_texts([body]), native.brep_texts([other])

    def found(damaged):
        monkeypatch.setattr(native, "brep_texts", lambda bodies: [damaged])
        return solids.opencascade_finds(body, Job())

    assert found(text) == ""
    assert found(others) == "volume"
    assert found(re.sub(rb"(Ve\s+1e-07\s+)(\S+)", rb"\g<1>1e3", text, count=1)) == "invalid"
    turned, count = re.subn(rb"(Sh\n\n0101100\n)\+", rb"\g<1>-", text)
    assert count == 1 and found(turned) == "invalid"
    with pytest.raises(CurveUpsError, match=f"OpenCASCADE failed building {body.name}"):
        found(b"CASCADE Topology V2, (c) Matra-Datavision\nLocations 0\nCurves")
    monkeypatch.setattr(native, "check_bodies", lambda bodies, job: ["open"] * 5 + [""] * (len(bodies) - 5))
    check = Project.of_design(design).run(("check",))["check"]
    reason, = check.reasons()
    assert reason.kind == "unsound.many" and reason.tiles == tuple(range(5)) and reason.figures["more"] == 2
    assert str(reason).startswith("solids are not sound: T00001") and check.solids_block["invalid"] == 5


def test_other_threads_run_while_a_large_solid_is_read(design, monkeypatch):
    monkeypatch.setattr(solids, "_LARGE", 1)
    slab, = print_of(design, support="soluble").bodies("support")
    read, counts, made = solids._Yielding.read, [0], []

    def reading(self, size):
        counts[0] += 1
        return read(self, size)

    monkeypatch.setattr(solids._Yielding, "read", reading)
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    worker, seen = threading.Thread(target=lambda: made.extend(solids.part_solids([slab], Job()))), set()
    worker.start()
    while worker.is_alive():
        seen.add(counts[0])
    sys.setswitchinterval(interval)
    assert len(seen) > 2 and made[0].isValid()
    assert made[0].Volume == pytest.approx(slab.volume, rel=1e-9)
