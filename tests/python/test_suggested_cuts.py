# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups design --auto-cuts`: closed, deep and handled targets, and what reports suggest."""

import json
import re

import numpy as np
import pytest
from running import dome
from schema import check_design, check_report
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from shapes import obj_text, ring, sphere, vase

FAST = ("--no-solids", "--set", "L=14", "--set", "run_verification=off")


@pytest.fixture(scope="module")
def shapes_folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("shapes")
    for name, surface in (("sphere", sphere(30, 4)), ("ring", ring(40, 18, 5)), ("vase", vase(5))):
        (folder / f"{name}.obj").write_text(obj_text(*surface))
    return folder


def run(curveups, shapes_folder, out, name, *more, status=0):
    ran = curveups("design", shapes_folder / f"{name}.obj", "-o", out, *more)
    assert ran.status == status, ran.err
    design = json.loads((out / "design.json").read_text("utf-8"))
    report = json.loads((out / "report.json").read_text("utf-8"))
    check_design(design)
    check_report(report)
    return ran, design, report


def euler(design):
    """Vertices, edges and faces of the surface opened along its cuts: 1 for a disc."""
    F, cuts = np.array(design["F"]), {tuple(sorted(edge)) for edge in design["cuts"]}
    sides, joined, edges = {}, [], 0  # corners of faces at the ends of each edge; corners that are one vertex
    for corner, face in zip(range(0, F.size, 3), F.tolist()):
        for t, u in ((0, 1), (1, 2), (2, 0)):
            sides.setdefault(tuple(sorted((face[t], face[u]))), []).append((corner + t, corner + u))
    for edge, ends in sides.items():
        apart = len(ends) == 1 or edge in cuts
        edges += len(ends) if apart else 1
        if not apart:
            (a, b), (c, d) = ends
            joined += [(a, d), (b, c)]
    graph = coo_matrix((np.ones(len(joined)), np.transpose(joined)), shape=(F.size, F.size))
    return connected_components(graph, directed=False)[0] - edges + len(F)


def test_a_closed_sphere_without_cuts_names_the_remedy(curveups, shapes_folder, tmp_path):
    ran = curveups("design", shapes_folder / "sphere.obj", "-o", tmp_path / "out", *FAST)
    assert ran.status == 2
    assert len(ran.error_lines) == 1 and "--auto-cuts 1" in ran.error_lines[0]
    assert not (tmp_path / "out").exists()


def test_a_closed_sphere_is_opened_and_relieved(curveups, shapes_folder, tmp_path):
    _, one, report = run(curveups, shapes_folder, tmp_path / "1", "sphere", *FAST, "--auto-cuts", "1")
    assert euler(one) == 1
    made = report["suggested_cuts"]
    assert made[0]["applied"] and made[0]["predicted"]["before"] is None
    assert {tuple(sorted(e)) for e in made[0]["edges"]} == {tuple(sorted(e)) for e in one["cuts"]}
    assert "cuts" in [stage["name"] for stage in report["stages"]]

    _, more, relieved = run(curveups, shapes_folder, tmp_path / "4", "sphere", *FAST,
                            "--auto-cuts", "4")
    assert euler(more) == 1
    applied = [cut for cut in relieved["suggested_cuts"] if cut["applied"]]
    assert 2 <= len(applied) <= 4
    assert sum(len(cut["edges"]) for cut in applied) == len(more["cuts"])
    for before, after in zip(applied, applied[1:]):
        assert after["predicted"]["before"] == before["predicted"]["after"]
    # The same first cut, and a layout that is less stretched: as predicted, and as solved.
    assert applied[0]["edges"] == made[0]["edges"]
    assert relieved["layout"]["stretch"]["energy_per_contact"] < (
        0.7 * report["layout"]["stretch"]["energy_per_contact"])
    assert relieved["area"]["ratio"] < report["area"]["ratio"]


def test_a_ring_has_its_handle_cut(curveups, shapes_folder, tmp_path):
    _, design, report = run(curveups, shapes_folder, tmp_path / "o", "ring", *FAST, "--auto-cuts", "2")
    assert euler(design) in (0, 1)  # a hole may stay
    assert report["layout"]["converged"]


def test_cuts_are_the_same_with_one_and_two_threads(curveups_process, shapes_folder, tmp_path):
    for threads in ("1", "2"):
        ran = curveups_process("design", shapes_folder / "sphere.obj", "-o", tmp_path / threads, *FAST,
                               "--auto-cuts", "2", CURVEUPS_THREADS=threads)
        assert ran.status == 0, ran.err
    for name in ("design.json", "report.html"):
        assert (tmp_path / "1" / name).read_bytes() == (tmp_path / "2" / name).read_bytes()


def test_a_deep_vase_gets_suggestions_that_can_be_given_back(curveups, shapes_folder, tmp_path):
    ran, design, report = run(curveups, shapes_folder, tmp_path / "o", "vase", *FAST, status=1)
    assert design["cuts"] == []
    proposed = report["suggested_cuts"]
    assert 1 <= len(proposed) <= 2 and not any(cut["applied"] for cut in proposed)
    assert any(warning.get("kind") == "stretched" for warning in report["warnings"])
    assert "--auto-cuts" in ran.err and "vase-cuts.json" in ran.err
    page = (tmp_path / "o" / "report.html").read_text(encoding="utf-8")
    assert "Suggested cuts" in page
    # The file that was written, and --auto-cuts with as many: one and the same design.
    _, given, _ = run(curveups, shapes_folder, tmp_path / "given", "vase", *FAST, "--cuts",
                      tmp_path / "o" / "vase-cuts.json")
    _, auto, relieved = run(curveups, shapes_folder, tmp_path / "auto", "vase", *FAST, "--auto-cuts",
                            len(proposed))
    key = [sorted(tuple(sorted(e)) for e in d["cuts"]) for d in (given, auto)]
    assert key[0] == key[1]
    assert euler(auto) == 1
    after = proposed[-1]["predicted"]["after"]
    assert abs(relieved["layout"]["stretch"]["area_ratio"] / after["area_ratio"] - 1) < 0.1
    assert relieved["layout"]["stretch"]["slack_springs"] < report["layout"]["stretch"]["slack_springs"]


def test_a_design_that_fails_verification_says_what_may_help(curveups, shapes_folder, tmp_path):
    ran, design, report = run(curveups, shapes_folder, tmp_path, "sphere", "--no-solids", "--set", "L=12",
                              "--set", "run_repair=off", "--auto-cuts", "1", status=1)
    assert report["valid"] is False
    applied = [cut["applied"] for cut in report["suggested_cuts"]]
    assert applied == sorted(applied, reverse=True) and applied[0] and not applied[-1]
    suggested = [reason for reason in report["reasons"] if reason.startswith("suggested: ")]
    assert len(suggested) >= applied.count(False)
    assert sum("a cut of " in reason for reason in suggested) == applied.count(False)
    edges = json.loads((tmp_path / "sphere-cuts.json").read_text("utf-8"))["edges"]
    assert len(edges) == sum(len(cut["edges"]) for cut in report["suggested_cuts"])


def test_given_and_suggested_cuts_add_up(curveups, shapes_folder, tmp_path):
    _, design, _ = run(curveups, shapes_folder, tmp_path / "first", "sphere", *FAST, "--auto-cuts", "1")
    (tmp_path / "cuts.json").write_text(json.dumps({"edges": design["cuts"]}))
    _, both, report = run(curveups, shapes_folder, tmp_path / "both", "sphere", *FAST, "--auto-cuts", "1",
                          "--cuts", tmp_path / "cuts.json")
    given, all_cuts = ({tuple(sorted(e)) for e in d["cuts"]} for d in (design, both))
    assert given < all_cuts
    assert report["suggested_cuts"][0]["predicted"]["before"] is not None
    assert euler(both) == 1


def test_a_sound_target_is_left_alone(curveups, cap, designed, tmp_path):
    assert "suggested_cuts" not in designed.json("report.json")
    assert not list(designed.folder.glob("*-cuts.json"))
    ran = curveups("design", cap, "-o", tmp_path, "--no-remesh", "--no-solids", "--auto-cuts", "0")
    assert ran.status == designed.ran.status
    assert (tmp_path / "design.json").read_bytes() == (designed.folder / "design.json").read_bytes()


@pytest.mark.parametrize("text", ["-1", "two", "1.5", "101", ""])
def test_a_number_of_cuts_that_is_none(curveups, tmp_path, text):
    (tmp_path / "t.obj").write_text(dome(1))
    ran = curveups("design", tmp_path / "t.obj", "-o", tmp_path / "out", f"--auto-cuts={text}")
    assert ran.status == 2 and len(ran.error_lines) == 1 and "--auto-cuts" in ran.error_lines[0]
    assert not (tmp_path / "out").exists()


def test_a_cut_whose_sides_lie_on_one_another_is_no_cut(curveups, tmp_path):
    """A saddle has more than the full angle around each point: along such a cut its layout interlocks, and no
    single sheet can be slit so, whatever the forces say. It is not suggested either."""
    cut = [[[12.4, 43.5, 4.3], [24.1, 37.9, 0.2], [34.3, 29.1, -0.6], [41.3, 17.9, -1.5],
            [44.7, 5.2, -2.2]]]
    (tmp_path / "cut.json").write_text(json.dumps({"polylines": cut}))
    given = ("hyperboloid", "--no-solids", "--set", "L=12", "settle=off")
    ran = curveups("design", *given, "-o", tmp_path / "cut", "--cuts", tmp_path / "cut.json")
    assert ran.status == 1, ran.err
    report = json.loads((tmp_path / "cut" / "report.json").read_text("utf-8"))
    reason, = (reason for reason in report["reasons"] if "lie on itself" in reason)
    assert len(re.findall("T[0-9]{5}", reason)) >= 2 and report["cuts"] == 4
    ran = curveups("design", *given, "-o", tmp_path / "asked", "--auto-cuts", "2")
    assert ran.status == 0, ran.err
