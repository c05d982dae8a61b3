"""Counts the colors of a PNG picture: colors_of.py PICTURE --min-colors N fails where there are fewer."""
import argparse
import struct
import sys
import zlib


def rows_of(data):
    """Returns the rows of an 8-bit RGB or RGBA picture without interlacing, and the bytes of a pixel."""
    width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
    size = {2: 3, 6: 4}[color]
    assert depth == 8 and not interlaced
    packed, place = b"", 8
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place : place + 8])
        if kind == b"IDAT":
            packed += data[place + 8 : place + 8 + length]
        place += length + 12
    plain, rows, before = zlib.decompress(packed), [], bytearray(width * size)
    for y in range(height):
        start = y * (width * size + 1)
        row = bytearray(plain[start + 1 : start + 1 + width * size])
        for i in range(len(row)):
            left = row[i - size] if i >= size else 0
            corner = before[i - size] if i >= size else 0
            row[i] = (row[i] + predicted(plain[start], left, before[i], corner)) & 255
        rows.append(row)
        before = row
    return rows, size


def predicted(rule, left, above, corner):
    """Returns what PNG's filter number `rule` predicts of a byte."""
    if rule == 4:
        guess = left + above - corner
        return min((left, above, corner), key=lambda value: abs(guess - value))
    return [0, left, above, (left + above) // 2][rule]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("picture")
    parser.add_argument("--min-colors", type=int, required=True)
    arguments = parser.parse_args()
    with open(arguments.picture, "rb") as file:
        rows, size = rows_of(file.read())
    colors = {bytes(row[i : i + 3]) for row in rows for i in range(0, len(row), size)}
    if len(colors) < arguments.min_colors:
        sys.exit(f"{arguments.picture} has {len(colors)} colors, wanted are {arguments.min_colors}")


if __name__ == "__main__":
    main()
