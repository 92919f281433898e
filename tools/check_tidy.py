# SPDX-License-Identifier: LGPL-2.1-or-later
"""clang-tidy on every source file of native/curveups, as many at once as there are processors.

A file that passed leaves a stamp in build/tidy and is left out as long as neither it, nor what it includes
of ours, nor .clang-tidy changes. Called by tools/check."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NATIVE = ROOT / "native"
STAMPS = ROOT / "build" / "tidy"


def fingerprint(source: Path) -> str:
    """Of a file with all it includes of ours, and of what is checked."""
    files, waiting = {source}, [source]
    while waiting:
        for name in re.findall(r'#include "(curveups/[^"]+)"', waiting.pop().read_text(encoding="utf-8")):
            if (header := NATIVE / name) not in files and header.is_file():
                files.add(header)
                waiting.append(header)
    digest = hashlib.sha256()
    for path in (ROOT / ".clang-tidy", *sorted(files)):
        digest.update(str(path.relative_to(ROOT)).encode() + path.read_bytes())
    return digest.hexdigest()


def complaints(source: Path) -> str:
    """What clang-tidy has to say of a file, empty where that is nothing."""
    stamp, key = STAMPS / source.relative_to(NATIVE).with_suffix(".ok"), fingerprint(source)
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == key:
        return ""
    ran = subprocess.run(["clang-tidy-14", "-p", str(ROOT / "build" / "test"), "--quiet",
                          "--warnings-as-errors=*", str(source)], capture_output=True, text=True, check=False)
    if ran.returncode:
        return ran.stdout or ran.stderr
    stamp.parent.mkdir(parents=True, exist_ok=True)
    stamp.write_text(key, encoding="utf-8")
    return ""


def main() -> int:
    sources = sorted(NATIVE.rglob("*.cpp"), key=lambda path: -path.stat().st_size)
    with ThreadPoolExecutor(os.cpu_count()) as workers:
        found = [text for text in workers.map(complaints, sources) if text]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
