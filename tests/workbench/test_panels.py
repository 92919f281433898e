# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels and legends follow other designs, the unit schema and scripts; FreeCAD is quit in mid-run."""

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
import robot
from curveups.base.findings import Finding
from curveups.base.parameters import with_values
from curveups.features import document as designs, properties
from curveups.features.design import stored
from curveups.window.notice import shown
from curveups.window.overlay import legend
from curveups.window.overlay.fields import design_fields
from curveups.window.overlays import overlay_of
from curveups.window.panel import show
from curveups.window.solve import SolvePanel
from robot import click, click_item, cut_off, display, picture, QtGui, settle, tidy, until, widget
from steps import enter, in_units, LIVE, opened, quit_freecad

pytestmark = pytest.mark.freecad(window=True)


def show_units(schema):
    """The window shows the units of that schema, and has noticed."""
    in_units(schema)
    settle(300)


def test_legends_of_two_designs_stand_side_by_side(dome_document, pictures):
    document, design = opened(dome_document)
    first = overlay_of(design)
    other = document.copyObject(design, True)
    other.Label, other.Placement.Base = "The other", (150, 0, 0)
    tidy()
    for obj in (design, other):
        obj.Tiles.ViewObject.Visibility = obj.Anchors.ViewObject.Visibility = False
        obj.ViewObject.Visibility = True
    settle(500)
    left, right = first.legend, overlay_of(other).legend
    assert left.content is not None and right.content is not None
    assert left.left + left.width <= right.left, (left.left, left.width, right.left)
    assert (left.heading, right.heading) == (design.Label, "The other")
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    assert picture("two") > 12
    # One that is alone needs no name and stands where it always did.
    other.ViewObject.Visibility = False
    settle(300)
    assert left.heading == "" and left.left == legend.LEFT
    other.ViewObject.Visibility = True
    settle(300)
    assert left.heading and right.left > left.left
    document.removeObject(design.Name)
    settle(300)
    assert right.heading == "" and right.left == legend.LEFT


def test_another_unit_schema_is_seen_at_once(dome_document, pictures):
    def texts(rows):
        return [rows.item(row, 1).text() for row in range(min(3, rows.rowCount()))]

    document, design = opened(dome_document)
    panel = show(SolvePanel, design)
    panel.turn_to("Tiles")
    field = panel.form.findChild(QtGui.QWidget, "HBody")
    assert field.text() == "3.00 mm", field.text()
    overlay_of(design).set_field("Gap")
    settle(300)
    assert "(mm)" in overlay_of(design).legend.content.title_line
    show_units(3)
    assert field.text().startswith("0.118 ") and "mm" not in field.text(), field.text()
    assert "mm" not in overlay_of(design).legend.content.title_line
    assert not document.UndoNames and design.HBody.Value == 3  # to look is no edit
    gap = Finding.about("gap", (), violation=0.254, pairs=((11, 43),))
    assert shown(gap, False) == "flat tiles are 0.0100 in nearer than DGapMin (T00012-T00044)"
    enter(panel.form, "HBody", "0.1 in")
    until(lambda: abs(design.HBody.Value - 2.54) < 1e-6, 5, "inches to arrive")
    document.undo()
    show_units(0)
    assert shown(gap, False) == "flat tiles are 0.254 mm nearer than DGapMin (T00012-T00044)"
    assert field.text() == "3.00 mm", field.text()
    panel.reject()
    settle(300)
    FreeCADGui.Selection.addSelection(design)
    FreeCADGui.runCommand("CurveUps_WorstContacts")
    rows = widget("rows")
    before = texts(rows)
    assert all("mm" in text for text in before), before
    show_units(3)
    assert not any("mm" in text for text in texts(rows)), texts(rows)
    show_units(0)
    assert texts(rows) == before


def test_pins_that_are_large_enough_to_be_valid_are_no_problem(dome_document):
    document, design = opened(dome_document)
    layout = stored(design).latest("design").design
    for name, marked in (("A_pin_min", 0), ("A_pin_floor", len(layout.F))):
        values = with_values(layout.parameters, {"A_pin_min": 999.0, name: 999.0})
        field = next(field for field in design_fields(layout.with_parameters(values), np.empty((0, 2)))
                     if field.name == "Pin area")
        assert len(field.problems) == marked, name


def quit_in_mid_run(pictures, left):
    robot.keep_pictures_in(pictures)
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    design = designs.new_design(FreeCAD.newDocument("Made"), "hyperboloid")
    show(SolvePanel, design).run("solve")
    until(lambda: LIVE._drawn >= 1, 120, "a picture of the run")
    quit_freecad(left)


@pytest.mark.all
def test_FreeCAD_can_be_quit_in_mid_run(elsewhere, tmp_path):
    """FreeCAD ends by itself, with no thread left in the solver."""
    left = tmp_path / "left"
    elsewhere(quit_in_mid_run, tmp_path / "pictures", left, window=True, ends=True)
    assert left.read_text("utf-8") == "[0] False False"


@pytest.fixture
def german():
    """Whose texts are longer."""
    FreeCADGui.setLocale("German")
    yield
    FreeCADGui.setLocale("English")


def test_the_panel_says_why_a_shape_does_not_hold_until_an_edit(dome_document, pictures):
    document, design = opened(dome_document)
    panel = show(SolvePanel, design)
    said = panel.form.verdict.text
    assert "valid, holds" in said() and "Warning" not in said()
    design.Margin = "off"
    design.FrictionCoefficient = 0.01
    document.recompute()
    click(panel.form.verify)
    until(lambda: "does not hold</b>" in said() and not LIVE.busy, 120, "the verdict")
    assert said().count("Warning: ") == 1, said()
    assert "Warning: the shape does not hold: friction lets it drift" in said(), said()
    picture("does-not-hold")
    assert cut_off(panel.form) == []
    document.openTransaction("an edit")
    design.FrictionCoefficient = 0.5
    document.commitTransaction()
    document.recompute()
    until(lambda: "Warning" not in said(), 10, "a warning of what was to go")
    document.undo()
    until(lambda: "Warning" in said(), 10, "the warning again")
    document.openTransaction("an edit that is refused")
    design.PMin, design.PMax = 2, 1
    document.commitTransaction()
    document.recompute()
    until(lambda: "invalid" in said() and "Warning" not in said(), 10, "a warning of another layout to go")


def test_the_process_window_is_shown_until_the_design_changes(german, dome_document, pictures):
    document, design = opened(dome_document)
    design.HoldTolerance, design.FrictionCoefficient = "0.02 mm", 0.05  # near what little friction misses
    design.Window = True
    document.recompute()
    panel = show(SolvePanel, design)
    rows = panel.form.window
    assert not rows.isVisible()
    click(panel.form.verify)
    until(lambda: rows.isVisible() and not LIVE.busy, 120, "the process window")
    report = {row.parameter: row for row in stored(design).latest("settle").window}
    assert rows.topLevelItemCount() == len(report)
    for number, row in enumerate(report.values()):
        item = rows.topLevelItem(number)
        for column, (end, failure) in enumerate(zip(row.ends, row.failures), 1):
            assert (item.text(column)[0] in "≤≥") == (end is None) == (item.toolTip(column) == ""), row
    assert cut_off(panel.form) == []
    picture("window")

    # A click on an end shows what fails first beyond it.
    number, column, failure = next((number, column, failure) for number, row in enumerate(report.values())
                                   for column, failure in enumerate(row.failures, 1)
                                   if failure and failure.tiles)
    click_item(rows, rows.topLevelItem(number), column)
    until(lambda: overlay_of(design).selected == sorted(failure.tiles), 10, "the tiles that fail first")

    # What settling alone reads makes the window out of date, and so does what the layout is made from.
    for name, value in (("HoldTolerance", "0.2 mm"), ("Tau", 2.9)):
        document.openTransaction("an edit")
        setattr(design, name, value)
        document.commitTransaction()
        document.recompute()
        until(lambda: not rows.isVisible(), 10, f"a window that {name} makes out of date to go")
        document.undo()
        until(lambda: rows.isVisible(), 10, "the window of the design as it was")


def test_the_wheel_scrolls_the_panel_and_edits_nothing(dome_document, pictures):
    def values():
        rows = [name for name in design.PropertiesList if properties.parameter_of(name)]
        return [properties.value_of(design, name) for name in rows], panel.form.group.currentIndex()

    document, design = opened(dome_document)
    panel = show(SolvePanel, design)
    panel.turn_to("Target")
    robot.window.resize(1440, 620)  # less than the panel needs
    settle(300)
    before, area = values(), scroll_area(panel.form)
    boxes = [box for kind in (QtGui.QAbstractSpinBox, QtGui.QComboBox)
             for box in panel.form.findChildren(kind) if box.isVisible()]
    assert len(boxes) > 3 and area.verticalScrollBar().maximum() > 0
    for box in boxes:
        robot.scroll_to(box, box.rect().center())
        place, at = box.mapToGlobal(box.rect().center()), area.verticalScrollBar().value()
        display("mousemove", place.x(), place.y())
        display("click", 4 if at else 5)  # the wheel, up or down
        assert area.verticalScrollBar().value() != at, box.objectName()
    settle(600)  # a pause in which edits are written
    assert values() == before and not document.UndoNames
    assert "valid" in panel.form.verdict.text()

    # A box that was clicked takes the wheel.
    field = panel.form.findChild(QtGui.QAbstractSpinBox, "L")
    click(field)
    display("click", 4)
    until(lambda: values() != before, 5, "the edit")


def scroll_area(widget):
    while not isinstance(widget, QtGui.QScrollArea):
        widget = widget.parentWidget()
    return widget


def test_a_box_takes_what_its_parameter_takes(dome_document, pictures):
    document, design = opened(dome_document)
    panel = show(SolvePanel, design)
    panel.turn_to("Target")
    for text in ("-6", "1e9"):
        enter(panel.form, "Scale", text)
        settle(600)
        assert 1e-6 <= design.Scale <= 1e6, (text, design.Scale)
        assert "invalid" not in panel.form.verdict.text(), panel.form.verdict.text()
    enter(panel.form, "Scale", "2")
    until(lambda: design.Scale == 2, 5, "a number in range")
