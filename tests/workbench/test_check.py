# SPDX-License-Identifier: LGPL-2.1-or-later
"""The check of a target, sizes that are chosen and profiles of printers, by mouse in a real window."""

import FreeCAD
import FreeCADGui
import Part
import pytest
from curveups.features import actions
from curveups.window.overlay.colours import MARK
from curveups.window.overlays import overlay_of
from robot import (at_rest, click, click_at, click_item, close_panel, once_open, picture, press, QtGui,
                   report, settle, until, widget)
from steps import begin, example, LIVE, panel

pytestmark = pytest.mark.freecad(window=True)


def checking(form):
    until(lambda: LIVE.busy or form.verdict.text() or form.line.text(), 10, "the check")
    at_rest()


def marked():
    """Pixels of the colour of marks beside the legend."""
    image = QtGui.QApplication.primaryScreen().grabWindow(0).toImage()
    wanted = [int(255 * part) for part in MARK]
    count = 0
    for y in range(100, 740):
        for x in range(660, 1200):
            pixel = image.pixel(x, y)
            rgb = (pixel >> 16 & 255, pixel >> 8 & 255, pixel & 255)
            count += all(abs(a - b) < 12 for a, b in zip(rgb, wanted))
    return count


def test_a_check_says_what_is_in_the_way_and_sizes_that_do(pictures):
    document, design = example("half-sphere", L=14, HBody=33)
    before = design.Results
    press("CurveUps_Check")
    form = widget("CheckPanel")
    assert LIVE.busy and form.cancel.isEnabled()
    click(form.cancel)
    at_rest()
    assert design.Results == before and "cancelled" in form.line.text(), form.line.text()
    click(form.check)
    checking(form)

    # Tiles that can't be made are drawn, marked and listed all the same.
    overlay = overlay_of(design)
    assert overlay.shows_target and overlay.note == "", overlay.note
    assert overlay.field().name == "Dihedral margin", overlay.fields()
    problems = overlay.scene.fields["Obstacles"].problems
    assert len(problems) and "Not feasible" in form.verdict.text(), form.verdict.text()
    assert picture("not-feasible") > 20
    assert marked() > 3 * len(problems), marked()
    listed = {form.obstacles.topLevelItem(row).text(0) for row in range(form.obstacles.topLevelItemCount())}
    assert listed == {f"T{tile + 1:05d}" for tile in problems}, listed
    assert document.UndoNames[0] == "Check", document.UndoNames

    item = form.obstacles.topLevelItem(0)
    click_item(form.obstacles, item)
    until(lambda: [tile + 1 for tile in overlay.selected] == [int(item.text(0)[1:])], 5, "its tile")
    rows = {form.margins.topLevelItem(row).text(0): form.margins.topLevelItem(row)
            for row in range(form.margins.topLevelItemCount())}
    row = rows["Front membrane"]
    assert row.text(2) == "≈ 0.3" and rows["Back pin"].text(1).endswith(" ✗"), rows["Back pin"].text(1)
    click_item(form.margins, row)
    until(lambda: overlay.field().name == "Membrane clearance", 5, "its field")

    # A thickness that works is looked for, taken over and checked; each is a step of undo.
    assert form.advice.text() == "" and not form.use_thickness.isVisible()
    click(form.find)
    until(lambda: LIVE.busy, 10, "the search")
    at_rest()
    assert "HBody can be up to" in form.advice.text() and not form.find.isVisible(), form.advice.text()
    assert "HBody" in form.use_thickness.text(), form.use_thickness.text()
    click(form.use_thickness)
    until(lambda: LIVE.busy, 10, "the next check")
    at_rest()
    assert 1 < design.HBody.Value < 33
    assert document.UndoNames[:2] == ["Check", "Use HBody"], document.UndoNames
    assert "<b>Feasible" in form.verdict.text() and not form.obstacles.isVisible(), form.verdict.text()
    assert len(overlay.scene.fields["Obstacles"].problems) == 0
    picture("feasible")

    # What was checked is out of date with the next edit, here by undo.
    document.undo()
    document.undo()
    settle(500)
    until(lambda: design.HBody.Value == 33 and "Not feasible" in form.verdict.text(), 5, "the check before")
    design.HBody = 3
    document.recompute()
    until(lambda: "Out of date" in form.verdict.text() and not form.sizes.isEnabled(), 5, "that it is old")
    close_panel()
    until(lambda: not overlay.shows_target, 5)
    assert report().count("error") == 0, report()


def test_the_target_of_a_solved_design_is_checked_beside_its_layout(pictures):
    document, design = example(L=13)
    actions.solve(design)
    document.recompute()
    settle(500)
    assert design.Verdict == "valid", list(design.Reasons)
    overlay = overlay_of(design)
    press("CurveUps_Check")
    form = widget("CheckPanel")
    checking(form)
    assert overlay.scene.flat is None and "Dihedral margin" in overlay.fields()
    assert design.Verdict == "valid" and "Feasible" in form.verdict.text()
    picture("of-a-valid-design")
    close_panel()
    until(lambda: overlay.scene.flat is not None and "Dihedral margin" not in overlay.fields(), 10,
          "the layout")
    assert design.Verdict == "valid"


def test_sizes_are_chosen_and_profiles_applied_in_the_panel_of_the_design(pictures):
    def item(menu, text):
        return next(action for action in menu.actions() if action.text() == text)

    document, design = example("half-sphere", L=13, HBody=8, MaximumDeviation=0.4)
    FreeCADGui.ActiveDocument.setEdit(design.Name)
    settle(300)
    form = panel().form
    panel().turn_to("Target")
    settle(200)
    picture("with-auto")
    assert form.minimumSizeHint().width() <= 310, form.minimumSizeHint().width()  # of FreeCAD's dock
    click(form.findChild(QtGui.QToolButton, "auto_L"))
    until(lambda: LIVE.busy, 10, "the search")
    at_rest()
    assert document.UndoNames[0] == "Choose Sizes" and design.L.Value != 13, (design.L, document.UndoNames)
    field = form.findChild(QtGui.QAbstractSpinBox, "L")
    assert abs(field.property("rawValue") - design.L.Value) < 1e-9
    assert "tried L = " in form.line.text() and form.line.text().endswith(": valid"), form.line.text()

    chosen = design.L.Value
    menu = form.profile.menu()
    assert [action.text() for action in menu.actions()] == ["Standard", "FDM"]
    once_open(menu, lambda: (picture("profiles"), item(menu, "FDM").trigger(), menu.close()))
    click(form.profile)
    until(lambda: design.Printer == "fdm", 10, "the profile")
    assert design.L.Value == 10 and design.Bumps == "none" and document.UndoNames[0] == "Apply Profile"
    panel().turn_to("Files")
    settle(200)
    assert form.findChild(QtGui.QComboBox, "Printer").currentText() == "fdm"
    picture("profile-applied")
    document.undo()
    settle(300)
    assert design.L.Value == chosen and design.Printer == "polyjet"

    menu = form.materials.menu()

    def marked():
        menu.aboutToShow.emit()
        return [action.text() for action in menu.actions() if action.isChecked()]

    assert marked() == ["latex-0.5", "cyanoacrylate", "vero"]
    thin = menu.actionGeometry(item(menu, "latex-0.25")).center()
    once_open(menu, lambda: (picture("materials"), click_at(menu.mapToGlobal(thin))))
    click(form.materials)
    until(lambda: design.ThicknessFront.Value == 0.25, 10, "the membrane")
    assert design.ThicknessBack.Value == 0.25 and document.UndoNames[0] == "Apply Material"
    assert marked() == ["latex-0.25", "cyanoacrylate", "vero"]
    design.ThicknessBack = 0.3
    assert marked() == ["cyanoacrylate", "vero"]
    close_panel()
    assert report().count("error") == 0, report()


def test_a_part_with_a_wall_is_taken_as_it_is_drawn(pictures):
    """The target is its outer skin without the rim, or the selected faces."""
    def radii(design):
        # Of the corners of the target about the bowl's middle.
        return [point.Vector.Length for point in design.Target.Mesh.Points]

    def check():
        press("CurveUps_Check")
        form = widget("CheckPanel")
        checking(form)
        return form

    document = begin()
    outer, inner = Part.makeSphere(45), Part.makeSphere(40)
    below = Part.makeBox(100, 100, 100, FreeCAD.Vector(-50, -50, -115))
    bowl = document.addObject("Part::Feature", "Bowl")
    bowl.Shape = outer.cut(inner).common(below).removeSplitter()
    FreeCADGui.Selection.addSelection(bowl)
    press("CurveUps_NewDesign")
    assert panel().form.target.text() == "Target: Bowl" and panel().form.check.isEnabled()
    bowl.ViewObject.Visibility = False
    design = document.Design
    design.L = 14
    document.recompute()
    form = check()
    distances = radii(design)
    assert min(distances) > 44.9 and max(distances) < 45.1, (min(distances), max(distances))
    assert "Feasible" in form.verdict.text(), form.verdict.text()
    picture("bowl-outer")
    close_panel()

    # A part that can't be read so is a line with the remedy, and the check before stays.
    design.Faces = "Face99"
    document.recompute()
    form = check()
    assert "Face99" in form.line.text() and "Face1 to Face" in form.line.text(), form.line.text()
    picture("bowl-no-such-face")
    close_panel()
    document.undo()

    # Only the selected face: the wall's rim and its other skin are no part of the target.
    name = next(f"Face{number}" for number, face in enumerate(bowl.Shape.Faces, 1)
                if face.Surface.TypeId == "Part::GeomSphere" and abs(face.Surface.Radius - 40) < 1e-6)
    bowl.ViewObject.Visibility = True
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(bowl, name)
    press("CurveUps_NewDesign")
    second = [obj for obj in document.Objects if obj.Name.startswith("Design")][-1]
    assert second.Faces == name, second.Faces
    assert panel().form.target.text() == f"Target: Bowl {name}"
    second.L = 14
    document.recompute()
    check()
    distances = radii(second)
    assert len(distances) > 20
    assert min(distances) > 39.9 and max(distances) < 40.1, (min(distances), max(distances))
    close_panel()


def test_a_part_that_is_feasible_as_it_is(pictures):
    """No size is offered where those that are set work. The part would cover its target, and is hidden until
    the panel closes."""
    document = begin()
    cap = document.addObject("Part::Feature", "Cap")
    ball = Part.makeSphere(40, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 35)
    cap.Shape = max(ball.Faces, key=lambda face: face.Area)
    document.recompute()
    FreeCADGui.Selection.addSelection(cap)
    press("CurveUps_NewDesign")
    document.Design.L = 11
    document.recompute()
    press("CurveUps_Check")
    form = panel().form
    checking(form)
    picture("cap")
    assert "<b>Feasible" in form.verdict.text(), form.verdict.text()
    assert "all tiles can be made" in form.verdict.text(), form.verdict.text()
    click(form.find)
    until(lambda: LIVE.busy, 10, "the search")
    at_rest()
    assert "L can be " in form.advice.text() and "(at HBody 3" in form.advice.text(), form.advice.text()
    assert not any(button.isVisible() for button in (form.use_length, form.use_thickness))
    margins = map(form.margins.topLevelItem, range(form.margins.topLevelItemCount()))
    needed = [row.text(2) for row in margins]
    assert not any(text.startswith("-") for text in needed), needed
    assert "arning" not in report(), report()
    assert not cap.Visibility
    close_panel()
    assert cap.Visibility
