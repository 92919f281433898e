# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's File > Export: a design or its bodies go through the writers of print files, everything else
goes to FreeCAD's own module as before.

FreeCAD's own write an empty STL and no STEP of a Design, and triangulate thousands of solids once more.
window/start.py lets FreeCAD's dialog ask here.
"""

from __future__ import annotations

import importlib
import threading
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator, Optional, Sequence

import FreeCAD

from ..base.errors import CurveUpsError, Stopped
from ..base.native import native
from ..base.output import Folder
from ..base.progress import Progress
from ..stages.stage import Job
from . import actions, proxy

# By the ending of a file: FreeCAD's own module, and that for windows.
_FREECADS = {".step": ("Import", "ImportGui"), ".stp": ("Import", "ImportGui")}
_FORMATS = {".step": "step", ".stp": "step", ".stl": "stl", ".3mf": "3mf"}


def exportOptions(filename: str) -> Optional[dict]:
    """What FreeCAD asks for before it exports: options of its own module, where that writes and has some."""
    if proxy.selection is not None and any(map(_is_ours, proxy.selection())):
        return None
    ask = getattr(_freecads(filename), "exportOptions", None)
    return ask(filename) if ask is not None else None


def export(objects: Sequence[Any], filename: str, options: Optional[dict] = None) -> None:
    """Writes what is selected; Escape stops it, and no file is there then. Raises CurveUpsError for a design
    that can't be written; where there is a window, it says so there instead."""
    try:
        design, kind = _chosen(objects, filename)
        if design is None:
            module = _freecads(filename)
            module.export(objects, filename, *([options] if options is not None else []))
        else:
            _write(design, kind, Path(filename))
    except (Stopped, native.Cancelled):
        return
    except CurveUpsError as error:
        if proxy.show_error is None:
            raise
        proxy.show_error(error)


def _freecads(filename: str) -> Any:
    names = _FREECADS.get(Path(filename).suffix.lower(), ("Mesh", "Mesh"))
    return importlib.import_module(names[bool(FreeCAD.GuiUp)])


def _is_ours(obj: Any) -> bool:
    """Whether our writers write it."""
    return proxy.type_of(obj) in ("CurveUps::Design", "CurveUps::Bodies")


def _chosen(objects: Sequence[Any], filename: str) -> tuple[Any, str]:
    """The design and the kind of its bodies that are to be written by us; None for what is FreeCAD's."""
    ours = list(filter(_is_ours, objects))
    found = {design.Name: design for obj in ours if (design := proxy.design_of(obj)) is not None}
    if len(found) == 1 and len(ours) == len(objects):
        return next(iter(found.values())), ours[0].Kind if len(ours) == 1 and hasattr(
            ours[0], "Kind") else "print"
    if any(proxy.type_of(obj) == "CurveUps::Design" for obj in ours):
        raise CurveUpsError("one design is exported at a time", filename, "select it alone, or its bodies")
    return None, ""


def _write(design: Any, kind: str, path: Path) -> None:
    ending = _FORMATS.get(path.suffix.lower(), "")
    if not ending:
        raise CurveUpsError(f"designs are not written as {path.suffix}", str(path), "choose STEP, STL or 3MF")
    doubts = actions.doubts(design)
    with _progress(path.name) as progress:
        Folder(path.parent).write(path.name, lambda place: actions.write_print(
            design, str(place), ending, kind, Job(progress)))
    if doubts:
        FreeCAD.Console.PrintWarning(f"CurveUps: {path.name} should not be printed, since {doubts[0]}\n")


@contextmanager
def _progress(title: str) -> Iterator[Progress]:
    """FreeCAD's bar of progress, which is for one thread. It raises where Escape was pressed."""
    bar, thread = FreeCAD.Base.ProgressIndicator(), threading.current_thread()
    bar.start(title, 0)  # how many steps there will be is not known

    def show(what: str, share: float) -> bool:
        try:
            if threading.current_thread() is thread:
                bar.next(True)
        except Exception:
            return False
        return True

    try:
        yield show
    finally:
        bar.stop()
