# SPDX-License-Identifier: LGPL-2.1-or-later
"""States of a document against the project's, after a change of each parameter."""

import FreeCAD
import pytest
from curveups.base.native import problem
from curveups.base.parameters import table
from curveups.features import document as documents, properties
from curveups.features.status import status_of
from curveups.stages import BY_NAME

pytestmark = pytest.mark.freecad

PARTS = ("Target", "Layout", "Verification", "Tiles")
TEXTS = {"tiles": "T00002", "faces": "Face1", "opening": "largest", "pieces": "2", "direction": "1,0,0"}


def another(row, value):
    """Another value of a parameter."""
    if row.choices:
        return next(choice for choice in row.choices if choice != value)
    if row.type == "switch":
        return not value
    if row.type in TEXTS:
        return TEXTS[row.type]
    step = 1 if row.type == "integer" else 0.01 * (row.maximum - row.minimum)
    return value + step if value + step <= row.maximum else value - step


def by_states(path):
    """Objects of a solved document that are out of date after a change, by parameter."""
    design = FreeCAD.openDocument(path).Design
    found = {}
    for row in properties.rows():
        before = properties.value_of(design, properties.property_name(row.name))
        write(design, row, another(row, before))
        found[row.name] = stale_parts(design)
        write(design, row, before)
    assert not stale_parts(design)
    return found, problem() is None


def stale_parts(design):
    states = status_of(design).parts
    return {part for part in PARTS if states[part][0] == "out of date"}


def write(design, row, value):
    name = properties.property_name(row.name)
    unit = properties.UNITS.get(row.unit, row.unit)
    plain = not hasattr(getattr(design, name), "getValueAs")
    setattr(design, name, value if plain else f"{value!r} {unit}")


def by_project(path):
    """Objects that are out of date by the project, by parameter."""
    design = FreeCAD.openDocument(path).Design
    found = {}
    for row in table():
        if row.level == "switch":
            continue
        parameters = documents.settings_of(design)
        parameters.set(row.name, another(row, parameters.get(row.name)))
        from_target = documents.project_of(design).copy()
        standing = documents.design_project_of(design).copy()
        for project in (from_target, standing):
            try:
                project.parameters = parameters
            except documents.CurveUpsError:  # values that contradict one another are refused as a whole
                break
        else:
            layout = [name for name in from_target.out_of_date("design") or ()
                      if name in BY_NAME or not by_name(name).keeps_layout]
            # The command line made solids and checked them, which no document keeps.
            judging = [name for name, stage in BY_NAME.items() if stage.contributes(parameters) and (
                standing.out_of_date(name) or standing.out_of_date(name) is None
                and row.keeps_layout and row.name in stage.parameters(parameters))]
            found[row.name] = {part for part, stale in (
                ("Target", from_target.out_of_date("target")), ("Layout", layout),
                ("Verification", layout or judging), ("Tiles", row.effect == "rebuild")) if stale}
    return found


def by_name(name):
    return next(row for row in table() if row.name == name)


def test_every_parameter(dome_document, elsewhere):
    path = str(dome_document)
    expected, (stale, with_solver) = by_project(path), by_states(path)
    assert with_solver and len(expected) > 40
    for name, parts in expected.items():
        assert stale[name] == parts, name
    for home, window in (("no native", False), ("workbench", True)):
        (again, with_solver), _ = elsewhere(by_states, path, home=home, window=window)
        assert with_solver == (home == "workbench") and again == stale
