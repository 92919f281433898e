# SPDX-License-Identifier: LGPL-2.1-or-later
"""`pieces`: targets that no single layout can do, in pieces side by side."""

import json
import zipfile

import numpy as np
import pytest
from curveups.base.errors import CurveUpsError
from curveups.base.findings import Finding
from curveups.base.native import native
from curveups.stages import pieces as pieces_stage
from curveups.stages.cut_request import CutRequest
from curveups.stages.division import all_cuts
from curveups.stages.stage import Inputs, Job
from curveups.stages.verification import Verification
from made import project
from schema import read_run
from shapes import obj_text, ring, sphere

NO_CUTS = np.zeros((0, 2), np.int32)


@pytest.fixture(scope="module")
def shapes_folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("shapes")
    for name, surface in (("ball", sphere(25, 3)), ("ring", ring(34, 14, 3))):
        (folder / f"{name}.obj").write_text(obj_text(*surface))
    return folder


@pytest.fixture(scope="module")
def ball(curveups, shapes_folder, tmp_path_factory):
    """A closed ball from one command, with all its files."""
    out = tmp_path_factory.mktemp("ball")
    ran = curveups("design", shapes_folder / "ball.obj", "-o", out, "--set", "pieces=auto")
    assert ran.status == 0, ran.err
    return out


def pieces_of(design):
    return native.pieces_of_faces(np.array(design["V"], float), np.array(design["F"], np.int32),
                                  np.array(design["cuts"], np.int32).reshape(-1, 2))


def divided(V, F, cuts=CutRequest(), **values):
    """The target and its Division."""
    results = project(V, F, cuts, **values).run(("division",))
    return results["target"], results["division"]


def test_a_ball_is_valid_in_two_pieces(ball):
    design, report = read_run(ball)
    assert report["valid"] is True
    piece = pieces_of(design)
    sizes = np.bincount(piece)
    assert len(sizes) == 2 and sizes.min() > 0.9 * sizes.max()
    said = report["pieces"]
    assert [one["piece"] for one in said] == [1, 2]
    assert [one["tiles"] for one in said] == sizes.tolist()
    assert [one["first_tile"] for one in said] == [int(np.argmax(piece == k)) for k in range(2)]
    assert sum(one["contacts"] for one in said) == report["contacts"]
    assert sum(one["actuated_cm2"] for one in said) == pytest.approx(report["area"]["actuated_cm2"])
    for one in said:
        assert one["valid"] is True and one["reasons"] == []
        assert one["normal_min"] >= one["f_min"] > 0
    assert min(one["normal_min"] for one in said) == report["contact_forces"]["normal_min"]
    assert "pieces" in [stage["name"] for stage in report["stages"]]
    assert "<h2>Pieces</h2>" in (ball / "report.html").read_text(encoding="utf-8")


def test_pieces_lie_side_by_side(ball):
    design, report = read_run(ball)
    piece, T = pieces_of(design), np.array(design["T"])
    boxes = [(T[piece == k].min((0, 1)), T[piece == k].max((0, 1))) for k in range(2)]
    (low, high), (other_low, other_high) = boxes
    assert ((high < other_low) | (other_high < low)).any()
    assert report["constraints"]["overlaps"] == 0


def test_each_piece_is_printed_and_anchored_by_itself(ball):
    _, report = read_run(ball)
    assert report["print"]["pieces"] == 2
    with zipfile.ZipFile(ball / "ball-print.3mf") as archive:
        model = archive.read("3D/3dmodel.model").decode("utf-8")
    assert model.count("<item ") == 2


@pytest.mark.all
def test_a_torus_is_valid(curveups, shapes_folder, tmp_path):
    ran = curveups("design", shapes_folder / "ring.obj", "-o", tmp_path, "--no-solids", "--set",
                   "pieces=auto")
    assert ran.status == 0, ran.err
    design, report = read_run(tmp_path)
    assert report["valid"] is True and len(report["pieces"]) == len(set(pieces_of(design).tolist())) > 1


def test_the_number_is_kept_and_the_threads_do_not_matter(curveups, shapes_folder, tmp_path, monkeypatch):
    found = []
    for threads in ("1", "2"):
        monkeypatch.setenv("CURVEUPS_THREADS", threads)
        out = tmp_path / threads
        ran = curveups("design", shapes_folder / "ring.obj", "-o", out, "--no-solids", "--set", "pieces=5",
                       "L=10", "run_verification=off")
        assert ran.status == 0, ran.err
        found.append((out / "design.json").read_bytes())
    assert found[0] == found[1]
    assert pieces_of(json.loads(found[0])).max() == 4


def test_designs_reopen_with_their_pieces(curveups, shapes_folder, ball, tmp_path):
    """The borders of a design, given as its cuts, are the pieces that are asked for."""
    design, _ = read_run(ball)
    (tmp_path / "cuts.json").write_text(json.dumps({"edges": design["cuts"]}))
    ran = curveups("design", shapes_folder / "ball.obj", "-o", tmp_path / "out", "--no-solids", "--set",
                   "pieces=2", "run_verification=off", "--cuts", tmp_path / "cuts.json")
    assert ran.status == 0, ran.err
    again = json.loads((tmp_path / "out" / "design.json").read_text("utf-8"))
    assert again["cuts"] == design["cuts"]
    assert json.loads((ball / "design.json").read_text("utf-8"))["parameters"]["pieces"] == "auto"


def test_what_lies_flat_stays_in_one_piece():
    V, F = native.builtin_target("half-sphere", 0.05)
    for asked in ("1", "auto"):
        _, division = divided(V, F, pieces=asked)
        assert len(division.edges) == 0


def test_cuts_that_are_asked_for_stay_and_are_told_apart():
    V, F = sphere(25, 3)
    target, _ = divided(V, F)
    middle = np.argsort(np.linalg.norm(target.V - [25, 0, 0], axis=1))[0]
    face = next(face for face in target.F.tolist() if middle in face)
    asked = np.array([sorted(face[:2])], np.int32)
    target, division = divided(V, F, CutRequest(edges=asked), pieces=3)
    assert division.given.tolist() == asked.tolist()
    assert asked[0].tolist() in division.edges.tolist() and len(division.edges) > 20
    assert np.bincount(division.piece).size == 3


def test_auto_takes_the_fewest_that_are_not_stretched_too_far():
    """A ball with a small opening is stretched too far in one piece, halves of it are not."""
    V, F = sphere(40, 4)
    keep = V[F].mean(1)[:, 2] < 36  # a ball with a small opening
    F = F[keep]
    used, F = np.unique(F, return_inverse=True)
    V, F = V[used], F.reshape(-1, 3).astype(np.int32)
    target, division = divided(V, F, pieces="auto")
    assert np.bincount(division.piece).size == 2
    values = native.Parameters()
    values.set("pieces", "2")
    assert np.array_equal(all_cuts(CutRequest(), target.V, target.F, values, Job()), division.edges)


def test_a_piece_is_judged_by_its_own_mean_force():
    """Two pairs of tiles, apart: one pushes a hundred times more."""
    V = np.array([[0, 0, 0], [7, 0, 0], [3, 6, 0], [10, 6, 0]], float)
    V = np.vstack([V, V + [40, 0, 0]])
    F = np.array([[0, 1, 2], [1, 3, 2], [4, 5, 6], [5, 7, 6]], np.int32)
    parameters = native.Parameters()
    T = V[F][:, :, :2].copy()
    design = native.Design("pair", parameters, V, F, T, np.ones((4, 2, 3)), NO_CUTS)
    found = Verification(
        valid=True, blocks={"contact_forces": {"f_min": 0.05}}, design=design,
        arrays={"contact_tiles": np.array([[0, 1], [2, 3]]), "contact_normal_mean": np.array([10.0, 0.1]),
                "contact_normal_min": np.array([0.5, 0.06])})

    class Sound:
        def reasons(self):
            return (Finding.about("gap", [2, 3], violation=0.1, pairs=((2, 3),)),)

    def judged(**values):
        for name, value in values.items():
            parameters.set(name, value)
        results = {"design": type("Made", (), {"design": design}), "figures": Sound(), "verification": found}
        return pieces_stage.STAGE.run(Inputs(parameters, results), Job())

    made = judged()
    assert made.reasons() == () and [piece["valid"] for piece in made.block] == [True, False]
    made = judged(pieces="2")
    assert len(made.reasons()) == 1 and "piece 1 by itself" in str(made.reasons()[0])
    assert "T00001-T00002" in str(made.reasons()[0]) and made.reasons()[0].tiles == (0, 1)
    first, second = made.report()["pieces"]
    assert first["valid"] is False and first["f_min"] == pytest.approx(1.0)
    assert second["contacts"] == 1
    assert second["reasons"] == ["flat tiles are 0.1 mm nearer than d_gap_min (T00003-T00004)"]


def test_a_piece_is_not_valid_where_a_sentence_names_only_tiles_of_others():
    """Sentences are cut short after some tiles: what a reason is about does not depend on that."""
    pairs = tuple((tile, tile + 1) for tile in range(0, 40, 2))
    reason = Finding.about("weak_points", np.ravel(pairs), points=20, f_min=0.1, contacts=pairs, least=0.0,
                           weakest=((0, 1),))
    assert "T00039" not in str(reason) and "and 12 more" in str(reason)
    assert reason.concerns([38]) and not reason.concerns([40]) and Finding("no_pressure").concerns([40])


@pytest.mark.parametrize("value", ["0", "25", "two", "-1", "1.5", "02", "auto,2"])
def test_other_values_are_refused(curveups, shapes_folder, tmp_path, value):
    ran = curveups("design", shapes_folder / "ball.obj", "-o", tmp_path / "out", "--set", f"pieces={value}")
    assert ran.status == 2 and len(ran.error_lines) == 1
    assert "pieces" in ran.error_lines[0] and "auto" in ran.error_lines[0]
    assert not (tmp_path / "out").exists()


def test_a_number_is_a_number_in_a_file_too(curveups, shapes_folder, tmp_path):
    (tmp_path / "set.json").write_text('{"pieces": 24, "L": 14}')
    ran = curveups("design", shapes_folder / "ball.obj", "-o", tmp_path / "out", "--config",
                   tmp_path / "set.json")
    assert ran.status == 2 and "too few for 24 pieces" in ran.error_lines[0]


def test_a_closed_target_names_the_way_out():
    with pytest.raises(CurveUpsError) as caught:
        project(*sphere(25, 3), will_be_cut=False).run(("target",))
    assert "pieces=auto" in caught.value.remedy


def test_check_looks_at_the_pieces(curveups, shapes_folder):
    assert curveups("check", shapes_folder / "ball.obj", "--set", "pieces=2", "L=10").status == 0
    assert curveups("check", shapes_folder / "ball.obj", "--set", "L=10").status == 1
