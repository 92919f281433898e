# SPDX-License-Identifier: LGPL-2.1-or-later
"""Broken and hostile targets: each ends with status 2, one clear line and no file."""

import math
import os
import random
import re
import struct
import zipfile

import pytest
from running import dome

TRIANGLE = "v 0 0 0\nv 10 0 0\nv 0 10 0\n"


def grid(columns, rows, point, close_columns=False, flip_seam=False):
    """OBJ text of a grid of triangles through point(u, v)."""
    text = "".join("v %r %r %r\n" % point(i / columns, j / rows)
                   for i in range(columns + (0 if close_columns else 1)) for j in range(rows + 1))
    for i in range(columns):
        last = i == columns - 1
        for j in range(rows):
            a = i * (rows + 1) + j
            if last and close_columns:
                b, b1 = (rows - j, rows - j - 1) if flip_seam else (j, j + 1)
            else:
                b, b1 = a + rows + 1, a + rows + 2
            text += f"f {a + 1} {b + 1} {b1 + 1}\nf {a + 1} {b1 + 1} {a + 2}\n"
    return text


def moebius():
    def point(u, v):
        t, w = 2 * math.pi * u, 20 * (v - 0.5)
        r = 40 + w * math.cos(t / 2)
        return r * math.cos(t), r * math.sin(t), w * math.sin(t / 2)

    return grid(40, 3, point, close_columns=True, flip_seam=True)


def closed_sphere():
    text, rings, columns = "", 8, 16
    text += "v 0 0 40\nv 0 0 -40\n"
    for i in range(1, rings):
        for k in range(columns):
            p, a = math.pi * i / rings, 2 * math.pi * k / columns
            text += "v %r %r %r\n" % (40 * math.sin(p) * math.cos(a), 40 * math.sin(p) * math.sin(a),
                                      40 * math.cos(p))

    def at(i, k):
        return 1 if i == 0 else 2 if i == rings else 3 + (i - 1) * columns + k % columns

    for i in range(rings):
        for k in range(columns):
            if i < rings - 1:
                text += f"f {at(i, k)} {at(i + 1, k)} {at(i + 1, k + 1)}\n"
            if i > 0:
                text += f"f {at(i, k)} {at(i + 1, k + 1)} {at(i, k + 1)}\n"
    return text


def figure_eight():
    """A strip along a figure of eight, which runs through itself where that crosses."""
    def point(u, v):
        a = 2 * math.pi * (0.8 * u - 0.1)
        return 40 * math.sin(a), 30 * math.sin(2 * a), 40 * v

    return grid(40, 6, point)


def scaled(text, factor):
    return re.sub(r"v (\S+) (\S+) (\S+)",
                  lambda m: "v %r %r %r" % tuple(factor * float(x) for x in m.groups()), text)


def zip_with(path, files):
    with zipfile.ZipFile(path, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)


def model_3mf(body):
    return ('<?xml version="1.0"?><model unit="millimeter" xmlns='
            '"http://schemas.microsoft.com/3dmanufacturing/core/2015/02">' + body + "</model>")


NOISE = random.Random(7).randbytes(20000)
SHARP = "v 0 0 0\nv 0 20 0\nv 7 10 0\nv 7 10 0.3\nf 1 3 2\nf 2 4 1\n"

TEXTS = {
    "empty.obj": "",
    "only-comments.obj": "# nothing\n",
    "no-faces.obj": TRIANGLE,
    "nan.obj": "v 0 0 0\nv nan 0 0\nv 0 10 0\nf 1 2 3\n",
    "infinite.obj": "v 0 0 0\nv 1e400 0 0\nv 0 10 0\nf 1 2 3\n",
    "two-numbers.obj": "v 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n",
    "words.obj": "v zero zero zero\nf 1 2 3\n",
    "index-zero.obj": TRIANGLE + "f 0 1 2\n",
    "index-beyond.obj": TRIANGLE + "f 1 2 4\n",
    "index-behind.obj": TRIANGLE + "f 1 2 -9\n",
    "two-corners.obj": TRIANGLE + "f 1 2\n",
    "zero-area.obj": "v 0 0 0\nv 10 0 0\nv 20 0 0\nf 1 2 3\n",
    "all-one-point.obj": "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n",
    "moebius.obj": moebius(),
    "closed-sphere.obj": closed_sphere(),
    "through-itself.obj": figure_eight(),
    "three-at-an-edge.obj": "v 0 0 0\nv 20 0 0\nv 0 20 0\nv 0 -20 0\nv 0 0 20\n"
                            "f 1 2 3\nf 2 1 4\nf 1 2 5\n",
    "huge.obj": scaled(dome(2), 1e12) + "\n",
    "one-point-often.obj": scaled(dome(3), 0.0),
    "far-away.obj": re.sub(r"v (\S+) (\S+) (\S+)", r"v 1e30 1e30 1e30", dome(3)),
    "beyond-squares.obj": scaled(dome(3), 1e200),
    "beyond-squares-of-four.obj": "v 0 0 0\nv 1e200 0 0\nv 1e200 1e200 0\nv 0 1e200 0\nf 1 2 3 4\n",
    "metres.obj": scaled(dome(3), 1e-3),
    "not-off.off": "COFFEE\n",
    "short.off": "OFF\n3 1 0\n0 0 0\n10 0 0\n",
    "beyond.off": "OFF\n3 1 0\n0 0 0\n10 0 0\n0 10 0\n3 0 1 7\n",
    "nan.off": "OFF\n3 1 0\n0 0 0\n10 nan 0\n0 10 0\n3 0 1 2\n",
    "no-counts.off": "OFF\n",
    "nan.stl": "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 nan\n"
               "vertex 0 9 0\nendloop\nendfacet\nendsolid x\n",
    "cut-off.stl": "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0",
    "words.stl": "hello world",
    "nan.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
               "end_header\n0 0 0\nnan 0 0\n0 9 0\n3 0 1 2\n",
    "short.ply": "ply\nformat ascii 1.0\nelement vertex 900000000\nproperty float x\n"
                 "property float y\nproperty float z\nelement face 5\n"
                 "property list uchar int vertex_indices\nend_header\n0 0 0\n",
    "words.ply": "hello world",
    "words.step": "hello world",
    "words.iges": "hello world",
    "words.brep": "hello world",
    "words.3mf": "hello world",
    "unknown.xyz": "0 0 0\n",
    "no-ending": "0 0 0\n",
    "step-inside.stl": "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n",
    "empty.step": "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n",
    "folded-shut.obj": SHARP,
}
# Taken as they are: remeshing would mend them.
AS_THEY_ARE = {
    "needles.obj": "".join(f"v {i * 10} 0 0\n" for i in range(5))
                   + "".join(f"v {i * 10 + 5} 1e-7 0\n" for i in range(4))
                   + "".join(f"f {i + 1} {i + 2} {i + 6}\n" for i in range(4)),
    "inconsistent.obj": "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\nf 1 2 3\nf 1 4 3\n",
    "duplicate-face.obj": TRIANGLE + "f 1 2 3\nf 1 2 3\n",
    "self-touching.obj": TRIANGLE + "v 20 20 0\nv 30 20 0\nf 1 2 3\nf 4 5 3\n",
    "folded-shut-as-is.obj": SHARP,
    "through-itself-as-is.obj": figure_eight(),
    "metres-as-is.obj": scaled(dome(2), 1e-3),
}
BYTES = {
    "noise.obj": NOISE, "noise.off": NOISE, "noise.stl": NOISE, "noise.ply": NOISE,
    "noise.step": NOISE, "noise.iges": NOISE, "noise.brep": NOISE, "noise.3mf": NOISE,
    "announced.stl": b"\0" * 80 + struct.pack("<I", 2_000_000_000) + b"\0" * 500,
    "none-announced.stl": b"\0" * 84,
    "nan-binary.stl": b"\0" * 80 + struct.pack("<I", 1)
                      + struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 9, 0, 0, math.nan, 9, 0, 0),
    "zip-without-model.3mf": None, "not-xml.3mf": None, "bad-index.3mf": None,
    "endless-components.3mf": None, "nothing-left.3mf": None, "ten-of-ten-of-ten.3mf": None,
}
ZIPS = {
    "zip-without-model.3mf": {"readme.txt": "nothing"},
    "not-xml.3mf": {"3D/3dmodel.model": "<model"},
    "bad-index.3mf": {"3D/3dmodel.model": model_3mf(
        '<resources><object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/></vertices>'
        '<triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object></resources>'
        '<build><item objectid="1"/></build>')},
    "endless-components.3mf": {"3D/3dmodel.model": model_3mf(
        '<resources><object id="1"><components><component objectid="1"/></components></object>'
        '</resources><build><item objectid="1"/></build>')},
    "nothing-left.3mf": {"3D/3dmodel.model": model_3mf(
        '<resources><object id="1"><mesh><vertices>'
        + "".join('<vertex x="%s" y="%s" z="%s"/>' % tuple(line.split()[1:])
                  for line in dome(3).splitlines() if line[0] == "v")
        + "</vertices><triangles>"
        + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(int(v) - 1 for v in line.split()[1:])
                  for line in dome(3).splitlines() if line[0] == "f")
        + '</triangles></mesh></object></resources>'
        '<build><item objectid="1" transform="0 0 0 0 0 0 0 0 0 0 0 0"/></build>')},
    "ten-of-ten-of-ten.3mf": {"3D/3dmodel.model": model_3mf(
        '<resources><object id="1"><mesh><vertices/><triangles/></mesh></object>'
        + "".join(f'<object id="{k + 1}"><components>' + f'<component objectid="{k}"/>' * 10
                  + "</components></object>" for k in range(1, 15))
        + '</resources><build><item objectid="15"/></build>')},
}


def expect_refusal(ran, folder, target):
    assert ran.status == 2, (ran.status, ran.err)
    others = [line for line in ran.err.splitlines() if not line.startswith("curveups: error: ")]
    # Progress lines may stand before it, nothing of a library's.
    assert all(line.startswith("curveups: ") for line in others), ran.err
    assert len(ran.error_lines) == 1, ran.err
    assert re.match(r"^curveups: error: .+ \(.*%s.*\): .+$" % re.escape(target.name),
                    ran.error_lines[0]), ran.error_lines
    assert ran.out == ""
    assert not (folder / "out").exists()
    assert [p.name for p in folder.iterdir()] == [target.name]


@pytest.mark.parametrize("name", [*TEXTS, *BYTES, *AS_THEY_ARE])
def test_hostile_target(curveups, tmp_path, name):
    target = tmp_path / name
    if name in ZIPS:
        zip_with(target, ZIPS[name])
    elif name in BYTES:
        target.write_bytes(BYTES[name])
    else:
        target.write_text(TEXTS.get(name, AS_THEY_ARE.get(name)))
    extra = ["--no-remesh"] if name in AS_THEY_ARE else []
    expect_refusal(curveups("design", target, "-o", tmp_path / "out", "--no-solids", *extra),
                   tmp_path, target)


def test_a_spike_of_metres_is_refused_at_once_with_mending_too(curveups, tmp_path):
    target = tmp_path / "spike.obj"
    target.write_text("v 0 0 4000\n" + dome(3).partition("\n")[2])
    ran = curveups("design", target, "-o", tmp_path / "out", "--no-solids", "--set", "mend=on")
    expect_refusal(ran, tmp_path, target)
    assert "an edge of 39" in ran.err and "remeshing" not in ran.err, ran.err


def test_folder_as_target(curveups, tmp_path):
    target = tmp_path / "folder.obj"
    target.mkdir()
    expect_refusal(curveups("design", target, "-o", tmp_path / "out"), tmp_path, target)


def test_unreadable_target(curveups, tmp_path):
    if os.geteuid() == 0:
        pytest.skip("root reads everything")
    target = tmp_path / "secret.obj"
    target.write_text(dome(2))
    target.chmod(0)
    expect_refusal(curveups("design", target, "-o", tmp_path / "out"), tmp_path, target)


def test_file_where_the_folder_should_be(curveups, tmp_path, cap):
    (tmp_path / "out").write_text("mine")
    for place in (tmp_path / "out", tmp_path / "out" / "deeper"):
        ran = curveups("design", cap, "-o", place, "--no-solids")
        assert ran.status == 2 and len(ran.err.splitlines()) == 1
    assert (tmp_path / "out").read_text("utf-8") == "mine"


@pytest.mark.parametrize("text, word", [
    ("{}", "no cuts"), ("[]", "object"), ("{", "JSON"), ('{"edge": []}', "edge"),
    ('{"edges": [[0]]}', "pairs"), ('{"edges": [[0, 99999]]}', "edge"), ('{"edges": [[0, 1.5]]}', "pairs"),
    ('{"edges": [[-1, 2]]}', "pairs"), ('{"polylines": [[[0,0,0]]]}', "polyline"),
    ('{"polylines": [[[0,0,0],[0,0,"x"]]]}', "polyline"),
    ('{"polylines": [[[1e9,0,0],[2e9,0,0]]]}', "away"), ('{"edges": 3}', "pairs"),
])
def test_broken_cuts(curveups, tmp_path, cap, text, word):
    cuts = tmp_path / "cuts.json"
    cuts.write_text(text)
    ran = curveups("design", cap, "-o", tmp_path / "out", "--no-remesh", "--no-solids",
                   "--cuts", cuts)
    assert ran.status == 2 and len(ran.error_lines) == 1
    assert word in ran.error_lines[0] and "cuts.json" in ran.error_lines[0]
    assert not (tmp_path / "out").exists()
