# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever is not what the results were made from is said at once, with the reason, and kept through
saving: nothing stays valid over old shapes."""

import pytest

OPEN = """
import FreeCAD
from curveups.features import document as documents
from curveups.base.errors import CurveUpsError
document = FreeCAD.openDocument(path)
design = document.Design
PARTS = ('Target', 'Cuts', 'Layout', 'Verification', 'Tiles', 'Support', 'Anchors')

def parts(*stale):
    found = {part for part in PARTS if getattr(design, part).Status == 'out of date'}
    assert found == set(stale), found
    assert all(getattr(design, part).Reason for part in stale)

def judged():
    assert (design.Verdict, design.Status, list(design.Reasons)) == ('valid', 'current', [])
    parts()

def stale(name, command):
    assert (design.Verdict, design.Status) == ('out of date', 'out of date'), (design.Verdict, name)
    assert len(design.Reasons) == 1 and name in design.Reasons[0] and command in design.Reasons[0]
    assert documents.state_of(design) == ('out of date', design.Reasons[0])

def reopened(copy):
    document.saveAs(copy)
    FreeCAD.closeDocument(document.Name)
    return FreeCAD.openDocument(copy)
"""
SOLIDS = "'Tiles', 'Support', 'Anchors'"


@pytest.mark.parametrize("name, value, command, parts", [
    ("HBody", "2.5 mm", "Verify", f"'Verification', {SOLIDS}"),
    ("BumpDiameter", "1.4 mm", "Verify", f"'Verification', {SOLIDS}"),
    ("FrictionCoefficient", 0.3, "Verify", "'Verification'"),
    ("ShearModulusBack", "0.3 MPa", "Verify", "'Verification'"),
    ("Tau", 2, "Solve", "'Layout', 'Verification'"),
    ("WA", 20, "Solve", "'Layout', 'Verification'"),
    ("Flip", True, "Solve", "'Target', 'Layout', 'Verification'"),
])
def test_an_edit_of_each_tier(freecad, document, tmp_path, name, value, command, parts):
    """At once, without a recompute; through saving and reopening; and back."""
    freecad(OPEN + f"""
judged()
before = design.{name}
design.{name} = {value!r}
stale('{name}', '{command}')
parts({parts})
document = reopened(copy)
design = document.Design
stale('{name}', '{command}')
design.{name} = before
judged()
done()
""", path=document, copy=tmp_path / "copy.FCStd")


def test_expressions_and_forgeries(freecad, document):
    freecad(OPEN + """
design.setExpression('Tau', '1 + 1.5')
document.recompute()
stale('Tau', 'Solve')
for name, value in (('Verdict', 'valid'), ('Status', 'current'), ('Reasons', [])):
    setattr(design, name, value)
    stale('Tau', 'Solve')
document.Layout.Status = 'current'
assert document.Layout.Status == 'out of date'
design.setExpression('Tau', None)
design.Tau = 3
kept = list(document.Layout.Poses)
document.Layout.Poses = [x + 1 for x in kept]
stale('by hand', 'Solve')
document.Layout.Poses = kept
judged()
design.setExpression('Tau', '1 + 1.5')
document.recompute()
design.setExpression('Verdict', "<<valid>>")
document.recompute()
stale('Tau', 'Solve')
design.setExpression('Verdict', None)
design.setExpression('Tau', None)
design.Tau = 3
judged()
done()
""", path=document)


def test_hands_at_what_was_computed(freecad, document, tmp_path):
    """Lists and results that are not those that were written are noticed, reopened too, and used for
    nothing; the command that is named makes them anew."""
    freecad(OPEN + """
for name, value in (('ContactNormalMin', [9.0]), ('WeakContacts', [0, 1]), ('Digest', 'x')):
    kept = getattr(design.Verification, name)
    setattr(design.Verification, name, value)
    stale('by hand', 'Verify')
    parts('Verification')
    setattr(design.Verification, name, kept)
    judged()
design.Verification.ContactNormalMin = [9.0]
documents.take(design, documents.design_project_of(design).run(('figures', 'verification')))
judged()
assert len(design.Verification.ContactNormalMin) == len(design.Verification.ContactFriction) > 1
kept, wrong = design.Results, design.Results.replace('"layout"', '"Layout"', 1)
assert wrong != kept
design.Results = wrong
stale('by hand', 'Solve')
parts('Layout', 'Verification')
try:
    documents.design_project_of(design)
    raise AssertionError('a layout was taken from it')
except CurveUpsError as error:
    assert 'by hand' in str(error) and 'Solve' in str(error), error
document = reopened(copy)
design = document.Design
stale('by hand', 'Solve')
design.Results = kept
judged()
design.Results = wrong
documents.take(design, documents.project_of(design).run(('design', 'figures', 'verification')))
judged()
done()
""", path=document, copy=tmp_path / "copy.FCStd")


@pytest.mark.parametrize("name, value, reason", [
    ("HPin", "999 mm", "50.00 mm"), ("HBody", "45 mm", "back faces vanish"), ("PMin", "5 mm", "PMax"),
    ("BumpCount", 1, "give 3 to 40"), ("HeldTiles", "'x'", "no tile")])
def test_a_refused_value_stays_and_is_said(freecad, document, tmp_path, name, value, reason):
    """In one line with range or remedy, without a traceback; shapes and results stay as they were."""
    out = freecad(OPEN + f"""
volume, results, before = document.Tiles.Shape.Volume, design.Results, design.{name}
design.{name} = {value!r}
typed = design.{name}
document.recompute()
assert design.{name} == typed
assert (design.Verdict, design.Status) == ('not valid', 'invalid'), (design.Verdict, design.Status)
assert len(design.Reasons) == 1 and {reason!r} in design.Reasons[0], list(design.Reasons)
assert document.Tiles.Shape.Volume == volume and design.Results == results
try:
    documents.build_bodies(design)
    assert {name!r} == 'PMin'  # of the layout: solids are of that which there is
except CurveUpsError as error:
    assert {reason!r} in str(error)
if {name!r} != 'HBody':
    try:
        documents.settings_of(design)
        assert False
    except CurveUpsError as error:
        assert design.Label in str(error)
document = reopened(copy)
design = document.Design
assert (design.Verdict, design.Status) == ('not valid', 'invalid'), (design.Verdict, design.Status)
design.{name} = before
document.recompute()
judged()
assert abs(document.Tiles.Shape.Volume / volume - 1) < 1e-12
done()
""", path=document, copy=tmp_path / "copy.FCStd")
    assert "Traceback" not in out, out
    assert sum(reason in line for line in out.splitlines()) == 1, out  # once in the report view


NEW = """
import FreeCAD, Mesh, Part
from curveups.features import document as documents
from curveups.base.errors import CurveUpsError
document = FreeCAD.newDocument('New')

def cap(radius=40):
    sphere = Part.makeSphere(radius, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 50, 90, 360)
    return next(face for face in sphere.Faces if 'Sphere' in face.Surface.TypeId)

def solve(*goals):
    project = documents.project_of(design)
    documents.take(design, project.run(goals or ('design', 'figures', 'deviation', 'verification')))
    document.recompute()
"""


def test_the_source_is_an_object_of_the_document(freecad, tmp_path):
    freecad(NEW + """
source = document.addObject('Part::Feature', 'Cap')
source.Shape = cap()
design = documents.new_design(document, source, 'Dome')
assert (design.Label, design.Verdict, design.Status) == ('Dome', 'not judged', 'empty')
design.L = 10
solve()
assert (design.Verdict, design.Status) == ('valid', 'current'), list(design.Reasons)
assert design.Target.Mesh.CountFacets == design.TileCount == len(design.Layout.Poses) // 6
assert len(design.Verification.ContactNormalMin) == design.ContactCount
assert abs(min(design.Verification.ContactNormalMin) - design.MinNormalForce) < 1e-9
assert abs(design.Tiles.Shape.Volume / 1000 / design.TileVolume - 1) < 1e-6
document.saveAs(copy)
FreeCAD.closeDocument(document.Name)
document = FreeCAD.openDocument(copy)
design, source = document.Design, document.Cap
assert design.Verdict == 'valid' and documents.project_of(design).out_of_date('verification') == ()
for change, back in ((lambda: setattr(source, 'Shape', cap(41)), lambda: setattr(source, 'Shape', cap())),
                     (lambda: setattr(source.Placement, 'Base', FreeCAD.Vector(0, 0, 7)),
                      lambda: setattr(source.Placement, 'Base', FreeCAD.Vector()))):
    change()
    document.recompute()
    assert design.Verdict == 'out of date' and 'Cap' in design.Reasons[0], list(design.Reasons)
    assert design.Target.Status == design.Layout.Status == 'out of date'
    assert documents.project_of(design).out_of_date('layout') == ('source',)
    back()
    document.recompute()
    assert design.Verdict == 'valid', list(design.Reasons)
document.removeObject('Cap')
assert design.Verdict == 'out of date' and 'deleted' in design.Reasons[0], list(design.Reasons)
document.removeObject(design.Target.Name)
assert design.Verdict == 'out of date' and 'target was deleted' in design.Reasons[0]
documents.set_source(design, 'cap')
assert design.Target.BuiltIn == 'cap' and design.Verdict == 'out of date'
solve('design', 'figures')
assert (design.Verdict, design.Status, design.Verification.Status) == ('not judged', 'current', 'empty')
done()
""", copy=tmp_path / "copy.FCStd")


def test_a_mesh_or_a_file_as_source(freecad, document, tmp_path):
    target = tmp_path / "dome.obj"
    target.write_text((document.parents[1] / "dome.obj").read_text())
    freecad(NEW + """
mesh = document.addObject('Mesh::Feature', 'Surface')
mesh.Mesh = Mesh.Mesh(target)
mesh.Placement.Base = FreeCAD.Vector(0, 0, 3)
for source in (mesh, target):
    design = documents.new_design(document, source)
    assert design.Label == ('Surface design' if source is mesh else 'dome')
    design.Target.KeepMesh = True
    solve()
    assert design.TileCount == 54 and design.Verdict == 'valid'
    assert abs(design.L.Value - 7.5) > 0.01  # the mesh's own
    assert documents.project_of(design).out_of_date('verification') == ()
    assert abs(max(v.z for v in design.Layout.Vertices) - (43 if source is mesh else 40)) < 1e-5
with open(target, 'a') as file:
    file.write('v 0 0 0' + chr(10))
design.touch()
document.recompute()
assert design.Verdict == 'out of date' and target in design.Reasons[0], list(design.Reasons)
assert document.Design.Verdict == 'valid'
done()
""", target=target)


def test_sources_that_are_none_change_nothing(freecad, tmp_path):
    (tmp_path / "text.txt").write_text("no target")
    freecad(NEW + """
line = document.addObject('Part::Feature', 'Line')
line.Shape = Part.makeLine(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0))
for source, word in ((folder + '/nothing.stl', 'no such'), (folder, 'no file'), (line, 'no surface'),
                     (folder + '/text.txt', 'format'), ('a' * 5000, ''), ('bad' + chr(0), '')):
    try:
        documents.new_design(document, source)
        assert False, source
    except CurveUpsError as error:
        assert word in str(error), error
    assert [obj.Name for obj in document.Objects] == ['Line']
done()
""", folder=tmp_path)


def test_a_solve_is_one_step_of_undo(freecad):
    freecad(NEW + """
document.UndoMode = 1
document.openTransaction('New')
design = documents.new_design(document, 'cap')
design.L = 10
document.commitTransaction()
results = documents.project_of(design).run(('design', 'figures', 'verification'))
states = []
for tau in (3, 2.8):
    document.openTransaction('Solve')
    design.Tau = tau
    documents.take(design, documents.project_of(design).run(('design', 'figures', 'verification')))
    document.commitTransaction()
    assert design.Verdict == 'valid' and design.Tau == tau
    states.append((list(design.Layout.Poses), design.Results, list(design.Verification.ContactNormalMin)))
assert states[0] != states[1]
document.undo()
assert (design.Verdict, design.Tau) == ('valid', 3), list(design.Reasons)
assert (list(design.Layout.Poses), design.Results, list(design.Verification.ContactNormalMin)) == states[0]
assert documents.project_of(design).out_of_date('verification') == ()
document.undo()
assert (design.Status, design.TileCount, list(design.Layout.Poses)) == ('empty', 0, [])
document.redo()
document.redo()
assert (list(design.Layout.Poses), design.Results, list(design.Verification.ContactNormalMin)) == states[1]
assert design.Verdict == 'valid' and design.Target.Mesh.CountFacets == design.TileCount
document.recompute()
assert design.Tiles.Status == 'current'
document.undo()
assert design.Tiles.Status == 'out of date' and 'layout' in design.Tiles.Reason
for _ in range(2):
    document.undo()
assert not documents.designs(document)
document.redo()
assert documents.designs(document)[0].Status == 'empty'
done()
""")


def test_cuts(freecad):
    freecad(NEW + """
design = documents.new_design(document, 'cap')
design.L = 10
try:
    documents.set_cuts(design, [[0, 1]])
    assert False
except CurveUpsError as error:
    assert 'no tiles' in str(error)
solve()
F = documents.project_of(design).latest('target').F
a, b = int(F[len(F) // 2][0]), int(F[len(F) // 2][1])
documents.set_cuts(design, [[a, b]])
assert design.Verdict == 'out of date' and 'cuts' in design.Reasons[0]
assert design.Cuts.Status == design.Layout.Status == 'out of date' != design.Target.Status
documents.set_cuts(design, [])
assert design.Verdict == 'valid'
documents.set_cuts(design, [[a, b]])
try:
    documents.set_cuts(design, [[0, 10**6]])
    assert False
except CurveUpsError:
    assert list(design.Cuts.Edges) == [a, b]
solve()
assert design.CutCount == 1 and design.Cuts.Status == 'current' and design.Verdict == 'valid'
done()
""")


def test_figures_are_read_by_sheets_and_placement_moves_everything(freecad, document):
    freecad(OPEN + """
sheet = document.addObject('Spreadsheet::Sheet', 'Sheet')
sheet.set('A1', '=Design.TileCount * 2')
sheet.set('A2', '=Design.TileVolume / Design.AreaRatio')
values = document.addObject('Spreadsheet::Sheet', 'Values')
values.set('A1', '=2 mm + 0.5 mm')
design.setExpression('HBody', 'Values.A1')
document.recompute()
assert sheet.A1 == 108 and abs(sheet.A2 - design.TileVolume / design.AreaRatio) < 1e-9
stale('HBody', 'Verify')
assert abs(document.Tiles.Shape.BoundBox.ZLength - 4.5) < 1e-6 and document.Tiles.Status == 'current'
design.Placement.Base = FreeCAD.Vector(100, 0, 0)
assert all(abs(document.getObject(part).Placement.Base.x - 100) < 1e-9
           for part in ('Target', 'Tiles', 'Support', 'Anchors'))
design.setExpression('HBody', None)
design.HBody = 3
document.recompute()
judged()
assert abs(document.Tiles.Shape.BoundBox.Center.x - 100) < 1
done()
""", path=document)


def test_copies_have_parts_of_their_own(freecad, document, tmp_path):
    freecad(OPEN + """
for deep in (True, False):
    document.copyObject(design, deep)
first, second, third = documents.designs(document)
names = [getattr(one, part).Name for one in (first, second, third) for part in PARTS]
assert len(set(names)) == 21 and len(document.Objects) == 24, names
third.HPin = 0.7
document.recompute()
assert [round(one.Tiles.Shape.BoundBox.ZLength, 6) for one in (first, second, third)] == [5, 5, 4.4]
assert [one.Verdict for one in (first, second, third)] == ['valid', 'valid', 'out of date']
assert documents.design_of(third.Tiles) == third and documents.design_of(first.Cuts) == first
document = reopened(copy)
assert [one.Verdict for one in documents.designs(document)] == ['valid', 'valid', 'out of date']
done()
""", path=document, copy=tmp_path / "copy.FCStd")


def test_running_is_said_and_ends(freecad, document):
    freecad(OPEN + """
documents.set_running(design, True)
assert design.Status == 'running' and documents.state_of(design)[0] == 'running'
documents.set_running(design, False)
judged()
done()
""", path=document)
