#!/usr/bin/env python3
"""Draws the rooms of the package and what they include.

Usage: scripts/draw_rooms.py OUTPUT.svg [INCLUDE_DIR]

INCLUDE_DIR is include/ of this checkout, or that of an older one (git worktree add FOLDER COMMIT):
there, files belong to the rooms in which files of their names are now. Rooms stand in the order in
which data passes; an arrow from a room to one above it is as it should be and grey, one to a room
below it is red. Numbers are lines of code. The public parts that all rooms may use (the complex,
cavities, proposals, reports, files) are left out.
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent.parent
NOW = HERE / "include"
WIDTH, BOX, HEIGHT, GAP = 900, 260, 34, 22


def rooms_in_order():
    text = (HERE / "test" / "rooms.sh").read_text()
    return re.search(r"rooms=\(([^)]*)\)", text).group(1).split()


def key(path):
    """The name of a file without what tells its dimension."""
    return re.sub(r"_[23]$|_[23](?=_impl$)", "", path.stem).lower()


def own_room(path):
    parts = path.parts
    if "internal" in parts:
        after = parts[parts.index("internal") + 1 :]
        return after[0] if len(after) > 1 else None
    is_function = len(parts) == 2 and path.name[0].islower()
    return "facades" if is_function else "public parts"


def lines(path):
    text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)
    return sum(1 for line in text.splitlines() if line.strip() and not line.strip().startswith("//"))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    include = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else NOW
    order = rooms_in_order() + ["facades"]
    known = {}
    for p in NOW.rglob("*.h"):
        of_file = own_room(p.relative_to(NOW))
        if of_file in order + ["public parts"]:
            known[key(p)] = of_file

    files = {p.relative_to(include).as_posix(): p for p in sorted(include.rglob("*.h"))}
    room = {}
    for name, path in files.items():
        of_file = own_room(path.relative_to(include))
        is_placed = of_file in order or of_file == "public parts"
        room[name] = of_file if is_placed else known.get(key(path), "in no room")
    if "in no room" in room.values():
        order.insert(0, "in no room")
    size = {r: sum(lines(files[f]) for f in files if room[f] == r) for r in order}
    arrows = {}
    for name, path in files.items():
        for other in re.findall(r"#include <(CGAL/[^>]*)>", path.read_text()):
            if other in files and len({room[name], room[other], "public parts"}) == 3:
                pair = (room[name], room[other])
                arrows[pair] = arrows.get(pair, 0) + 1

    y = {r: 40 + i * (HEIGHT + GAP) for i, r in enumerate(order)}
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" '
        f'height="{60 + len(order) * (HEIGHT + GAP)}" font-family="sans-serif" font-size="15">',
        '<rect width="100%" height="100%" fill="white"/>',
    ]
    for (a, b), number in sorted(arrows.items()):
        down = order.index(b) > order.index(a)
        side, color = (0, "#cc2222") if down else (1, "#888888")
        span = abs(order.index(a) - order.index(b))
        x = (WIDTH + BOX) / 2 if side else (WIDTH - BOX) / 2
        reach = x + (1 if side else -1) * (18 + 20 * span)
        ya, yb = y[a] + HEIGHT * 0.65, y[b] + HEIGHT * 0.35
        out.append(
            f'<path d="M {x} {ya} C {reach} {ya}, {reach} {yb}, {x} {yb}" fill="none" '
            f'stroke="{color}" stroke-opacity=".7" stroke-width="{min(6, 0.6 + number / 6):.1f}">'
            f"<title>{a} includes {b}: {number}</title></path>"
        )
    for r in order:
        shade = min(70, size[r] // 60)
        out.append(
            f'<rect x="{(WIDTH - BOX) / 2}" y="{y[r]}" width="{BOX}" height="{HEIGHT}" rx="5" '
            f'fill="hsl(210, 60%, {95 - shade // 2}%)" stroke="#335577"/>'
            f'<text x="{WIDTH / 2}" y="{y[r] + 22}" text-anchor="middle">{r}: {size[r]}</text>'
        )
    wrong = sum(n for (a, b), n in arrows.items() if order.index(b) > order.index(a))
    out.append(
        f'<text x="20" y="24">{sum(arrows.values())} includes between rooms, {wrong} of them '
        "against the order (red, on the left)</text></svg>"
    )
    pathlib.Path(sys.argv[1]).write_text("\n".join(out) + "\n")


main()
