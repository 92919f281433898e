# SPDX-License-Identifier: LGPL-2.1-or-later
"""Good files made a little wrong: what editors, transfers and other programs' mistakes leave."""

import io
import random
import re
import zipfile

TOKENS = [b"nan", b"-inf", b"1e300", b"-1e-300", b"1e999", b"-1", b"0", b"1", b"2147483648",
          b"-9223372036854775809", b"99999999999999999999", b"0.5", b"1,5", b"foo", b"", b"null", b"\xff\xfe",
          b"\"", b"[", b"{", b"<", b"#", b"\\", b"$1", b"1e", b"0x10", b"+", b"3 3"]
_DECIMAL = re.compile(rb"[-+]?\d+\.\d*(?:[eE][-+]?\d+)?")
_NUMBER = re.compile(rb"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")


def mutated(data: bytes, chance: random.Random) -> tuple[bytes, bool]:
    """One to four changes, or a single loss; the contents of archives are changed, or their bytes. And
    whether something was lost, and nothing changed: what is read then is all that there was, or less is
    noticed."""
    if data[:2] == b"PK" and chance.random() < 0.8:
        return _mutated_archive(data, chance), False
    if chance.random() < 0.25:
        return chance.choice(_LOSSES)(data, chance), True
    changes = [chance.choice(_CHANGES) for _ in range(chance.choice((1, 1, 1, 2, 4)))]
    for change in changes:
        data = change(data, chance)
    return data, all(change in _LOSSES for change in changes)


def _mutated_archive(data: bytes, chance: random.Random) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as source, zipfile.ZipFile(out, "w") as target:
        for entry in source.infolist():
            target.writestr(entry.filename, mutated(source.read(entry), chance)[0])
    return out.getvalue()


def _lines(data: bytes) -> list[bytes]:
    return data.splitlines(keepends=True)


def _lose_line(data: bytes, chance: random.Random) -> bytes:
    lines = _lines(data)
    if lines:
        del lines[chance.randrange(len(lines))]
    return b"".join(lines)


def _double_line(data: bytes, chance: random.Random) -> bytes:
    lines = _lines(data)
    if lines:
        at = chance.randrange(len(lines))
        lines[at:at] = [lines[at]] * chance.choice((1, 1, 50))
    return b"".join(lines)


def _swap_lines(data: bytes, chance: random.Random) -> bytes:
    lines = _lines(data)
    if lines:
        a, b = chance.randrange(len(lines)), chance.randrange(len(lines))
        lines[a], lines[b] = lines[b], lines[a]
    return b"".join(lines)


def _other_number(data: bytes, chance: random.Random) -> bytes:
    places = [match.span() for match in _NUMBER.finditer(data)]
    if not places:
        return data
    begin, end = chance.choice(places)
    if chance.random() < 0.3:  # another number of the file
        other = data[slice(*chance.choice(places))]
    else:
        other = chance.choice(TOKENS)
    return data[:begin] + other + data[end:]


def _scaled_number(data: bytes, chance: random.Random) -> bytes:
    places = [match.span() for match in _NUMBER.finditer(data)]
    if not places:
        return data
    begin, end = chance.choice(places)
    return data[:begin] + repr(float(data[begin:end]) * 10.0 ** chance.randint(-6, 6)).encode() + data[end:]


def _scale_all(data: bytes, chance: random.Random) -> bytes:
    """Every number with a point: another unit, an overflow, or one place for everything."""
    by = chance.choice((0.0, 1e-300, 1e-3, 25.4, 1e6, 1e30, 1e300))
    return _DECIMAL.sub(lambda match: repr(float(match[0]) * by).encode(), data)


def _level_line(data: bytes, chance: random.Random) -> bytes:
    """All numbers of a line become the same."""
    lines = _lines(data)
    if lines:
        at, value = chance.randrange(len(lines)), chance.choice((b"0", b"1", b"0.5"))
        lines[at] = _NUMBER.sub(value, lines[at])
    return b"".join(lines)


def _lose_bytes(data: bytes, chance: random.Random) -> bytes:
    at = chance.randrange(len(data) + 1)
    return data[:at] + data[at + chance.choice((1, 1, 2, 40)):]


def _more_bytes(data: bytes, chance: random.Random) -> bytes:
    at = chance.randrange(len(data) + 1)
    more = chance.choice(TOKENS) if chance.random() < 0.5 else chance.randbytes(chance.choice((1, 4, 60)))
    return data[:at] + more + data[at:]


def _flip_bit(data: bytes, chance: random.Random) -> bytes:
    if not data:
        return data
    at = chance.randrange(len(data))
    return data[:at] + bytes([data[at] ^ (1 << chance.randrange(8))]) + data[at + 1:]


def _cut_off(data: bytes, chance: random.Random) -> bytes:
    return data[: chance.randrange(len(data) + 1)]


def _repeat(data: bytes, chance: random.Random) -> bytes:
    at = chance.randrange(len(data) + 1)
    piece = data[at : at + chance.choice((10, 100, 1000))]
    return data[:at] + piece * chance.choice((2, 3, 200)) + data[at:]


_CHANGES = (_lose_line, _double_line, _swap_lines, _other_number, _other_number, _scaled_number, _lose_bytes,
            _more_bytes, _flip_bit, _cut_off, _repeat, _scale_all, _level_line)
_LOSSES = (_lose_line, _cut_off)
