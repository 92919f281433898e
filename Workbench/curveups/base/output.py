# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes files that are either whole or absent."""

from __future__ import annotations

import errno
import glob
import os
import re
from pathlib import Path
from typing import Any, Callable, NoReturn, Optional

from .errors import NOT_WRITTEN, CurveUpsError, Stopped, without_package

LONGEST_NAME = 120  # characters, so that endings fit into the 255 of a file name


def safe_name(text: str) -> str:
    """`text` made safe for file names: one part of a path, not hidden, not too long."""
    return re.sub(r"[^A-Za-z0-9._-]+", "-", text).strip("-._")[:LONGEST_NAME] or "target"


def plain_name(text: str) -> str:
    """`text` for titles and files of any format, without characters that can't be printed."""
    shown = "".join(c for c in text if c.isprintable()).strip()
    return shown[:LONGEST_NAME] or "target"


def require_folder_name(path: Path) -> None:
    """Raises CurveUpsError, before any work is done, for a path that can't become a folder."""
    for place in (path, *path.parents):
        try:
            if place.is_dir():
                return
            if place.exists():
                what = "the output folder is a file" if place == path else "a file is in the way"
                raise CurveUpsError(what, str(place), "name another folder with -o")
        except OSError as error:  # a folder above may not be entered, or the name is too long
            raise _unusable(path, error) from error


def _unusable(path: Path, error: OSError) -> CurveUpsError:
    return CurveUpsError(f"the output folder can't be made: {error.strerror}", str(path),
                         "choose a folder you may write to", NOT_WRITTEN)


class Folder:
    """Writes files into a folder: under a temporary name first, which a rename makes the real one.

    A file that could not be written leaves nothing behind; those before it stay. As a context manager it
    turns unexpected exceptions between files into status 4, with the names of the complete files.
    """

    def __init__(self, path: Path):
        self.path = path
        self.files: dict[str, int] = {}  # sizes in bytes, by name
        try:
            path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise _unusable(path, error) from error

    def __enter__(self) -> "Folder":
        return self

    def __exit__(self, kind: Any, error: Optional[BaseException], trace: Any) -> None:
        if isinstance(error, Exception) and not _passes(error):
            self._fail("the next file", error)

    def remove(self, *names: str) -> None:
        """Removes files of an earlier run, in this order."""
        for name in names:
            try:
                (self.path / name).unlink(missing_ok=True)
            except OSError as error:
                raise CurveUpsError(f"a file of an earlier run can't be removed: {error.strerror}",
                                    str(self.path / name), "remove it, or choose another folder",
                                    NOT_WRITTEN) from error

    def write(self, name: str, writer: Callable[[Path], object]) -> None:
        """Call `writer` with a temporary path of the same ending, then rename the file.

        Raises CurveUpsError (status 4) that names the complete files; a stop passes as it is.
        """
        if not name or name != os.path.basename(name):
            raise CurveUpsError(f"'{name}' is no file name", str(self.path), "name it without slashes")
        place, temporary = self.path / name, self.path / f".part-{name}"
        try:
            if place.exists() and not place.is_file():
                raise OSError(errno.EEXIST, "a folder, a device or a pipe has its name")
            writer(temporary)
            size = temporary.stat().st_size
            os.replace(temporary, place)
        except Exception as error:
            if _passes(error) and not isinstance(error, CurveUpsError):
                raise
            self._fail(name, error)
        finally:  # FreeCAD writes beside its file, under names that begin with the same letters
            for left in self.path.glob(f"{glob.escape(temporary.name)}*"):
                left.unlink(missing_ok=True)
        self.files[name] = size

    def write_text(self, name: str, text: str) -> None:
        """Write UTF-8 text with plain line ends."""
        self.write(name, lambda path: path.write_bytes(text.encode("utf-8")))

    def _fail(self, name: str, error: Exception) -> NoReturn:
        remedy = "free space or choose another folder"
        error = without_package(error)
        if isinstance(error, CurveUpsError):
            reason, remedy = error.what, error.remedy or remedy
        else:
            reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
        complete = f"complete are {', '.join(self.files)}" if self.files else "no file was made"
        raise CurveUpsError(f"{name} could not be written: {reason}", str(self.path / name),
                            f"{remedy}; {complete}", NOT_WRITTEN) from error


def _passes(error: Exception) -> bool:
    """True for errors that need no other words: our own, and a stop (Cancelled in the native module)."""
    return isinstance(error, (CurveUpsError, Stopped)) or type(error).__name__ == "Cancelled"
