# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints that are too large for their printer's bed: turned, with fewer anchors, or in parts that butt."""

import io
import json
import subprocess
from types import SimpleNamespace

import ezdxf
import numpy as np
import pytest

from curveups.base import freecad_session
from curveups.base.language import ENGLISH
from curveups.base.native import native
from curveups.kit import beds, drawing, files, maps
from curveups.kit import kit as kit_module
from curveups.project.project import Project
from curveups.stages.solids import amounts, check_solids
from curveups.stages.stage import Job


@pytest.fixture(scope="module")
def design(printed):
    return native.read_design((printed.folder / "design.json").read_text("utf-8"))


def divided(design, bed, **values):
    own = native.Parameters(design.parameters)
    for name, value in values.items():
        own.set(name, value)
    design = design.with_parameters(own)
    model = native.make_print_model(design)
    printer = {"bed_mm": [*bed, 100], "growth_mm": 0.05}
    return model, beds.beds(design, model, printer, native.tile_shapes(design), lambda *_: True), printer


def require_whole(model, found, printer):
    """Every body is printed once, valid, on a bed that has room for it."""
    bodies = volume = 0
    for number in range(len(found.places)):
        bed = found.bed(number)
        room = np.array(printer["bed_mm"][:2]) + 1e-6
        assert (np.abs(bed.mesh("tiles")[0][:, :2]).max(0) <= room / 2).all()
        assert (bed.bbox[:2] <= room).all() and check_solids(bed, True, Job())[0] == []
        bodies += len(bed.bodies("tiles"))
        volume += bed.volumes["tiles"]
    assert bodies == model.tile_count and volume == pytest.approx(model.volumes["tiles"])


def test_what_fits_stays_as_it_is(design):
    model, found, _ = divided(design, (100, 120))
    assert found is None
    assert divided(design, model.bbox[:2])[1] is None


def test_a_print_is_turned_where_that_does(design):
    """A strip that lies askew."""
    turn = np.array([[np.cos(0.6), -np.sin(0.6)], [np.sin(0.6), np.cos(0.6)]])
    V, F = _strip()
    T = (V[F] + 0.1 * V[F].mean(1)[:, None])[:, :, :2]
    strip = native.Design("strip", design.parameters, V, F, T @ turn.T,
                          np.full((6, 2, 3), 1.5), np.zeros((0, 2), np.int32))
    model, found, printer = divided(strip, (95, 45))
    assert min(model.bbox[:2]) > 45 and len(found.places) == 1 and not found.seams and not found.left_out
    require_whole(model, found, printer)


def _strip():
    V = np.array([(7.0 * k, 12.0 * (k % 2), 0.0) for k in range(8)])
    return V, np.array([(k, k + 2, k + 1) if k % 2 == 0 else (k, k + 1, k + 2) for k in range(6)], np.int32)


def test_anchors_for_which_there_is_no_room_are_left_out(design):
    model, _, _ = divided(design, (200, 200))
    bed = [float(side) - 3 for side in model.bbox[:2]]
    model, found, printer = divided(design, bed)
    assert len(found.places) == 1 and not found.seams
    require_whole(model, found, printer)
    anchors = found.model.bodies("anchors")
    assert 0 < found.left_out == len(model.bodies("anchors")) - len(anchors)
    assert len(anchors) > 4 and found.model.volumes["support"] > 0
    # What the order counts is what goes on the bed.
    whole, printed = amounts([model]), amounts([found.bed(0)])
    share = len(anchors) / (len(anchors) + found.left_out)
    assert printed["bodies"] == whole["bodies"] - found.left_out
    tops = np.pi * design.parameters.get("anchor_radius") ** 2
    assert 0 < printed["anchor_volume_cm3"] <= share * whole["anchor_volume_cm3"] + 1e-6
    for side in ("front", "back"):
        assert printed["glue"][f"{side}_anchors_mm2"] == pytest.approx(len(anchors) * tops, rel=1e-6)
        assert printed["glue"][f"{side}_pins_mm2"] == pytest.approx(whole["glue"][f"{side}_pins_mm2"])
    assert printed["support_volume_cm3"] < whole["support_volume_cm3"]


@pytest.mark.parametrize("support", ["soluble", "breakaway"])
@pytest.mark.parametrize("orientation", ["front-up", "front-down"])
def test_parts_butt_in_a_frame(design, support, orientation):
    model, found, printer = divided(design, (52, 30), support=support, orientation=orientation)
    assert found.seams and len({part for bed in found.places for part in bed}) > 1
    require_whole(model, found, printer)
    assert found.position_error == pytest.approx(2 * beds.FIT + found.seams * 0.1)
    kit = SimpleNamespace(beds=found, model=model, title="cap", name="cap", say=ENGLISH)
    document = ezdxf.read(io.StringIO(drawing.dxf(maps.frame(kit)).decode("utf-8")))
    assert not document.audit().errors
    space = document.modelspace()
    parts = [np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="control"]')]
    pockets = [np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="cut"]')][1:]
    assert {text.dxf.text for text in space.query("TEXT")} == {
        f"{part + 1}" for bed in found.places for part in bed}
    if support == "breakaway":
        anchors = len(found.model.bodies("anchors"))
        assert len(parts) == model.tile_count + anchors and not pockets  # on a drawing
        return
    pocket, = pockets
    assert pocket.min() > 0
    assert all((part.min(0) > pocket.min(0)).all() and (part.max(0) < pocket.max(0)).all() for part in parts)
    for k, one in enumerate(parts):
        for other in parts[:k]:
            assert apart(one, other) >= 0.9 * 0.1 - 1e-4  # arcs are chords
    # The gaps between parts are all that is missing.
    lost = abs(area(pocket)) - sum(abs(area(part)) for part in parts)
    assert 0 < lost < 0.05 * abs(area(pocket))


def apart(one, other):
    a, b = one[:-1], one[1:]
    t = np.einsum("pnk,nk->pn", other[:, None] - a, b - a) / np.einsum("nk,nk->n", b - a, b - a)
    return np.linalg.norm(other[:, None] - a - t.clip(0, 1)[..., None] * (b - a), axis=2).min()


def area(line):
    (x, y), (u, v) = line[:-1].T, line[1:].T
    return 0.5 * np.sum(x * v - u * y)


def test_pieces_lie_side_by_side_on_as_few_beds(design):
    """Kit of a cap that is cut in two."""
    V, F = np.asarray(design.V), np.asarray(design.F)
    T = np.asarray(design.T)
    left = T.mean(1)[:, 0] < T.mean((0, 1))[0]
    edges = [{tuple(sorted((int(f[k]), int(f[(k + 1) % 3])))) for f in half for k in range(3)}
             for half in (F[left], F[~left])]
    cuts = sorted(edges[0] & edges[1])
    T = T + np.where(left, -35.0, 35.0)[:, None, None] * (1, 0)
    two = native.Design("two", design.parameters, V, F, T, design.q, np.array(cuts, np.int32))
    model, found, printer = divided(two, (66, 118))
    assert model.piece_count == 2 and len(found.places) == 1 and not found.seams
    require_whole(model, found, printer)
    model, found, printer = divided(two, (66, 60))
    assert len(found.places) == 2 and not found.seams


def test_parts_of_another_number_of_tiles_are_refused(design):
    for parts in ([0, 1], [-1] * 24, [24] * 24):
        with pytest.raises(Exception, match="parts of another number"):
            native.make_print_model(design, part_of_tile=parts)
    with pytest.raises(Exception, match="opening"):
        native.make_print_model(design, opening=float("nan"))
    with pytest.raises(Exception, match="region"):
        native.make_print_model(design, region=[(0, 0), (1, 0), (float("inf"), 1)])
    model = native.make_print_model(design)
    for places in ({}, {1: [0, 0, 0]}, {0: [float("nan"), 0, 0]}, {0: [0, 0, float("inf")]}):
        with pytest.raises(native.InvalidInput):
            model.only_pieces(places)


def test_every_bed_and_the_frame_are_in_the_kit(printed, tmp_path, monkeypatch):
    """Kit of a print on bridges, on an FDM printer whose bed is small."""
    small = {**kit_module.read_printer("fdm"), "bed_mm": [52, 30, 100]}
    monkeypatch.setattr(kit_module, "read_printer", lambda name: small)
    for name in ("small-cap-bed-07.3mf", "small-cap-bed-07.step"):  # of an earlier run
        (tmp_path / name).write_text("")
    design = native.read_design((printed.folder / "design.json").read_text("utf-8"))
    own = native.Parameters(design.parameters)
    own.set("support", "breakaway")
    own.set("run_verification", False)
    results = Project.of_design(design.with_parameters(own)).run(files.goals(), Job(), strict=True)
    order = files.Order(2, "{quantity}-{name}-{body}")
    assert not files.write_kit(results, tmp_path, Job(), order)
    found = json.loads((tmp_path / "kit.json").read_text("utf-8"))
    count = len(found["beds"]["beds"])
    assert count > 1 and found["beds"]["position_error_mm"] > 0
    endings = (".3mf", ".step", "-fused.stl", "-fused.3mf")
    assert {path.name for path in tmp_path.glob("*-bed-*")} == {
        f"2x-small-cap-bed-{k:02}{ending}" for k in range(1, count + 1) for ending in endings}
    for ending in ("print-fused.stl", "print-fused.3mf"):  # nothing that fits no bed
        assert not (tmp_path / f"2x-small-cap-{ending}").exists()
    _, mesh = freecad_session.load("Mesh")
    for number, bed in enumerate(found["beds"]["beds"], 1):
        shell = mesh.Mesh(str(tmp_path / f"2x-small-cap-bed-{number:02}-fused.stl"))
        assert shell.isSolid() and shell.countComponents() == len(bed["parts"])
        box = shell.BoundBox
        assert [box.XLength, box.YLength, box.ZLength] == pytest.approx(bed["bbox_mm"], abs=0.04)  # chords
    assert (tmp_path / "small-cap-frame.dxf").exists()
    # The order is of beds, and says what each holds.
    printed = read_text(tmp_path / "small-cap-shop.pdf")
    assert f"2x-small-cap-bed-01.3mf to 2x-small-cap-bed-{count:02}.3mf" in printed
    assert f"{count} builds" in printed
    assert "with fused in the name" in printed
    assert f"divided among {count} beds" in printed and "the print does not fit" not in printed
    for number, bed in enumerate(found["beds"]["beds"], 1):
        assert found["files"][f"2x-small-cap-bed-{number:02}.3mf"]["sha256"] in printed
        size = " × ".join(f"{x:.1f}" for x in bed["bbox_mm"])
        assert printed.count(size) > 1 and f"bed {number}: {size}" in printed  # in figures and picture
    bodies = sum(bed["bodies"] for bed in found["beds"]["beds"])
    assert bodies == found["print"]["bodies"]
    assert f"of {bodies} bodies each" in printed
    assert any(f"There are {bodies} bodies" in step["text"] for step in found["steps"])
    assert "ring over" in " ".join(step["text"] for step in found["steps"])
    lay, = (step["text"] for step in found["steps"] if step["title"] == "Lay the parts side by side")
    for number, bed in enumerate(found["beds"]["beds"], 1):
        assert f"from bed {number}: {', '.join(map(str, bed['parts']))}" in lay
    said = read_text(tmp_path / "small-cap-assembly.pdf")
    assert "Lay the parts side by side" in said and f"bed {count}:" in said


def read_text(path):
    """Text of a PDF."""
    said = subprocess.run(["pdftotext", path, "-"], check=True, capture_output=True, encoding="utf-8").stdout
    return " ".join(said.split())


@pytest.mark.parametrize("error", [native.TopologyError, native.SolverFailure])
def test_a_print_that_can_not_be_made_with_fewer_anchors_is_cut(design, monkeypatch, error):
    def make(design, *given, **named):
        if "region" in named:
            raise error("no slab can be cut so")
        return native.make_print_model(design, *given, **named)

    model = native.make_print_model(design)
    bed = [float(side) - 8 for side in model.bbox[:2]]
    names = {name: getattr(native, name) for name in ("Parameters", "TopologyError", "SolverFailure",
                                                      "pieces_of_faces", "Cancelled", "SUPPORT_MARGIN",
                                                      "ANCHOR_DISTANCE")}
    monkeypatch.setattr(beds, "native", SimpleNamespace(make_print_model=make, **names))
    found = beds.beds(design, model, {"bed_mm": [*bed, 100], "growth_mm": 0.05}, native.tile_shapes(design),
                      lambda *_: True)
    assert found.seams and not found.left_out
