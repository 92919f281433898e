# SPDX-License-Identifier: LGPL-2.1-or-later
"""`python -m curveups.cli`."""

import os
import sys

from . import main

code = main()
sys.stderr.flush()
# FreeCAD, loaded as a module, may crash while the interpreter takes itself apart.
os._exit(code)
