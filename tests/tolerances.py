#!/usr/bin/env python3
"""Holds every method that takes tolerances against what it was asked for.

usage: tests/tolerances.py [PLUMB [METHOD...]]

Prints, for the pendulum with four elements over 1 s, the greatest error of the tip as a multiple of rtol times the
length, and the seconds that it took; "refused" where the method says that it cannot, "late" after a minute.
Exit status 1 where a method that did not refuse is more than ten times beyond its tolerance.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

CASE = """
title = "pendulum"
cable = {{ length = 1, area = 25e-6, density = 320, youngs_modulus = 1.6e6, elements = 4 }}
start = {{ direction = [1, 0, 0], angular_velocity = [0, 4, 0] }}
supports = {{ first = "pinned", last = "free" }}
loads = {{ gravity = [0, -9.81, 0] }}
method = {{ name = "{method}", rtol = {rtol} }}
time = {{ end = 1, output_interval = 0.02 }}
probe = [{{ name = "tip", at = 1, quantity = "position" }}]
"""
TOLERANCES = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10]
SECONDS = 60


def solve(plumb, method, rtol):
    with tempfile.TemporaryDirectory() as folder:
        case, file = pathlib.Path(folder) / "case.toml", pathlib.Path(folder) / "probes.csv"
        case.write_text(CASE.format(method=method, rtol=rtol))
        command = [plumb, "solve", case, "--json", "--quiet", "--csv", file]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return {"outcome": "late"}, []
        if done.returncode not in (0, 4):
            sys.exit(done.stderr)
        rows = list(csv.reader(file.open()))[1:]
        return json.loads(done.stdout), [[float(x) for x in row[1:]] for row in rows]


def main():
    plumb = sys.argv[1] if len(sys.argv) > 1 else "build/release/plumb"
    doctor = json.loads(subprocess.run([plumb, "doctor", "--json"], capture_output=True, text=True).stdout)
    names = sys.argv[2:] or [method["name"] for method in doctor["methods"] if "rtol" in method["keys"]]
    exact = solve(plumb, "arkode-erk", 1e-13)[1]
    beyond = 0
    print(f"{'error / (rtol L), time':24}" + "".join(f"{t:>18g}" for t in TOLERANCES))
    for name in names:
        line = f"{name:24}"
        for rtol in TOLERANCES:
            result, tips = solve(plumb, name, rtol)
            if result["outcome"] != "completed":
                line += f"{'late' if result['outcome'] == 'late' else 'refused':>18}"
                continue
            error = max(sum((a - b)**2 for a, b in zip(p, q))**0.5 for p, q in zip(tips, exact)) / rtol
            beyond += error > 10
            line += f"{error:>9.2g} {result['solve_seconds']:>6.3f} s"
        print(line, flush=True)
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main())
