# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a project as text, and back, bit for bit. Their keys are saved too, so that results of other
inputs are out of date when read. Values shared by several results are written once."""

from __future__ import annotations

import base64
import binascii
import dataclasses
import json
from typing import Any, Callable, Hashable, Mapping, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Value
from ..base.native import native, translated
from ..stages.stage import digest
from .project import Made

FORMAT, VERSION = "curveups-results", 1


def to_text(made: Mapping[str, Made]) -> str:
    """Text of all lasting results, but for transient fields."""
    shared: list[Any] = []  # arrays, designs and values, each once; indices stand for them elsewhere
    places: dict[Hashable, int] = {}

    def share(key: Hashable, encoded: Callable[[], Any]) -> dict[str, int]:
        if key not in places:
            shared.append(encoded())
            places[key] = len(shared) - 1
        return {"shared": places[key]}

    def encode(value: Any) -> Any:
        if isinstance(value, Value):
            return share(id(value), lambda: {"value": type(value).__name__, "fields": {
                field.name: encode(getattr(value, field.name)) for field in dataclasses.fields(value)
                if not field.metadata.get("transient")}})
        if isinstance(value, native.Design):
            text = native.write_design(value)
            return share(text, lambda: {"design": text})
        if isinstance(value, np.ndarray):
            data = np.ascontiguousarray(value).tobytes()
            return share(digest(value), lambda: {"array": base64.b64encode(data).decode("ascii"),
                                                 "type": value.dtype.str, "shape": value.shape})
        if isinstance(value, Mapping):
            return {"map": {str(key): encode(item) for key, item in value.items()}}
        if isinstance(value, (list, tuple)):
            return [encode(item) for item in value]
        return value.item() if isinstance(value, np.generic) else value

    results = {name: {"key": dict(item.key), "seconds": item.seconds, "result": encode(item.result)}
               for name, item in made.items() if item.result.lasting}
    return json.dumps({"format": FORMAT, "version": VERSION, "shared": shared, "results": results})


def from_text(text: str, where: str = "") -> dict[str, Made]:
    """Inverse of to_text. Raises CurveUpsError for any other text."""
    try:
        data = json.loads(text)
        if data["format"] != FORMAT or data["version"] != VERSION:
            raise ValueError(f"version {data['version']} of {data['format']}")
        with translated(where):
            shared: list[Any] = []
            for value in data.get("shared", []):  # each refers to earlier ones
                shared.append(_decode(value, shared))
            return {name: Made(_decode(item["result"], shared), item["key"], float(item["seconds"]))
                    for name, item in data["results"].items()}
    except (ValueError, TypeError, LookupError, AttributeError, RecursionError, binascii.Error) as error:
        raise CurveUpsError(f"the saved results can't be read: {error}", where,
                            "solve the design again") from None


def _decode(value: Any, shared: Sequence[Any]) -> Any:
    if isinstance(value, list):
        return tuple(_decode(item, shared) for item in value)
    if not isinstance(value, dict):
        return value
    if "shared" in value:
        return shared[value["shared"]]
    if "value" in value:
        kind = Value.known[value["value"]]
        return kind(**{name: _decode(item, shared) for name, item in value["fields"].items()})
    if "design" in value:
        return native.read_design(value["design"])
    if "array" in value:
        array = np.frombuffer(base64.b64decode(value["array"], validate=True), np.dtype(value["type"]))
        return array.reshape(value["shape"]).copy()
    return {name: _decode(item, shared) for name, item in value["map"].items()}
