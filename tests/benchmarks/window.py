# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast the window answers: one design of some 2500 tiles in FreeCAD on a virtual display, drawn by
software. Called by tools/bench --window; status 1 where a goal is missed.

    window.py [--scale S] [--json FILE]

Each figure is the seconds that a user waits, to the last event of the window's loop. Pauses are the
longest time in which a timer of 5 ms did not come.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from window import freecad_home, run_in_window  # noqa: E402

# What, unit, goal, and whether less is better.
GOALS = {
    "solving": ("s", None, True),
    "longest pause while solving, live pictures": ("ms", 100, True),
    "longest pause while solving, no pictures": ("ms", 50, True),
    "preview of a new thickness": ("s", 0.5, True),
    "solids": ("s", 2.0, True),
    "undo": ("s", 0.3, True),
    "opening": ("s", 3.0, True),
    "frames a second, flat": ("", 25, False),
    "frames a second, actuated": ("", 25, False),
}

WORK = """
import json, time

def seconds(work):
    start = time.perf_counter()
    work()
    while QtGui.QApplication.hasPendingEvents():
        QtGui.QApplication.processEvents()
    return time.perf_counter() - start

class Pauses:
    # Longest time without a beat of the window's loop.
    def __enter__(self):
        self.longest, self.last = 0.0, time.perf_counter()
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(lambda: self.beat())
        self.timer.start(5)
        return self

    def beat(self):
        now = time.perf_counter()
        self.longest, self.last = max(self.longest, now - self.last), now

    def __exit__(self, *_):
        self.timer.stop()

def solve(design, pictures):
    from curveups.window import preferences, runs
    from curveups.window.run import LIVE
    preferences.group().SetBool("DrawLive", pictures)
    with Pauses() as pauses:
        runs.start('solve', design)
        while LIVE.busy:
            settle(50)
            if not LIVE.busy:
                break
            running = pauses.longest  # what follows is the document's
    return running

def canvas_of_view():
    area = FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea)
    return area.activeSubWindow().findChild(QtGui.QGraphicsView).viewport()

def thickness(overlay):
    # mm, of the tiles as they are drawn
    corners = overlay._picture.corners
    return ((corners[:, :3].mean(axis=1) - corners[:, 3:].mean(axis=1)) ** 2).sum(axis=1).mean() ** 0.5

def frames(view):
    canvas = canvas_of_view()
    camera, count, start = view.getCameraNode(), 0, time.perf_counter()
    from pivy import coin
    while time.perf_counter() - start < 4:
        turn = coin.SbRotation(coin.SbVec3f(0, 0, 1), 0.02)
        camera.orientation = camera.orientation.getValue() * turn
        canvas.repaint()
        QtGui.QApplication.processEvents()
        count += 1
    return count / (time.perf_counter() - start)

def work():
    from curveups.features.actions import build_solids
    from curveups.features.document import new_design
    from curveups.window.overlays import overlay_of
    window = FreeCADGui.getMainWindow()
    window.resize(1440, 900)
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    found = {}
    document = FreeCAD.newDocument('Large')
    settle(300)
    design = new_design(document, 'half-sphere')
    design.Scale = float(scale)
    document.recompute()
    start = time.perf_counter()
    found['longest pause while solving, live pictures'] = 1000 * solve(design, True)
    found['solving'] = time.perf_counter() - start
    assert design.Verdict == 'valid', (design.Verdict, list(design.Reasons))
    found['tiles'] = design.TileCount
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    settle(500)
    overlay_of(design).set_morph(0)
    found['frames a second, flat'] = frames(view)
    overlay_of(design).set_morph(1)
    found['frames a second, actuated'] = frames(view)
    found['solids'] = seconds(lambda: build_solids(design))

    canvas, before = canvas_of_view(), thickness(overlay_of(design))

    def edit():
        # As the property editor does it.
        document.openTransaction('Edit HBody')
        design.HBody = design.HBody.Value + 0.2
        document.recompute()
        document.commitTransaction()
        FreeCADGui.updateGui()
        canvas.repaint()

    start = time.perf_counter()
    edit()
    found['preview of a new thickness'] = time.perf_counter() - start
    assert 0.1 < thickness(overlay_of(design)) - before < 0.3  # it is what was drawn
    settle(6000)  # solids may follow
    found['undo'] = seconds(lambda: (document.undo(), FreeCADGui.updateGui()))
    settle(6000)
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    settle(300)
    found['opening'] = seconds(lambda: (FreeCAD.openDocument(path), FreeCADGui.updateGui()))
    document = FreeCAD.ActiveDocument
    design = next(obj for obj in document.Objects if obj.Name == 'Design')
    assert design.Verdict == 'valid', (design.Verdict, list(design.Reasons))
    settle(3000)  # views of shapes follow, a quarter of a second each
    design.Tau = design.Tau * 0.99
    document.recompute()
    found['longest pause while solving, no pictures'] = 1000 * solve(design, False)
    with open(figures, 'w') as file:
        json.dump(found, file)
"""


def measure(scale: float) -> dict[str, float]:
    """Figures that GOALS names, and the number of tiles."""
    with tempfile.TemporaryDirectory() as place:
        home, figures = freecad_home(Path(place) / "home", True), Path(place) / "figures.json"
        run_in_window(WORK, home, place, timeout=900, scale=scale, path=Path(place) / "large.FCStd",
                      figures=figures)
        return json.loads(figures.read_text("utf-8"))


def missed(found: dict[str, float]) -> list[str]:
    """Names of the goals that are not reached."""
    return [name for name, (_, goal, less) in GOALS.items()
            if goal is not None and (found[name] > goal if less else found[name] < goal)]


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/bench --window", description="How fast the window answers.")
    parser.add_argument("--scale", type=float, default=1.9, help="of the half-sphere: 1.9 has 2480 tiles")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures there too")
    options = parser.parse_args()
    found = measure(options.scale)
    if options.json:
        options.json.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    late = missed(found)
    print(f"{found['tiles']:.0f} tiles, drawn by software; {os.cpu_count()} cores, on which "
          f"{os.getloadavg()[1]:.1f} programs ran meanwhile")
    for name, (unit, goal, less) in GOALS.items():
        aim = "" if goal is None else f"{'at most' if less else 'at least'} {goal} {unit}".rstrip()
        print(f"{name:45} {found[name]:8.2f} {unit:3} {aim:18} {'MISSED' if name in late else ''}".rstrip())
    return 1 if late else 0


if __name__ == "__main__":
    sys.exit(main())
