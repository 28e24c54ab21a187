#!/usr/bin/env python3
"""Tries what the program advises after a failure.

usage: tests/advice.py [PLUMB [RUNS [METHOD...]]]

Draws pendulums of other stiffness, mesh, step and duration for each method until RUNS (40) of them have failed, runs
each again as advised, and prints how many then ran to the end. Exit status 1 where more than one in twenty did not.
"""

import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

CASE = """
title = "pendulum"
cable = {{ length = 1, area = {area}, density = {density}, youngs_modulus = {E}, elements = {elements} }}
start = {{ direction = [1, 0, 0], angular_velocity = [0, 4, 0] }}
supports = {{ first = "pinned", last = "free" }}
loads = {{ gravity = [0, -9.81, 0] }}
method = {{ name = "{name}", {keys} }}
time = {{ end = {end}, output_interval = {interval} }}
probe = [{{ name = "tip", at = 1, quantity = "position" }}]
"""
METHOD = re.compile(r"(?:(?P<other>[a-z0-9-]+) with )?(?:a step (?P<below>below|of) (?P<step>\S+) s|rtol = (?:atol = )?(?P<rtol>\S+))"
                    r" \(tried")
NEWTON = re.compile(r"newton_iterations of (\d+) as by default \(tried")


def solve(plumb, text):
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case.toml"
        case.write_text(text)
        try:
            done = subprocess.run([plumb, "solve", case, "--json", "--quiet"], capture_output=True, text=True, timeout=60)
        except subprocess.TimeoutExpired:
            return {"outcome": "late", "message": ""}
        if done.returncode not in (0, 4):
            sys.exit(done.stderr)
        return json.loads(done.stdout)


def drawn(draw, by_step, implicit):
    f = math.exp(draw.uniform(math.log(0.5), math.log(20)))
    end = draw.choice([0.5, 1, 2, 3])
    step = math.exp(draw.uniform(math.log(2e-3), math.log(0.4))) if implicit else math.exp(
        draw.uniform(math.log(1e-4), math.log(5e-3)))
    return {"area": 1e-6 * f**2, "density": 8000 / f**2, "E": 1e9 / f**4, "elements": draw.choice([2, 4, 8, 16]),
            "end": end, "interval": end / 10, "keys": f"step = {step:.3g}" if by_step else
            f"rtol = {10**draw.uniform(-9, -0.3):.2g}"}


def main():
    plumb = sys.argv[1] if len(sys.argv) > 1 else "build/release/plumb"
    wanted = int(sys.argv[2]) if len(sys.argv) > 2 else 40
    doctor = json.loads(subprocess.run([plumb, "doctor", "--json"], capture_output=True, text=True).stdout)
    bad = False
    for method in doctor["methods"]:
        if method["family"] == "static" or (sys.argv[3:] and method["name"] not in sys.argv[3:]):
            continue
        draw, failed, ran, first = random.Random(1), 0, 0, []
        for _ in range(5 * wanted):
            case = drawn(draw, "step" in method["keys"].split(",")[0], method["implicit"])
            before = solve(plumb, CASE.format(name=method["name"], **case))
            if before["outcome"] in ("completed", "late"):
                continue
            failed += 1
            advised = METHOD.search(before["message"])
            newton = NEWTON.search(before["message"])
            if advised or newton:
                name = advised["other"] or method["name"] if advised else method["name"]
                if newton:
                    case["keys"] += f", newton_iterations = {newton[1]}"
                elif advised["rtol"]:
                    case["keys"] = f"rtol = {advised['rtol']}"
                else:
                    case["keys"] = f"step = {float(advised['step']) * (0.95 if advised['below'] == 'below' else 1)}"
                after = solve(plumb, CASE.format(name=name, **case))
                ran += after["outcome"] == "completed"
                if after["outcome"] != "completed":
                    first.append(before["message"] + "\n      then: " + after["outcome"] + " " + after["message"])
            else:
                first.append(before["message"])
            if failed == wanted:
                break
        print(f"{method['name']:24} {ran:3} of {failed:3} ran as advised", *first[:1], sep="\n      " if first else "",
              flush=True)
        bad = bad or ran < 0.95 * failed
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
