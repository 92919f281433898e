# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object: parameters, the solved layout and the verdict on it.

The layout is kept as the text of design.json, so that reopening a document needs no solving and
changes no bit. Recomputing follows geometry parameters alone.
"""

from __future__ import annotations

import json
from typing import Any

from .. import __version__
from ..errors import CurveUpsError
from ..native import native, translated
from ..project import Project, Results
from ..verdict import Verdict
from . import properties
from .properties import HIDDEN, OUTPUT, READ_ONLY


class DesignProxy:
    """Behaviour of a Design object."""

    TYPE = "CurveUps::Design"

    def __init__(self, obj: Any, results: Results):
        self.project: Project | None = None
        obj.addProperty("App::PropertyString", "Layout", "Design",
                        "The solved layout, as the text of design.json.", READ_ONLY | HIDDEN)
        obj.addProperty("App::PropertyString", "Verdict", "Design",
                        "Whether the design is valid as it stands.", READ_ONLY | OUTPUT)
        obj.addProperty("App::PropertyStringList", "Reasons", "Design",
                        "Why it is not, or was not judged.", READ_ONLY | OUTPUT)
        obj.addProperty("App::PropertyString", "SolvedVerdict", "Design",
                        "The verdict at the geometry parameters the layout was solved with.",
                        READ_ONLY | HIDDEN)
        obj.addProperty("App::PropertyString", "CurveUpsVersion", "Design",
                        "The version that made this object.", READ_ONLY)
        design, verdict = results.design, results.verdict
        obj.Layout = native.write_design(design)
        obj.SolvedVerdict = json.dumps({"valid": verdict.valid, "reasons": verdict.reasons})
        obj.CurveUpsVersion = __version__
        properties.add_parameters(obj, design.parameters)
        obj.Proxy = self
        self.project = Project.of_design(design, obj.Label, results.made)

    def execute(self, obj: Any) -> None:
        """Makes the bodies for the current geometry parameters, unless they stand already. Where they
        can't be, raises and leaves what depends on this object as it was."""
        project = self._project(obj)
        parameters = project.latest("design").design.parameters
        with translated(obj.Label):
            changed = properties.apply_to(obj, parameters)
        project.parameters = parameters
        results = project.run(("figures", "bodies"), strict=True,
                              note=f"geometry changed since verification ({', '.join(changed)})")
        saved = json.loads(obj.SolvedVerdict)
        verdict = results.verdict if changed else Verdict(saved["valid"], tuple(saved["reasons"]))
        obj.Verdict, obj.Reasons = verdict.word, list(verdict.reasons)
        if changed:
            import FreeCAD

            found = [warning["what"] for warning in results["bodies"].warnings()]
            for text in (*(verdict.reasons if verdict.valid is False else ()), *found):
                FreeCAD.Console.PrintWarning(f"{obj.Label}: {text}\n")

    def shape(self, obj: Any, kind: str) -> Any:
        """The compound of one kind of body, from the last recompute."""
        with translated(obj.Label):
            return self._project(obj).run(("bodies",), strict=True)["bodies"].model.shape(kind)

    def _project(self, obj: Any) -> Project:
        if self.project is None:
            with translated(obj.Label):
                self.project = Project.of_design(native.read_design(obj.Layout), obj.Label)
        return self.project

    def onDocumentRestored(self, obj: Any) -> None:
        """Documents of older versions lack the parameters that came later."""
        self.project = None
        try:
            properties.add_parameters(obj, native.read_design(obj.Layout).parameters)
        except native.Error as error:
            raise CurveUpsError(f"the layout can't be read: {error}", obj.Label,
                                "open an older copy of the document") from None
        _attach_view(obj)

    def dumps(self) -> dict:
        return {"type": self.TYPE}

    def loads(self, state: Any) -> None:
        self.project = None

    __getstate__ = dumps
    __setstate__ = loads


def _attach_view(obj: Any) -> None:
    import FreeCAD

    if FreeCAD.GuiUp:
        from ..viewproviders.design import DesignView

        DesignView(obj.ViewObject)
