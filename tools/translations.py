# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renews resources/translations from the texts of the Workbench: CurveUps_LANGUAGE.ts for translators (Qt
Linguist, or by hand: what is new is marked "unfinished"), and the .qm that FreeCAD reads.

    tools/translations [LANGUAGE...]      LANGUAGE (fr, pt-BR) is begun; those that are there are renewed

Qt's own lupdate of Debian 12 passes over calls with keyword arguments, so texts are found here. Those of
parameters come from the native module; without it those of the languages that are there are kept.
"""

from __future__ import annotations

import ast
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path
from typing import Any, Iterable, Iterator, Optional

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "resources" / "translations"
MARKERS = ("translate", "QT_TRANSLATE_NOOP")
SAYING, SHEETS = ("say", "kit.say", "Text"), "CurveUps_Sheets"  # of sheets (base/language.py)
PROPERTIES = "App::Property"  # where FreeCAD's property editor looks for tooltips
ERRORS = ("InvalidInput", "TopologyError", "InfeasibleDesign", "SolverFailure", "IoError")  # in C++
Text = tuple[str, str]  # context and text


def texts() -> set[Text]:
    """Every text that the window shows."""
    found: set[Text] = set()
    for path in [ROOT / "InitGui.py", *(ROOT / "Workbench").rglob("*.py")]:
        found.update(texts_of_python(path.read_text(encoding="utf-8")))
    for path in (ROOT / "resources" / "ui").glob("*.ui"):
        found.update(texts_of_form(path.read_text(encoding="utf-8")))
    found.update(texts_of_parameters())
    found.update(texts_of_states())
    found.update(texts_of_findings())
    found.update(texts_of_errors())
    found.update(texts_of_printers())
    return found


def texts_of_python(source: str) -> Iterator[Text]:
    """Texts that calls of a marker name literally; names hand on texts that are marked elsewhere."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call):
            marker = getattr(node.func, "id", getattr(node.func, "attr", ""))
            values = [argument.value for argument in node.args[:2] if isinstance(argument, ast.Constant)]
            if marker in MARKERS and len(values) == 2:
                yield str(values[0]), str(values[1])
            elif ast.unparse(node.func) in SAYING and values:
                yield SHEETS, " ".join(str(values[0]).split())
            elif marker == "Command":  # of the window's table: its name, text and tooltip
                values = [argument.value for argument in node.args[:3] if isinstance(argument, ast.Constant)]
                yield from ((str(values[0]), str(text)) for text in values[1:])
            elif marker == "Stage":
                yield from (("CurveUpsSolve", word.value.value) for word in node.keywords
                            if word.arg == "label" and isinstance(word.value, ast.Constant))
            elif marker == "Field":  # of the overlay: its name, and what is wrong beyond its limit
                named = [word.value for word in node.keywords if word.arg == "problem"]
                for value in (*node.args[:1], *named):
                    if isinstance(value, ast.Constant):
                        yield "CurveUps_Fields", str(value.value)


def texts_of_parameters() -> set[Text]:
    """Tooltips of parameters, which are in the native module."""
    sys.path.insert(0, str(ROOT / "Workbench"))
    from curveups.features import properties

    return {(PROPERTIES, properties.tip_of(row)) for row in properties.rows()}


def texts_of_states() -> set[Text]:
    """Names of groups of parameters, and of states and verdicts."""
    sys.path.insert(0, str(ROOT / "Workbench"))
    from curveups.features import properties, status
    from curveups.project.project import HOLDS

    states = status.OUT_OF_DATE, status.EMPTY, status.INVALID, status.RUNNING
    return {("CurveUpsSolve", word) for word in (
        *properties.GROUPS, *status.VERDICTS.values(), *HOLDS.values(), *states)}


def texts_of_printers() -> set[Text]:
    """Texts of sheets on printers and on kinds of support."""
    found: set[str] = set()
    for path in (ROOT / "resources" / "printers").glob("*.json"):
        values = json.loads(path.read_text(encoding="utf-8"))
        found.update(values[name] for name in ("name", "material_class", "finish"))
    for path in (ROOT / "native" / "curveups" / "fabrication").glob("*_support.cpp"):
        for bodies, removal in re.findall(r'SupportKind \w+\(\) {\s*return {"([^"]*)", "[^"]*",\s*"([^"]*)"',
                                          path.read_text(encoding="utf-8")):
            found.update((bodies, removal))
    return {(SHEETS, text) for text in found if text}


def texts_of_findings() -> set[Text]:
    """Sentences for or against a design."""
    sys.path.insert(0, str(ROOT / "Workbench"))
    from curveups.base import sentences

    return {(sentences.CONTEXT, text) for text in sentences.texts()}


def texts_of_errors() -> set[Text]:
    """Faults and remedies, as errors have them; {0} stands for what is known only then."""
    from curveups.base.sentences import CONTEXT

    found: set[str] = set()
    for path in (ROOT / "Workbench").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "CurveUpsError":
                found.update(map(_template_of_python, (*node.args[:1], *node.args[2:3])))
    for path in (ROOT / "native" / "curveups").rglob("*.[ch]pp"):
        text = re.sub("//.*", "", path.read_text(encoding="utf-8"))
        for start in re.finditer(rf"\b(?:{'|'.join(ERRORS)})\(", text):
            found.update(map(_template_of_cpp, _arguments(text[start.end():])[:2]))
    return {(CONTEXT, text) for text in found if re.search("[a-z]{2}", re.sub("{.}", "", text))}


def _template_of_python(node: ast.expr) -> str:
    """Texts of an expression."""
    parts = node.values if isinstance(node, ast.JoinedStr) else [node]
    return _numbered(part.value if isinstance(part, ast.Constant) else None for part in parts)


def _arguments(text: str) -> list[list[str]]:
    """Summands of each argument of a call in C++ that begins in front of the text."""
    found: list[list[str]] = [[""]]
    depth = 0
    for token in re.findall(r'"(?:[^"\\]|\\.)*"|[^"]', text):
        depth += (token in "([{") - (token in ")]}") if len(token) == 1 else 0
        if depth < 0:
            break
        if depth == 0 and token == ",":
            found.append([""])
        elif depth == 0 and token == "+":
            found[-1].append("")
        else:
            found[-1][-1] += token
    return found


def _template_of_cpp(parts: list[str]) -> str:
    """Literals among summands, also as std::string, and anything else."""
    literal = r'(?:std::string\()?((?:"(?:[^"\\]|\\.)*"\s*)+)\)?'
    found = [re.fullmatch(literal, part.strip()) for part in parts]
    return _numbered("".join(map(ast.literal_eval, re.findall(r'"(?:[^"\\]|\\.)*"', one[1]))) if one else None
                     for one in found)


def _numbered(texts: Iterable[Any]) -> str:
    """Text with {0}, {1} and so on for the parts that are not known."""
    number = itertools.count()
    return "".join(f"{{{next(number)}}}" if text is None else str(text) for text in texts)


def texts_of_form(source: str) -> Iterator[Text]:
    """Texts of a form, in the context of its class."""
    root = xml.fromstring(source)
    for text in root.iter("string"):
        if text.text and text.get("notr") != "true":
            yield root.findtext("class", ""), text.text


def translations(path: Path) -> dict[Text, Optional[str]]:
    """Translation of each text in a .ts file; None where it is not finished."""
    return {(context.findtext("name", ""), message.findtext("source", "")):
            None if message.find("translation[@type]") is not None else message.findtext("translation")
            for context in xml.parse(path).getroot().iter("context")
            for message in context.iter("message")}


def renew(path: Path) -> int:
    """Writes a language's .ts with the texts of today and what is known of them, and its .qm. Returns how
    many lack a translation."""
    known = translations(path) if path.exists() else {}
    # A text that has moved to another context keeps its translation.
    by_text = {text: translated for (_, text), translated in known.items() if translated}
    root = xml.Element("TS", version="2.1", language=path.stem.split("_", 1)[1].replace("-", "_"))
    contexts: dict[str, xml.Element] = {}
    missing = 0
    for name, text in sorted(texts()):
        if name not in contexts:
            contexts[name] = xml.SubElement(root, "context")
            xml.SubElement(contexts[name], "name").text = name
        message = xml.SubElement(contexts[name], "message")
        xml.SubElement(message, "source").text = text
        translated = known.get((name, text)) or by_text.get(text)
        if translated:
            xml.SubElement(message, "translation").text = translated
        else:
            xml.SubElement(message, "translation", type="unfinished")
            missing += 1
    xml.indent(root, "  ")
    path.write_text('<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
                    + xml.tostring(root, encoding="unicode") + "\n", encoding="utf-8")
    subprocess.run([_lrelease(), "-silent", path, "-qm", path.with_suffix(".qm")], check=True)
    return missing


def _lrelease() -> str:
    found = shutil.which("lrelease", path=os.pathsep.join([os.environ.get("PATH", ""), "/usr/lib/qt6/bin"]))
    if not found:
        sys.exit("curveups: error: Qt's lrelease is missing: install qt6-l10n-tools")
    return found


def main(languages: list[str]) -> None:
    """Renews all languages, and begins those that are named."""
    if any(language.startswith("-") for language in languages):
        sys.exit(__doc__)
    FOLDER.mkdir(exist_ok=True)
    paths = {*FOLDER.glob("CurveUps_*.ts"), *(FOLDER / f"CurveUps_{language}.ts" for language in languages)}
    for path in sorted(paths):
        print(f"{path.name}: {renew(path)} texts without a translation")


if __name__ == "__main__":
    main(sys.argv[1:])
