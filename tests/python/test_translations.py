# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the window stands in every language, with the same places to fill in."""

import re
import sys

import pytest
from running import ROOT

sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "Workbench")]

import translations  # noqa: E402
from curveups.base import sentences  # noqa: E402

LANGUAGES = sorted(translations.FOLDER.glob("CurveUps_*.ts"))
every_language = pytest.mark.parametrize("path", LANGUAGES, ids=[path.stem for path in LANGUAGES])


def test_texts_are_found():
    python = '''
class Solve:
    text = QT_TRANSLATE_NOOP("CurveUps_Solve", "So"
                             "lve")
    def say(self):
        return qt.translate("Panel", "{n} tiles", n=3), translate(self.name, self.text)
    def fields(self):
        return Field("Gap", "mm", CONTACT, lambda: 1, "low", problem="gaps too small", note="not this")
'''
    assert set(translations.texts_of_python(python)) == {
        ("CurveUps_Solve", "Solve"), ("Panel", "{n} tiles"), ("CurveUps_Fields", "Gap"),
        ("CurveUps_Fields", "gaps too small")}
    form = ('<ui><class>Form</class><widget><property name="text"><string>Stop</string></property>'
            '<property name="x"><string notr="true">objectName</string></property></widget></ui>')
    assert set(translations.texts_of_form(form)) == {("Form", "Stop")}
    assert ("Workbench", "&CurveUps") in translations.texts()
    assert "CurveUps_de" in {path.stem for path in LANGUAGES}


def test_whatever_work_says_of_itself_is_known():
    """The window translates these lines as they come."""
    said = set()
    for path in (ROOT / "native" / "curveups").rglob("*.[ch]pp"):
        said.update(re.findall(r'(?:keep_going\(\s*[^,"]*,|checkpoint\()\s*"([^"]+)"',
                               path.read_text("utf-8")))
    for path in (ROOT / "Workbench").rglob("*.py"):
        for line in re.findall(r'job(?:\.go_on)?\(f?"([^"]*)"', path.read_text("utf-8")):
            said.add(line.partition("{")[0])
    assert {"remeshing", "writing STEP", "checking tiles", "uniting bodies", "trying ", "writing "} <= said
    unknown = {line for line in said if not any(
        re.fullmatch(re.escape(text).replace(r"\{0\}", ".*"), line) for text in sentences.PROGRESS)}
    assert not unknown - {"dividing into "}


def test_errors_of_both_languages_are_found():
    """With places for what is known only then."""
    found = {text for _, text in translations.texts_of_errors()}
    assert {"p_min ({0} mm) is larger than p_max ({1} mm)", "lower p_min or raise p_max",
            "a facet can't be read: {0}", 'there is no built-in target "{0}"',
            "{0} follows an expression", "give {0} to {1}"} <= found
    assert not [text for text in found if '"' in text.replace('"{0}"', "") or "std::" in text]


def test_parameters_are_found_without_the_native_module_too(monkeypatch):
    found = translations.texts_of_parameters()
    assert len(found) > 40 and all(text.endswith(".") for _, text in found)
    assert any("Thickness of a tile" in text and "Takes effect at once." in text for _, text in found)
    monkeypatch.setattr("curveups.base.native.problem", lambda: "it is not there")
    assert translations.texts_of_parameters() == found


@every_language
def test_every_text_is_translated(path):
    known = translations.translations(path)
    missing = sorted(text for text in translations.texts() if not known.get(text))
    assert not missing, f"run tools/translations and translate {len(missing)} texts: {missing[:5]}"
    assert not set(known) - translations.texts(), "run tools/translations: some texts are gone"


@every_language
def test_translations_have_the_same_places(path):
    def places(text):
        return sorted(re.findall(r"{[^{}]*}|%\d|<[^<>]*>", text))

    for (context, source), text in translations.translations(path).items():
        assert places(text) == places(source), (context, source, text)
        assert (source[-1] in ".:…") == (text[-1] in ".:…"), (source, text)


@every_language
def test_what_FreeCAD_reads_is_that_translation(path):
    """Each translation stands in the compiled file: UTF-16, most significant byte first."""
    compiled = path.with_suffix(".qm").read_bytes()
    for source, text in translations.translations(path).items():
        assert text.encode("utf-16-be") in compiled, f"run tools/translations: {source} is not up to date"
