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

CASE = pathlib.Path(__file__).parent.parent / "cases" / "pendulum.toml"
TOLERANCES = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10]
SECONDS = 60


def solve(plumb, method, rtol, order=""):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "probes.csv"
        command = [plumb, "solve", CASE, "--json", "--quiet", "--csv", file, "--set", "time.end=1", "--set",
                   f'method={{ name = "{method}", rtol = {rtol}{order} }}']
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return {"outcome": "late"}, []
        rows = list(csv.reader(file.open())) if file.exists() else []
        first = rows[0].index("tip.x [m]") if rows else 0
        tips = [[float(x) for x in row[first:first + 3]] for row in rows[1:]]
        return json.loads(done.stdout or '{"outcome": "invalid"}'), tips


def main():
    plumb = sys.argv[1] if len(sys.argv) > 1 else "build/release/plumb"
    doctor = json.loads(subprocess.run([plumb, "doctor", "--json"], capture_output=True, text=True).stdout)
    names = sys.argv[2:] or [m["name"] for m in doctor["methods"] if "rtol" in str(m)]
    _, exact = solve(plumb, "arkode-erk", 1e-13)
    beyond = 0
    print(f"{'error / (rtol L)':24}" + "".join(f"{t:>18g}" for t in TOLERANCES))
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
