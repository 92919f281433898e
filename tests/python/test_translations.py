# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the window stands in every language, with the same places to fill in."""

import re
import sys

import pytest
from running import ROOT

sys.path.insert(0, str(ROOT / "tools"))

import translations  # noqa: E402

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
