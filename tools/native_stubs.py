# SPDX-License-Identifier: LGPL-2.1-or-later
"""Types of the native module for editors and mypy, from the signatures in its docstrings.

Called by tools/stubs (writes Workbench/curveups/_native.pyi) and by tools/check (with --check: says where
that file is stale)."""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
STUBS = ROOT / "Workbench" / "curveups" / "_native.pyi"
HEAD = """# SPDX-License-Identifier: LGPL-2.1-or-later
# Written by tools/stubs from the built module; tools/check says where it is stale.
# Annotated: the array's shape, where it is fixed.
"""


def native_stubs() -> str:
    """Stubs by mypy's stubgen of the built module, with numpy's own types for arrays."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-c", "from mypy.stubgen import main; main()", "-q", "-m",
                        "curveups._native", "-o", folder], check=True,
                       cwd=ROOT / "Workbench")
        text = Path(folder, "curveups", "_native.pyi").read_text(encoding="utf-8")

    def array(match: re.Match[str]) -> str:
        kind, shape = match[1].rstrip("_"), match[3]
        if kind == "int64":  # of arguments alone, which may be narrower
            kind = "signedinteger[Any]"
        plain = f"numpy.typing.NDArray[numpy.{kind}]"
        return f"Annotated[{plain}, '{shape.replace(',', ' x ')}']" if shape else plain

    text = re.sub(r"numpy\.ndarray\[numpy\.(\w+)(\[([^\]]*)\])?(?:, [^\]]*)?\]", array, text)
    text = re.sub(r"\b(\w+(\[\w+\])?)\[\d+\]", r"\1", text)  # an array of so many is a list of them
    # Lists are returned; any sequence is taken.
    text = re.sub(r"(?m)^(\s*def \w+\()(.*)(\) ->)",
                  lambda m: m[1] + m[2].replace("List[", "Sequence[") + m[3], text)
    # pybind11's object is Python's Any; a docstring with a colon in it is no type.
    text = re.sub(r"-> (object|[A-Z]\w*( \w+)+[^:\n]*): \.\.\.", "-> Any: ...", text)
    text = text.replace("import numpy\n", "import numpy\nimport numpy.typing\n", 1)
    text = re.sub(r"from typing import (.*)\n", lambda m: "from typing import " + ", ".join(
        sorted({"Annotated", "Any", "Callable", "Sequence", *m[1].split(", ")})) + "\n", text, count=1)
    return HEAD + text


def main() -> int:
    text = native_stubs()
    if "--check" not in sys.argv[1:]:
        STUBS.write_text(text, encoding="utf-8")
        return 0
    if STUBS.exists() and STUBS.read_text(encoding="utf-8") == text:
        return 0
    print(f"{STUBS.relative_to(ROOT)} is stale: run tools/stubs", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
