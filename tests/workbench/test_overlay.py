# SPDX-License-Identifier: LGPL-2.1-or-later
"""The overlay in FreeCAD's window: its pictures, the mouse on it, and choices that outlive a document."""

import dataclasses
import gc
import weakref

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from curveups.features import document as documents
from curveups.window.overlay import colours, legend as parts, showing
from curveups.window.overlay.picking import pick
from curveups.window.overlays import overlay_of, overlays
from pivy import coin
from robot import QtCore, QtGui, settle, until
from steps import LIVE

pytestmark = pytest.mark.freecad(window=True)


def opened(path):
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    document = FreeCAD.openDocument(str(path))
    window = FreeCADGui.getMainWindow()
    window.resize(1400, 880)
    area = window.findChild(QtGui.QMdiArea)
    for child in area.subWindowList():
        if document.Label not in child.windowTitle():
            child.close()
    area.activeSubWindow().showMaximized()
    settle(600)
    design = document.Design
    showing.show_flat(design)
    settle(800)
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.setAnimationEnabled(False) if hasattr(view, "setAnimationEnabled") else None
    view.viewTop()
    view.fitAll()
    settle(300)
    overlay = overlay_of(design)
    assert overlay.scene is not None, overlay.note
    return document, design, view, overlay


def size(view):
    region = view.getViewer().getSoRenderManager().getViewportRegion()
    return tuple(region.getViewportSizePixels())


def pixel_of(view, point):
    """Pixel of a point, from the lower left corner."""
    volume = view.getCameraNode().getViewVolume(size(view)[0] / size(view)[1])
    x, y, _ = volume.projectToScreen(coin.SbVec3f(*map(float, point))).getValue()
    return x * size(view)[0], y * size(view)[1]


def picture_of(view, pictures, name):
    """Picture of the view, in its own pixels."""
    path = str(pictures / f"{name}.png")
    view.saveImage(path, *size(view), "White")
    image = QtGui.QImage(path)
    assert image.width() == size(view)[0]
    return image


def colour(image, pixel):
    x, y = pixel
    return np.array(QtGui.QColor(image.pixel(int(x), int(image.height() - y))).getRgbF()[:3])


def mouse(view, pixel, *kinds):
    widget = view.graphicsView().viewport()
    ratio = widget.devicePixelRatioF()
    point = QtCore.QPointF(pixel[0] / ratio, widget.height() - pixel[1] / ratio)
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    for kind in kinds:
        held = {"MouseButtonRelease": none, "MouseMove": none, "Drag": left}.get(kind, left)
        button = none if kind in ("MouseMove", "Drag") else left
        event = QtGui.QMouseEvent(getattr(QtCore.QEvent, "MouseMove" if kind == "Drag" else kind), point,
                                  widget.mapToGlobal(point.toPoint()), button, held, QtCore.Qt.NoModifier)
        QtCore.QCoreApplication.sendEvent(widget, event)
        settle(60)


def click_on(view, pixel):
    mouse(view, pixel, "MouseMove", "MouseButtonPress", "MouseButtonRelease")


def picked(view, pixel, design):
    picked_tile = pick(view, pixel, design)
    assert picked_tile is not None
    return picked_tile


def third(corners, tile, edge):
    """The middle of the third of a tile's front that belongs to an edge."""
    front = corners[tile, :3]
    return (front[edge] + front[(edge + 1) % 3] + front.mean(0)) / 3


def test_colours_are_those_of_the_values(dome_document, pictures):
    document, design, view, overlay = opened(dome_document)
    design.ViewObject.ColourMap = "Viridis"
    assert overlay.fields()[:2] == ["Normal force", "Friction ratio"], overlay.fields()
    overlay.set_field("Normal force")
    field, scene = overlay.field(), overlay.scene
    image = picture_of(view, pictures, "flat")
    for number, share in ((field.order[0], 0), (field.order[-1], 1)):
        expected = colours.sample("Viridis", np.array(share))
        for k in (0, 1):
            point = third(overlay.figures()[0][0], scene.contacts[number, k], scene.sides[number, k])
            rgb = colour(image, pixel_of(view, point))
            shade = rgb.max() / expected.max()  # the lights of FreeCAD 1 are dimmer
            assert 0.7 < shade < 1.15, (number, rgb, expected)
            assert np.abs(rgb - shade * expected).max() < 0.13, (number, rgb, expected)
    # A contact is drawn beside its edge and nowhere else: at the boundary there is none.
    sides = {(int(t), int(e)) for t, e in zip(scene.contacts.ravel(), scene.sides.ravel())}
    free = next((t, e) for t in range(len(scene.F)) for e in range(3) if (t, e) not in sides)
    rgb = colour(image, pixel_of(view, third(overlay.figures()[0][0], *free)))
    assert np.ptp(rgb) < 0.05, rgb
    # Another range, another colour; another field, another picture; none, a plain one.
    overlay.set_range((field.values.max() * 2, field.values.max() * 3))
    assert picture_of(view, pictures, "range") != image
    overlay.set_field("Gap")
    gap = picture_of(view, pictures, "gap")
    overlay.set_field("None")
    assert gap != image and picture_of(view, pictures, "plain") != gap and overlay.legend.content is None
    # The target shape; both; pins.
    showing.show_actuated(design)
    settle(1000)
    assert overlay.morph() == 1
    assert np.array_equal(overlay.figures()[0][0], scene.actuated)
    actuated = picture_of(view, pictures, "actuated")
    design.ViewObject.Pins = True
    assert picture_of(view, pictures, "pins") != actuated
    design.ViewObject.Both = True
    (flat, _), (other, shift) = overlay.figures()
    assert np.array_equal(flat, scene.flat) and np.array_equal(other, scene.actuated)
    assert (other + shift)[..., 0].min() > flat[..., 0].max()
    # Half-way every tile is as it was.
    design.ViewObject.Both = False
    overlay.set_morph(0.5)
    half = overlay.figures()[0][0]

    def edges(corners):
        return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    assert np.abs(edges(half) - edges(scene.flat)).max() < 1e-9
    # Problems are marked by a shape on a white disc, and counted in the legend.
    overlay.set_morph(0)
    design.ViewObject.Pins = False
    weak = dataclasses.replace(field, limit=float(np.sort(field.values)[3]))
    overlay.show_scene(dataclasses.replace(scene, fields={**scene.fields, field.name: weak}))
    assert 0 < len(weak.problems) <= 3
    content = overlay.legend.content
    assert content is not None
    assert content.marks == (("cross", f"contacts below f_min: {len(weak.problems)}"),)
    marked = picture_of(view, pictures, "marked")
    for point in scene.places(weak, weak.problems, scene.flat):
        x, y = pixel_of(view, point)
        near = np.array([colour(marked, (x + dx, y + dy)) for dx in range(-4, 5) for dy in range(-4, 5)])
        assert (near > 0.99).all(axis=1).sum() > 15, "no disc"
        assert (np.abs(near - colours.MARK).max(axis=1) < 0.05).sum() > 5, "no cross"


@pytest.mark.parametrize("screen", [
    "usual", pytest.param("4K", marks=[pytest.mark.all, pytest.mark.freecad(window="4K")])])
def test_the_legend_stands_on_its_paper(screen, dome_document, pictures):
    document, design, view, overlay = opened(dome_document)
    if screen == "4K":
        window = FreeCADGui.getMainWindow()
        window.resize(3800, 2060)
        settle(500)
        if parts.scale() == 1 and int(QtCore.qVersion().split(".")[0]) > 5:
            pytest.skip("Qt 6 does not scale by this display's resolution")
        assert parts.scale() == 2
    overlay.set_field("Friction ratio")
    design.Tau = 2.9  # says that the values are old
    document.recompute()
    settle(500)
    camera = coin.cast(view.getCameraNode(), "SoOrthographicCamera")
    camera.height = 50 * camera.height.getValue()  # nothing else is near
    image, scale, legend = picture_of(view, pictures, "legend"), parts.scale(), overlay.legend
    dark = np.array([[QtGui.qGray(image.pixel(x, y)) < 100 for x in range(int(600 * scale))]
                     for y in range(image.height())])
    columns = np.flatnonzero(dark.any(axis=0))
    paper = scale * np.array([parts.LEFT - 16, parts.LEFT - 16 + legend.width])
    assert paper[0] <= columns[0] and columns[-1] <= paper[1] - 6 * scale, (columns[[0, -1]], paper)
    assert columns[-1] > paper[1] - 40 * scale, "the paper is too wide"


def test_picking_gives_tiles_and_edges(dome_document, pictures):

    def selected():
        return [(obj.ObjectName, *obj.SubElementNames) for obj in FreeCADGui.Selection.getSelectionEx()]

    document, design, view, overlay = opened(dome_document)
    scene = overlay.scene
    for tile, edge in ((0, 0), (17, 1), (53, 2)):
        pixel = pixel_of(view, third(overlay.figures()[0][0], tile, edge))
        click_on(view, pixel)
        assert selected() == [("Design", f"T{tile + 1:05d}")], (tile, selected())
        assert overlay.selected == [tile]
        until(lambda: "Normal force" in QtGui.QToolTip.text(), 5, "its values at the pointer")
        point = picked(view, pixel, design)
        assert point.vertices == (scene.F[tile, edge], scene.F[tile, (edge + 1) % 3])
        assert np.abs(point.point - third(overlay.figures()[0][0], tile, edge)).max() < 0.2, point.point
    width, height = size(view)
    assert pick(view, (width - 3, 3), design) is None
    # The same tile lights up wherever it is drawn, and is picked there.
    design.ViewObject.Both = True
    view.fitAll()
    settle(200)
    before = picture_of(view, pictures, "before")
    overlay.select_tiles([20])
    settle(200)
    after = picture_of(view, pictures, "after")
    for corners, shift in overlay.figures():
        pixel = pixel_of(view, third(corners, 20, 0) + shift)
        lit, was = colour(after, pixel), colour(before, pixel)
        number = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View").GetUnsigned(
            "SelectionColor", 0x1CAD1CFF)
        wanted = np.array([number >> bits & 255 for bits in (24, 16, 8)]) / 255
        shade = lit.max() / wanted.max()
        assert np.abs(lit - was).max() > 0.1 and np.abs(lit - shade * wanted).max() < 0.2, (lit, was, wanted)
        assert set(picked(view, pixel, design).vertices) < set(scene.F[20])
        FreeCADGui.Selection.clearSelection()  # a second click takes the whole design, as FreeCAD does
        click_on(view, pixel)
        assert selected() == [("Design", "T00021")], selected()
    # A design that is selected as a whole keeps its colours; one that is moved is picked where it is.
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(design)
    settle(200)
    corners, shift = overlay.figures()[0]
    pixel = pixel_of(view, third(corners, 20, 0))
    assert np.abs(colour(picture_of(view, pictures, "whole"), pixel) - colour(before, pixel)).max() < 0.1
    design.Placement.Base = FreeCAD.Vector(30, 20, 0)
    settle(200)
    pixel = pixel_of(view, third(corners, 20, 0) + [30, 20, 0])
    point = picked(view, pixel, design)
    assert set(point.vertices) < set(scene.F[20])
    assert np.abs(point.point - third(corners, 20, 0) - [30, 20, 0]).max() < 0.2


def test_what_is_chosen_is_kept_in_the_document(dome_document, tmp_path, pictures):
    copy = str(tmp_path / "copy.FCStd")
    document, design, view, overlay = opened(dome_document)
    overlay.set_field("Normal force")
    low, high = overlay.range()
    kept = (low + high) / 2, high
    overlay.set_range(kept)
    assert overlay.range() == kept and overlay.legend.content.low == kept[0]
    overlay.set_field("Gap")
    assert overlay.range() != kept
    overlay.set_field("Normal force")
    overlay.set_morph(0.25)
    design.ViewObject.Pins = True
    design.ViewObject.ColourMap = "Cividis"
    document.saveAs(copy)
    FreeCAD.closeDocument(document.Name)
    settle(200)
    assert overlays() == [] and overlay.closed
    again = FreeCAD.openDocument(copy)
    overlay = until(lambda: overlay_of(again.Design).scene and overlay_of(again.Design), 10, "the picture")
    view_provider = again.Design.ViewObject
    assert overlay.field().name == "Normal force", overlay.note
    assert overlay.range() == kept and overlay.morph() == 0.25
    assert view_provider.Pins and view_provider.ColourMap == "Cividis"
    overlay.set_range(None)
    assert overlay.range() == (low, high), overlay.range()


def test_it_follows_document_solver_and_panels(dome_document, pictures):

    def spread(image):
        # How far apart colours are in the middle of a picture.
        wide, high = image.width() // 60, image.height() // 60
        pixels = [colour(image, (x * wide, y * high)) for x in range(20, 40) for y in range(20, 40)]
        return float(np.std([np.ptp(rgb) for rgb in pixels if np.ptp(rgb) > 0.02] or [0]))

    document, design, view, overlay = opened(dome_document)
    before = overlay.scene
    overlay.set_field("Normal force")
    # Geometry: the picture at once, and what was computed for another one says so.
    design.HBody = 2.0
    document.recompute()
    settle(300)
    assert overlay.scene is not before and overlay.note == ""
    assert np.allclose(overlay.scene.flat[:, 0, 2] - overlay.scene.flat[:, 3, 2], 2.0)
    notes = overlay.legend.content.notes
    assert any(note.startswith("out of date") and "HBody" in note for note in notes), notes
    assert overlay.legend.content.faded and "HBody" in overlay.age(overlay.field())
    # What can't be built leaves the last picture, with the reason.
    shown = overlay.scene
    design.HBody = 45.0
    document.recompute()
    settle(300)
    assert overlay.scene is shown and "back faces vanish" in overlay.note, overlay.note
    assert any("back faces vanish" in note for note in overlay.legend.content.notes)
    design.HBody = 3.0
    document.recompute()
    settle(300)
    assert overlay.note == "" and overlay.age(overlay.field()) == "" and not overlay.legend.content.faded
    assert np.allclose(overlay.scene.flat, before.flat)
    # So does a layout that is out of date, by a parameter or by its cuts, in every field of it: pale, and
    # without marks. A redraw is not needed for that.
    lively = picture_of(view, pictures, "lively")
    edge = [int(v) for v in overlay.scene.F[0][:2]]
    changes = {"Tau": (lambda: setattr(design, "Tau", 2.5), lambda: setattr(design, "Tau", 3.0)),
               "Scale": (lambda: setattr(design, "Scale", 1.1), lambda: setattr(design, "Scale", 1.0)),
               "cuts": (lambda: documents.set_cuts(design, [edge]), lambda: documents.set_cuts(design, []))}
    for said, (change, back) in changes.items():
        change()
        document.recompute()
        settle(300)
        assert design.Verdict == "out of date"
        for name in ("Normal force", "Gap"):
            overlay.set_field(name)
            content = overlay.legend.content
            assert content.faded and not content.marks, content
            assert any(note.startswith("out of date") and said in note for note in content.notes), content
        overlay.set_field("Normal force")
        pale = picture_of(view, pictures, "stale-" + said)
        assert spread(pale) < 0.5 * spread(lively), (spread(pale), spread(lively))
        back()
        document.recompute()
        settle(300)
        assert not overlay.legend.content.faded
        assert spread(picture_of(view, pictures, "again")) == spread(lively)
    notes = overlay.legend.content.notes
    assert any(note.startswith("of the verified layout") and "Tau = 3" in note for note in notes), notes
    # What a solver has at hand, and the end of that.
    native_design = documents.design_project_of(design).latest("design").design
    T, q = np.asarray(native_design.T), np.asarray(native_design.q)
    overlay.set_iterate(T + 5.0, q)
    assert np.allclose(overlay.figures()[0][0][:, :3, :2], T + 5.0)
    assert "Gap" not in overlay.fields()
    overlay.set_iterate(T[:5], q[:5])  # of other tiles: left out
    assert len(overlay.scene.F) == len(T)
    overlay.show_design()
    assert np.allclose(overlay.scene.flat, before.flat) and "Gap" in overlay.fields()
    # Two panels.
    FreeCADGui.runCommand("CurveUps_WorstContacts")
    settle(300)
    rows = FreeCADGui.getMainWindow().findChild(QtGui.QTableWidget, "rows")
    field = overlay.field()
    assert rows.rowCount() == len(field.order)
    rows.selectRow(0)
    settle(300)
    assert sorted(overlay.selected) == sorted(overlay.scene.contacts[field.order[0]])
    FreeCADGui.Control.closeDialog()
    settle(100)
    FreeCADGui.runCommand("CurveUps_Overlay")
    settle(300)
    slider = FreeCADGui.getMainWindow().findChild(QtGui.QSlider, "morph")
    slider.setValue(slider.maximum() // 2)
    settle(100)
    assert overlay.morph() == 0.5
    # Nothing is left of a design that is deleted, and its panel goes.
    document.openTransaction("delete")
    document.removeObject("Design")
    document.commitTransaction()
    settle(300)
    assert overlay.closed and not FreeCADGui.Control.activeDialog()
    # ... but comes back with it.
    document.undo()
    settle(500)
    again = overlay_of(document.Design)
    assert not again.closed and again.scene is not None and again.legend.content is not None, again.note
    again.select_tiles([7])
    settle(100)
    assert again.selected == [7]


def test_solids_and_membranes_come_when_they_are_asked_for(dome_document, monkeypatch, pictures):
    document, design, view, overlay = opened(dome_document)

    def shown():
        return [name for name in ("Design", "Target", "Tiles", "Support", "Anchors")
                if document.getObject(name).ViewObject.Visibility]

    assert shown() == ["Design"], shown()
    flat = picture_of(view, pictures, "flat")
    # Solids only when they are asked for.
    FreeCADGui.runCommand("CurveUps_ShowSolids")
    until(lambda: "Tiles" in shown())
    assert shown() == ["Tiles", "Anchors"], shown()
    settle(300)
    assert picture_of(view, pictures, "solids") != flat
    FreeCADGui.runCommand("CurveUps_ShowActuated")
    until(lambda: overlay.morph() == 1)
    assert shown() == ["Design"], shown()
    # Membranes: computed when they are first asked for, drawn in both states and between, coloured.
    FreeCADGui.runCommand("CurveUps_Overlay")
    settle(300)
    without = picture_of(view, pictures, "without")
    assert "Membrane stretch" not in overlay.fields()
    FreeCADGui.getMainWindow().findChild(QtGui.QCheckBox, "membranes").setChecked(True)
    until(lambda: not LIVE.busy)
    settle(300)
    assert "Membrane stretch" in overlay.fields() and len(overlay.scene.membranes) == 2
    assert picture_of(view, pictures, "membranes") != without
    front, back = overlay.scene.membranes
    assert np.allclose(front.flat[:, 2], 5) and np.allclose(back.flat[:, 2], 0)  # on the pins' ends
    for sheet in (front, back):
        at_ends = [overlay.scene.membrane_at(sheet, t) for t in (0, 1e-12, 1 - 1e-12, 1)]
        assert np.allclose(at_ends[0], at_ends[1]) and np.allclose(at_ends[2], at_ends[3])
    overlay.set_field("Membrane stretch")
    assert 1 < overlay.range()[0] < overlay.range()[1] < 6, overlay.range()
    # They go with what they were computed for.
    design.HBody = 2.5
    document.recompute()
    settle(300)
    assert overlay.scene.membranes == () and "Membrane stretch" not in overlay.fields()


def test_it_goes_with_its_document(dome_document):
    """A deleted overlay is freed at once, not when Python collects garbage in the middle of a run."""
    document, *_, overlay = opened(dome_document)
    seen = weakref.ref(overlay)
    del _, overlay
    gc.disable()
    try:
        FreeCAD.closeDocument(document.Name)
        until(lambda: seen() is None, 5, "its end")
    finally:
        gc.enable()
