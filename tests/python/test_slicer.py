# SPDX-License-Identifier: LGPL-2.1-or-later
"""The print's 3MF as PrusaSlicer takes it: every body stays where it is."""

import html
import json
import re
import shutil
import signal
import struct
import subprocess
import zipfile

import numpy as np
import pytest
from curveups.base import freecad_session
from running import ROOT, by_admesh
from scipy.spatial import cKDTree

SLICER = shutil.which("prusa-slicer")
pytestmark = pytest.mark.skipif(not SLICER, reason="there is no prusa-slicer")


# As the window does where it is asked for one object of many parts: PrusaSlicer 2.5 makes an object of
# every component, and would drop each onto the bed.
IN_PLACE = ("--dont-arrange", "--no-ensure-on-bed")
# PrusaSlicer looks for seams that nobody sees, which takes most of its time.
SEAMS = ("--seam-position", "rear")


def slicer(folder, *arguments):
    done = subprocess.run([SLICER, "--datadir", folder / "settings", *map(str, arguments)], cwd=folder,
                          capture_output=True, text=True, timeout=500)
    assert done.returncode == 0 or crashed_at_its_end(done, folder), done.stdout + done.stderr
    return done.stdout


def crashed_at_its_end(done, folder):
    """PrusaSlicer 2.9.2 does, where it adds supports, once the G-code is there as a whole."""
    code = folder / "a.gcode"
    if done.returncode != -signal.SIGSEGV or not code.exists():
        return False
    text = code.read_text("utf-8")
    return "PrusaSlicer 2.9.2" in text[:200] and text.rstrip().endswith("; prusaslicer_config = end")


def corners_of(path):
    """Corners of the facets of a binary STL, mm."""
    data = path.read_bytes()
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
    facets = np.frombuffer(data, facet, offset=84, count=struct.unpack_from("<I", data, 80)[0])
    return facets["corners"].astype(float)


def farthest(points, others):
    """The largest distance of one of the points from the nearest of the others."""
    return cKDTree(others).query(points)[0].max()


@pytest.fixture(scope="module", params=["soluble", "breakaway"])
def print_files(curveups, printed, tmp_path_factory, request):
    folder = tmp_path_factory.mktemp(request.param)
    assert curveups("export", printed.folder / "design.json", "-o", folder, "--set",
                    f"support={request.param}").status == 0
    return folder


def test_every_body_keeps_its_place(print_files):
    """Bridges begin above the bed."""
    kinds = [print_files / f"small-cap-{kind}.stl" for kind in ("tiles", "support", "anchors")]
    ours = np.vstack([corners_of(path) for path in kinds]).mean(axis=1)
    slicer(print_files, "--export-stl", *IN_PLACE, "--output", print_files / "sliced.stl",
           "small-cap-print.3mf")
    theirs = corners_of(print_files / "sliced.stl").mean(axis=1)
    assert len(theirs) == len(ours)
    assert farthest(theirs, ours) < 0.01 and farthest(ours, theirs) < 0.01


def test_every_body_is_sound(print_files):
    """And none is lost."""
    said = slicer(print_files, "--info", "small-cap-print.3mf")
    with zipfile.ZipFile(print_files / "small-cap-print.3mf") as archive:
        bodies = archive.read("3D/3dmodel.model").decode().count("<mesh>")
    assert said.count("manifold = yes") == bodies > 30 and "manifold = no" not in said
    # Later versions say places from a body's own middle; heights are the same in all.
    ends = [[float(z) for z in re.findall(rf"^{end}_z = (\S+)", said, re.MULTILINE)]
            for end in ("min", "max")]
    heights = {round(top - bottom, 2) for bottom, top in zip(*ends)}
    breakaway = "breakaway" in (print_files / "design.json").read_text("utf-8")
    assert heights == ({5.0, 0.8} if breakaway else {5.0, 4.7})


def test_it_can_be_sliced(print_files):
    code = print_files / "a.gcode"
    slicer(print_files, "--export-gcode", "--support-material", *SEAMS, *IN_PLACE, "--output", code,
           "small-cap-print.3mf")
    heights = [float(z) for z in re.findall(r"^G1 Z([0-9.]+)", code.read_text("utf-8"), re.MULTILINE)]
    assert 4.5 < max(heights) < 12  # the print is 5 mm high; the nozzle is lifted between parts


def test_materials_arrive_in_prusaslicers_own_project(curveups, printed, tmp_path):
    """The slab is of the second extruder: tools change in every layer that has both."""
    assert curveups("kit", printed.folder / "design.json", "-o", tmp_path).status == 0
    code = tmp_path / "a.gcode"
    slicer(tmp_path, "--export-gcode", "--nozzle-diameter", "0.4,0.4", "--filament-diameter", "1.75,1.75",
           "--layer-height", "0.3", "--first-layer-height", "0.3", *SEAMS, *IN_PLACE, "--output", code,
           "small-cap-prusa.3mf")
    text = code.read_text("utf-8")
    assert set(re.findall("^T[0-9]$", text, re.MULTILINE)) == {"T0", "T1"}
    assert len(re.findall("^T[0-9]$", text, re.MULTILINE)) > 10
    assert "manifold = no" not in slicer(tmp_path, "--info", "small-cap-prusa.3mf")
    assert not (tmp_path / "small-cap-print-fused.stl").exists()  # two materials are no shell


def test_a_fused_print_is_one_sound_body(curveups, printed, tmp_path):
    assert curveups("kit", printed.folder / "design.json", "-o", tmp_path, "--set",
                    "support=breakaway").status == 0
    for ending in ("stl", "3mf"):
        said = slicer(tmp_path, "--info", f"small-cap-print-fused.{ending}")
        assert said.count("manifold = yes") == 1 and "manifold = no" not in said
        assert re.findall(r"^number_of_parts *= *(\d+)", said, re.MULTILINE) == ["1"]
        assert [round(float(z), 2) for z in re.findall(r"^size_z = (\S+)", said, re.MULTILINE)] == [5.0]
    path = tmp_path / "small-cap-print-fused.stl"
    found = by_admesh(path)
    assert found["Total disconnected facets"] == found["Degenerate facets"] == 0
    assert found["Number of parts"] == 1
    _, mesh = freecad_session.load("Mesh")
    whole = mesh.Mesh(str(path))
    assert whole.isSolid() and not whole.hasSelfIntersections()


# As resources/profiles/fdm.json tells.
FDM = ("--nozzle-diameter", "0.4", "--layer-height", "0.2", "--first-layer-height", "0.2",
       "--fill-density", "100%", "--fill-pattern", "rectilinear", "--filament-diameter", "1.75",
       "--skirts", "0", "--gcode-comments", "--bed-shape", "0x0,250x0,250x210,0x210", "--center", "125,105",
       "--support-material", "--support-material-buildplate-only")


@pytest.fixture(scope="module")
def fdm_print(curveups, tmp_path_factory):
    folder = tmp_path_factory.mktemp("fdm")
    ran = curveups("design", "half-sphere", "-o", folder, "--profile", "fdm", "--set", "scale=0.6")
    assert ran.status == 0, ran.err
    # One object of all parts, as in the window.
    kinds = [(folder / f"half-sphere-{kind}.stl").read_bytes() for kind in ("tiles", "support", "anchors")]
    facets = sum(struct.unpack_from("<I", kind, 80)[0] for kind in kinds)
    (folder / "all.stl").write_bytes(bytes(80) + struct.pack("<I", facets) + b"".join(k[84:] for k in kinds))
    return folder, json.loads((folder / "report.json").read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def fdm_code(fdm_print):
    folder, _ = fdm_print
    code = folder / "a.gcode"
    slicer(folder, "--export-gcode", *FDM, *SEAMS, *IN_PLACE, "--output", code, "all.stl")
    return list(extrusions(code.read_text("utf-8")))


def test_the_profile_for_fdm_leaves_level_overhangs_alone(fdm_print):
    _, report = fdm_print
    assert report["valid"] is True
    said = {warning.get("kind") for warning in report["warnings"]}
    assert not said & {"bed", "material", "gap", "feature", "resolution", "glue", "loose"}
    assert report["print"]["smallest_feature_mm"] >= 0.4
    assert report["solids"]["min_clearance_flat_mm"] >= 0.8 - 1e-6


def test_the_profile_for_fdm_is_sliced_whole(fdm_print, fdm_code):
    """Half way up, where there are no bridges, each tile and anchor is a loop of its own: none is lost
    and none grows together with another. As much is extruded as the bodies hold."""
    folder, report = fdm_print
    loops, volume = loops_and_volume(fdm_code, 2.2)
    block = report["print"]
    with zipfile.ZipFile(folder / "half-sphere-print.3mf") as archive:
        bridges = archive.read("3D/3dmodel.model").decode().count('name="Support ')
    assert loops == block["bodies"] - bridges
    held = 1000 * sum(block[f"{kind}_volume_cm3"] for kind in ("tile", "anchor", "support"))
    assert volume == pytest.approx(held, rel=0.05)


def test_supports_for_the_profile_lie_on_the_side_that_is_glued_second(fdm_print, fdm_code):
    """Level with the back pins on the bed, and nowhere else; the page and the README have them taken away
    when the front membrane holds the tiles."""
    folder, report = fdm_print
    heights = {z for kind, z, _, _ in fdm_code if kind.startswith("Support")}
    assert heights and max(heights) < 0.6 + 1e-6  # H_pin
    assert report["print"]["glue"]["first"] == "front"
    page = html.unescape((folder / "report.html").read_text(encoding="utf-8"))
    steps = re.findall(r"<li>(.*?)</li>", page)
    assert "front side up" in page
    glued, = (k for k, step in enumerate(steps) if step.startswith("Glue the front first"))
    peeled, = (k for k, step in enumerate(steps) if "peel the slicer's supports off the back" in step)
    assert glued < peeled and "slicer's supports lie level" in steps[glued]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert readme.index("the front pins and the anchors") < readme.index("slicer's supports")


def extrusions(code):
    """What is drawn of a G-code: kind, height, whether a line begins, mm3."""
    z, kind, drawing, relative, before = 0.0, "", False, False, 0.0
    for line in code.splitlines():
        if line.startswith(";TYPE:"):
            kind, drawing = line[6:], False
        elif line.startswith("M83"):
            relative = True
        elif line.startswith("G92 E0"):
            before = 0.0
        elif line.startswith("G1 "):
            words = {word[0]: float(word[1:]) for word in line.split(";")[0].split()[1:]}
            z = words.get("Z", z)
            extruded = words.get("E", before if not relative else 0.0) - (0.0 if relative else before)
            before = words.get("E", before)
            draws = extruded > 0 and "X" in words
            if draws:
                yield kind, z, not drawing, extruded * np.pi * (1.75 / 2) ** 2
            drawing = draws


def loops_and_volume(drawn, height):
    """Outer loops of the layer at that height, and mm3 extruded but for supports."""
    loops = sum(begins for kind, z, begins, _ in drawn
                if kind == "External perimeter" and abs(z - height) < 0.05)
    return loops, sum(volume for kind, _, _, volume in drawn if not kind.startswith(("Support", "Skirt")))
