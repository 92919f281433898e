# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the package `curveups` importable in FreeCAD, with or without a window.

FreeCAD runs this text without a file name, after putting this folder on sys.path.
"""

import os
import sys

import FreeCAD

for _folder in list(sys.path):
    _package = os.path.normpath(os.path.join(_folder, "Workbench"))
    if os.path.isfile(os.path.join(_package, "curveups", "__init__.py")) and _package not in sys.path:
        sys.path.append(_package)

from curveups.features import observer as _observer  # noqa: E402  found through the loop above

_observer.install()

# freecad -t lists them, freecad -t TestCurveUps runs them.
FreeCAD.__unit_test__ += ["TestCurveUps"]
