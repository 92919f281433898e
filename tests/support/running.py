# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start of the program, and a small target, for all Python tests."""

import math
import os
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# The interpreter of the tests: in FreeCAD sys.executable is FreeCAD.
PYTHON = os.environ.setdefault("CURVEUPS_PYTHON", sys.executable)
if "FreeCAD" not in sys.modules:  # FreeCAD finds the package by itself
    sys.path.insert(0, str(ROOT / "Workbench"))


@dataclass
class Ran:
    status: int
    out: str
    err: str

    @property
    def error_lines(self):
        return [line for line in self.err.splitlines() if line.startswith("curveups: error: ")]


def call_main(*arguments, cwd=None):
    """Run the command line in this process and return its status and what it printed.

    Standard output and error are taken at their descriptors, since the program hands its own on."""
    from curveups.cli import main

    folder = os.getcwd()
    kept = [os.dup(1), os.dup(2)]
    streams = sys.stdout, sys.stderr
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        try:
            for number, file in ((1, out), (2, err)):
                os.dup2(file.fileno(), number)
            sys.stdout, sys.stderr = (open(number, "w", encoding="utf-8", closefd=False) for number in (1, 2))
            os.chdir(cwd or folder)
            try:
                status = main([str(argument) for argument in arguments])
            except SystemExit as ended:  # --help and --version
                status = int(ended.code or 0)
            sys.stdout.flush()
            sys.stderr.flush()
        finally:
            sys.stdout, sys.stderr = streams
            os.chdir(folder)
            for number, duplicate in zip((1, 2), kept):
                os.dup2(duplicate, number)
                os.close(duplicate)
        printed = []
        for file in (out, err):
            file.seek(0)
            printed.append(file.read().decode("utf-8", "replace"))
    return Ran(status, *printed)


def command(*arguments):
    return [PYTHON, "-m", "curveups.cli", *map(str, arguments)]


def environment(**more):
    return {**os.environ, "PYTHONPATH": str(ROOT / "Workbench"), **more}


def dome(rings, radius=40.0, edge=8.0):
    """OBJ text of a spherical cap of 6 rings^2 triangles, counter-clockwise from outside."""
    vertices = [(0.0, 0.0, radius)]
    for ring in range(1, rings + 1):
        polar = ring * edge / radius
        for k in range(6 * ring):
            angle = 2 * math.pi * k / (6 * ring)
            vertices.append((radius * math.sin(polar) * math.cos(angle),
                             radius * math.sin(polar) * math.sin(angle),
                             radius * math.cos(polar)))

    def index(ring, k):
        return 0 if ring == 0 else 1 + 3 * ring * (ring - 1) + k % (6 * ring)

    faces = []
    for ring in range(1, rings + 1):
        for sector in range(6):
            for j in range(ring):
                outer = sector * ring + j
                inner = sector * (ring - 1) + j
                faces.append((index(ring, outer), index(ring, outer + 1), index(ring - 1, inner)))
                if j < ring - 1:
                    faces.append((index(ring - 1, inner), index(ring, outer + 1),
                                  index(ring - 1, inner + 1)))
    return "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in vertices) + "".join(
        f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces)
