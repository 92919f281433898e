# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test of the portable zip in a FreeCAD that has nothing else of ours (tools/test --portable): an example by
mouse, an edit, its STEP file, and the document saved and opened again. Ends with the versions.

    python3 check_portable.py ZIP PICTURES
"""

import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from window import ROBOT, freecad_home, run_in_window  # noqa: E402

WORK = ROBOT + """
def design():
    return FreeCAD.ActiveDocument.Design

def judged():
    at_rest()
    return design().Verdict == 'valid' and design().Status == 'current'

def work():
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    import curveups
    assert curveups.__file__.startswith(place), curveups.__file__
    tidy()
    choose(lambda: menu_bar('CurveUps'), 'Examples', 'Half-Sphere')
    until(lambda: FreeCAD.ActiveDocument and judged(), 120, 'the verdict')
    until(lambda: design().Tiles.Shape.Solids, 60, 'solids')
    at_rest()
    assert picture('1-example') > 12
    height = design().Tiles.Shape.BoundBox.ZLength

    FreeCADGui.ActiveDocument.setEdit(design().Name)
    widget('group').setCurrentText('Tiles')
    settle()
    fill(widget('HBody'), '3.2')
    until(lambda: abs(design().HBody.Value - 3.2) < 1e-9, 10, 'the thickness')
    close_panel()
    until(lambda: design().Tiles.Shape.BoundBox.ZLength > height + 0.1, 60, 'thicker tiles')
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(design())
    press('CurveUps_Verify')
    until(judged, 60, 'the verdict on the thicker tiles')
    close_panel()
    picture('2-thicker')

    press('CurveUps_Export')
    fill(widget('folder'), files)
    click(widget('write'))
    until(lambda: os.path.isfile(os.path.join(files, 'report.json')), 120, 'the files')
    at_rest()
    close_panel()
    import Part
    step, = [name for name in os.listdir(files) if name.endswith('-print.step')]
    solids = Part.read(os.path.join(files, step)).Solids
    assert len(solids) > design().TileCount and all(solid.isValid() for solid in solids[::20]), len(solids)

    saved = os.path.join(files, 'saved.FCStd')
    in_dialog(lambda: keys('ctrl+s'), lambda: choose_file(saved))
    until(lambda: os.path.exists(saved), 20, 'the file')
    FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
    in_dialog(lambda: keys('ctrl+o'), lambda: choose_file(saved))
    until(lambda: FreeCAD.ActiveDocument and judged(), 30, 'the verdict after opening')
    assert len(design().Tiles.Shape.Solids) == design().TileCount
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    assert picture('3-opened') > 12
    assert 'Traceback' not in report(), report()

    # Beside the libraries of this process, with all processors.
    import ctypes, platform
    from curveups import cli
    for library in ('libopenblas.so.0', 'libtbb.so.12'):
        ctypes.CDLL(library, ctypes.RTLD_GLOBAL)
    assert cli.main([*arguments.split(), '-o', beside]) in (0, 4)
    print('versions: FreeCAD', '.'.join(FreeCAD.Version()[:3]), 'OpenCASCADE', Part.OCC_VERSION, 'Qt',
          QtCore.qVersion(), 'Python', platform.python_version(), file=sys.__stdout__, flush=True)
"""

ARGUMENTS = ["design", "half-sphere", "--no-solids"]


def main():
    archive, pictures = map(Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as place:
        home, alone, beside = (Path(place) / name for name in ("home", "alone", "beside"))
        freecad_home(home, with_workbench=False)
        for mods in home.glob(".local/share/FreeCAD/**/Mod"):
            with zipfile.ZipFile(archive) as file:
                file.extractall(mods)
        addon = next(home.glob(".local/share/FreeCAD/Mod/CurveUps"))
        ran = subprocess.run([sys.executable, "-m", "curveups.cli", *ARGUMENTS, "-o", alone], text=True,
                             cwd=addon / "Workbench", stdin=subprocess.DEVNULL, capture_output=True)
        # 4: without the packages that the report's page needs.
        assert ran.returncode == 0 or (ran.returncode == 4 and "install" in ran.stderr), ran.stderr
        output = run_in_window(WORK, home, place, pictures=pictures, files=Path(place) / "files", place=place,
                               arguments=" ".join(ARGUMENTS), beside=beside)
        designs = [(folder / "design.json").read_bytes() for folder in (alone, beside)]
        assert designs[0] == designs[1], "another design beside other libraries"
        print(*(line for line in ran.stderr.splitlines() if "error" in line), sep="\n")
        print(*(line for line in output.splitlines() if line.startswith("versions")), sep="\n")


if __name__ == "__main__":
    main()
