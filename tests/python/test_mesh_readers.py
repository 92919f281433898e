# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files are read whole, or refused: no line is passed over in silence."""

import struct
import zipfile

import numpy as np
import pytest

from curveups.base.errors import CurveUpsError, Stopped
from curveups.targets.target_files import read_target

V = np.array([[0, 0, 0], [9, 0, 0], [9, 9, 0.1], [0, 9, 0]], float)
F = np.array([[0, 1, 2], [0, 2, 3]])
BOM = b"\xef\xbb\xbf"


def stl(number="{:.17g}", line_end="\n"):
    text = "solid a vertex of facets\n"
    for face in F:
        text += "facet normal 0 0 1\n outer loop\n"
        text += "".join("  vertex " + " ".join(number.format(x) for x in V[v]) + "\n" for v in face)
        text += " endloop\nendfacet\n"
    return (text + "endsolid a\n").replace("\n", line_end)


def binary_stl():
    return b"solid of binary".ljust(80) + struct.pack("<I", len(F)) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *V[face].ravel(), 7) for face in F)


def ply_header(form, real="float", vertex_extra="", face_extra="", faces=None):
    return (f"ply\nformat {form} 1.0\ncomment made by hand\nelement vertex {len(V)}\n"
            + "".join(f"property {real} {axis}\n" for axis in "xyz") + vertex_extra
            + f"element face {len(F) if faces is None else faces}\n" + face_extra
            + "property list uchar int vertex_indices\nend_header\n")


def ply(**header):
    return (ply_header("ascii", **header) + "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in V.tolist())
            + "".join("3 %d %d %d\n" % tuple(face) for face in F))


def binary_ply(order, real="f"):
    form = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    return ply_header(form, {"f": "float", "d": "double"}[real]).encode() + b"".join(
        struct.pack(order + "3" + real, *row) for row in V) + b"".join(
        struct.pack(order + "B3i", 3, *face) for face in F)


def obj():
    return "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in V.tolist()) + "".join(
        "f %d %d %d\n" % tuple(face + 1) for face in F)


def off():
    return (f"OFF\n{len(V)} {len(F)} 0\n" + "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in V.tolist())
            + "".join("3 %d %d %d\n" % tuple(face) for face in F))


def read(folder, name, content):
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    found = read_target(path, 0.01)
    return found.V, found.F


def expect_surface(found, tolerance=0.0):
    """The very triangles, whatever the vertices' order."""
    found_V, found_F = found
    assert found_F.shape == F.shape
    assert np.abs(found_V[found_F] - V[F]).max() <= tolerance


SOUND = {
    "text.stl": stl(), "windows.stl": stl(line_end="\r\n"), "upper.stl": stl().upper(),
    "exponents.stl": stl("{:+.9E}"), "binary.stl": binary_stl(), "bom.stl": BOM + stl().encode(),
    "two-solids.stl": stl().replace("endfacet\nfacet", "endfacet\nendsolid\nsolid b\nfacet"),
    "text.ply": ply(), "double.ply": ply(real="double"), "windows.ply": ply().replace("\n", "\r\n"),
    "little.ply": binary_ply("<"), "big.ply": binary_ply(">"), "big-double.ply": binary_ply(">", "d"),
    "bom.ply": BOM + ply().encode(),
    "blank-lines.ply": ply().replace("3 0 1 2", "\n3 0 1 2"),
    "text.obj": obj(), "bom.obj": BOM + obj().encode(), "continued.obj": obj().replace("f 1 2", "f 1 \\\n 2"),
    "comment.obj": "# C:\\parts\\\n" + obj(),
    "continued-vertex.obj": obj().replace("v 9.0 0.0", "v 9.0\\\r\n0.0"),
    "text.off": off(), "bom.off": BOM + off().encode(),
}


@pytest.mark.parametrize("name", SOUND)
def test_sound_file(tmp_path, name):
    # STL and PLY's float have single precision.
    expect_surface(read(tmp_path, name, SOUND[name]), tolerance=1e-6 if name.endswith(("stl", "ply")) else 0)


def test_precision_of_a_ply_is_that_of_its_type(tmp_path):
    assert read(tmp_path, "a.ply", ply(real="double"))[0][2, 2] == 0.1
    assert read(tmp_path, "b.ply", ply())[0][2, 2] == np.float32(0.1)


@pytest.fixture
def large(tmp_path, monkeypatch):
    """Files of 20,000 triangles in every format of meshes."""
    columns = np.arange(101.0)
    points = np.stack([*np.meshgrid(columns, columns), np.zeros((101, 101))], axis=-1).reshape(-1, 3)
    at = (np.arange(101 * 101).reshape(101, 101)[:-1, :-1]).reshape(-1, 1)
    monkeypatch.setitem(globals(), "V", points)
    monkeypatch.setitem(globals(), "F", np.concatenate([at + [0, 1, 102], at + [0, 102, 101]]))
    with zipfile.ZipFile(tmp_path / "a.3mf", "w") as archive:
        archive.writestr("3D/3dmodel.model", (
            '<model><resources><object id="1"><mesh><vertices>'
            + "".join('<vertex x="%r" y="%r" z="%r"/>' % tuple(row) for row in V.tolist())
            + "</vertices><triangles>"
            + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(face) for face in F)
            + '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>'))
    for name, content in {"a.obj": obj(), "a.off": off(), "a.stl": stl(), "a.ply": ply()}.items():
        (tmp_path / name).write_text(content)
    return tmp_path


@pytest.mark.parametrize("ending", ["obj", "off", "stl", "ply", "3mf"])
def test_reading_tells_how_far_it_is_and_can_be_stopped(large, ending):
    told = []
    assert len(read_target(large / f"a.{ending}", 0.01, lambda share: not told.append(share)).F) == len(F)
    assert told == sorted(told) and 0 <= told[0] < 0.1 and 0.4 < told[-1] <= 1 and len(set(told)) > 3, told
    for last in range(len(told)):
        asked = iter([True] * last)
        with pytest.raises(Stopped):
            read_target(large / f"a.{ending}", 0.01, lambda _: next(asked, False))


SCRAMBLED = {  # each was read as another surface, in silence, by the reader of a library
    "word.stl": (stl().replace("vertex 9 9", "vertex foo 9", 1), "line 2"),
    "word-in-second.stl": (stl()[::-1].replace("9 xetrev", "oof xetrev", 1)[::-1], "line 9"),
    "two-numbers.stl": (stl().replace("vertex 9 0 0", "vertex 9 0", 1), "line 2"),
    "four-corners.stl": (stl().replace(" endloop", "  vertex 1 2 3\n endloop", 1), "line 2"),
    "no-endfacet.stl": (stl().replace("endfacet\n", "", 1), "line 2"),
    "lost-line.stl": (stl().replace("  vertex 9 0 0\n", "", 1), "line 2"),
    "huge.stl": (stl().replace("vertex 9 0 0", "vertex 1e300 0 0"), "finite"),
    "no-end.stl": (stl().replace("endsolid a\n", ""), "ends early"),
    "cut-off.stl": (stl()[:-40], "ends early"),
    "short-binary.stl": (binary_stl()[:-1], "ends early"),
    "word.ply": (ply().replace("9.0 0.0 0.0", "foo 0.0 0.0"), "foo"),
    "two-numbers.ply": (ply().replace("9.0 0.0 0.0", "9.0 0.0"), "9.0 0.0"),
    "four-numbers.ply": (ply().replace("9.0 0.0 0.0", "9.0 0.0 0.0 1.0"), "9.0 0.0 0.0 1.0"),
    "corner.ply": (ply().replace("3 0 1 2", "3 0 1 x"), "x"),
    "fraction.ply": (ply().replace("3 0 1 2", "3 0 1 2.5"), "2.5"),
    "few-corners.ply": (ply().replace("3 0 1 2", "4 0 1 2"), "too few"),
    "many-corners.ply": (ply().replace("3 0 1 2", "3 0 1 2 3"), "too many"),
    "beyond.ply": (ply().replace("3 0 1 2", "3 0 1 4"), "not there"),
    "below.ply": (ply().replace("3 0 1 2", "3 0 1 -2"), "not there"),
    "one-more-face.ply": (ply(faces=3), "ends early"),
    "short-little.ply": (binary_ply("<")[:-3], "ends early"),
    "count-in-little.ply": (binary_ply("<").replace(struct.pack("<B3i", 3, *F[0]),
                                                    struct.pack("<B3i", 200, *F[0])), "ends early"),
    "beyond-in-big.ply": (binary_ply(">").replace(struct.pack(">B3i", 3, *F[0]),
                                                  struct.pack(">B3i", 3, 0, 1, 9)), "not there"),
    "no-z.ply": (ply().replace("property float z\n", "property float w\n"), "'z'"),
    "no-faces.ply": (ply().replace("element face", "element strip"), "no faces"),
    "huge-index.obj": (obj().replace("f 1 2 3", "f 1 2 99999999999999999999"), "not there"),
    "continued-to-nothing.obj": (obj() + "f 1 2 \\\n", "2 corners"),
}


@pytest.mark.parametrize("name", SCRAMBLED)
def test_scrambled_file(tmp_path, name):
    content, word = SCRAMBLED[name]
    with pytest.raises(CurveUpsError) as refused:
        read(tmp_path, name, content)
    assert word in str(refused.value) and name in str(refused.value)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("nan", [b"\x00\x00\xc0\x7f", b"\x01\x00\x80\x7f"])  # quiet, signalling
def test_a_nan_of_a_binary_ply_is_refused_without_a_warning(tmp_path, nan):
    data = bytearray(binary_ply("<"))
    at = data.index(b"end_header\n") + len(b"end_header\n")
    data[at:at + 4] = nan
    with pytest.raises(CurveUpsError, match="a vertex is not finite"):
        read(tmp_path, "nan.ply", bytes(data))


def test_lists_of_several_lengths_and_other_data_of_a_binary_ply(tmp_path):
    data = ply_header("binary_little_endian", vertex_extra="property uchar red\n",
                      face_extra="property uchar flags\n", faces=2).encode()
    data += b"".join(struct.pack("<3fB", *row, 200) for row in V)
    data += struct.pack("<BB3i", 1, 3, 0, 1, 2) + struct.pack("<BB4i", 1, 4, 0, 1, 2, 3)
    found_V, found_F = read(tmp_path, "mixed.ply", data)
    assert len(found_V) == 4 and found_F.tolist() == [[0, 1, 2], [0, 1, 2], [0, 2, 3]]


ARROW = [(0, 0), (4, 0), (1, 1), (0, 4)]  # a fan from its first corner stays inside
BENT = [(4, 0), (1, 1), (0, 4), (0, 0)]   # from this one it does not
FORK = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]


@pytest.mark.parametrize("corners", [ARROW, BENT, FORK])
@pytest.mark.parametrize("ending", ["obj", "off", "ply"])
def test_concave_polygons_are_covered_once(tmp_path, corners, ending):
    points = [(x, y, 0.5 * x) for x, y in corners]
    count, numbers = len(points), list(range(len(points)))
    lines = "".join("%r %r %r\n" % p for p in points)
    content = {
        "obj": "".join("v %r %r %r\n" % p for p in points) + "f " + " ".join(str(n + 1) for n in numbers),
        "off": f"OFF\n{count} 1 0\n{lines}{count} " + " ".join(map(str, numbers)),
        "ply": f"ply\nformat ascii 1.0\nelement vertex {count}\nproperty double x\nproperty double y\n"
               "property double z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
               f"{lines}{count} " + " ".join(map(str, numbers)) + "\n"}[ending]
    found_V, found_F = read(tmp_path, "a." + ending, content)
    a, b, c = (found_V[found_F[:, k], :2] for k in range(3))
    doubled = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    x, y = np.array(corners, float).T
    area = 0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()
    assert len(found_F) == count - 2
    assert (doubled > 0).all()
    assert 0.5 * doubled.sum() == pytest.approx(area, rel=1e-12)


@pytest.mark.parametrize("crossing", [False, True])
def test_a_polygon_of_thousands_of_corners_is_divided(tmp_path, crossing):
    """A star, which is covered once, and one that crosses itself, which becomes a fan."""
    count = 4000
    radius = np.where(np.arange(count) % 2, 60.0, 58.0)
    turn = 2 * np.pi * np.arange(count) / count * (1999 if crossing else 1)
    points = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.zeros(count)], axis=1)
    (tmp_path / "star.obj").write_text("".join("v %r %r %r\n" % tuple(row) for row in points.tolist())
                                       + "f " + " ".join(map(str, range(1, count + 1))) + "\n")
    told = []
    found = read_target(tmp_path / "star.obj", 0.01, lambda share: not told.append(share))
    assert len(found.F) == count - 2 and told
    if crossing:
        assert (found.F[:, 0] == 0).all()
        return
    a, b, c = (found.V[found.F[:, k], :2] for k in range(3))
    doubled = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    assert (doubled > 0).all()
    assert doubled.sum() == pytest.approx(count * 60 * 58 * np.sin(2 * np.pi / count), rel=1e-9)


def test_quads_and_polygons_that_cross_themselves_stay_fans(tmp_path):
    square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    assert read(tmp_path, "square.obj", square + "f 1 2 3 4\n")[1].tolist() == [[0, 1, 2], [0, 2, 3]]
    assert read(tmp_path, "bow.obj", square + "f 1 3 2 4\n")[1].tolist() == [[0, 2, 1], [0, 1, 3]]


def test_a_line_that_goes_on_for_hundreds_of_thousands(tmp_path):
    path = tmp_path / "long.obj"
    path.write_text("v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 \\\n" + " \\\n" * 300_000 + "2 3\n")
    assert read_target(path, 0.1).F.tolist() == [[0, 1, 2]]


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("number", ["1e300", "inf", "nan"])
def test_a_3mf_whose_places_overflow_is_refused_without_a_warning(tmp_path, number):
    model = ('<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
             '<resources><object id="1"><mesh><vertices><vertex x="0" y="0" z="1e200"/>'
             '<vertex x="9" y="0" z="0"/><vertex x="0" y="9" z="0"/></vertices>'
             '<triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>'
             '<object id="2"><components><component objectid="1" '
             f'transform="{number} 0 0 0 {number} 0 0 0 {number} 0 0 0"/></components></object></resources>'
             f'<build><item objectid="2" transform="1e300 0 0 0 1 0 0 0 {number} 0 0 0"/></build></model>')
    with zipfile.ZipFile(tmp_path / "far.3mf", "w") as archive:
        archive.writestr("3D/3dmodel.model", model)
    with pytest.raises(CurveUpsError) as caught:
        read_target(tmp_path / "far.3mf", 0.01)
    assert caught.value.remedy
