# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the native module's parameter table as JSON: parameter_table.py FILE. The build calls it."""

import json
import sys
from pathlib import Path

from curveups import _native

Path(sys.argv[1]).write_text(json.dumps(_native.parameter_table(), indent=1) + "\n", encoding="utf-8")
