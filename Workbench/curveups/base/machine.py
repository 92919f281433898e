# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hides the differences between operating systems, each in one place."""

from __future__ import annotations

import ctypes
import mmap
import os
import signal
import sys

_KEPT = 512 << 20  # bytes
_BLAS = 160  # MB
_PARENT_DEATH_SIGNAL = 1  # of prctl
_TRIM_THRESHOLD, _MMAP_THRESHOLD, _ARENA_MAX = -1, -3, -8  # of mallopt


def peak_memory_mb() -> float | None:
    """The most memory that this process has held, MB; None where the system does not tell."""
    try:
        import resource
    except ImportError:  # Windows
        return None
    unit = 1024 * 1024 if sys.platform == "darwin" else 1024
    return round(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / unit, 1)


def keep_memory() -> None:
    """Lets the C library keep what is given back for what is asked for next, pieces of up to 512 MB each,
    where it can be told so (glibc) and the process may have as much as it likes: memory that the system
    gives anew with every step of the solvers took a tenth of their time. Where it may not, threads share
    what they take from. For processes of our own."""
    try:
        mallopt = ctypes.CDLL(None).mallopt
    except (AttributeError, OSError, TypeError):
        return
    if memory_is_limited():
        mallopt(_ARENA_MAX, 1)
        return
    for option in (_TRIM_THRESHOLD, _MMAP_THRESHOLD):
        mallopt(option, _KEPT)


def is_running(process: int) -> bool:
    """Whether there is a process of this number; of Windows, which has no harmless question, yes."""
    if sys.platform == "win32":
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        pass
    return True


def end_with_parent(parent: int) -> None:
    """Ends this process with its parent, of this number, even where that is killed (Linux alone)."""
    try:
        prctl = ctypes.CDLL(None).prctl
    except (AttributeError, OSError, TypeError):
        return
    prctl(_PARENT_DEATH_SIGNAL, int(signal.SIGKILL))
    if os.getppid() != parent:  # it ended before
        os._exit(1)


def memory_is_limited() -> bool:
    """Whether this process may have only so much (ulimit -v)."""
    try:
        import resource
    except ImportError:
        return False
    return resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY


def claim_memory_of_blas() -> None:
    """Lets OpenBLAS take its 128 MB while they are there, where memory is limited: with the first product of
    matrices it waits for them for ever. Raises MemoryError."""
    if memory_is_limited():
        import numpy as np

        require_memory(_BLAS)
        np.ones((256, 256)) @ np.ones((256, 256))  # smaller ones need no memory


def require_memory(megabytes: int) -> None:
    """Raises MemoryError where so much is not to be had, for what fails otherwise than by saying so."""
    try:
        mmap.mmap(-1, megabytes << 20).close()
    except OSError:
        raise MemoryError from None
