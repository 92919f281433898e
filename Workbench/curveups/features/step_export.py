# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's File > Export of a design: a STEP file with a name and a colour for every body, which FreeCAD's
own has not."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Sequence

from ..base.errors import CurveUpsError
from ..base.output import Folder
from . import actions
from .proxy import design_of


def export(objects: Sequence[Any], filename: str) -> None:
    """Writes the print of the design that the objects are, or belong to. Raises CurveUpsError."""
    import FreeCAD

    found = {design.Name: design for obj in objects if (design := design_of(obj)) is not None}
    if len(found) != 1:
        raise CurveUpsError("one design is exported at a time", filename, "select a design, or its bodies")
    design = next(iter(found.values()))
    doubts = actions.doubts(design)
    path = Path(filename)
    Folder(path.parent).write(path.name, lambda place: actions.write_print(design, str(place)))
    if doubts:
        FreeCAD.Console.PrintWarning(f"CurveUps: {path.name} says that it should not be printed, since "
                                     f"{doubts[0]}\n")
