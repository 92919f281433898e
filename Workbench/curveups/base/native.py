# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads the native module and explains a failure.

`from curveups.base.native import native` gives the module; every other file imports it from here. The module
is loaded at its first use: documents open without it.
"""

from __future__ import annotations

import importlib
import importlib.util
import re
import sys
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, Iterator, Optional

from .. import __version__
from .errors import CurveUpsError, Stopped, tile_list


def _load() -> ModuleType:
    here = Path(__file__).parents[1]
    name = f"Python {sys.version_info.major}.{sys.version_info.minor}"
    built = sorted(path.name for path in here.glob("_native*") if path.suffix != ".pyi")
    pythons = [f"{major}.{minor}" for major, minor in re.findall(r"cpython-(\d)(\d+)", " ".join(built))]
    try:
        module = importlib.import_module("curveups._native")
    except ImportError as error:
        if not built:
            raise CurveUpsError("the native module has not been built", str(here),
                                "install CurveUps again, or run tools/setup in a checkout") from error
        if importlib.util.find_spec("curveups._native") is None:
            raise CurveUpsError(
                f"the native module is not for {name}", ", ".join(built),
                f"use a FreeCAD with Python {' or '.join(pythons)}, or run tools/setup in a checkout"
            ) from error
        raise CurveUpsError(f"the native module can't be loaded: {error}", built[0],
                            "install CurveUps again, or run tools/setup in a checkout") from error
    if module.__version__ != __version__:
        raise CurveUpsError(f"the native module is of version {module.__version__}, not {__version__}",
                            built[0], "install CurveUps again, or run tools/setup in a checkout")
    return module


class _Native:
    """The module, loaded at its first use. A failed load is tried again at the next use."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):  # introspection does not need the module
            raise AttributeError(name)
        if "loaded" not in self.__dict__:
            self.__dict__["loaded"] = _load()
        return getattr(self.__dict__["loaded"], name)


if TYPE_CHECKING:
    from .. import _native as native
else:
    native = _Native()


def problem() -> Optional[CurveUpsError]:
    """Error of loading the native module; None where it loads."""
    try:
        native.thread_count
    except CurveUpsError as error:
        return error
    return None


@contextmanager
def translated(where: str = "") -> Iterator[None]:
    """Turns exceptions of the native module and its libraries into CurveUpsError or Stopped, here alone.
    `where` names the input they came from."""
    try:
        yield
    except (CurveUpsError, Stopped):
        raise  # the module is missing, or a nested call has translated the exception
    except native.Cancelled:
        raise Stopped from None
    except native.Error as error:
        place = ", ".join(part for part in (where, tile_list(error.tiles)) if part)
        raise CurveUpsError(str(error), place, error.remedy, tiles=error.tiles) from error
    except MemoryError:
        raise CurveUpsError("there is not enough memory", where,
                            "use larger tiles (--set L=...) or a smaller target") from None
    except RuntimeError as error:  # of a library: the native module's own errors are handled above
        raise CurveUpsError(f"unexpected failure: {error}", where, "please report it") from error
