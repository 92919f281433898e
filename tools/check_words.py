# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refuses docstrings of Python and comments of C++ that begin with a preposition or a pronoun instead
of the thing that they name (CONTRIBUTING.md). tools/check calls it."""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path
from typing import Iterator

ROOT = Path(__file__).resolve().parent.parent
REFUSED = re.compile(
    r"(of|what|where|whether|that|by|it|its|they|their|this|these|those|one|which|who)\b", re.I)


def docstrings(path: Path) -> Iterator[tuple[int, str]]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
            yield node.body[0].lineno, ast.get_docstring(node) or ""


def comments(path: Path) -> Iterator[tuple[int, str]]:
    """First line of every run of comments, each with its line's number."""
    within = False
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        comment = re.match(r"(.*?)//+ ?(.*)", line)
        if comment and not within:
            yield number, comment[2]
        within = bool(comment)


def main() -> int:
    refused = [f"{path.relative_to(ROOT)}:{line}: {text.splitlines()[0]}"
               for folder, pattern, read in (("Workbench", "*.py", docstrings), ("tools", "*.py", docstrings),
                                             ("tests", "*.py", docstrings), ("native", "*.?pp", comments),
                                             ("tests", "*.?pp", comments))
               for path in sorted((ROOT / folder).rglob(pattern))
               for line, text in read(path) if REFUSED.match(text)]
    print("\n".join(refused))
    return bool(refused)


if __name__ == "__main__":
    sys.exit(main())
