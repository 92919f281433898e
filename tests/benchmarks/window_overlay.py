#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast the overlay is in FreeCAD's window under software rendering.

    tests/benchmarks/window_overlay.py [--json FILE]

Domes of about 2493 and 10,000 tiles, laid out side by side: no solver has to run. Prints, in ms: build
(arrays to a picture's nodes), an iterate (T and q of a solver), a step of the morph, other colours, a pick;
and frames a second while the camera turns, beside those of an empty view, which are the renderer's own. On
a machine that does other things too, look at the milliseconds of processor time a frame instead.
"""

import json
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from window import freecad_home, run_in_window  # noqa: E402

WORK = """
import json, time
import numpy as np
from pivy import coin

def dome(count):
    # V, F, T and q of a dome of about so many tiles, each of which lies flat, apart from all others.
    from curveups.base.native import native
    V, F = native.builtin_target('cap')
    area = np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1).sum() / 2
    made = native.remesh(V, F, float(np.sqrt(area / count * 4 / np.sqrt(3))))
    V, F = made.V * (7.5 / made.mean_edge), made.F
    corners = V[F]
    along = corners[:, 1] - corners[:, 0]
    length = np.linalg.norm(along, axis=1)
    third = corners[:, 2] - corners[:, 0]
    x = np.einsum('mk,mk->m', third, along) / length
    y = np.sqrt(np.einsum('mk,mk->m', third, third) - x * x)
    T = np.zeros((len(F), 3, 2))
    T[:, 1, 0], T[:, 2, 0], T[:, 2, 1] = length, x, y
    T += 1.4 * corners.mean(1)[:, None, :2]
    q = np.full((len(F), 2, 3), 0.8)
    return V, F, T, q

def median(work, times=9):
    found = []
    for k in range(times):
        start = time.perf_counter()
        work(k)
        found.append(time.perf_counter() - start)
    return 1000 * float(np.median(found))

def frames(view, seconds=3.0):
    # Turns the camera; every frame is drawn before the next one begins.
    camera, widget = view.getCameraNode(), view.graphicsView().viewport()
    turn = coin.SbRotation(coin.SbVec3f(0, 0, 1), 0.05)
    count, start, cpu = 0, time.perf_counter(), time.process_time()
    while time.perf_counter() - start < seconds or count < 5:
        camera.orientation.setValue(camera.orientation.getValue() * turn)
        widget.repaint()
        FreeCADGui.updateGui()
        count += 1
    return {'frames_per_second': count / (time.perf_counter() - start),
            'cpu_ms_per_frame': 1000 * (time.process_time() - cpu) / count}

def work():
    from curveups.features import document as documents
    from curveups.base.native import native
    from curveups.window.overlays import overlay_of
    from curveups.window.overlay.fields import CONTACT, Field
    from curveups.window.overlay.picking import pick
    from curveups.window.overlay.scene import Scene, shapes_of
    document = FreeCAD.newDocument('bench')
    window = FreeCADGui.getMainWindow()
    window.resize(1440, 900)
    window.findChild(QtGui.QMdiArea).activeSubWindow().showMaximized()
    settle(1000)
    view = FreeCADGui.getDocument(document.Name).activeView()
    results = [{'tiles': 0, **frames(view)}]
    design = documents.new_design(document, 'cap')
    settle(300)
    overlay = overlay_of(design)
    cuts, parameters = np.empty((0, 2), np.int32), native.Parameters()
    for count in (2493, 10000):
        V, F, T, q = dome(count)

        def scene():
            shapes = native.tile_shapes_at(V, F, cuts, parameters, T, q)
            values = np.linspace(0, 1, len(shapes.contacts))
            field = Field('Normal force', 'N', CONTACT, lambda: values, 'low', 0.01, 'cross', 'weak')
            return Scene(V, F, cuts, parameters, **shapes_of(shapes, parameters), fields={field.name: field})

        build = median(lambda k: overlay.show_scene(scene()), 3)
        view.viewIsometric()
        view.fitAll()
        settle(500)
        colours = median(lambda k: overlay.set_range((0.01 * k, 1.0)))
        overlay.set_range(None)
        morph = median(lambda k: overlay.set_morph((k + 1) / 10))
        overlay.set_morph(1)
        width, height = view.getSize()
        picked = median(lambda k: pick(view, (width // 2, height // 2), design))
        actuated = frames(view)
        design.ViewObject.Pins = True
        pins = frames(view)
        design.ViewObject.Pins = False
        overlay.set_morph(0)
        iterate = median(lambda k: overlay.set_iterate(T * (1 + 0.01 * k), q))
        results.append({'tiles': len(F), 'build_ms': build, 'iterate_ms': iterate, 'morph_ms': morph,
                        'colours_ms': colours, 'pick_ms': picked, **actuated,
                        **{name + '_with_pins': value for name, value in pins.items()}})
        overlay.show_scene(None)
    open(results_file, 'w').write(json.dumps(results))
"""


def main() -> None:
    """Runs it and prints the table."""
    arguments = sys.argv[1:]
    if arguments and (len(arguments) != 2 or arguments[0] != "--json"):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as place:
        found = Path(place) / "results.json"
        home = freecad_home(Path(place) / "home", True)
        run_in_window(WORK, home, place, results_file=found)
        results = json.loads(found.read_text("utf-8"))
    for row in results:
        print(f"{row['tiles']:6d} tiles: "
              + ", ".join(f"{name} {value:.1f}" for name, value in row.items() if name != "tiles"))
    if arguments:
        Path(arguments[1]).write_text(json.dumps(results, indent=1) + "\n")


if __name__ == "__main__":
    main()
