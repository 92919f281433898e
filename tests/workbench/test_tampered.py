# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that somebody changed: properties that are gone or called otherwise, results that are damaged.
They open, say what is wrong in a line, and everything else in them is there."""

import re
import traceback
import zipfile
from typing import Any, Callable

import FreeCAD
import pytest
from curveups.base.errors import CurveUpsError
from curveups.features import document as documents

pytestmark = pytest.mark.freecad


def probe(path):
    """What commands do with a design first; all may refuse with an error of ours, and nothing else."""
    document = FreeCAD.openDocument(str(path))
    wrong = []
    for design in documents.designs(document):
        probes: list[Callable[[Any], Any]] = [
            documents.settings_of, documents.project_of, documents.design_project_of, documents.cuts_of,
            documents.state_of, lambda obj: obj.Proxy.refresh(obj), lambda obj: document.recompute()]
        for one in probes:
            try:
                one(design)
            except CurveUpsError:
                pass
            except Exception:
                wrong.append(traceback.format_exc())
        assert isinstance("; ".join([design.Verdict, design.Status, *design.Reasons]), str)
    FreeCAD.closeDocument(document.Name)
    return "\n".join(wrong)


def objects_of(xml):
    """Names of the objects, with the span of each one's properties."""
    data = xml.index("<ObjectData")
    for match in re.finditer(r'<Object name="(\w+)"[^>]*>.*?</Object>', xml[data:], re.S):
        yield match[1], data + match.start(), data + match.end()


def properties_of(text):
    return re.findall(r'<Property name="(\w+)" type="([\w:]+)"', text)


def without(text, name):
    """An object's properties without one."""
    found = re.subn(r'\s*<Property name="%s" .*?</Property>' % name, "", text, flags=re.S)
    assert found[1] == 1, name
    return re.sub(r'<Properties Count="(\d+)"', lambda m: f'<Properties Count="{int(m[1]) - 1}"', found[0])


def renamed(text, name):
    return text.replace(f'<Property name="{name}" ', f'<Property name="{name}Once" ')


def with_text(text, name, value):
    value = value.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")
    found = re.subn(r'(<Property name="%s" .*?<String value=")[^"]*' % name,
                    lambda m: m[1] + value, text, flags=re.S)
    assert found[1] == 1, name
    return found[0]


def stored_text(text, name):
    found = re.search(r'<Property name="%s" .*?<String value="([^"]*)' % name, text, re.S)
    assert found, name
    return found[1].replace("&quot;", '"').replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")


def variants(xml):
    """(name, changed xml), one change each."""
    for obj, begin, end in objects_of(xml):
        text = xml[begin:end]

        def changed(new):
            return xml[:begin] + new + xml[end:]

        for name, kind in properties_of(text):
            if name in ("Proxy", "Label", "Visibility", "ExpressionEngine", "Label2"):
                continue
            yield f"{obj}-without-{name}", changed(without(text, name))
            if obj == "Design":
                yield f"{obj}-renamed-{name}", changed(renamed(text, name))
            if kind != "App::PropertyString":
                continue
            for k, value in enumerate(("", "{", "[]", "{}", "null", '{"records": 3}',
                                       '{"records": {"design": {"key": {"L": 3}}}, "valid": 5}',
                                       stored_text(text, name)[:-20])):
                if name not in ("CurveUpsVersion",):
                    yield f"{obj}-{name}-is-{k}", changed(with_text(text, name, value))


@pytest.fixture(scope="module")
def tampered(dome_document, tmp_path_factory):
    folder = tmp_path_factory.mktemp("tampered")
    with zipfile.ZipFile(dome_document) as archive:
        contents = {entry: archive.read(entry) for entry in archive.namelist()}
    for name, xml in variants(contents["Document.xml"].decode("utf-8")):
        with zipfile.ZipFile(folder / f"{name}.FCStd", "w") as archive:
            for entry, data in contents.items():
                archive.writestr(entry, xml.encode() if entry == "Document.xml" else data)
    return folder


@pytest.mark.parametrize("name, state", [
    ("Design-Results-is-1", "out of date"), ("Design-Keys-is-1", "empty"),
    ("Design-without-Keys", "empty"), ("Design-without-Layout", "current")])
def test_damaged_results_are_said(tampered, name, state):
    """They are no layout that is current, and Solve makes a sound design of them."""
    document = FreeCAD.openDocument(f"{tampered}/{name}.FCStd")
    design = documents.designs(document)[0]
    said = "; ".join(design.Reasons)
    assert design.Status == state, (name, design.Status)
    assert name == "Design-without-Layout" or "damaged" in design.Reasons[0], list(design.Reasons)
    assert name != "Design-Results-is-1" or "the stored results are damaged" in said, said
    assert design.Target.File or design.Target.BuiltIn, "no source"
    design.Results = ""
    documents.take(design, documents.project_of(design).run(("design", "figures", "verification")))
    assert design.Layout is not None and len(design.Layout.Poses) == 6 * 54
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)


def test_tampered_documents(capfd, tampered):
    wrong = {}
    for path in sorted(tampered.glob("*.FCStd")):
        text = probe(path) + "".join(capfd.readouterr())
        if re.search(r"Traceback|KeyError|AttributeError|ReferenceError|IndexError", text):
            wrong[path.stem] = text[-900:]
    assert len(list(tampered.glob("*.FCStd"))) > 100
    assert not wrong, "\n".join(f"{name}: {text}" for name, text in wrong.items())
