#!/usr/bin/env python3
"""Measures the conversion of images by dsc: wall-clock time, peak memory and triangles.

Usage: benchmark/planar_images.py DSC [LARGEST_SIDE]

The images show 40 cells of a Voronoi diagram, 20 disks, or random pixels. LARGEST_SIDE (default: 4000)
bounds the side of an image in pixels. A slope is the exponent of the time over the number of pixels.
"""
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
import time
import zlib


def write_png(path, rows):
    def chunk(name, data):
        return (struct.pack('>I', len(data)) + name + data
                + struct.pack('>I', zlib.crc32(name + data)))
    header = struct.pack('>IIBBBBB', len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    with open(path, 'wb') as out:
        out.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header)
                  + chunk(b'IDAT', zlib.compress(b''.join(b'\0' + r for r in rows)))
                  + chunk(b'IEND', b''))


def nearest_seeds(seeds, y, side):
    """Returns a row of the diagram: the lower envelope of the parabolas of the seeds."""
    envelope = []  # x of the seed, its squared height, its number, begin of its interval
    for x, height, number in sorted((x, (y - sy)**2, i) for i, (x, sy) in enumerate(seeds)):
        begin = -math.inf
        while envelope:
            before = envelope[-1]
            begin = (x * x + height - before[0]**2 - before[1]) / (2 * (x - before[0]))
            if begin > before[3]:
                break
            envelope.pop()
            begin = -math.inf
        envelope.append((x, height, number, begin))
    row = bytearray()
    for k, part in enumerate(envelope):
        end = envelope[k + 1][3] if k + 1 < len(envelope) else side
        row += bytes([part[2] + 1]) * (min(side, max(0, math.ceil(end - .5))) - len(row))
    return bytes(row)


def cells(side):
    seeds = [(random.random() * side, random.random() * side) for _ in range(40)]
    return [nearest_seeds(seeds, y + .5, side) for y in range(side)]


def disks(side):
    some = [(side * random.uniform(.1, .9), side * random.uniform(.1, .9),
             side * random.uniform(.01, .09)) for _ in range(20)]
    rows = []
    for y in range(side):
        row = bytearray(side)
        for i, (cx, cy, radius) in enumerate(some):
            half = math.sqrt(max(0, radius**2 - (y + .5 - cy)**2))
            first, last = math.ceil(cx - half - .5), math.ceil(cx + half - .5)
            row[first:last] = bytes([i + 1]) * (last - first)
        rows.append(bytes(row))
    return rows


def noise(side):
    return [bytes(b % 2 for b in random.randbytes(side)) for _ in range(side)]


def write_in_child(path, make, side):
    """Writes an image in a child process, so that its memory does not count for the measured program."""
    child = os.fork()
    if child == 0:
        random.seed(1)
        write_png(path, make(side))
        os._exit(0)
    if os.waitpid(child, 0)[1] != 0:
        sys.exit('the image could not be written')


def measure(dsc, image):
    """Returns wall-clock seconds, kilobytes and triangles of `dsc info`."""
    start = time.monotonic()
    process = subprocess.Popen([dsc, 'info', image], stdout=subprocess.PIPE, text=True)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.monotonic() - start
    lines = dict(line.split(maxsplit=1) for line in output.splitlines()[:2])
    return seconds, usage.ru_maxrss, int(lines['triangles']) if status == 0 else None


def main():
    dsc, largest = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 4000
    print('| image | pixels | s | slope | MB | bytes/pixel | triangles |\n' + '|---' * 7 + '|')
    with tempfile.TemporaryDirectory() as folder:
        image = os.path.join(folder, 'image.png')
        for name, make, sides in (('cells', cells, (500, 1000, 2000, 4000)),
                                  ('disks', disks, (500, 1000, 2000, 4000)),
                                  ('noise', noise, (100, 200, 400, 800))):
            before = None
            for side in sides:
                if side > largest:
                    continue
                write_in_child(image, make, side)
                seconds, kilobytes, triangles = measure(dsc, image)
                slope = f'{math.log(seconds / before) / math.log(4):.2f}' if before else ''
                before = seconds
                print(f'| {name} | {side}² | {seconds:.2f} | {slope} | {kilobytes / 1000:.0f} |'
                      f' {1000 * kilobytes / side**2:.0f} | {triangles} |', flush=True)


if __name__ == '__main__':
    main()
