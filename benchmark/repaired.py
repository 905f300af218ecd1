#!/usr/bin/env python3
"""Repairs surfaces that do not bound a solid and rotates them; prints a row of a table for each.

Usage: benchmark/repaired.py DSC SECONDS FILE...

SECONDS is the time limit of a run. Surfaces that `dsc` accepts without --repair have no row.
"""
import json
import os
import subprocess
import sys
import tempfile

TURN = ["--axis", "0,0,1", "--angle", "2", "--quiet"]
COUNTS = ["merged_points", "degenerate_triangles", "repeated_triangles", "stitched_points", "filled_holes",
          "crossing_pairs"]


def run(arguments, seconds):
    """Returns the error message of the program, or an empty string if it succeeded."""
    try:
        done = subprocess.run(arguments, capture_output=True, text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return f"**not done in {seconds:g} s**"
    if done.returncode == 0:
        return ""
    lines = done.stderr.strip().splitlines() or ["no message"]
    if done.returncode == 1:
        return lines[-1]
    return f"**failed with {done.returncode}**: {lines[-1]}"


def row(program, path, seconds):
    name = os.path.basename(path)
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        error = run([program, "rotate", path, *TURN, "--repair", "--steps", "10", "--report", report], seconds)
        if error:
            reason = error.replace(path + " cannot be repaired: ", "").replace(path + ": ", "")
            reason = reason.replace("dsc: ", "").split(":")[0]
            return [name] + ["–"] * 10 + ["refused: " + reason]
        with open(report, encoding="utf-8") as file:
            told = json.load(file)
    repair = told["repairs"][0]
    edge = repair["mean_edge"]
    incomplete = sum(not step["complete"] for step in told["steps"])
    return ([name] + [repair[count] for count in COUNTS] + ["yes" if repair["wrap"] else "no"] +
            [f"{repair[way] / edge:.3g}" for way in ("distance_from_input", "distance_to_input")] +
            [told["steps"][-1]["interface_triangles"], f"rotates, {incomplete} steps incomplete"])


def main():
    program, seconds = sys.argv[1], float(sys.argv[2])
    for path in sys.argv[3:]:
        if run([program, "rotate", path, *TURN, "--steps", "1"], seconds):
            print("| " + " | ".join(str(cell) for cell in row(program, path, seconds)) + " |", flush=True)


if __name__ == "__main__":
    main()
