# SPDX-License-Identifier: LGPL-2.1-or-later
"""`joint=holes`: pieces that can be sewn together after printing."""

import html
import json
import struct

import numpy as np
import pytest
from curveups.base import freecad_session
from curveups.base.native import native
from schema import read_run
from shapes import obj_text, sphere

SIZES = ("pieces=2", "L=8", "H_body=2", "run_verification=off")


@pytest.fixture(scope="module")
def ball_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("ball") / "ball.obj"
    path.write_text(obj_text(*sphere(30, 3)))
    return path


@pytest.fixture(scope="module")
def sewn(curveups, ball_file, tmp_path_factory):
    out = tmp_path_factory.mktemp("sewn")
    ran = curveups("design", ball_file, "-o", out, "--set", *SIZES, "joint=holes")
    assert ran.status == 0, ran.err
    return out


def borders(design):
    """Edges between pieces."""
    V, F = np.array(design["V"]), np.array(design["F"], np.int32)
    piece = native.pieces_of_faces(V, F, np.array(design["cuts"], np.int32))
    faces = {}
    for i, face in enumerate(F.tolist()):
        for t in range(3):
            faces.setdefault(frozenset((face[t], face[(t + 1) % 3])), []).append(i)
    return [pair for pair in faces.values() if len(pair) == 2 and piece[pair[0]] != piece[pair[1]]]


def exported(curveups, folder, out, joint, status=0):
    """The report on the same layout with or without holes: what nobody but an editor of files asks for."""
    design = json.loads((folder / "design.json").read_text("utf-8"))
    design["parameters"]["joint"] = joint
    out.mkdir(exist_ok=True)
    (out / "edited.json").write_text(json.dumps(design))
    ran = curveups("export", out / "edited.json", "-o", out)
    assert ran.status == status, ran.err
    return json.loads((out / "report.json").read_text("utf-8"))


def test_every_edge_between_the_pieces_has_two_holes(sewn):
    design, report = read_run(sewn)
    edges = borders(design)
    assert len(edges) > 20
    assert report["joints"] == {"edges": len(edges), "holes": 2 * len(edges), "hole_mm": 1.0, "wall_mm": 0.3,
                                "without": []}
    assert not [one for one in report["warnings"] if one["kind"] == "joint"]
    assert report["constraints"]["max_pin_bound_violation_mm"] < 1e-6
    assert report["solids"]["invalid"] == 0
    tiles = (sewn / "ball-tiles.step").read_text("utf-8")
    assert tiles.count("CYLINDRICAL_SURFACE") == 2 * len(edges)
    assert (sewn / "ball-actuated.step").read_text("utf-8").count("CYLINDRICAL_SURFACE") == 2 * len(edges)


def test_the_kit_says_how_the_pieces_are_sewn(sewn, curveups, tmp_path):
    design, report = read_run(sewn)
    assert curveups("kit", sewn / "design.json", "-o", tmp_path).status in (0, 1)
    found = json.loads((tmp_path / "kit.json").read_text("utf-8"))
    assert found["status"] == "complete" and found["print"]["pieces"] == 2
    assert found["joints"]["holes"] == report["joints"]["holes"]
    assert sorted(found["borders"]["pairs"]) == sorted(map(sorted, borders(design)))
    sew = found["steps"][-1]
    assert "sew them along their borders" in sew["title"]
    assert f"{found['joints']['holes']} holes in all" in sew["text"] and "(1 mm)" in sew["text"]
    assert set(map(tuple, found["borders"]["named"])) <= set(map(tuple, found["borders"]["pairs"]))
    assert all(f"T{a + 1:05}–T{b + 1:05}" in sew["text"] for a, b in found["borders"]["named"])
    _, mesh = freecad_session.load("Mesh")
    former = mesh.Mesh(str(tmp_path / "ball-former.stl"))  # one for each piece
    assert former.countComponents() == 2 and former.isSolid()


def test_the_stl_is_closed_and_has_the_holes(sewn):
    data = (sewn / "ball-tiles.stl").read_bytes()
    count = struct.unpack("<I", data[80:84])[0]
    facets = np.frombuffer(data, np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")]), count, 84)
    corners = facets["v"].astype(float)
    points, index = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    index = index.reshape(-1, 3)
    edges = [tuple(edge) for face in index.tolist() for edge in zip(face, face[1:] + face[:1])]
    assert sorted(edges) == sorted((b, a) for a, b in edges)
    # V - E + F = 2 - 2 holes, of each tile.
    _, report = read_run(sewn)
    euler = len(points) - len(edges) // 2 + count
    assert euler == 2 * report["tiles"] - 2 * report["joints"]["holes"]


def test_one_piece_has_nothing_to_join(curveups, cap, tmp_path):
    ran = curveups("design", cap, "-o", tmp_path, "--set", "joint=holes", "run_verification=off")
    assert ran.status == 0, ran.err
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    said, = (one for one in report["warnings"] if one["kind"] == "joint")
    assert "nothing to join" in said["what"] and "set pieces" in said["remedy"]
    assert report["joints"]["edges"] == report["joints"]["holes"] == 0


def test_holes_that_find_no_room_are_refused(curveups, ball_file, tmp_path):
    """Before anything is solved, where pins can't give way; and what is named does."""
    def run(name, *values):
        return curveups("design", ball_file, "-o", tmp_path / name, "--set", "pieces=2", "verify=off",
                        "joint=holes", *values)

    refused = run("wide", "A_pin_floor=4")
    line, = refused.error_lines
    assert refused.status == 2 and not (tmp_path / "wide").exists()
    assert "no room for stitching holes of 1 mm" in line and "T0" in line and "tried" not in line
    assert "lower A_pin_floor" in line
    assert run("advised", "A_pin_floor=1").status == 0
    report = json.loads((tmp_path / "advised" / "report.json").read_text("utf-8"))
    assert report["joints"]["without"] == []


def test_tiles_of_standard_size_have_holes(curveups, ball_file, tmp_path):
    """Pins beside them are smaller than A_pin_min, which is said, and no smaller than A_pin_floor. The glue
    of three of them would have to withstand 0.743 MPa."""
    ran = curveups("design", ball_file, "-o", tmp_path, "--set", "pieces=2", "joint=holes",
                   "glue_strength=0.8")
    assert ran.status == 0, ran.err
    design, report = read_run(tmp_path)
    assert report["valid"] is True and len(borders(design)) > 20
    assert report["holds"] is True  # each piece by itself: they do not lean on one another
    assert report["joints"]["edges"] == len(borders(design)) and report["joints"]["without"] == []
    assert not [one for one in report["warnings"] if one.get("kind") == "joint"]
    small, = (one for one in report["warnings"] if "pin sides can't reach A_pin_min" in one["what"])
    assert 1 <= float(small["what"].split("smallest has ")[1].split()[0]) < 4
    beside = {tile for pair in borders(design) for tile in pair}
    assert set(small["tiles"]) <= beside
    page = html.unescape((tmp_path / "report.html").read_text(encoding="utf-8"))
    assert "stitching hole (1 mm)" in page and f"{report['joints']['holes']} holes in all" in page
    assert "So the 2 pieces come apart" in page


def test_a_layout_without_holes_is_to_be_made_anew(curveups, ball_file, tmp_path):
    assert curveups("design", ball_file, "-o", tmp_path / "a", "--no-solids", "--set", *SIZES).status == 0
    report = exported(curveups, tmp_path / "a", tmp_path / "b", "holes", status=1)
    said, = (one for one in report["warnings"] if one["kind"] == "joint")
    assert report["joints"]["holes"] == 0 and "compute the layout" in said["remedy"]
    assert report["valid"] is False and "pin insets" in report["reasons"][0]
