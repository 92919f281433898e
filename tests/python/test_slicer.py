# SPDX-License-Identifier: LGPL-2.1-or-later
"""The print's 3MF as PrusaSlicer takes it: every body stays where it is."""

import re
import shutil
import struct
import subprocess
import zipfile

import numpy as np
import pytest

SLICER = shutil.which("prusa-slicer")
pytestmark = pytest.mark.skipif(not SLICER, reason="there is no prusa-slicer")


# As the window does where it is asked for one object of many parts: PrusaSlicer 2.5 makes an object of
# every component, and would drop each onto the bed.
IN_PLACE = ("--dont-arrange", "--no-ensure-on-bed")


def slicer(folder, *arguments):
    done = subprocess.run([SLICER, "--datadir", folder / "settings", *map(str, arguments)], cwd=folder,
                          capture_output=True, text=True, timeout=500)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def corners_of(path):
    """Corners of the facets of a binary STL, mm."""
    data = path.read_bytes()
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
    facets = np.frombuffer(data, facet, offset=84, count=struct.unpack_from("<I", data, 80)[0])
    return facets["corners"].astype(float)


def farthest(points, others):
    """The largest distance of one of the points from the nearest of the others."""
    return max(np.linalg.norm(others - point, axis=1).min() for point in points)


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
    breakaway = "breakaway" in (print_files / "design.json").read_text()
    assert heights == ({5.0, 0.8} if breakaway else {5.0, 4.7})


def test_it_can_be_sliced(print_files):
    code = print_files / "a.gcode"
    slicer(print_files, "--export-gcode", "--support-material", *IN_PLACE, "--output", code,
           "small-cap-print.3mf")
    heights = [float(z) for z in re.findall(r"^G1 Z([0-9.]+)", code.read_text(), re.MULTILINE)]
    assert 4.5 < max(heights) < 12  # the print is 5 mm high; the nozzle is lifted between parts
