#!/usr/bin/env python3
# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares whole processes of two programs `dsc`.

Usage: benchmark/processes.py OLD NEW FOLDER [WORD...] [--runs N]

OLD and NEW are programs `dsc` in Release. FOLDER contains `bunny00.off` and `refined_elephant.off` of CGAL's data. Runs each
command with both programs in turns, with one thread. Prints a line for each command: medians of the processor
time of the process and of the seconds in steps, as the program prints them. WORDs choose commands by parts of
their names. A command that one of the programs refuses has no number there.
"""
import argparse
import os
import pathlib
import re
import statistics
import subprocess
import tempfile

BUNNY, ELEPHANT = "offset {data}/bunny00.off", "offset {data}/refined_elephant.off"
COMMANDS = {
    "out, 14 k, 10 steps": BUNNY + " --triangles 14000 --distance .25e --steps 10",
    "in, 14 k, 10 steps": BUNNY + " --triangles 14000 --distance=-.25e --steps 10",
    "report, 14 k, 10 steps": BUNNY + " --triangles 14000 --distance .25e --steps 10 --report {folder}/report.json",
    "elephant in, 14 k, 10 steps": ELEPHANT + " --triangles 14000 --distance=-.25e --steps 10",
    "curvature, 14 k, 5 steps": "mean-curvature {data}/bunny00.off --triangles 14000 --steps 5",
    "rotation, 14 k, 5 steps": "rotate {data}/bunny00.off --triangles 14000 --axis 1,2,3 --angle 10 --steps 5",
    "enright, 20 steps": "enright --period 3 --dt .01 --steps 20",
    "out, 200 k, 4 steps": BUNNY + " --triangles 200000 --distance .25e --steps 4",
    "out, 1 M, 2 steps": BUNNY + " --triangles 1000000 --distance .25e --steps 2",
}


def measured(program, command, data):
    """Returns processor seconds and seconds in steps of a run, or nothing if it fails."""
    with tempfile.TemporaryDirectory() as folder:
        arguments = command.format(data=data, folder=folder).split()
        before = os.times()
        done = subprocess.run([program, *arguments, "--threads", "1"], capture_output=True, text=True, check=False)
        after = os.times()
        if done.returncode != 0:
            return None
        seconds = after.children_user - before.children_user + after.children_system - before.children_system
        return seconds, float(re.search(r"([0-9.e+-]+) s$", done.stdout.strip()).group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    print("| command | old: process (s) | steps (s) | new: process (s) | steps (s) | times as fast: process | steps |\n" + "| --- " * 7 + "|")
    for name, command in COMMANDS.items():
        if options.words and not any(word in name for word in options.words):
            continue
        results = {program: [] for program in (options.old, options.new)}
        for _ in range(options.runs):
            for program, list_of in results.items():
                list_of.append(measured(program, command, options.folder.resolve()))
        medians = [[statistics.median(r[k] for r in runs) if None not in runs else float("nan") for k in (0, 1)]
                   for runs in results.values()]
        (old, old_steps), (new, new_steps) = medians
        print(f"| {name} | {old:.2f} | {old_steps:.2f} | {new:.2f} | {new_steps:.2f} | {old / new:.2f} | {old_steps / new_steps:.2f} |", flush=True)


if __name__ == "__main__":
    main()
