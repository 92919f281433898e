# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hides the differences between operating systems, each in one place."""

from __future__ import annotations

import ctypes
import sys

_KEPT = 512 << 20  # bytes


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
    gives anew with every step of the solvers took a tenth of their time. For processes of our own."""
    try:
        import resource

        mallopt = ctypes.CDLL(None).mallopt
    except (ImportError, AttributeError, OSError, TypeError):
        return
    if resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY:
        return
    for option in (-1, -3):  # M_TRIM_THRESHOLD, M_MMAP_THRESHOLD
        mallopt(option, _KEPT)
