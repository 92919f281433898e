# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files are read with their vertices' numbers and precision, or refused."""

import struct
import zipfile

import numpy as np
import pytest

from curveups.base.errors import CurveUpsError
from curveups.targets.target_files import read_target

V = np.array([[0, 0, 0], [9, 0, 0], [9, 9, 0.1], [0, 9, 0]], float)
F = np.array([[0, 1, 2], [0, 2, 3]])
BOM = b"\xef\xbb\xbf"


def stl():
    return "solid a vertex of facets\n" + "".join(
        "facet normal 0 0 1\n outer loop\n"
        + "".join("  vertex %r %r %r\n" % tuple(V[v].tolist()) for v in face) + " endloop\nendfacet\n"
        for face in F) + "endsolid a\n"


def binary_stl():
    return b"solid of binary".ljust(80) + struct.pack("<I", len(F)) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *V[face].ravel(), 7) for face in F)


def rows():
    return ("".join("%r %r %r\n" % tuple(row) for row in V.tolist())
            + "".join("3 %d %d %d\n" % tuple(face) for face in F))


def ply_header(form, real="float"):
    return (f"ply\nformat {form} 1.0\ncomment made by hand\nelement vertex {len(V)}\n"
            + "".join(f"property {real} {axis}\n" for axis in "xyz")
            + f"element face {len(F)}\nproperty list uchar int vertex_indices\nend_header\n")


def binary_ply(order, real="f"):
    form = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    return ply_header(form, {"f": "float", "d": "double"}[real]).encode() + b"".join(
        struct.pack(order + "3" + real, *row) for row in V) + b"".join(
        struct.pack(order + "B3i", 3, *face) for face in F)


def obj():
    return "".join("v %r %r %r\n" % tuple(row) for row in V.tolist()) + "".join(
        "f %d %d %d\n" % tuple(face + 1) for face in F)


PLY, OFF = ply_header("ascii") + rows(), f"OFF\n{len(V)} {len(F)} 0\n{rows()}"


def read(folder, name, content):
    path = folder / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    surface = read_target(path, 0.01)
    return surface.V, surface.F


SOUND = {
    "text.stl": stl(), "windows.stl": stl().replace("\n", "\r\n"), "upper.stl": stl().upper(),
    "binary.stl": binary_stl(), "bom.stl": BOM + stl().encode(),
    "two-solids.stl": stl().replace("endfacet\nfacet", "endfacet\nendsolid\nsolid b\nfacet"),
    "text.ply": PLY, "little.ply": binary_ply("<"), "big-double.ply": binary_ply(">", "d"),
    "windows.ply": PLY.replace("\n", "\r\n"),
    "text.obj": obj(), "bom.obj": BOM + obj().encode(), "continued.obj": obj().replace("f 1 2", "f 1 \\\n 2"),
    "normals.obj": obj().replace("f 1 2 3", "vn 0 0 1\nf 1//1 2/1/1 3/1"),
    "backwards.obj": obj().replace("f 1 3 4", "f -4 -2 -1"),
    "text.off": OFF, "coloured.off": OFF.replace("3 0 1 2", "3 0 1 2 255 0 0  # red"),
}


@pytest.mark.parametrize("name", SOUND)
def test_sound_file(tmp_path, name):
    """The very numbers; STL has single precision and no order of vertices."""
    read_V, read_F = read(tmp_path, name, SOUND[name])
    assert np.array_equal(read_V[read_F], V[F]) or np.allclose(read_V[read_F], V[F], 0, 1e-6) and (
        name.endswith("stl") or name == "little.ply")
    if not name.endswith("stl"):
        assert np.array_equal(read_F, F)


def write_3mf(path, V, F, unit, objects, items):
    """Object 1 is the mesh; objects and items are text of the model."""
    model = (
        f'<model unit="{unit}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">'
        '<resources><object id="1"><mesh><vertices>'
        + "".join('<vertex x="%r" y="%r" z="%r"/>' % tuple(row) for row in V)
        + "</vertices><triangles>"
        + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(face) for face in F)
        + f"</triangles></mesh></object>{objects}</resources><build>{items}</build></model>")
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("3D/3dmodel.model", model)


def component(number, part, transform):
    return (f'<object id="{number}"><components><component objectid="{part}" transform="{transform}"/>'
            "</components></object>")


def test_a_3mf_is_read_where_its_build_places_it_in_millimetres(tmp_path):
    write_3mf(tmp_path / "a.3mf", V.tolist(), F, "centimeter", component(2, 1, "1 0 0 0 1 0 0 0 1 2 0 0"),
              '<item objectid="2" transform="0 1 0 -1 0 0 0 0 1 0 0 5"/>')
    read = read_target(tmp_path / "a.3mf", 0.01)
    x, y, z = V.T
    assert np.allclose(read.V, 10 * np.stack([-y, x + 2, z + 5], axis=1)) and np.array_equal(read.F, F)


@pytest.mark.parametrize("unit, length", [("inch", 25.4), ("micron", 1e-3), ("millimeter", 1.0)])
@pytest.mark.parametrize("mirrored", ["", "item", "component", "both"])
def test_outsides_of_a_3mf_stay_outside(tmp_path, unit, length, mirrored):
    corners = [[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 5]]
    faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    turned = {name: "-1 0 0 0 1 0 0 0 2 0 0 7" if mirrored in (name, "both") else "1 0 0 0 1 0 0 0 2 0 0 7"
              for name in ("item", "component")}
    write_3mf(tmp_path / "a.3mf", corners, faces, unit, component(2, 1, turned["component"]),
              f'<item objectid="2" transform="{turned["item"]}"/>')
    read = read_target(tmp_path / "a.3mf", 0.01)
    volume = np.linalg.det(read.V[read.F]).sum() / 6
    assert volume == pytest.approx(4 * 3 * 4 * 5 / 6 * length**3)


def test_lists_of_several_lengths_and_other_data_of_a_binary_ply(tmp_path):
    header = ply_header("binary_little_endian").replace("property float z\n", "property float z\n"
                                                        "property uchar red\n")
    data = header.replace("property list", "property uchar flags\nproperty list").encode()
    data += b"".join(struct.pack("<3fB", *row, 200) for row in V)
    data += struct.pack("<BB3i", 1, 3, 0, 1, 2) + struct.pack("<BB4i", 1, 4, 0, 1, 2, 3)
    read_V, read_F = read(tmp_path, "mixed.ply", data)
    assert len(read_V) == 4 and read_F.tolist() == [[0, 1, 2], [0, 1, 2], [0, 2, 3]]


BROKEN = {  # words, and an end that comes early; the fuzzer tries the rest
    "word.obj": (obj().replace("v 9.0", "v nine"), "line 2"),
    "beyond.obj": (obj() + "f 1 2 9\n", "not there"),
    "nan.obj": (obj().replace("9.0", "nan"), "finite"), "empty.obj": ("", "no faces"),
    "not-off.off": ("COFFEE\n", "no OFF file"),
    "binary.off": (b"OFF BINARY\n\0\0\0\4\xff", "binary OFF"),
    "fewer.off": (OFF.replace("4 2 0", "4 3 0"), "ends early"),
    "word.stl": (stl().replace("vertex 9.0 9.0", "vertex foo 9.0", 1), "can't be read"),
    "cut-off.stl": (stl()[:-40], "ends early"), "short-binary.stl": (binary_stl()[:-1], "ends early"),
    "word.ply": (PLY.replace("9.0 0.0 0.0", "foo 0.0 0.0"), "foo"),
    "short-little.ply": (binary_ply("<")[:-3], "ends early"), "header.ply": ("ply\n", "PLY"),
    "words.3mf": ("hello", "3MF"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_file(tmp_path, name):
    content, word = BROKEN[name]
    with pytest.raises(CurveUpsError) as refused:
        read(tmp_path, name, content)
    assert word in str(refused.value) and name in str(refused.value) and refused.value.remedy


ARROW = [(0, 0), (4, 0), (1, 1), (0, 4)]  # a fan from its first corner stays inside
BENT = [(4, 0), (1, 1), (0, 4), (0, 0)]   # from this one it does not
FORK = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]


@pytest.mark.parametrize("corners", [ARROW, BENT, FORK])
def test_concave_polygons_are_covered_once(tmp_path, corners):
    points = [(x, y, 0.5 * x) for x, y in corners]
    read_V, read_F = read(tmp_path, "a.obj", "".join("v %r %r %r\n" % p for p in points) + "f "
                          + " ".join(str(n + 1) for n in range(len(points))))
    a, b, c = (read_V[read_F[:, k], :2] for k in range(3))
    doubled = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    x, y = np.array(corners, float).T
    area = 0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()
    assert len(read_F) == len(corners) - 2 and (doubled > 0).all()
    assert 0.5 * doubled.sum() == pytest.approx(area, rel=1e-12)


def test_quads_and_polygons_that_cross_themselves_stay_fans(tmp_path):
    square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    assert read(tmp_path, "square.obj", square + "f 1 2 3 4\n")[1].tolist() == [[0, 1, 2], [0, 2, 3]]
    assert read(tmp_path, "bow.obj", square + "f 1 3 2 4\n")[1].tolist() == [[0, 2, 1], [0, 1, 3]]
