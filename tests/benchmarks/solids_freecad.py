# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tile solids and STEP by this project and by FreeCAD's own means, on the same tiles.

    python tests/benchmarks/solids_freecad.py DESIGN.json [TILES]

FreeCAD's way, for the first TILES tiles (100): a body from its six corners by Part.Shell, two pins fused to
it, without bumps and truncation, then Import.export of named parts. This project's, for all tiles: bodies
with pins and bumps, truncated, and the STEP of the same. Processor milliseconds a tile."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Workbench"))

from curveups.base.native import native  # noqa: E402

SCRIPT = """
import json, sys, time
import FreeCAD, Import, Part
corners, pins, out = json.load(open({given!r}))
V = FreeCAD.Vector

def prism(low, high):
    sides = [(k, (k + 1) % 3) for k in range(3)]
    faces = [low[::-1], high] + [[low[k], low[n], high[n], high[k]] for k, n in sides]
    faces = [Part.Face(Part.makePolygon([V(*p) for p in face + face[:1]])) for face in faces]
    solid = Part.Solid(Part.Shell(faces))
    return solid if solid.Volume > 0 else solid.reversed()

begun = time.process_time()
solids = []
for tile, (front, back) in zip(corners, pins):
    pair = [prism(front[:3], front[3:]), prism(back[:3], back[3:])]
    solids.append(prism(tile[3:], tile[:3]).multiFuse(pair))
made = time.process_time()
document = FreeCAD.newDocument()
parts = []
for number, solid in enumerate(solids):
    part = document.addObject("Part::Feature", "T%05d" % (number + 1))
    part.Shape = solid
    parts.append(part)
shown = time.process_time()
Import.export(parts, out)
written = time.process_time()
json.dump({{"valid": sum(s.isValid() for s in solids), "solids": made - begun, "step": written - shown}},
          open({answer!r}, "w"))
"""


def main() -> None:
    design = native.read_design(Path(sys.argv[1]).read_text(encoding="utf-8"))
    count = min(int(sys.argv[2]) if len(sys.argv) > 2 else 100, len(design.F))
    native.set_thread_count(1)
    with tempfile.TemporaryDirectory() as folder:
        begun = time.process_time()
        model = native.make_print_model(design)
        model.build_solids()
        made = time.process_time()
        model.write("step", "tiles", f"{folder}/own.step")
        written = time.process_time()
        shapes = native.tile_shapes(design)
        given, answer = f"{folder}/tiles.json", f"{folder}/answer.json"
        Path(given).write_text(json.dumps([shapes.flat[:count].tolist(), shapes.flat_pins[:count].tolist(),
                                           f"{folder}/freecad.step"]), encoding="utf-8")
        script = f"{folder}/script.py"
        Path(script).write_text(SCRIPT.format(given=given, answer=answer), encoding="utf-8")
        subprocess.run(["freecadcmd", "-c", f"import runpy; runpy.run_path({script!r}, run_name='__main__')"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       stdin=subprocess.DEVNULL)
        theirs = json.loads(Path(answer).read_text(encoding="utf-8"))
        tiles = len(design.F)
        own = {"solids": (made - begun) / tiles, "step": (written - made) / tiles}
        print(f"{'ms a tile':16} {'FreeCAD':>9} {'own':>9} {'ratio':>7}    {design.name}, {tiles} tiles, "
              f"FreeCAD {count}, {theirs['valid']} valid")
        for what in ("solids", "step"):
            other = theirs[what] / count
            print(f"{what:16} {1e3 * other:9.2f} {1e3 * own[what]:9.2f} {other / own[what]:7.1f}")


if __name__ == "__main__":
    main()
