# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that somebody changed: properties that are gone or called otherwise, results that are damaged.
They open, say what is wrong in a line, and everything else in them is there."""

import re
import struct
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


# Others of ours, what there is not, and one of Python's. Of a class of C, such as collections.OrderedDict,
# FreeCAD 0.20 makes an object without calling the class, and crashes in Python's next garbage collection,
# where the workbench is not installed too.
CLASSES = (("curveups.features.cuts", "CutsProxy"), ("curveups.features.design", "DesignProxy"),
           ("nowhere", "Proxy"), ("json", "JSONDecoder"))


def with_other_proxies(xml):
    for obj, begin, end in objects_of(xml):
        for module, name in CLASSES:
            changed, count = re.subn(r'module="curveups\.features\.\w+" class="\w+"',
                                     f'module="{module}" class="{name}"', xml[begin:end])
            if count and changed != xml[begin:end]:
                yield f"{obj}-proxy-{module}-{name}", xml[:begin] + changed + xml[end:]


def with_other_links(xml):
    """The slots of the Design, and the part that a Target is of: to any other object, to none, to one that
    there is not."""
    names = [obj for obj, _, _ in objects_of(xml)]
    links = r'<Property name="(\w+)" type="App::PropertyLink"[^>]*>\s*<Link value="(\w*)"'
    for match in re.finditer(links, xml):
        for name in (*names, "", "Nobody"):
            if name != match[2] and match[1] != "Tip":
                yield f"link-{match[1]}-{name}", xml[:match.start(2)] + name + xml[match.end(2):]


def with_other_lists(contents):
    """(name, contents): lists that FreeCAD stores as files or in Document.xml, damaged, empty and swapped."""
    xml = contents["Document.xml"].decode("utf-8")
    for match in re.finditer(r'<(?:Float|Vector)List file="(\w+)"', xml):
        file, data = match[1], contents[match[1]]
        count = len(data[4:]) // max(1, struct.unpack("<I", data[:4])[0])
        others = {"empty": struct.pack("<I", 0)}
        if len(data) > 4:
            rest = data[4:-count] if count else b""
            others["one-less"] = struct.pack("<I", struct.unpack("<I", data[:4])[0] - 1) + rest
            others["nan"] = data[:4] + struct.pack("<d", float("nan")) + data[12:]
            others["huge"] = data[:4] + struct.pack("<d", 1e300) + data[12:]
        for name, other in others.items():
            if other != data:
                yield f"list-{file}-{name}", {**contents, file: other}
    lists = re.findall(r'<FloatList file="(\w+)"', xml)
    for one, another in zip(lists, lists[1:]):
        yield f"list-{one}-is-{another}", {**contents, one: contents[another], another: contents[one]}
    wrong = {"odd": [1], "far": [0, 10 ** 6], "negative": [-5, 3], "many": [0, 1] * 50_000}
    integers = r'name="(\w+)" type="App::PropertyIntegerList"[^>]*>\s*(<IntegerList.*?</IntegerList>)'
    for match in re.finditer(integers, xml, re.S):
        for name, values in wrong.items():
            inner = "".join(f'<I v="{value}"/>' for value in values)
            new = f'<IntegerList count="{len(values)}">{inner}</IntegerList>'
            yield (f"list-{match[1]}-{name}",
                   {**contents, "Document.xml": (xml[:match.start(2)] + new + xml[match.end(2):]).encode()})


@pytest.fixture(scope="module")
def document_of_six(designed, tmp_path_factory):
    """Of six tiles: it is opened once for each change."""
    return designed(tmp_path_factory.mktemp("six"), rings=1)


@pytest.fixture(scope="module")
def tampered(document_of_six, tmp_path_factory):
    folder = tmp_path_factory.mktemp("tampered")
    with zipfile.ZipFile(document_of_six) as archive:
        contents = {entry: archive.read(entry) for entry in archive.namelist()}
    whole = contents["Document.xml"].decode("utf-8")
    changed = [(name, {**contents, "Document.xml": xml.encode()}) for change in
               (variants, with_other_proxies, with_other_links) for name, xml in change(whole)]
    for name, entries in (*changed, *with_other_lists(contents)):
        with zipfile.ZipFile(folder / f"{name}.FCStd", "w") as archive:
            for entry, data in entries.items():
                archive.writestr(entry, data)
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
    assert design.Layout is not None and len(design.Layout.Poses) == 6 * 6
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)


@pytest.mark.parametrize("slot, other", [
    ("Cuts", "Layout"), ("Layout", "Verification"), ("Verification", "Cuts"), ("Tiles", "Support"),
    ("Target", "Tiles")])
def test_what_a_link_was_changed_to_is_put_right(tampered, slot, other):
    document = FreeCAD.openDocument(f"{tampered}/link-{slot}-{other}.FCStd")
    design = document.Design
    assert getattr(design, slot) == document.getObject(slot)
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)
    setattr(design, slot, document.getObject(other))  # a script's
    assert getattr(design, slot) == document.getObject(slot) and design.Verdict == "valid"
    document.removeObject(slot)
    setattr(design, slot, document.getObject(other))
    assert getattr(design, slot) is None  # there is no other of its kind


def test_links_that_were_swapped_are_put_right(dome_document):
    document = FreeCAD.openDocument(str(dome_document))
    design = document.Design
    design.Proxy._refreshing = True  # as in a file: both are changed before anybody looks
    design.Cuts, design.Layout = design.Layout, design.Cuts
    design.Proxy._refreshing = False
    design.Proxy.refresh(design)
    assert (design.Cuts, design.Layout) == (document.Cuts, document.Layout)
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)


@pytest.mark.parametrize("name, said", [
    ("link-Source-Layout", "this has no surface"), ("list-Edges-odd", "odd number of vertices"),
    ("list-Edges-far", "no edge of the target"), ("list-Edges-negative", "no edge of the target")])
def test_what_can_not_be_used_is_named_with_its_remedy(tampered, name, said):
    document = FreeCAD.openDocument(f"{tampered}/{name}.FCStd")
    design = document.Design
    with pytest.raises(CurveUpsError, match=said) as caught:
        documents.cuts_of(design)
        documents.project_of(design)
    assert caught.value.remedy and caught.value.where in (document.Layout.Label, document.Cuts.Label)
    if "Edges" in name:
        assert design.Status == "out of date" and "the cuts changed" in design.Reasons[0]


def test_tampered_documents(capfd, tampered):
    wrong = {}
    for path in sorted(tampered.glob("*.FCStd")):
        text = probe(path) + "".join(capfd.readouterr())
        if re.search(r"Traceback|KeyError|AttributeError|ReferenceError|IndexError", text):
            wrong[path.stem] = text[-900:]
    assert len(list(tampered.glob("*.FCStd"))) > 100
    assert not wrong, "\n".join(f"{name}: {text}" for name, text in wrong.items())
