# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the beam formulas of a stretching ring with CalculiX (ccx): a ring in one part as bricks, whose
sheet pulls at the middle of each tooth of the sides. Run with the Python and paths of build/python.env:

    python tests/benchmarks/ring_calculix.py [WIDTH HEIGHT of the print, mm]...
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from curveups.base.native import native
from curveups.kit import ring as rings
from curveups.stages.sheets import sheets

BED, PRINT = (1e4, 1e4), 5.0
STEP = 3.75  # mm, a quarter of the teeth's pitch


def main() -> None:
    sizes = [float(word) for word in sys.argv[1:]] or [195.4, 194.3, 505.0, 396.6]
    for box in zip(sizes[::2], sizes[1::2]):
        block = sheets(box, native.Parameters())
        ring = rings.rings(block, PRINT, BED)
        inwards, out = solve(block, ring)
        front = ring["front"]
        print(f"{box[0]:g} x {box[1]:g} mm, {ring['thickness_mm']:g} mm thick, {ring['teeth']} teeth; "
              f"bends {pair(front['bends_mm'])} mm (CalculiX {pair(inwards)}), "
              f"rises {pair(front['rises_mm'])} mm ({pair(out)})")


def pair(values) -> str:
    return " and ".join(f"{value:.3f}" for value in values)


def solve(block, ring):
    """mm by which the middles of sides along x and y bend inwards, and by which their inner edges leave the
    plane of the corners' middles."""
    width, thickness, outer = ring["width_mm"], ring["thickness_mm"], np.array(ring["outer_mm"])
    counts = np.append(np.rint(outer / STEP), 4).astype(int)
    edge = round(width / STEP)
    shape = counts + 1

    def number(i, j, k):
        return 1 + i + shape[0] * (j + shape[1] * k)

    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    bricks = [[number(i + a, j + b, k + c) for c in (0, 1) for a, b in corners]
              for k in range(counts[2]) for j in range(counts[1]) for i in range(counts[0])
              if min(i, j, counts[0] - 1 - i, counts[1] - 1 - j) < edge]
    used = sorted({node for brick in bricks for node in brick})
    size = np.array([STEP, STEP, thickness / counts[2]])
    place = {node: np.array(np.unravel_index(node - 1, shape, order="F")) * size for node in used}
    loads = {}
    pull = block["load_n"]["front"][0] / block["window_mm"][1] * block["tooth_pitch_mm"] / block["tooth_rows"]
    for tooth in rings.teeth(block, "front"):
        for axis in (0, 1):
            # Teeth of the sides that end the sheet along this axis; the corners' sheet is slack.
            across, along = tooth[axis], tooth[1 - axis]
            if width <= across <= outer[axis] - width or not width <= along <= outer[1 - axis] - width:
                continue
            inward = 1 if across < width else -1
            node = np.rint(tooth / STEP).astype(int)
            loads[number(*node, counts[2]), axis + 1] = pull * inward
            # The pull is half a tooth above the face: a pair of forces beside it.
            for sign in (-1, 1):
                beside = node.copy()
                beside[axis] += sign
                key = number(*beside, counts[2]), 3
                lift = inward * pull * ring["tooth_height_mm"] / 2 / (2 * STEP)
                loads[key] = loads.get(key, 0.0) - sign * lift
    ends = [number(i, j, 0) for i, j in ((0, 0), (counts[0], 0), (counts[0], counts[1]), (0, counts[1]))]
    lines = ["*NODE,NSET=ALL", *(f"{node},{p[0]:.9g},{p[1]:.9g},{p[2]:.9g}" for node, p in place.items()),
             "*ELEMENT,TYPE=C3D8I,ELSET=ALL",
             *(f"{number},{','.join(map(str, brick))}" for number, brick in enumerate(bricks, 1)),
             "*MATERIAL,NAME=PLASTIC", "*ELASTIC", f"{rings.MODULUS},{rings.POISSON}",
             "*SOLID SECTION,ELSET=ALL,MATERIAL=PLASTIC",
             "*BOUNDARY", *(f"{node},3" for node in ends[:3]), f"{ends[0]},1,2", f"{ends[1]},2",
             "*STEP", "*STATIC", "*CLOAD",
             *(f"{node},{axis},{force:.9g}" for (node, axis), force in loads.items()),
             "*NODE PRINT,NSET=ALL", "U", "*END STEP"]
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "ring.inp").write_text("\n".join(lines) + "\n")
        subprocess.run(["ccx", "ring"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        text = (Path(folder) / "ring.dat").read_text().splitlines()
    moved = {int(words[0]): np.array(words[1:], float)
             for line in text if len(words := line.split()) == 4 and words[0].isdigit()}

    def mean(i, j):
        return sum(moved[number(i, j, k)] for k in range(shape[2])) / shape[2]

    half, middle = edge // 2, counts // 2
    corner = sum(mean(i, j) for i in (half, counts[0] - half) for j in (half, counts[1] - half)) / 4
    found = []
    for axis in (0, 1):
        inner, centre, opposite = [middle[0]] * 2, [middle[0]] * 2, [middle[0]] * 2
        inner[axis] = centre[axis] = opposite[axis] = middle[axis]
        inner[1 - axis], centre[1 - axis], opposite[1 - axis] = edge, half, counts[1 - axis] - half
        bent = (mean(*centre) - mean(*opposite))[1 - axis] / 2
        # The corners' own shortening is no bending.
        ends = [[half, half], [half, half]]
        ends[1][1 - axis] = counts[1 - axis] - half
        bent -= (mean(*ends[0]) - mean(*ends[1]))[1 - axis] / 2
        found.append((bent, abs(mean(*inner)[2] - corner[2])))
    return [one for one, _ in found], [one for _, one in found]


if __name__ == "__main__":
    main()
