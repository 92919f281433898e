# SPDX-License-Identifier: LGPL-2.1-or-later
"""clang-tidy on every source file of native/curveups, as many at once as there are processors.

A file that passed leaves a stamp in the user's cache, for all checkouts, as ccache does. It is left out as
long as neither it, nor what it includes of ours, nor how it is compiled, nor clang-tidy and its settings
change. tools/check calls this."""

from __future__ import annotations

import hashlib
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NATIVE = ROOT / "native"
STAMPS = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "curveups" / "tidy"


def settings() -> dict[Path, str]:
    """Command that compiles each source file, and the clang-tidy that checks it."""
    tool = subprocess.run(["clang-tidy-14", "--version"], capture_output=True, text=True, check=True).stdout
    commands = json.loads((ROOT / "build" / "test" / "compile_commands.json").read_text(encoding="utf-8"))
    return {Path(one["file"]): tool + one["command"].replace(str(ROOT), "") for one in commands}


def fingerprint(source: Path, setting: str) -> str:
    """Hash of a file with all it includes of ours, and of the checks."""
    files, waiting = {source}, [source]
    while waiting:
        for name in re.findall(r'#include "(curveups/[^"]+)"', waiting.pop().read_text(encoding="utf-8")):
            if (header := NATIVE / name) not in files and header.is_file():
                files.add(header)
                waiting.append(header)
    digest = hashlib.sha256(setting.encode())
    for path in (ROOT / ".clang-tidy", *sorted(files)):
        digest.update(str(path.relative_to(ROOT)).encode() + path.read_bytes())
    return digest.hexdigest()


def complaints(source: Path, setting: str) -> str:
    """Complaints of clang-tidy about a file; empty without any."""
    stamp = STAMPS / fingerprint(source, setting)
    if stamp.is_file():
        return ""
    ran = subprocess.run(["clang-tidy-14", "-p", str(ROOT / "build" / "test"), "--quiet",
                          "--warnings-as-errors=*", str(source)], capture_output=True, text=True, check=False)
    if ran.returncode:
        return ran.stdout or ran.stderr
    STAMPS.mkdir(parents=True, exist_ok=True)
    stamp.touch()
    return ""


def main() -> int:
    sources = sorted(NATIVE.rglob("*.cpp"), key=lambda path: -path.stat().st_size)
    known = settings()
    with ThreadPoolExecutor(os.cpu_count()) as workers:
        found = [text for text in workers.map(
            lambda source: complaints(source, known.get(source, "")), sources) if text]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
