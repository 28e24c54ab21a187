#!/usr/bin/env python3
"""Shows what Newton's iteration adds to the answer of every implicit method, against its newton_tolerance.

usage: tests/newton_tolerances.py [PLUMB [METHOD...]]

Prints, for a soft pendulum over 1 s and a stiff one over 0.2 s, with several steps, the greatest distance of the tip
from where the same method goes with the same step and an iteration to round-off, as a multiple of newton_tolerance
times the length, and the corrections a step; "refused" where the run did not complete, "round-off" where two
iterations to round-off are as far apart as that. Exit status 1 where more than newton_tolerance was added.
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

CASE = """
title = "pendulum"
cable = {{ length = 1, area = {area}, density = {density}, youngs_modulus = {youngs_modulus}, elements = {elements} }}
start = {{ direction = [1, 0, 0], angular_velocity = [0, 4, 0] }}
supports = {{ first = "pinned", last = "free" }}
loads = {{ gravity = [0, -9.81, 0] }}
method = {{ name = "{method}", step = {step}, newton_tolerance = {tolerance} }}
time = {{ end = {end}, output_interval = {interval} }}
probe = [{{ name = "tip", at = 1, quantity = "position" }}]
"""
SOFT = {"area": 25e-6, "density": 320, "youngs_modulus": 1.6e6, "elements": 4, "end": 1, "interval": 0.02}
STIFF = {"area": 1e-6, "density": 8000, "youngs_modulus": 1e9, "elements": 16, "end": 0.2, "interval": 0.004}
CASES = {"soft, 4 elements": (SOFT, [1e-2, 2e-3, 2e-4, 5e-5]), "stiff, 16 elements": (STIFF, [4e-3, 1e-3, 2e-4, 2e-5])}
TOLERANCES = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12]
ROUND_OFF = [1e-15, 2e-15]


def solve(plumb, case):
    with tempfile.TemporaryDirectory() as folder:
        path, file = pathlib.Path(folder) / "case.toml", pathlib.Path(folder) / "probes.csv"
        path.write_text(CASE.format(**case))
        done = subprocess.run([plumb, "solve", path, "--json", "--quiet", "--csv", file], capture_output=True, text=True)
        if done.returncode not in (0, 4):
            sys.exit(done.stderr)
        rows = list(csv.reader(file.open()))[1:]
        return json.loads(done.stdout), [[float(x) for x in row[1:]] for row in rows]


def distance(a, b):
    return max(sum((x - y)**2 for x, y in zip(p, q))**0.5 for p, q in zip(a, b))


def main():
    plumb = sys.argv[1] if len(sys.argv) > 1 else "build/release/plumb"
    doctor = json.loads(subprocess.run([plumb, "doctor", "--json"], capture_output=True, text=True).stdout)
    names = sys.argv[2:] or [method["name"] for method in doctor["methods"]
                             if "newton_tolerance" in method["keys"] and method["family"] != "static"]
    beyond = 0
    for title, (cable, steps) in CASES.items():
        print(f"{title + ': added / tolerance, corrections a step':52}" + "".join(f"{t:>16g}" for t in TOLERANCES))
        for name in names:
            for step in steps:
                case = {**cable, "method": name, "step": step}
                exact, exact_tips = solve(plumb, {**case, "tolerance": ROUND_OFF[0]})
                other, other_tips = solve(plumb, {**case, "tolerance": ROUND_OFF[1]})
                line = f"{name:24}{step:>10g} s{'':16}"
                if exact["outcome"] != "completed" or other["outcome"] != "completed":
                    print(line + "refused")
                    continue
                noise = distance(exact_tips, other_tips)
                for tolerance in TOLERANCES:
                    run, tips = solve(plumb, {**case, "tolerance": tolerance})
                    if run["outcome"] != "completed":
                        line += f"{'refused':>16}"
                        continue
                    added = distance(tips, exact_tips)
                    beyond += added > tolerance + 10 * noise
                    amount = "round-off" if added <= 10 * noise else f"{added / tolerance:.2g}"
                    line += f"{amount:>10} {run['newton_iterations'] / run['steps']:>5.2f}"
                print(line, flush=True)
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main())
