# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imports FreeCAD as a module, unless the program runs inside FreeCAD already."""

from __future__ import annotations

import os
import signal
import sys
import threading
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator

from .errors import CurveUpsError

_DEBIAN = "/usr/lib/freecad-python3/lib"


def load(*modules: str) -> Any:
    """Imports FreeCAD and the named modules of it; returns FreeCAD, or a tuple with all of them.

    Takes 0.2 to 0.6 s outside of FreeCAD: call it only where it is needed. Raises CurveUpsError.
    """
    # tools/setup asks freecadcmd for the folder and sets the variable; Debian's folder comes last.
    for folder in (None, os.environ.get("CURVEUPS_FREECAD_LIB"), _DEBIAN):
        if folder and folder not in sys.path:
            sys.path.append(folder)
        try:
            with _kept_signals():
                loaded = [__import__(name) for name in ("FreeCAD", *modules)]
        except ImportError as error:
            reason = error
            continue
        return loaded[0] if not modules else tuple(loaded)
    raise CurveUpsError(f"FreeCAD can't be loaded: {reason}", sys.executable,
                        "install FreeCAD, then run tools/setup again")


@contextmanager
def _kept_signals() -> Iterator[None]:
    """Restores the handler of SIGINT, which FreeCAD replaces when it is imported."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    handler = signal.getsignal(signal.SIGINT)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler or signal.SIG_DFL)


def version(freecad: Any) -> str:
    """FreeCAD's version, as 0.20.2."""
    parts = freecad.Version()
    return ".".join(str(part) for part in parts[:3] if str(part).isdigit())


def python() -> str:
    """Interpreter for a new process: inside FreeCAD sys.executable is FreeCAD itself."""
    own = Path(sys.executable)
    if own.stem.startswith("python"):
        return str(own)
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    for place in (Path(sys.prefix, "bin", name) for name in (version, "python3", "python")):
        if place.is_file():
            return str(place)
    raise CurveUpsError("FreeCAD's Python was not found", sys.prefix, "install FreeCAD whole")


def environment() -> dict[str, str]:
    """Environment of a process that imports this package and FreeCAD as this one does."""
    paths = [str(Path(__file__).parents[2]), os.environ.get("PYTHONPATH", "")]
    variables = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths)), "PYTHONSAFEPATH": "1"}
    loaded = sys.modules.get("FreeCAD")
    file = getattr(loaded, "__file__", None)
    folder = os.path.dirname(file) if file else loaded and os.path.join(loaded.getHomePath(), "lib")
    if folder:
        variables.setdefault("CURVEUPS_FREECAD_LIB", folder)
    return variables
