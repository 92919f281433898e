# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders that are made once for all processes of a test run."""

from __future__ import annotations

import atexit
import fcntl
import os
import shutil
import tempfile
from pathlib import Path
from typing import Callable

_NAME = "CURVEUPS_SHARED_BY_TESTS"
if _NAME not in os.environ:  # the first process of the run; all others inherit its environment
    os.environ[_NAME] = tempfile.mkdtemp(prefix="curveups-tests-")
    atexit.register(shutil.rmtree, os.environ[_NAME], True)


def shared(name: str, make: Callable[[Path], object]) -> Path:
    """The folder that make(folder) has filled. The first process makes it, the others wait."""
    folder = Path(os.environ[_NAME]) / name
    done = folder.with_suffix(".done")
    with open(folder.with_suffix(".lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not done.exists():
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
            make(folder)
            done.touch()
    return folder
