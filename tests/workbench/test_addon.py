# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checkout as an addon: what FreeCAD reads of package.xml, and the tests that it lists."""

import os
import subprocess

from running import ROOT


def test_package_file(freecad):
    freecad("""
import os
import FreeCAD, curveups
package = FreeCAD.Metadata(os.path.join(root, 'package.xml'))
assert package.Name == 'CurveUps' and package.Version == curveups.__version__, package.Version
assert package.FreeCADMin == '0.20.2', package.FreeCADMin
assert os.path.isfile(os.path.join(root, package.Icon)), package.Icon
assert {url['type'] for url in package.Urls} >= {'repository', 'readme', 'documentation', 'bugtracker'}
for licence in package.License:
    assert os.path.isfile(os.path.join(root, licence['file'])), licence
workbench, = package.Content['workbench']
assert workbench.Classname == 'CurveUpsWorkbench'
assert workbench.Classname in open(os.path.join(root, 'InitGui.py')).read()
assert {need['package'] for need in package.Depend} == {'numpy', 'matplotlib'}
for address in (url['location'] for url in package.Urls if url['type'] in ('readme', 'documentation')):
    assert os.path.isfile(os.path.join(root, address.split('.invalid/')[1])), address
done()
""", root=ROOT)


def run_freecad(homes, *arguments):
    env = {**os.environ, "HOME": str(homes[True])}
    env.pop("PYTHONPATH", None)
    ran = subprocess.run(["freecadcmd", *arguments], env=env, stdin=subprocess.DEVNULL,
                         capture_output=True, text=True, timeout=300)
    return ran.stdout + ran.stderr


def test_freecad_lists_and_runs_its_tests(homes):
    assert "TestCurveUps" in run_freecad(homes, "-t").split()
    out = run_freecad(homes, "-t", "TestCurveUps")
    assert "test_stale_results_say_so" in out and "\nOK" in out, out
    assert "Ran 3 tests" in out, out
