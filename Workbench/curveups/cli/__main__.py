# SPDX-License-Identifier: LGPL-2.1-or-later
"""`python -m curveups.cli`."""

import os
import sys

# A standard stream that is closed would leave its number to the next file that is opened, and what
# libraries print there would go into that.
for _number in range(3):
    try:
        os.fstat(_number)
    except OSError:
        os.open(os.devnull, os.O_RDWR)
sys.stderr = sys.stderr or open(os.devnull, "w")

# Our results need BLAS on one thread, and OpenBLAS waits for ever, as it is loaded, for the memory of others.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# OpenCASCADE's memory by oneTBB's allocator, where its build has that: checking solids is mostly small pieces
# of memory, and takes 0.6 of the time that it takes with the system's.
os.environ.setdefault("MMGT_OPT", "2")

from ..base.errors import NOT_WRITTEN, STOPPED  # noqa: E402

try:
    from ..base.machine import keep_memory
    from . import main

    keep_memory()
    code = main()
except KeyboardInterrupt:
    code = STOPPED
except SystemExit as ended:  # --help and --version
    code = int(ended.code or 0)
for stream in filter(None, (sys.stdout, sys.stderr)):
    try:
        stream.flush()
    except OSError:
        code = code if stream is sys.stderr else NOT_WRITTEN
# FreeCAD, loaded as a module, may crash while the interpreter takes itself apart.
os._exit(code)
