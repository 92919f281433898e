# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads the native module, and says plainly what is wrong where that fails.

`from curveups.native import native` gives the module; every other file imports it from here.
"""

from __future__ import annotations

import importlib
import importlib.util
import sys
from pathlib import Path

from . import __version__
from .errors import CurveUpsError


def _load():
    here = Path(__file__).parent
    name = f"Python {sys.version_info.major}.{sys.version_info.minor}"
    built = sorted(path.name for path in here.glob("_native*"))
    try:
        module = importlib.import_module("curveups._native")
    except ImportError as error:
        if not built:
            raise CurveUpsError(
                "the native module has not been built", str(here), "run tools/setup"
            ) from error
        if importlib.util.find_spec("curveups._native") is None:
            raise CurveUpsError(
                f"the native module is not for {name}", ", ".join(built), "run tools/setup again"
            ) from error
        raise CurveUpsError(
            f"the native module can't be loaded: {error}", built[0], "run tools/setup again"
        ) from error
    if module.__version__ != __version__:
        raise CurveUpsError(
            f"the native module is of version {module.__version__}, not {__version__}",
            built[0],
            "run tools/setup again",
        )
    return module


native = _load()
