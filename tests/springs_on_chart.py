#!/usr/bin/env python3
"""Another program's curve on Plumb's charts of speed against accuracy: springs_on_chart.py PROGRAM FOLDER.

Runs the springs of independent_pendulum.py with several numbers of links and of steps, each timed, writes their tables
and a case with a [[run.point]] for each to FOLDER, and makes its study there. Then it holds the points against errors of
its own: the greatest distance of the tips in the tables to those of Plumb's finest mesh, solved apart. Ends with 1 where
one differs by more than a hundredth.
"""

import argparse
import csv
import io
import json
import math
import pathlib
import subprocess
import sys
import time

import independent_pendulum as springs

CASE = """title = "Springs beside Plumb's methods"

[cable]
length = 1.0
area = 2.5e-5
density = 320
youngs_modulus = 1.6e6
elements = 4
[start]
angular_velocity = [0, 4, 0]
[supports]
first = "pinned"
[loads]
gravity = [0, -9.81, 0]
[method]
name = "rk4"
step = 5e-4
[time]
end = {end}
output_interval = {interval}
[[probe]]
name = "tip"
at = 1.0
[scene]
size = [640, 360]
[study.work_precision]
quick.elements = [4, 8, 16]
[[run]]
name = "springs"
program = "springs in plain Python"
columns = {{ t = "Time", "tip.x" = "Tip X", "tip.y" = "Tip Y", "tip.z" = "Tip Z" }}
{where}"""

POINT = """[[run.point]]
file = "{file}"
seconds = {seconds:.4g}
label = "{links} links, {steps} steps a row"
"""


def table(links, steps, end):
    """The text of the springs' table, and the seconds of the processor that they took."""
    springs.set_up(links=links, steps_per_row=steps, end=end)
    text = io.StringIO()
    began = time.process_time()
    springs.write(text)
    return text.getvalue(), time.process_time() - began


def tips(text):
    """The tip of each row by its time (ms, to the microsecond), m."""
    result = {}
    for row in csv.DictReader(io.StringIO(text)):
        cells = {key.split(" [")[0]: float(value) for key, value in row.items()}
        if "Time" in cells:
            result[round(1000 * cells["Time"])] = [cells[f"Tip {axis}"] / 1000 for axis in "XYZ"]
        else:
            result[round(1e6 * cells["t"])] = [cells[f"tip.{axis}"] for axis in "xyz"]
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--links", type=int, nargs="+", default=[4, 8, 16, 32])
    parser.add_argument("--end", type=float, default=2.0, help="s, a multiple of 0.016")
    parser.add_argument("--machine", help="say that it was another one")
    parser.add_argument("--yardstick", type=float, help="s, of that machine")
    parser.add_argument("--full", action="store_true", help="the whole study, not the short one of plumb run")
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)

    where = f'machine = "{asked.machine}"\n' if asked.machine else ""
    where += f"yardstick = {asked.yardstick}\n" if asked.yardstick else ""
    case = CASE.format(end=asked.end, interval=0.016, where=where)
    texts = {}
    for links in asked.links:
        # The step shortens as the links do: the fastest of them vibrates at 2c/l.
        steps = max(2, math.ceil(links * 0.6))
        file = f"springs_{links}.csv"
        texts[file], seconds = table(links, steps, asked.end)
        (asked.folder / file).write_text(texts[file])
        case += POINT.format(file=file, seconds=seconds, links=links, steps=steps)
        print(f"{links} links: {seconds:.3g} s")
    path = asked.folder / "springs.toml"
    path.write_text(case)

    made = subprocess.run([asked.program, "study" if asked.full else "run", path, "-o", asked.folder / "out", "--json", "--quiet"],
                          capture_output=True, text=True, check=False)
    if not made.stdout:
        sys.exit(f"springs_on_chart: {made.stderr}")
    study = json.loads(made.stdout)["work_precision"]
    finest = study["converged_reference"]["elements"]
    exact = subprocess.run([asked.program, "solve", path, "--csv", "-", "--quiet", "--set", f"cable.elements={finest}",
                            "--set", f"method.step={1e-3 / finest}"], capture_output=True, text=True, check=True)
    reference = tips(exact.stdout)
    status = 0
    for point in study["given_curves"][0]["points"]:
        own = tips(texts[point["file"]])
        apart = max(math.dist(own[t], place) for t, place in reference.items() if t in own)
        said = point["total_error"]["tip_max"]
        good = abs(said - apart) <= 0.01 * apart
        status |= not good
        print(f"{point['label']}: {point['work_seconds']:.3g} s, {said:.4g} m on the chart, {apart:.4g} m apart"
              f"{'' if good else ': DIFFERS'}{'; ' + point['why_not'] if point['why_not'] else ''}")
    return status


if __name__ == "__main__":
    sys.exit(main())
