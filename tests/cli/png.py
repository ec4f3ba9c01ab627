"""Reads PNG files without another program: to start ffmpeg takes longer than to decode a small picture here."""

import struct
import zlib

SAMPLES = {0: 1, 2: 3, 6: 4}  # of a pixel, by colour type: grey; red, green, blue; and alpha
MOST = 1_000_000  # samples; ffmpeg is faster above


def header(data):
    """Width, height, bits and colour type."""
    return struct.unpack(">IIBB", data[16:26]) if data[:8] == b"\x89PNG\r\n\x1a\n" else None


def _paeth(a, b, c):
    """Of left, above and above left, the one nearest to a + b - c."""
    to_a, to_b, to_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
    return a if to_a <= to_b and to_a <= to_c else b if to_b <= to_c else c


def _unfiltered(kind, row, above, step):
    """The samples of a row, of which the file has differences."""
    if kind == 0:
        return row
    if kind == 2:
        return bytearray((x + b) & 255 for x, b in zip(row, above))
    left = bytes(step)
    for i, x in enumerate(row):
        a = row[i - step] if i >= step else left[i]
        if kind == 1:
            row[i] = (x + a) & 255
        elif kind == 3:
            row[i] = (x + (a + above[i]) // 2) & 255
        else:
            row[i] = (x + _paeth(a, above[i], above[i - step] if i >= step else 0)) & 255
    return row


def rows_of(data):
    """The rows of a small picture of 8 bits, each of its pixels' red, green and blue; None if it is another."""
    width, height, bits, kind = header(data) or (0, 0, 0, 0)
    step = SAMPLES.get(kind, 0)
    if bits != 8 or step == 0 or width * height * step > MOST or data[28] != 0:
        return None
    packed = b""
    at = 8
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        if name == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += length + 12
    samples = zlib.decompress(packed)
    rows = []
    row = bytearray(width * step)
    for start in range(0, len(samples), width * step + 1):
        row = _unfiltered(samples[start], bytearray(samples[start + 1:start + 1 + width * step]), row, step)
        red, green, blue = (row[0::step],) * 3 if step == 1 else (row[k::step] for k in range(3))
        rows.append(list(zip(red, green, blue)))
    return rows
