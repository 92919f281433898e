# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups compare`: scans made from a design, turned, noisy, with outliers, a fifth missing."""

import json
from types import SimpleNamespace

import numpy as np
import pytest

from curveups.base.native import native
from curveups.kit.compare import PER_TILE, SAMPLED, predicted, read_scan
from shapes import obj_text

NOISE = 0.05  # mm


@pytest.fixture(scope="module")
def piece(printed, tmp_path_factory):
    """A design whose shape fixes how a scan of it is turned: the cap, bent."""
    data = json.loads((printed.folder / "design.json").read_text("utf-8"))
    V = np.array(data["V"])
    x, y = (V - V.mean(0))[:, :2].T
    V[:, 2] += 0.012 * x * x + 0.006 * x * y + 0.0003 * x ** 3 - 0.0002 * y ** 3
    F, T = np.array(data["F"]), np.array(data["T"])
    along, other = (V[F[:, k]] - V[F[:, 0]] for k in (1, 2))
    length = np.linalg.norm(along, axis=1)
    T[:, 1] = T[:, 0] + np.c_[length, 0 * length]
    area = np.linalg.norm(np.cross(along, other), axis=1)
    T[:, 2] = T[:, 0] + np.c_[(along * other).sum(1), area] / length[:, None]
    path = tmp_path_factory.mktemp("scan") / "bent.json"
    path.write_text(json.dumps({**data, "name": "bent", "V": V.tolist(), "T": T.tolist()}))
    return SimpleNamespace(path=path, V=V, F=F)


def sampled(V, F, count, seed):
    """Points spread over a surface, of which a fifth at one side is missing."""
    random, corners = np.random.default_rng(seed), V[F]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    corners = corners[random.choice(len(F), count, p=area / area.sum())]
    u = random.random((count, 2))
    u = np.where(u.sum(1, keepdims=True) > 1, 1 - u, u)
    points = corners[:, 0] + np.einsum("nk,nki->ni", u, corners[:, 1:] - corners[:, :1])
    return points[np.argsort(points @ random.normal(size=3))[: count * 4 // 5]]


def scanned(points, seed):
    """The same, noisy, with 2 % of outliers, turned and moved: and how."""
    random = np.random.default_rng(seed)
    noisy = points + random.normal(0, NOISE, points.shape)
    noisy[random.random(len(noisy)) < 0.02] += random.normal(0, 15, 3)
    R = np.linalg.qr(random.normal(size=(3, 3)))[0]
    R *= np.linalg.det(R)
    t = random.normal(0, 200, 3)
    return noisy @ R.T + t, points @ R.T + t


def write_points(path, points, names=None):
    lines = ("%.6f %.6f %.6f" % tuple(point) for point in points)
    path.write_text("".join(f"{name} {line}\n" if name else f"{line}\n"
                            for name, line in zip(names or [""] * len(points), lines)))


def compared(curveups, design, scan, folder):
    ran = curveups("compare", design, scan, "-o", folder)
    assert ran.status == 0, ran.err
    assert {"compare.json", "compare.html", "deviation.csv"} == {p.name for p in folder.iterdir()}
    return json.loads((folder / "compare.json").read_text("utf-8")), ran


@pytest.mark.parametrize("count", [20000, 300])
def test_a_scan_is_laid_onto_its_design(curveups, piece, tmp_path, count):
    clean = sampled(piece.V, piece.F, count, 1)
    scan, still = scanned(clean, 2)
    write_points(tmp_path / "scan.xyz", scan)
    found, _ = compared(curveups, piece.path, tmp_path / "scan.xyz", tmp_path / "out")
    move = np.array(found["transform"])
    back = still @ move[:3, :3].T + move[:3, 3]
    assert native.distances(back, piece.V, piece.F).max() < 0.05
    away = np.linalg.norm(back - clean, axis=1).max()
    assert found["turn_fixed"] and away < (0.05 if count > 1000 else 0.2)
    block = found["deviation"]
    assert block["p50_mm"] == pytest.approx(0.6745 * NOISE, rel=0.15)  # of the normal distribution
    assert block["max_mm"] > 1 and block["hausdorff_mm"] >= block["max_mm"]  # outliers are told
    assert found["points_given"] == len(clean) and 0.7 < found["covered"] < 0.99
    rows = np.loadtxt(tmp_path / "out" / "deviation.csv", delimiter=",", skiprows=1)
    assert np.median(abs(rows[:, 3])) == pytest.approx(block["p50_mm"], abs=1e-4)
    if count > 1000:
        medians = [one["median_mm"] for one in found["tiles"]]
        assert len(medians) > 15 and np.max(np.abs(medians)) < 0.03
    pose = found["pose"]
    assert pose["noise_mm"] == pytest.approx(NOISE, rel=0.2) and pose["loss_mm"] > 3 * NOISE
    assert away < 6 * max(pose["translation_sd_mm"]) + 1e-3


def test_a_piece_that_swelled_is_seen_at_its_tiles(curveups, piece, tmp_path):
    """By markers, which fix the turn of any shape: one tile stands out by half a millimetre."""
    corners = piece.V[piece.F]
    out = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    markers = corners.mean(1)
    markers[11] += 0.5 * out[11] / np.linalg.norm(out[11])
    turn = np.linalg.qr(np.random.default_rng(5).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    names = [f"T{row + 1:05d}" for row in range(len(markers))]
    write_points(tmp_path / "markers.csv", markers @ turn.T + 7, names)
    found, _ = compared(curveups, piece.path, tmp_path / "markers.csv", tmp_path / "out")
    assert found["by"] == "markers" and found["turn_fixed"]
    values = {one["tile"]: one["median_mm"] for one in found["tiles"]}
    assert values.pop("T00012") == pytest.approx(0.5, abs=1e-3)
    assert max(map(abs, values.values())) < 1e-3


def test_what_settled_forces_predict_is_told_beside_a_scan(curveups, piece, tmp_path):
    """As long as the report is of this design."""
    points = piece.V[piece.F].mean(1)
    write_points(tmp_path / "markers.csv", points, [f"T{row + 1:05d}" for row in range(len(points))])
    report = {"settled": {"scan": {"mean_mm": 0.02, "max_mm": 0.07}, "open_contacts": [[3, 4]]}}
    beside = tmp_path / "d" / "design.json"
    beside.parent.mkdir()
    beside.write_bytes(piece.path.read_bytes())
    (beside.parent / "report.json").write_text(json.dumps(report))
    found, ran = compared(curveups, beside, tmp_path / "markers.csv", tmp_path / "out")
    assert found["predicted"]["open"] == [[3, 4]] and "T00004-T00005" in ran.out
    page = (tmp_path / "out" / "compare.html").read_text("utf-8")
    assert "Predicted by settled forces" in page and "0.07" in page
    (beside.parent / "report.json").write_text(json.dumps({**report, "print": {"files": {"design.json": 7}}}))
    assert not predicted(beside)
    sound = report["settled"]["scan"]
    for scan, pairs in (({"mean_mm": 0.02}, []), ({**sound, "max_mm": "far"}, []), (sound, [3]),
                        ({**sound, "max_mm": float("nan")}, []), (sound, [[float("inf"), 1]])):
        (beside.parent / "report.json").write_text(json.dumps(
            {"settled": {"scan": scan, "open_contacts": pairs}}))
        assert not predicted(beside)


def test_a_mesh_is_a_scan(curveups, piece, tmp_path):
    V, F = piece.V, piece.F
    for _ in range(3):
        middles = [(V[F[:, a]] + V[F[:, b]]) / 2 for a, b in ((0, 1), (1, 2), (2, 0))]
        m = len(V) + np.arange(3 * len(F)).reshape(3, -1)
        V, F = np.vstack([V, *middles]), np.vstack([
            np.c_[F[:, 0], m[0], m[2]], np.c_[m[0], F[:, 1], m[1]], np.c_[m[2], m[1], F[:, 2]], m.T])
    scan, still = scanned(V, 5)
    (tmp_path / "scan.obj").write_text(obj_text(scan, F))
    found, _ = compared(curveups, piece.path, tmp_path / "scan.obj", tmp_path / "out")
    move = np.array(found["transform"])
    assert native.distances(still @ move[:3, :3].T + move[:3, 3], piece.V, piece.F).max() < 0.05


def test_a_coarse_mesh_covers_all_tiles(piece, tmp_path):
    """Whose corners alone would touch few of them."""
    (tmp_path / "scan.obj").write_text(obj_text(np.asarray(piece.V), np.asarray(piece.F)))
    points = read_scan(tmp_path / "scan.obj", len(piece.F)).points
    assert native.distances(points, piece.V, piece.F).max() < 1e-6
    owners = native.closest_points(points[len(piece.V):], piece.V, piece.F)[1]
    counts = np.bincount(owners, minlength=len(piece.F))
    assert (counts >= PER_TILE).all() and counts.max() < 3 * SAMPLED


def test_a_symmetric_shape_leaves_the_turn_open(curveups, printed, tmp_path):
    design = native.read_design((printed.folder / "design.json").read_text("utf-8"))
    scan, still = scanned(sampled(np.asarray(design.V), np.asarray(design.F), 3000, 3), 4)
    write_points(tmp_path / "scan.xyz", scan)
    found, ran = compared(curveups, printed.folder / "design.json", tmp_path / "scan.xyz", tmp_path / "out")
    move = np.array(found["transform"])
    assert native.distances(still @ move[:3, :3].T + move[:3, 3], design.V, design.F).max() < 0.05
    assert found["other_turns"] >= 1 and not found["turn_fixed"] and "tiles" not in found
    assert "does not fix how the scan is turned" in ran.out


@pytest.mark.parametrize("text, said", [
    ("1 2 3\n", "1 points can't be laid"), ("".join(f"{k} {k} {k}\n" for k in range(20)), "not on a line"),
    ("1 2 x\n", "line 1"), ("1 2 nan\n", "line 1"), ("T99999 1 2 3\n", "line 1"),
    ("T00001 0 0 0\n1 2 3\n" * 8, "others have none")])
def test_what_is_no_scan_is_refused(curveups, piece, tmp_path, text, said):
    (tmp_path / "scan.xyz").write_text(text)
    ran = curveups("compare", piece.path, tmp_path / "scan.xyz", "-o", tmp_path / "out")
    assert ran.status == 2 and said in ran.err and not (tmp_path / "out").exists()
    ran = curveups("compare", piece.path, tmp_path / "none.stl", "-o", tmp_path / "out")
    assert ran.status == 2 and "the scan can't be read" in ran.err and "none.stl" in ran.err
    assert "built-in" not in ran.err
