# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes files that are either whole or absent."""

from __future__ import annotations

import errno
import glob
import os
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Callable, ClassVar, Iterator, NoReturn, Optional

from .errors import NOT_WRITTEN, CurveUpsError, Stopped
from .machine import is_running

LONGEST_NAME = 120  # characters, so that endings fit into the 255 of a file name


def safe_name(text: str) -> str:
    """`text` made safe for file names: one part of a path, not hidden, not too long."""
    return re.sub(r"[^A-Za-z0-9._-]+", "-", text).strip("-._")[:LONGEST_NAME] or "target"


def is_text(text: str) -> bool:
    """Whether libraries can be told `text`: arguments may hold bytes that are no UTF-8, and JSON halves of
    letters."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def left_by_killed(folder: Path, pattern: str) -> Iterator[Path]:
    """What has a temporary name (.PROCESS-NAME) for a name of this pattern, of a process that has ended."""
    for left in folder.glob(f".[0-9]*-{pattern}"):
        process = left.name[1:].partition("-")[0]
        if process.isdecimal() and not is_running(int(process)):
            yield left


def plain_name(text: str) -> str:
    """`text` as it can stand in titles and files of any format: what no text can hold is left out."""
    shown = "".join(c for c in text if c.isprintable()).strip()
    return shown[:LONGEST_NAME] or "target"


def require_folder_name(path: Path) -> None:
    """Refuses, before any work is done, a path that can't become a folder."""
    for place in (path, *path.parents):
        try:
            there, folder = place.exists(), place.is_dir()
        except OSError as error:  # a folder above may not be entered, or the name is too long
            raise _unusable(path, error) from error
        if there:
            if not folder:
                raise CurveUpsError(
                    "the output folder is a file" if place == path else "a file is in the way",
                    str(place), "name another folder with -o")
            return


def _unusable(path: Path, error: OSError) -> CurveUpsError:
    return CurveUpsError(f"the output folder can't be made: {error.strerror}", str(path),
                         "choose a folder you may write to", NOT_WRITTEN)


@dataclass(frozen=True)
class Prepared:
    """A file under a temporary name (`path`), with the name that it is to have and its size in bytes."""

    name: str
    path: Path
    size: int = 0


class Folder:
    """Writes files into a folder: under a temporary name first, which a rename makes the real one.

    A file that could not be written leaves nothing behind; those before it stay. As a context it answers
    for whatever unexpected happens between the files: status 4, and what is complete.
    """

    written: ClassVar[int] = 0  # files by all of them, since the program began

    def __init__(self, path: Path):
        self.path = path
        self.files: dict[str, int] = {}
        self._made: list[Path] = []  # folders, the lowest first
        try:
            self._made = [place for place in (path, *path.parents) if not place.exists()]
            path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            self._remove_made()
            raise _unusable(path, error) from error

    def _remove_made(self) -> None:
        for place in self._made:
            try:
                place.rmdir()
            except OSError:
                return

    def __enter__(self) -> "Folder":
        return self

    def __exit__(self, kind: Any, error: Optional[BaseException], trace: Any) -> None:
        if isinstance(error, Exception) and not isinstance(error, (CurveUpsError, Stopped)):
            self._fail("what follows", error)

    def remove(self, *names: str) -> None:
        """Takes files of an earlier run away, in this order."""
        for name in names:
            try:
                self._sweep(name)
                self._require_file(name)
                (self.path / name).unlink(missing_ok=True)
            except OSError as error:
                raise CurveUpsError(f"a file of an earlier run can't be removed: {error.strerror}",
                                    str(self.path / name), "remove it, or choose another folder",
                                    NOT_WRITTEN) from error

    def withdraw(self) -> None:
        """Takes away what was written, and the folders that were made for it."""
        self.remove(*self.files)
        self.files.clear()
        self._remove_made()

    def holds(self, name: str, text: str) -> bool:
        """Whether a file is there with just this content."""
        try:
            return (self.path / name).read_bytes() == text.encode("utf-8")
        except OSError:
            return False

    def write(self, name: str, writer: Callable[[Path], object]) -> None:
        """Calls `writer` with a temporary path of the same ending, then gives the file its name.

        Whatever else keeps the file from being written ends with status 4 and says what is complete;
        only a stop passes as it is.
        """
        self.keep(self.prepare(name, writer))

    def prepare(self, name: str, writer: Callable[[Path], object]) -> Prepared:
        """The first half of `write`: a whole file that does not have its name yet, and is nobody's until it
        is kept or dropped."""
        if not name or name != os.path.basename(name):
            raise CurveUpsError(f"'{name}' is no file name", str(self.path), "name it without slashes")
        prepared = Prepared(name, self.path / f".{os.getpid()}-{name}")
        try:
            self._sweep(name)
            try:
                writer(prepared.path)
                with open(prepared.path, "rb+") as file:
                    os.fsync(file.fileno())
                return replace(prepared, size=prepared.path.stat().st_size)
            except BaseException:
                self.drop(prepared)
                raise
        except Exception as error:
            if isinstance(error, Stopped) or type(error).__name__ == "Cancelled":
                raise
            self._fail(name, error)

    def _sweep(self, name: str) -> None:
        """Takes away what killed programs have left of this file, under its temporary names."""
        for left in left_by_killed(self.path, f"{glob.escape(name)}*"):
            left.unlink(missing_ok=True)

    def _require_file(self, name: str) -> None:
        """Raises OSError where a device or a pipe has this name: nobody means it to go."""
        place = self.path / name
        if place.exists() and not place.is_file():
            raise OSError(errno.EEXIST, "a folder, a device or a pipe has its name")

    def keep(self, prepared: Prepared) -> None:
        """Gives a prepared file its name."""
        try:
            self._require_file(prepared.name)
            os.replace(prepared.path, self.path / prepared.name)
        except OSError as error:
            self._fail(prepared.name, error)
        finally:
            self.drop(prepared)
        self.files[prepared.name] = prepared.size
        Folder.written += 1

    def drop(self, prepared: Prepared) -> None:
        """Takes a prepared file away, with what FreeCAD writes beside a name, under one that begins with
        it."""
        for left in self.path.glob(glob.escape(prepared.path.name) + "*"):
            left.unlink(missing_ok=True)

    def write_text(self, name: str, text: str) -> None:
        """Writes UTF-8 text with plain line ends."""
        self.write(name, lambda path: path.write_bytes(text.encode("utf-8")))

    def _fail(self, name: str, error: Exception) -> NoReturn:
        remedy = "free space or choose another folder"
        if isinstance(error, CurveUpsError):
            reason, remedy = error.what, error.remedy or remedy
        elif isinstance(error, MemoryError):
            reason, remedy = "there is not enough memory", "use larger tiles or a smaller target"
        else:
            reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
        complete = f"complete are {', '.join(self.files)}" if self.files else "no file was made"
        if not self.files:
            self._remove_made()
        raise CurveUpsError(f"{name} could not be written: {reason}", str(self.path / name),
                            f"{remedy}; {complete}",
                            NOT_WRITTEN) from error
