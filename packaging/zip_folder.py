# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zip of a folder, whose bytes follow from its files and one time.

    zip_folder.py FOLDER ZIP SECONDS
"""

import sys
import time
import zipfile
from pathlib import Path


def zip_folder(folder: Path, target: Path, seconds: int) -> None:
    """Write the files in the order of their names, with this time since 1970."""
    date = time.gmtime(seconds)[:6]
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            info = zipfile.ZipInfo(path.relative_to(folder.parent).as_posix(), date)
            info.external_attr = (0o755 if path.suffix == ".so" else 0o644) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, path.read_bytes())


zip_folder(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]))
