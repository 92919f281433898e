# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a project as text, and back, bit for bit: with their keys, so that what is out of date
when they are read again is known to be."""

from __future__ import annotations

import base64
import binascii
import dataclasses
import json
from typing import Any, Mapping

import numpy as np

from .errors import CurveUpsError
from .native import native, translated
from .project import Made
from .stages.stage import Value

FORMAT, VERSION = "curveups-results", 1


def to_text(made: Mapping[str, Made]) -> str:
    """Those results that consist of numbers, texts, arrays and designs; others are made anew."""
    results = {name: {"key": dict(one.key), "seconds": one.seconds, "result": _encode(one.result)}
               for name, one in made.items() if one.result.lasting}
    return json.dumps({"format": FORMAT, "version": VERSION, "results": results})


def from_text(text: str, where: str = "") -> dict[str, Made]:
    """Raises CurveUpsError where the text is not what `to_text` wrote."""
    try:
        data = json.loads(text)
        if data["format"] != FORMAT or data["version"] != VERSION:
            raise ValueError(f"version {data['version']} of {data['format']}")
        with translated(where):
            return {name: Made(_decode(one["result"]), one["key"], float(one["seconds"]))
                    for name, one in data["results"].items()}
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError, binascii.Error) as error:
        raise CurveUpsError(f"the saved results can't be read: {error}", where,
                            "solve the design again") from None


def _encode(value: Any) -> Any:
    if isinstance(value, Value):
        fields = {field.name: _encode(getattr(value, field.name)) for field in dataclasses.fields(value)}
        return {"value": type(value).__name__, "fields": fields}
    if isinstance(value, native.Design):
        return {"design": native.write_design(value)}
    if isinstance(value, np.ndarray):
        return {"array": base64.b64encode(np.ascontiguousarray(value).tobytes()).decode("ascii"),
                "type": value.dtype.str, "shape": value.shape}
    if isinstance(value, Mapping):
        return {"map": {str(key): _encode(item) for key, item in value.items()}}
    if isinstance(value, (list, tuple)):
        return [_encode(item) for item in value]
    return value.item() if isinstance(value, np.generic) else value


def _decode(value: Any) -> Any:
    if isinstance(value, list):
        return tuple(_decode(item) for item in value)
    if not isinstance(value, dict):
        return value
    if "value" in value:
        kind = Value.known[value["value"]]
        return kind(**{name: _decode(item) for name, item in value["fields"].items()})
    if "design" in value:
        return native.read_design(value["design"])
    if "array" in value:
        found = np.frombuffer(base64.b64decode(value["array"], validate=True), np.dtype(value["type"]))
        return found.reshape(value["shape"]).copy()
    return {name: _decode(item) for name, item in value["map"].items()}
