# SPDX-License-Identifier: LGPL-2.1-or-later
"""`python -m curveups.cli`."""

import os
import sys

# OpenCASCADE prints to standard output from C: that goes nowhere, answers go to a stream of their own.
sys.stdout = os.fdopen(os.dup(1), "w", encoding="utf-8")
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)

from . import main  # noqa: E402

try:
    code = main()
except SystemExit as ended:  # --help and --version
    code = int(ended.code or 0)
for stream in (sys.stdout, sys.stderr):
    stream.flush()
# FreeCAD, loaded as a module, may crash while the interpreter takes itself apart.
os._exit(code)
