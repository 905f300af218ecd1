#!/usr/bin/env python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cuts the icons of the packages, doc/PACKAGE/fig/*-ico.png, out of pictures of the manual.

Usage: scripts/draw_icons.py
"""

import pathlib
import struct
import zlib

DOC = pathlib.Path(__file__).resolve().parent.parent / "doc"
SIDE = 120  # of an icon, in pixels
SIGNATURE = b"\x89PNG\r\n\x1a\n"
# Package, icon, picture, left border and side length of the square in the picture, in pixels
ICONS = (
    ("Deformable_simplicial_complexes", "deformable_simplicial_complexes", "merging_spheres", 860, 380),
    ("Interface_flows", "interface_flows", "flow_double_bubble", 940, 225),
    ("Solid_reconstruction_3", "solid_reconstruction_3", "flow_reconstruct_gear", 852, 300),
    ("Cut_loci_2", "cut_loci_2", "plane_cut_locus_bumps", 11, 457),
    ("Incompressible_fluids_3", "incompressible_fluids_3", "fluid_collision", 604, 230),
    ("Image_segmentation", "image_segmentation", "segmentation_brain", 0, 440),
)


def unfilter(data, height, stride, step):
    """Yields the rows of a PNG file."""
    above = bytearray(stride)
    for y in range(height):
        kind, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a, b, c = (row[i - step], above[i], above[i - step]) if i >= step else (0, above[i], 0)
            distances = (abs(b - c), abs(a - c), abs(a + b - 2 * c))
            paeth = (a, b, c)[distances.index(min(distances))]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        yield row
        above = row


def read_png(path):
    """Returns the rows of a PNG file with 8 bits per channel: lists of (red, green, blue)."""
    content, at, data, palette = path.read_bytes(), len(SIGNATURE), b"", b""
    while at < len(content):
        length, kind = struct.unpack(">I4s", content[at:at + 8])
        chunk, at = content[at + 8:at + 8 + length], at + 12 + length
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", chunk[:10])
        elif kind == b"PLTE":
            palette = chunk
        elif kind == b"IDAT":
            data += chunk
    if depth != 8:
        raise SystemExit(f"draw_icons.py: {path} does not have 8 bits per channel")
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[color]
    rows = unfilter(zlib.decompress(data), height, width * channels, channels)

    def pixel(row, x):
        if color == 3:
            return palette[3 * row[x]:3 * row[x] + 3]
        return row[x * channels:x * channels + 3] if channels > 2 else [row[x * channels]] * 3

    return [[pixel(row, x) for x in range(width)] for row in rows]


def write_png(path, rows):
    """Writes rows of bytes: red, green and blue of each pixel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    # Filter 1: a pixel is stored as the difference from the pixel on its left.
    filtered = (bytes((b - a) & 255 for a, b in zip(bytes(3) + bytes(row), bytes(row))) for row in rows)
    data = zlib.compress(b"".join(b"\1" + row for row in filtered), 9)
    pathlib.Path(path).write_bytes(SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def square(rows, left, side):
    """Returns the rows of a square at the top of the picture, scaled to the size of an icon."""
    result = []
    for j in range(SIDE):
        row = []
        for i in range(SIDE):
            cells = [rows[min(y, len(rows) - 1)][min(x, len(rows[0]) - 1)]
                     for y in range(j * side // SIDE, (j + 1) * side // SIDE)
                     for x in range(left + i * side // SIDE, left + (i + 1) * side // SIDE)]
            row += [round(sum(cell[k] for cell in cells) / len(cells)) for k in range(3)]
        result.append(row)
    return result


def main():
    for package, icon, picture, left, side in ICONS:
        figures = DOC / package / "fig"
        write_png(figures / f"{icon}-ico.png", square(read_png(figures / f"{picture}.png"), left, side))


if __name__ == "__main__":
    main()
