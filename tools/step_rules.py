# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules of the STEP standard (ISO 10303-21, AP214) that readers rarely report: references, types, rules.
The module reads text alone and shares nothing with the writer."""

from __future__ import annotations

import math
import re
from collections import Counter
from pathlib import Path

CURVE, SURFACE = "LINE|CIRCLE", "PLANE|SPHERICAL_SURFACE|CYLINDRICAL_SURFACE"
SHAPE = "SHAPE_REPRESENTATION|ADVANCED_BREP_SHAPE_REPRESENTATION"

# Attributes of each entity: s a text, r a real number, b true or false, v three reals, $ and * as they are,
# #A|B a reference to an A or a B, [#A] a list of such; spaces only divide. Complex entities by the names
# of all their parts.
ENTITIES = {
    "CARTESIAN_POINT": "s v",
    "DIRECTION": "s v",
    "VECTOR": "s #DIRECTION r",
    "LINE": "s #CARTESIAN_POINT #VECTOR",
    "CIRCLE": "s #AXIS2_PLACEMENT_3D r",
    "AXIS2_PLACEMENT_3D": "s #CARTESIAN_POINT #DIRECTION #DIRECTION",
    "PLANE": "s #AXIS2_PLACEMENT_3D",
    "SPHERICAL_SURFACE": "s #AXIS2_PLACEMENT_3D r",
    "CYLINDRICAL_SURFACE": "s #AXIS2_PLACEMENT_3D r",
    "VERTEX_POINT": "s #CARTESIAN_POINT",
    "EDGE_CURVE": f"s #VERTEX_POINT #VERTEX_POINT #{CURVE} b",
    "ORIENTED_EDGE": "s * * #EDGE_CURVE b",
    "EDGE_LOOP": "s [#ORIENTED_EDGE]",
    "FACE_OUTER_BOUND": "s #EDGE_LOOP b",
    "FACE_BOUND": "s #EDGE_LOOP b",
    "ADVANCED_FACE": f"s [#FACE_OUTER_BOUND|FACE_BOUND] #{SURFACE} b",
    "CLOSED_SHELL": "s [#ADVANCED_FACE]",
    "MANIFOLD_SOLID_BREP": "s #CLOSED_SHELL",
    "SHAPE_REPRESENTATION": "s [#AXIS2_PLACEMENT_3D] #context",
    "ADVANCED_BREP_SHAPE_REPRESENTATION": "s [#AXIS2_PLACEMENT_3D|MANIFOLD_SOLID_BREP] #context",
    "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION": "s [#STYLED_ITEM] #context",
    "ITEM_DEFINED_TRANSFORMATION": "s s #AXIS2_PLACEMENT_3D #AXIS2_PLACEMENT_3D",
    "APPLICATION_CONTEXT": "s",
    "APPLICATION_PROTOCOL_DEFINITION": "s s i #APPLICATION_CONTEXT",
    "PRODUCT_CONTEXT": "s #APPLICATION_CONTEXT s",
    "PRODUCT_DEFINITION_CONTEXT": "s #APPLICATION_CONTEXT s",
    "PRODUCT": "s s s [#PRODUCT_CONTEXT]",
    "PRODUCT_RELATED_PRODUCT_CATEGORY": "s $ [#PRODUCT]",
    "PRODUCT_DEFINITION_FORMATION": "s s #PRODUCT",
    "PRODUCT_DEFINITION": "s s #PRODUCT_DEFINITION_FORMATION #PRODUCT_DEFINITION_CONTEXT",
    "PRODUCT_DEFINITION_SHAPE": "s s #PRODUCT_DEFINITION|NEXT_ASSEMBLY_USAGE_OCCURRENCE",
    "SHAPE_DEFINITION_REPRESENTATION": f"#PRODUCT_DEFINITION_SHAPE #{SHAPE}",
    "NEXT_ASSEMBLY_USAGE_OCCURRENCE": "s s s #PRODUCT_DEFINITION #PRODUCT_DEFINITION $",
    "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION": "#relation #PRODUCT_DEFINITION_SHAPE",
    "STYLED_ITEM": "s [#PRESENTATION_STYLE_ASSIGNMENT] #MANIFOLD_SOLID_BREP",
    "PRESENTATION_STYLE_ASSIGNMENT": "[#SURFACE_STYLE_USAGE]",
    "SURFACE_STYLE_USAGE": "side #SURFACE_SIDE_STYLE",
    "SURFACE_SIDE_STYLE": "s [#SURFACE_STYLE_FILL_AREA]",
    "SURFACE_STYLE_FILL_AREA": "#FILL_AREA_STYLE",
    "FILL_AREA_STYLE": "s [#FILL_AREA_STYLE_COLOUR]",
    "FILL_AREA_STYLE_COLOUR": "s #COLOUR_RGB",
    "COLOUR_RGB": "s r r r",
    "UNCERTAINTY_MEASURE_WITH_UNIT": "length #unit s s",
}
COMPLEX = {
    "LENGTH_UNIT NAMED_UNIT SI_UNIT": "unit",
    "NAMED_UNIT PLANE_ANGLE_UNIT SI_UNIT": "unit",
    "NAMED_UNIT SI_UNIT SOLID_ANGLE_UNIT": "unit",
    "GEOMETRIC_REPRESENTATION_CONTEXT GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT GLOBAL_UNIT_ASSIGNED_CONTEXT "
    "REPRESENTATION_CONTEXT": "context",
    "REPRESENTATION_RELATIONSHIP REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION "
    "SHAPE_REPRESENTATION_RELATIONSHIP": "relation",
}
# What nothing has to refer to.
ROOTS = {"APPLICATION_PROTOCOL_DEFINITION", "PRODUCT_RELATED_PRODUCT_CATEGORY",
         "SHAPE_DEFINITION_REPRESENTATION", "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION",
         "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION"}

TEXT = r"'(?:[^'\\]|''|\\\\|\\X2\\(?:[0-9A-F]{4})+\\X0\\|\\X4\\(?:[0-9A-F]{8})+\\X0\\)*'"
REAL = r"-?\d+\.\d*(?:E[+-]?\d+)?"
PLAIN = {"s": TEXT, "r": REAL, "v": rf"\((?:{REAL},){{2}}{REAL}\)", "b": r"\.[TF]\.", "i": r"\d+",
         "$": r"\$", "*": r"\*", "side": r"\.BOTH\.", "length": rf"LENGTH_MEASURE\({REAL}\)"}


def _pattern(attributes: str) -> tuple[re.Pattern[str], list[set[str]]]:
    """Pattern of the text in brackets, with a group for each reference or list of them, and the kinds each
    may name."""
    parts, kinds = [], []
    for token in attributes.split():
        if token in PLAIN:
            parts.append(PLAIN[token])
            continue
        parts.append(r"\((#\d+(?:,\s?#\d+)*)\)" if token[0] == "[" else r"(#\d+)")
        kinds.append(set(token.strip("[]#").split("|")))
    return re.compile(",".join(parts)), kinds


_PATTERNS = {keyword: _pattern(attributes) for keyword, attributes in ENTITIES.items()}
_ENTITY = re.compile(r"#(\d+)=(\(?)([A-Z0-9_]*)(.*)", re.DOTALL)
_NUMBER = re.compile(r"#(\d+)")


class StepFile:
    """The entities of a file by number: keyword, text of the attributes, numbers they refer to. `wrong`:
    what the file breaks."""

    def __init__(self, path: Path) -> None:
        self.wrong: list[str] = []
        self.text: dict[int, str] = {}
        self.kind: dict[int, str] = {}
        self.refers: dict[int, list[list[int]]] = {}
        body = path.read_text(encoding="ascii")  # others are encoded
        head, data = body.split("DATA;\n", 1)
        if not data.endswith("ENDSEC;\nEND-ISO-10303-21;\n"):
            self.wrong.append("does not end")
        if max(map(len, body.split("\n"))) > 2000:
            self.wrong.append("has long lines")
        for entity in data.split(";\n")[:-3]:
            self._add(entity)
        self._check_references()
        for check in (self._check_products, self._check_relations, self._check_edges,
                      self._check_accuracy):
            if not self.wrong:
                check()

    def named(self, keyword: str) -> list[int]:
        return [number for number, kind in self.kind.items() if kind == keyword]

    def first_text(self, number: int) -> str:
        """The first attribute, as it is written."""
        found = re.match(TEXT, self.text[number])
        assert found
        return found[0][1:-1]

    @property
    def product_ids(self) -> list[str]:
        return [self.first_text(number) for number in self.named("PRODUCT")]

    @property
    def accuracy(self) -> float:
        """mm, the coarsest declared."""
        return max(float(self.text[number].split("(")[1].split(")")[0])
                   for number in self.named("UNCERTAINTY_MEASURE_WITH_UNIT"))

    def _add(self, entity: str) -> None:
        found = _ENTITY.fullmatch(entity)
        if not found:
            self.wrong.append(f"{entity[:40]!r} is no entity")
            return
        number, keyword = int(found[1]), found[3]
        attributes = found[4][1:-1] if not found[2] else keyword + found[4][:-1]
        if found[2]:
            keyword = COMPLEX.get(" ".join(re.findall(r"([A-Z0-9_]+)\((?!.*LENGTH_MEASURE)", attributes)), "")
        if number in self.kind:
            self.wrong.append(f"#{number} is there twice")
        self.kind[number], self.text[number] = keyword, attributes
        if found[2]:
            self.refers[number] = [[int(n)] for n in _NUMBER.findall(attributes)]
            if not keyword:
                self.wrong.append(f"#{number} {attributes[:60]} is not known")
            return
        match = _PATTERNS[keyword][0].fullmatch(attributes) if keyword in _PATTERNS else None
        if not match:
            self.wrong.append(f"#{number} {keyword}({attributes[:60]} is not as it should be")
            return
        self.refers[number] = [[int(n) for n in _NUMBER.findall(group)] for group in match.groups()]

    def _check_references(self) -> None:
        used = set()
        for number, groups in self.refers.items():
            kinds = _PATTERNS[self.kind[number]][1] if self.kind[number] in _PATTERNS else None
            for position, group in enumerate(groups):
                for other in group:
                    used.add(other)
                    if other not in self.kind:
                        self.wrong.append(f"#{number} refers to #{other}, which is not there")
                    elif kinds and self.kind[other] not in kinds[position]:
                        self.wrong.append(f"#{number} {self.kind[number]} refers to a {self.kind[other]}")
        for number in set(self.kind) - used:
            if self.kind[number] not in ROOTS:
                self.wrong.append(f"#{number} {self.kind[number]} is used by nothing")

    def _check_products(self) -> None:
        """Each product has an id of its own and a shape; an assembly's parts hang below one root."""
        for what, ids in (("product", self.product_ids),
                          ("usage", [self.first_text(n)
                                     for n in self.named("NEXT_ASSEMBLY_USAGE_OCCURRENCE")])):
            twice = [one for one, count in Counter(ids).items() if count > 1 or not one]
            if twice:
                self.wrong.append(f"the {what} id {twice[0]!r} is there more than once")
        shaped = {self.refers[self.refers[n][0][0]][0][0]
                  for n in self.named("SHAPE_DEFINITION_REPRESENTATION")}
        if shaped != set(self.named("PRODUCT_DEFINITION")):
            self.wrong.append("a product has no shape")
        usages = self.named("NEXT_ASSEMBLY_USAGE_OCCURRENCE")
        parts = {self.refers[n][1][0] for n in usages}
        if len(parts) != len(usages) or len(shaped - parts) != 1:
            self.wrong.append("the assembly is no tree with one root")

    def _check_relations(self) -> None:
        """representation_relationship_with_transformation, WR1: between two contexts; its operator takes an
        item of the first representation to one of the second."""
        for number in self.named("relation"):
            (first,), (second,), (operator,) = self.refers[number]
            items = [self.refers[shape][0] for shape in (first, second)]
            contexts = [self.refers[shape][1][0] for shape in (first, second)]
            (here,), (there,) = self.refers[operator]
            if contexts[0] == contexts[1]:
                self.wrong.append(f"#{number} relates a context with itself")
            if here not in items[0] or there not in items[1]:
                self.wrong.append(f"#{number}: the transformation is not between its representations")

    def _check_edges(self) -> None:
        """Loops are closed; of each edge there is one use in each direction; each face is in one shell."""
        uses: dict[int, list[bool]] = {}
        for bound in (*self.named("FACE_OUTER_BOUND"), *self.named("FACE_BOUND")):
            number, along, ends = self.refers[bound][0][0], self.text[bound].endswith(".T."), []
            for oriented in self.refers[number][0]:
                edge, forward = self.refers[oriented][0][0], self.text[oriented].endswith(".T.")
                uses.setdefault(edge, []).append(forward == along)
                a, b = self.refers[edge][0][0], self.refers[edge][1][0]
                ends.append((a, b) if forward else (b, a))
            if any(end[1] != ends[(k + 1) % len(ends)][0] for k, end in enumerate(ends)):
                self.wrong.append(f"#{number}: the loop is not closed")
        for edge, directions in uses.items():
            if sorted(directions) != [False, True]:
                self.wrong.append(f"#{edge}: the edge is not between two faces")
        shells = self.named("CLOSED_SHELL")
        faces = Counter(face for shell in shells for face in self.refers[shell][0])
        if set(faces) != set(self.named("ADVANCED_FACE")) or max(faces.values()) > 1:
            self.wrong.append("a face is not in one shell")

    def _check_accuracy(self) -> None:
        """Corners lie on the planes and lines they are said to lie on, up to the accuracy declared."""
        point = {n: _vector(self.text[n]) for n in (*self.named("CARTESIAN_POINT"), *self.named("DIRECTION"))}
        corners = {n: point[self.refers[n][0][0]] for n in self.named("VERTEX_POINT")}
        accuracy, worst = self.accuracy, 0.0
        for face in self.named("ADVANCED_FACE"):
            bounds, (surface,) = self.refers[face]
            if self.kind[surface] != "PLANE":
                continue
            (origin,), (normal,), _ = self.refers[self.refers[surface][0][0]]
            for oriented in (n for bound in bounds for n in self.refers[self.refers[bound][0][0]][0]):
                edge = self.refers[oriented][0][0]
                for vertex in (self.refers[edge][0][0], self.refers[edge][1][0]):
                    off = sum((c - o) * d for c, o, d in zip(corners[vertex], point[origin], point[normal]))
                    worst = max(worst, abs(off))
        for edge in self.named("EDGE_CURVE"):
            (a,), (b,), (curve,) = self.refers[edge]
            if self.kind[curve] != "LINE":
                continue
            (origin,), (vector,) = self.refers[curve]
            d = point[self.refers[vector][0][0]]
            for vertex in (a, b):
                away = [c - o for c, o in zip(corners[vertex], point[origin])]
                along = sum(x * y for x, y in zip(away, d))
                worst = max(worst, math.sqrt(max(0.0, sum(x * x for x in away) - along * along)))
        if worst > accuracy:
            self.wrong.append(f"corners lie {worst:.3g} mm beside their faces and edges, where "
                              f"{accuracy:g} mm are declared")


def _vector(text: str) -> list[float]:
    return [float(number) for number in text[text.rindex("(") + 1:-1].split(",")]


def wrong_step_files(paths: list[Path]) -> list[str]:
    """Faults of each file, and ids of products that two of them share."""
    wrong: list[str] = []
    seen: dict[str, Path] = {}
    for path in paths:
        file = StepFile(path)
        wrong += [f"{path.name}: {what}" for what in file.wrong[:5]]
        for one in file.product_ids:
            if seen.setdefault(one, path) is not path:
                wrong.append(f"{path.name}: product id {one!r} is that of {seen[one].name}, too")
    return wrong
