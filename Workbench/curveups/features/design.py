# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Design object: parameters, the solved layout and the verdict on it.

The layout is kept as the text of design.json, so that reopening a document needs no solving and
changes no bit. Recomputing follows geometry parameters alone.
"""

from __future__ import annotations

import json
from typing import Any

from .. import __version__, pipeline
from ..errors import CurveUpsError, from_native
from ..native import native
from ..solids import model_warnings
from . import properties
from .properties import HIDDEN, OUTPUT, READ_ONLY


class DesignProxy:
    """Behaviour of a Design object."""

    TYPE = "CurveUps::Design"

    def __init__(self, obj: Any, design: Any, verdict: Any):
        self.model = None
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
        obj.Layout = native.write_design(design)
        obj.SolvedVerdict = json.dumps({"valid": verdict.valid, "reasons": verdict.reasons})
        obj.CurveUpsVersion = __version__
        properties.add_parameters(obj, design.parameters)
        obj.Proxy = self

    def execute(self, obj: Any) -> None:
        """Builds the solids for the current geometry parameters, unless they stand already. Where they
        can't be, raises and leaves what depends on this object as it was."""
        standing, self.model = self.model, None
        try:
            design = native.read_design(obj.Layout)
            parameters = design.parameters
            changed = properties.apply_to(obj, parameters)
            parameters.check()
            design.parameters = parameters
            outcome = pipeline.Outcome(design.name, design, native.evaluate_design(design))
            model = standing or native.make_print_model(design)
        except native.Error as error:
            raise from_native(error, obj.Label) from None
        self.model = model
        self._judge(obj, outcome, changed)

    def _judge(self, obj: Any, outcome: Any, changed: list[str]) -> None:
        import FreeCAD

        saved = json.loads(obj.SolvedVerdict)
        valid, reasons = saved["valid"], saved["reasons"]
        if changed:
            outcome.verify_note = f"geometry changed since verification ({', '.join(changed)})"
            verdict = pipeline.judge(outcome)
            valid, reasons = verdict.valid, verdict.reasons
        obj.Verdict = {True: "valid", False: "not valid", None: "not judged"}[valid]
        obj.Reasons = reasons
        if changed:
            found = [warning["what"] for warning in model_warnings(self.model)]
            for text in (reasons if valid is False else []) + found:
                FreeCAD.Console.PrintWarning(f"{obj.Label}: {text}\n")

    def onChanged(self, obj: Any, name: str) -> None:
        """A parameter that changed, by undo as well, leaves the model behind."""
        if properties.is_free(name):
            self.model = None

    def shape(self, obj: Any, kind: str) -> Any:
        """The compound of one kind of body, from the last recompute."""
        if self.model is None:
            self.execute(obj)
        try:
            return self.model.shape(kind)
        except native.Error as error:
            raise from_native(error, obj.Label) from None

    def onDocumentRestored(self, obj: Any) -> None:
        """Documents of older versions lack the parameters that came later."""
        self.model = None
        try:
            properties.add_parameters(obj, native.read_design(obj.Layout).parameters)
        except native.Error as error:
            raise CurveUpsError(f"the layout can't be read: {error}", obj.Label,
                                "open an older copy of the document") from None
        _attach_view(obj)

    def dumps(self) -> dict:
        return {"type": self.TYPE}

    def loads(self, state: Any) -> None:
        self.model = None

    __getstate__ = dumps
    __setstate__ = loads


def _attach_view(obj: Any) -> None:
    import FreeCAD

    if FreeCAD.GuiUp:
        from ..viewproviders.design import DesignView

        DesignView(obj.ViewObject)
