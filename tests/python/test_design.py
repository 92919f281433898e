# SPDX-License-Identifier: LGPL-2.1-or-later
"""`curveups design`: files, formats, statuses, small and odd targets, determinism."""

import json
import math
import re
import zipfile

import numpy as np
import pytest
from running import ROOT, dome
from schema import FILES, check_design, check_report


def test_design_without_solids(designed):
    assert designed.ran.status == 0, designed.ran.err
    assert {p.name for p in designed.folder.iterdir()} == {"design.json", "report.json", "report.html"}
    design, report = designed.json("design.json"), designed.json("report.json")
    check_design(design)
    check_report(report)
    assert report["tiles"] == len(design["F"]) == 24
    assert report["name"] == "small-cap"  # safe for files
    assert report["title"] == design["name"] == "small cap"
    assert designed.ran.out == ""
    assert report["valid"] is True and report["reasons"] == []
    # --no-remesh: the mesh as it was, L its own mean edge length.
    assert np.array(design["F"]).max() == 18
    V, F = np.array(design["V"]), np.array(design["F"])
    edges = {tuple(sorted((f[t], f[(t + 1) % 3]))) for f in F.tolist() for t in range(3)}
    mean = np.mean([np.linalg.norm(V[a] - V[b]) for a, b in edges])
    assert math.isclose(design["parameters"]["L"], mean, rel_tol=1e-12)


def test_all_files_and_sizes(printed):
    assert printed.ran.status == 0, printed.ran.err
    expected = {name.replace("NAME", "small-cap") for name in FILES}
    assert {p.name for p in printed.folder.iterdir()} == expected
    report = printed.json("report.json")
    check_report(report)
    sizes = {p.name: p.stat().st_size for p in printed.folder.iterdir()}
    assert report["print"]["files"] == {n: s for n, s in sizes.items() if n != "report.json"}
    assert report["solids"]["tiles"] == 24 and report["solids"]["invalid"] == 0


def test_quiet_says_nothing(curveups, cap, tmp_path):
    ran = curveups("design", cap, "-o", tmp_path, "--no-remesh", "--no-solids", "--quiet")
    assert ran.err == "" and ran.out == ""


def test_progress_lines_are_plain_off_a_terminal(designed):
    assert "\r" not in designed.ran.err and "\033" not in designed.ran.err
    assert "curveups: layout" in designed.ran.err


def test_built_in_without_freecad(curveups_process, tmp_path):
    ran = curveups_process("design", "disc", "-o", tmp_path / "o", "--no-solids", "--set", "L=12",
                           CURVEUPS_FREECAD_LIB="/nowhere")
    assert ran.status == 0, ran.err
    report = json.loads((tmp_path / "o" / "report.json").read_text("utf-8"))
    assert abs(report["target"]["mean_edge_mm"] / 12 - 1) <= 0.03
    assert report["target"]["edge_cv"] <= 0.12


def alike(report):
    """A report without what may differ between runs: seconds, memory and software."""
    report = {name: value for name, value in report.items()
              if name not in ("peak_memory_mb", "software")}
    report["stages"] = [{**stage, "seconds": None} for stage in report["stages"]]
    return report


def test_same_bytes_with_one_and_two_threads(curveups_process, tmp_path):
    for threads in ("1", "2"):
        ran = curveups_process("design", "saddle", "-o", tmp_path / threads, "--set", "L=14",
                               CURVEUPS_THREADS=threads)
        assert ran.status == 0, ran.err

    def read(threads, name):
        return (tmp_path / threads / name).read_bytes()

    reports = [alike(json.loads(read(threads, "report.json"))) for threads in ("1", "2")]
    for report in reports:  # FreeCAD dates its documents
        report["print"]["files"].pop("saddle.FCStd")
    assert reports[0]["unilateral"]["feasible_at_bump_tips"] is True
    assert reports[0] == reports[1]
    for name in sorted(path.name for path in (tmp_path / "1").iterdir()):
        if name not in ("report.json", "saddle.FCStd"):
            assert read("1", name) == read("2", name), name


@pytest.mark.parametrize("name, text, tiles", [
    ("one.obj", "v 0 0 0\nv 12 0 0\nv 5 11 0\nf 1 2 3\n", 1),
    ("two.obj", "v 0 0 0\nv 12 0 0\nv 5 11 0\nv 6 -10 -2\nf 1 2 3\nf 2 1 4\n", 2),
    # OBJ's negative numbers count back from the last vertex: the second dome names its own.
    ("two-pieces.obj", dome(1) + re.sub(
        r"(?m)^f .*$", lambda m: "f " + " ".join(str(int(i) - 8) for i in m[0].split()[1:]),
        re.sub(r"(?m)^v (\S+)", lambda m: f"v {float(m[1]) + 60!r}", dome(1))), 12),
])
def test_small_targets(curveups, tmp_path, name, text, tiles):
    (tmp_path / name).write_text(text)
    ran = curveups("design", tmp_path / name, "-o", tmp_path / "out", "--no-remesh")
    assert ran.status == 0, ran.err
    report = json.loads((tmp_path / "out" / "report.json").read_text("utf-8"))
    assert report["tiles"] == tiles
    assert report["constraints"]["overlaps"] == 0
    assert report["solids"]["invalid"] == 0
    check_report(report)


def test_supports_that_run_into_one_another_are_named(curveups, tmp_path):
    """Domes apart as the layout sets them; slabs around wider anchors would need more room."""
    second = re.sub(r"(?m)^v (\S+)", lambda m: f"v {float(m[1]) + 60!r}", dome(1))
    second = re.sub(r"(?m)^f .*$", lambda m: "f " + " ".join(
        str(int(i) + 7) for i in m[0].split()[1:]), second)
    (tmp_path / "two.obj").write_text(dome(1) + second)
    ran = curveups("design", tmp_path / "two.obj", "-o", tmp_path / "out", "--no-remesh", "--no-solids",
                   "--set", "run_verification=off")
    assert ran.status == 0, ran.err
    ran = curveups("export", tmp_path / "out" / "design.json", "-o", tmp_path / "wide", "--set",
                   "anchor_radius=25")
    assert ran.status == 2 and not (tmp_path / "wide").exists(), ran.err
    found = re.search(r"support of piece (\d) runs into piece (\d) \(.*, T(\d+), T(\d+)\)",
                      ran.error_lines[0])
    assert found, ran.err
    pieces, tiles = found.groups()[:2], [int(number) for number in found.groups()[2:]]
    # Six tiles a dome: each piece's own, in the order in which the pieces are named.
    first = {"1": range(1, 7), "2": range(7, 13)}
    assert set(pieces) == {"1", "2"} and all(t in first[p] for t, p in zip(tiles, pieces))


def test_prints_that_cannot_be_made_leave_the_design(curveups, cap, tmp_path):
    out = tmp_path / "out"
    ran = curveups("design", cap, "-o", out, "--no-remesh", "--set", "support=breakaway", "H_body=0.6",
                   "run_verification=off")
    assert ran.status == 1, ran.err
    report = json.loads((out / "report.json").read_text("utf-8"))
    check_report(report)
    assert report["valid"] is False and report["status"] == "complete"
    assert ["too thin for breakaway bridges" in reason for reason in report["reasons"]] == [True]
    assert {path.name for path in out.iterdir()} == {"design.json", "report.json", "report.html"}
    # The design itself is sound: with another support it is exported.
    ran = curveups("export", out / "design.json", "-o", tmp_path / "again", "--set", "support=breakaway")
    assert ran.status == 2 and "bridges" in ran.error_lines[0] and not (tmp_path / "again").exists()
    ran = curveups("export", out / "design.json", "-o", tmp_path / "again", "--set", "support=soluble")
    assert ran.status == 0, ran.err


def test_scale_and_flip(curveups, tmp_path):
    metres = re.sub(r"(?m)^v (\S+) (\S+) (\S+)",
                    lambda m: "v " + " ".join(repr(float(x) / 1000) for x in m.groups()), dome(2))
    (tmp_path / "m.obj").write_text(metres)
    ran = curveups("design", tmp_path / "m.obj", "-o", tmp_path / "o", "--no-remesh", "--no-solids",
                   "--set", "scale=1000", "--set", "flip=on")
    assert ran.status == 0, ran.err
    design = json.loads((tmp_path / "o" / "design.json").read_text("utf-8"))
    V, F = np.array(design["V"]), np.array(design["F"])
    assert np.allclose(np.linalg.norm(V, axis=1), 40, atol=1e-9)
    a, b, c = V[F[:, 0]], V[F[:, 1]], V[F[:, 2]]
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), a) < 0).all()  # inwards


def test_cuts_by_edges_and_by_polyline(curveups, cap, tmp_path):
    # Vertices of the dome: 0 the top, 1 the first of ring 1, 7 of ring 2 straight behind it.
    for name, cuts in {"edges": {"edges": [[0, 1], [7, 1]]},
                       "lines": {"polylines": [[[0, 0, 40], [40 * math.sin(0.4), 0, 40 * math.cos(0.4)]]]}
                       }.items():
        (tmp_path / f"{name}.json").write_text(json.dumps(cuts))
        ran = curveups("design", cap, "-o", tmp_path / name, "--no-remesh", "--no-solids",
                       "--cuts", tmp_path / f"{name}.json")
        assert ran.status == 0, ran.err
        design = json.loads((tmp_path / name / "design.json").read_text("utf-8"))
        report = json.loads((tmp_path / name / "report.json").read_text("utf-8"))
        assert design["cuts"] == [[0, 1], [1, 7]]
        assert report["cuts"] == 2 and report["contacts"] == 24 * 3 // 2 - 12 // 2 - 2


def test_config_and_set(curveups, cap, tmp_path):
    (tmp_path / "c.json").write_text('{"H_body": 2.5, "d_gap_min": 0.7, "anchors": false}')
    ran = curveups("design", cap, "-o", tmp_path / "o", "--no-remesh", "--no-solids", "--config",
                   tmp_path / "c.json", "--set", "H_body=2", "--set", "run_verification=off")
    assert ran.status == 0, ran.err
    parameters = json.loads((tmp_path / "o" / "design.json").read_text("utf-8"))["parameters"]
    assert (parameters["H_body"], parameters["d_gap_min"]) == (2, 0.7)
    assert parameters["anchors"] is False
    assert parameters["run_verification"] is False and parameters["run_repair"] is False
    report = json.loads((tmp_path / "o" / "report.json").read_text("utf-8"))
    assert report["valid"] is None and report["reasons"] == ["verification was off"]
    assert "physics" not in report


def test_materials_are_configurations(curveups, cap, tmp_path):
    material, other = ROOT / "resources" / "materials" / "latex-0.25.json", tmp_path / "tiles.json"
    other.write_text('{"H_body": 2.5}')
    ran = curveups("design", cap, "-o", tmp_path / "out", "--no-remesh", "--no-solids", "--config", material,
                   "--config", other, "--set", "run_verification=off")
    assert ran.status == 0, ran.err
    used = json.loads((tmp_path / "out" / "design.json").read_text("utf-8"))["parameters"]
    given = json.loads(material.read_text("utf-8"))
    assert given.pop("about") and given.pop("kind") and given.pop("sources")
    assert {name: used[name] for name in given} == given and used["H_body"] == 2.5


def test_remesh_writes_the_numbers_that_cuts_refer_to(curveups, tmp_path):
    ran = curveups("remesh", "half-sphere", "-o", tmp_path, "--set", "L=12")
    assert ran.status == 0, ran.err
    assert [p.name for p in tmp_path.iterdir()] == ["half-sphere-remeshed.obj"]
    lines = (tmp_path / "half-sphere-remeshed.obj").read_text("utf-8").splitlines()
    V = np.array([[float(x) for x in line.split()[1:]] for line in lines if line.startswith("v ")])
    assert np.abs(np.linalg.norm(V, axis=1) - 48).max() <= 0.005 * 12
    ran = curveups("design", "half-sphere", "-o", tmp_path / "d", "--no-solids", "--set", "L=12")
    design = json.loads((tmp_path / "d" / "design.json").read_text("utf-8"))
    assert design["V"] == V.tolist()


def test_verify_and_export_from_a_design_file(curveups, printed, tmp_path):
    design = printed.folder / "design.json"
    ran = curveups("export", design, "-o", tmp_path / "same")
    assert ran.status == 0, ran.err
    names = {name.replace("NAME", "small-cap") for name in FILES}
    assert {p.name for p in (tmp_path / "same").iterdir()} == names
    stl = "small-cap-tiles.stl"
    assert (tmp_path / "same" / stl).read_bytes() == (printed.folder / stl).read_bytes()
    ran = curveups("verify", design, "-o", tmp_path / "verified")
    assert ran.status == 0, ran.err
    verified = json.loads((tmp_path / "verified" / "report.json").read_text("utf-8"))
    for block in ("physics", "contact_forces", "unilateral"):  # at the bumps' tips too
        assert verified[block] == printed.json("report.json")[block]
    assert verified["unilateral"]["feasible_at_bump_tips"] is True


def test_the_3mf_names_bodies_and_materials(printed):
    report = printed.json("report.json")
    with zipfile.ZipFile(printed.folder / "small-cap-print.3mf") as archive:
        text = archive.read("3D/3dmodel.model").decode()
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
    names = re.findall(r'<object [^>]*name="([^"]*)"', text)
    assert [n for n in names if n.startswith("T")] == [f"T{i:05d}" for i in range(1, 25)]
    # One build item a piece, the assembly of all bodies: slicers move build items, not components.
    assert names[-1] == "small cap" and len(names) == report["print"]["bodies"] + 1
    assert text.count("<item ") == report["print"]["pieces"] == 1
    assert text.count("<component ") == report["print"]["bodies"]
    colours = re.findall(r'<base name="([^"]*)" displaycolor="#([0-9A-F]{8})"', text)
    assert [name for name, _ in colours] == ["tiles (rigid)", "support (soluble)", "anchors (rigid)"]
    assert all(colour.endswith("FF") for _, colour in colours)
    used = re.findall(r'<object [^>]*name="([A-Z][a-z]*)[^"]*"[^>]* pindex="(\d)"', text)
    assert {(name, colours[int(k)][0]) for name, k in used} == {
        ("T", "tiles (rigid)"), ("Support", "support (soluble)"), ("Anchor", "anchors (rigid)")}
    assert len(used) == report["print"]["bodies"]
