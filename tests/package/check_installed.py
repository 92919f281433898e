# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test of the installed package on a Debian that has nothing else (tools/package --test): the
command line designs, and FreeCAD's window lists the workbench, designs with it and shows a document.

    python3 check_installed.py
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from window import freecad_home, run_in_window  # noqa: E402

WORK = """
def work():
    assert 'CurveUpsWorkbench' in FreeCADGui.listWorkbenches(), sorted(FreeCADGui.listWorkbenches())
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    assert os.path.isfile(FreeCADGui.activeWorkbench().Icon)
    import curveups
    assert curveups.__file__.startswith('/usr/'), curveups.__file__
    from curveups.window.notice import words_of
    assert words_of('no text of ours') == 'no text of ours'  # its templates are there
    document = FreeCAD.openDocument(path)
    settle()
    assert document.Design.Verdict == 'valid', (document.Design.Verdict, document.Design.Reasons)
    assert document.Tiles.Shape.Solids

    from curveups.features.document import new_design, project_of, take
    design = new_design(FreeCAD.newDocument(), 'half-sphere')
    design.L = 15
    design.Document.recompute()
    take(design, project_of(design).run(('figures', 'verification')))
    assert design.TileCount > 50 and design.Verdict == 'valid', (design.TileCount, design.Verdict)
"""


def main():
    with tempfile.TemporaryDirectory() as place:
        out = Path(place) / "out"
        (Path(place) / "numpy.py").write_text("raise SystemExit('executed')\n")  # is not ours
        done = subprocess.run(["curveups", "design", "half-sphere", "-o", out, "--set", "L=15"], cwd=place,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        report = json.loads((out / "report.json").read_text("utf-8"))
        assert report["valid"] and not list(Path("/usr/lib/curveups").rglob("*.tmp"))
        (Path(place) / "numpy.py").unlink()
        home = freecad_home(Path(place) / "home", with_workbench=False)
        run_in_window(WORK, home, place, path=out / "half-sphere.FCStd")
    print("curveups: the installed package designs, on the command line and in FreeCAD's window")


if __name__ == "__main__":
    main()
