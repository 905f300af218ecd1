#!/usr/bin/env python3
"""Measures and draws the costs of steps by parts, by sizes and by numbers of threads.

Usage: benchmark/costs.py BUILD_DIR OUTPUT_DIR [parts] [sizes] [threads]

BUILD_DIR is a Release build with the target `benchmarks`. Writes OUTPUT_DIR/costs_parts.svg,
costs_sizes.svg and costs_threads.svg, and prints tables. The manual uses the pictures in
doc/Deformable_simplicial_complexes/fig. The sizes take a quarter of an hour. The environment variable
SIZES, a list of numbers of triangles, selects other sizes.
"""

import json
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile

MESHES = "/usr/share/doc/libcgal-demo/data.tar.gz"
BUNNY = ["bunny00.off", "--triangles", "13900"]
SIZES = [1000, 3000, 14000, 50000, 200000, 800000, 3000000]
LARGEST = 1000000  # largest number of triangles for TetGen; larger inputs are refined afterwards
REFINED = 6  # approximate number of triangles that refinement makes of one triangle
THREADS = ["1", "2", "4", "8"]
MODES = ["rotation", "offset", "inwards", "curvature"]
COLOURS = ["#4477aa", "#66ccee", "#228833", "#ccbb44", "#ee6677", "#aa3377", "#bbbbbb", "#555555"]
WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 720, 360, 70, 24, 44
STEPS = "10"  # for each size


class Drawing:
    """An SVG file with a plot in a frame."""

    def __init__(self, right):
        self.items = []
        self.width = WIDTH - LEFT - right
        self.height = HEIGHT - TOP - BOTTOM

    def text(self, x, y, text, anchor="middle", turned=False):
        turn = f' transform="rotate(-90 {x:.1f} {y:.1f})"' if turned else ""
        self.items.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{turn}>{text}</text>')

    def line(self, points, colour, width=2.0):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.items.append(
            f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"/>'
        )

    def box(self, x, y, width, height, colour):
        self.items.append(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{colour}"/>'
        )

    def axis_of_values(self, highest, ticks, title):
        for tick in ticks:
            y = self.y(tick, highest)
            self.line([(LEFT, y), (LEFT + self.width, y)], "#dddddd", 1)
            self.text(LEFT - 6, y + 4, f"{tick:g}", "end")
        self.text(16, TOP + self.height / 2, title, turned=True)

    def y(self, value, highest):
        return TOP + self.height * (1 - value / highest)

    def legend(self, names):
        for i, name in enumerate(names):
            x, y = LEFT + self.width + 16, TOP + 10 + 20 * i
            self.box(x, y - 10, 12, 12, COLOURS[i])
            self.text(x + 18, y, name, "start")

    def save(self, path):
        path.write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
            f'viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>\n'
            + "\n".join(self.items)
            + "\n</svg>\n"
        )


def ticks_below(highest):
    """Returns four to eight round numbers up to a bound."""
    step = 10 ** len(str(int(highest * 1000))) / 1e4
    while highest / step < 4:
        step /= 2 if step * 2 > highest else 2.5
    return [i * step for i in range(int(highest / step) + 1)]


def steps_of(programs, mode, arguments, folder):
    path = folder / "steps.json"
    subprocess.run(
        [programs / "motion_benchmark", mode, *arguments, "--json", path],
        cwd=folder, check=True, stdout=subprocess.DEVNULL,
    )
    return json.loads(path.read_text())


def table(columns, rows):
    print("| " + " | ".join(columns) + " |\n|" + " --- |" * len(columns))
    for row in rows:
        print("| " + " | ".join(x if isinstance(x, str) else f"{x:.3g}" for x in row) + " |")
    print(flush=True)


def draw_parts(programs, folder, output):
    sums = {}
    for mode in MODES:
        run = steps_of(programs, mode, BUNNY, folder)
        sums[mode] = {
            part: sum(1000 * s["parts"][part] / s["sweep_milliseconds"] for s in run["steps"])
            / len(run["steps"])
            for part in run["steps"][0]["parts"]
        }
    names = list(next(iter(sums.values())))
    table(["flow"] + names, [[mode] + [sums[mode][n] for n in names] for mode in MODES])
    drawing = Drawing(140)
    highest = 1.05 * max(sum(parts.values()) for parts in sums.values())
    drawing.axis_of_values(highest, ticks_below(highest), "sweeps a step")
    for i, mode in enumerate(MODES):
        width = drawing.width / len(MODES)
        below = 0
        for part, colour in zip(names, COLOURS):
            y = drawing.y(below + sums[mode][part], highest)
            drawing.box(LEFT + (i + 0.2) * width, y, 0.6 * width, drawing.y(below, highest) - y, colour)
            below += sums[mode][part]
        drawing.text(LEFT + (i + 0.5) * width, HEIGHT - BOTTOM + 20, mode)
    drawing.legend(names)
    drawing.save(output / "costs_parts.svg")


def draw_sizes(programs, folder, output):
    sizes = [int(n) for n in os.environ.get("SIZES", "").split()] or SIZES
    modes = ["rotation", "inwards"]
    curves, rows = {mode: [] for mode in modes}, []
    for size in sizes:
        for mode in modes:
            refinements = 0
            while size > LARGEST * REFINED**refinements:
                refinements += 1
            arguments = ["sphere", "--triangles", str(size // REFINED**refinements), "--refine", str(refinements)]
            run = steps_of(programs, mode, [*arguments, "--steps", STEPS], folder)
            seconds = sorted(s["seconds"] for s in run["steps"])
            cost = 1e6 * seconds[len(seconds) // 2] / run["triangles"]
            curves[mode].append((run["triangles"], cost))
            rows.append([mode, str(run["triangles"]), str(run["tetrahedra"]), cost])
            print(rows[-1], file=sys.stderr, flush=True)
    table(["flow", "triangles", "tetrahedra", "microseconds a triangle and step"], sorted(rows, key=lambda r: r[0]))
    drawing = Drawing(140)
    highest = 1.1 * max(cost for curve in curves.values() for _, cost in curve)
    drawing.axis_of_values(highest, ticks_below(highest), "microseconds a triangle and step")
    for i in range(len(sizes)):
        x = LEFT + drawing.width * (i + 0.5) / len(sizes)
        drawing.text(x, HEIGHT - BOTTOM + 20, f"{curves[modes[0]][i][0]}")
    drawing.text(LEFT + drawing.width / 2, HEIGHT - 6, "triangles of the interface")
    for mode, colour in zip(modes, COLOURS):
        drawing.line(
            [
                (LEFT + drawing.width * (i + 0.5) / len(sizes), drawing.y(cost, highest))
                for i, (_, cost) in enumerate(curves[mode])
            ],
            colour,
        )
    drawing.legend(modes)
    drawing.save(output / "costs_sizes.svg")


def draw_threads(programs, folder, output):
    works = ["rotation", "offset", "mean_curvature"]
    numbers = [n for n in THREADS if int(n) <= (os.cpu_count() or 1)]
    rows, curves = [], {}
    for work in works:
        line = subprocess.run(
            [programs / "threads", work, *BUNNY, "--threads", *numbers],
            cwd=folder, check=True, capture_output=True, text=True,
        ).stdout
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        rows.append(cells)
        curves[work] = [1.0] + [float(cells[i]) for i in range(5, len(cells) - 1, 2)]
    columns = ["work", "input", "tetrahedra", "seconds, 1 thread"]
    for n in numbers[1:]:
        columns += [f"{n} threads", "times as fast"]
    table(columns + ["bits"], rows)
    drawing = Drawing(140)
    highest = max(1.1 * max(max(c) for c in curves.values()), 2.2)
    drawing.axis_of_values(highest, ticks_below(highest), "times as fast")
    width = drawing.width / len(works)
    for i, work in enumerate(works):
        for k, speed in enumerate(curves[work]):
            y = drawing.y(speed, highest)
            bar = 0.7 * width / len(numbers)
            drawing.box(LEFT + (i + 0.15) * width + k * bar, y, 0.9 * bar, drawing.y(0, highest) - y, COLOURS[k])
        drawing.text(LEFT + (i + 0.5) * width, HEIGHT - BOTTOM + 20, work.replace("_", " "))
    drawing.legend([f"{n} thread{'s' if n != '1' else ''}" for n in numbers])
    drawing.save(output / "costs_threads.svg")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    programs = pathlib.Path(sys.argv[1]).resolve() / "benchmark"
    output = pathlib.Path(sys.argv[2])
    output.mkdir(parents=True, exist_ok=True)
    parts = {"parts": draw_parts, "sizes": draw_sizes, "threads": draw_threads}
    chosen = sys.argv[3:] or list(parts)
    if unknown := [name for name in chosen if name not in parts]:
        sys.exit(f"costs.py: there is no part {unknown[0]}")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        with tarfile.open(MESHES) as archive:
            (folder / BUNNY[0]).write_bytes(archive.extractfile(f"data/meshes/{BUNNY[0]}").read())
        for part in chosen:
            parts[part](programs, folder, output)


if __name__ == "__main__":
    main()
