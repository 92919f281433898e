# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a Design and all below it are in the tree: badges, menus, double clicks; and stay through FreeCADs
that know nothing of them."""

import shutil

import pytest
from window import run_in_window

pytestmark = pytest.mark.skipif(not shutil.which("xvfb-run"), reason="there is no xvfb-run")

OPEN = """
PARTS = ('Target', 'Cuts', 'Layout', 'Verification', 'Tiles', 'Support', 'Anchors')
SHAPES = ('Target', 'Tiles', 'Support', 'Anchors')

def opened(path):
    document = FreeCAD.openDocument(path)
    settle(3000)  # views of shapes follow, one after another
    return document, FreeCADGui.getDocument(document.Name)

def shown(gui):
    return {name for name in SHAPES if gui.getObject(name).Visibility}
"""

TREE = OPEN + """
from curveups.features import document as documents
from curveups.window.viewproviders.part import ShapeView

def drawn(gui):
    # What stands in the tree before each name.
    images = {}
    for name in ('Design', *PARTS):
        proxy = gui.getObject(name).Proxy
        image = proxy.getIcon().pixmap(64, 64).toImage()
        images[name] = bytes(image.constBits())[:image.sizeInBytes()]
    return images

def work():
    document, gui = opened(path)
    document.UndoMode = 1
    design, panel = document.Design, __import__('curveups.window.panels.solve').window.panels.solve
    assert all(isinstance(gui.getObject(name).Proxy, ShapeView) for name in SHAPES)
    current = drawn(gui)
    assert len({current[name] for name in SHAPES}) == 4
    # A state is a badge, there and back.
    for name, value, changed in (('HBody', '2.9 mm', {'Tiles', 'Support', 'Anchors'}),
                                 ('L', '9 mm', {'Target', 'Layout'})):
        document.openTransaction('Edit')
        setattr(design, name, value)
        document.commitTransaction()
        now = drawn(gui)
        assert changed < {part for part in PARTS if now[part] != current[part]}, name
        document.undo()
        assert drawn(gui) == current, name
    # Every menu has commands, in a session that never activated the workbench too.
    for name in ('Design', *PARTS):
        menu = QtGui.QMenu()
        gui.getObject(name).Proxy.setupContextMenu(gui.getObject(name), menu)
        assert menu.actions() and all(action.text() for action in menu.actions()), name
    # A double click opens the panel, at what made the object; nothing is run by it.
    for name, group in (('Target', 'Target'), ('Layout', 'Layout'), ('Verification', 'Physics'),
                        ('Tiles', 'Tiles'), ('Support', 'Support'), ('Anchors', 'Anchors')):
        assert gui.getObject(name).Proxy.doubleClicked(gui.getObject(name))
        settle(100)
        assert panel._open is not None and panel._open.design == design, name
        assert panel._open.form.group.currentText() == group, (name, panel._open.form.group.currentText())
        assert not panel.LIVE.busy
    panel._open.reject()
    settle(200)
    # Undone deletions, copies and reopened documents have their views.
    FreeCADGui.Selection.addSelection(document.Name, 'Design')
    FreeCADGui.runCommand('Std_Delete')
    settle()
    assert not document.Objects
    document.undo()
    settle()
    copy = document.copyObject(document.Design, True)
    settle(3000)
    for one in (document.Design, copy):
        for slot in SHAPES:
            view = getattr(one, slot).ViewObject
            assert isinstance(view.Proxy, ShapeView), (one.Name, slot)
    copied = copy.Name
    before = shown(gui)
    document.saveAs(out)
    FreeCAD.closeDocument(document.Name)
    document, gui = opened(out)
    assert shown(gui) == before == {'Tiles', 'Anchors'}, (shown(gui), before)
    for one in (document.Design, document.getObject(copied)):
        for slot in SHAPES:
            assert isinstance(getattr(one, slot).ViewObject.Proxy, ShapeView), (one.Name, slot)
    assert drawn(gui) == current
    assert not gui.Modified, 'opening is no edit'
    FreeCAD.closeDocument(document.Name)
    closed = FreeCAD.openDocument(out).Name
    FreeCAD.closeDocument(closed)  # before its views are all ours
    settle(3000)
    assert closed not in FreeCAD.listDocuments()
"""

ELSEWHERE = OPEN + """
def work():
    import sys
    assert not any('CurveUps' in p for p in sys.path)
    for start, end in ((path, once), (once, twice)):
        document, gui = opened(start)
        # Hidden solids stay so: to show thousands takes half a minute.
        assert shown(gui) == {'Tiles', 'Anchors'}, (start, shown(gui))
        document.saveAs(end)
        FreeCAD.closeDocument(document.Name)
"""


def test_all_below_a_design_is_a_full_member_of_the_tree(document, homes, tmp_path):
    out = run_in_window(TREE, homes[True], tmp_path, path=document, out=tmp_path / "again.FCStd")
    assert "Traceback" not in out, out


def test_what_was_hidden_stays_so_in_any_FreeCAD(document, homes, tmp_path):
    """Saved twice where nothing is known of the workbench, opened where it is."""
    once, twice = tmp_path / "once.FCStd", tmp_path / "twice.FCStd"
    run_in_window(ELSEWHERE, homes[False], tmp_path, path=document, once=once, twice=twice)
    out = run_in_window(OPEN + """
def work():
    from curveups.window.viewproviders.part import ShapeView
    document, gui = opened(path)
    assert shown(gui) == {'Tiles', 'Anchors'}, shown(gui)
    assert all(isinstance(gui.getObject(name).Proxy, ShapeView) for name in SHAPES)
    assert document.Design.Verdict == 'valid'
""", homes[True], tmp_path, path=twice)
    assert "Traceback" not in out, out
