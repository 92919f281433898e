# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preference page against the one table."""

import re
from xml.etree import ElementTree

from running import ROOT

from curveups.features.properties import property_name
from curveups.base.parameters import table


def test_the_preference_page_has_the_table_s_ranges_and_defaults():
    page = ElementTree.parse(ROOT / "resources" / "ui" / "preferences.ui")
    rows = {property_name(row.name): row for row in table()}
    found = 0
    for widget in page.iter("widget"):
        values = {item.get("name"): (item[0].text or "") for item in widget.findall("property")}
        if not values.get("prefPath", "").endswith("Defaults"):
            continue
        row = rows[values["prefEntry"]]
        assert [float(values[name]) for name in ("minimum", "maximum", "rawValue")] == [
            row.minimum, row.maximum, row.default]
        assert re.fullmatch(row.unit, values["unit"])
        found += 1
    assert found == 3
