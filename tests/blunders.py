#!/usr/bin/env python3
"""Makes the blunders of [sensitivity] as runs of other programs, which the criteria of a case should not let pass.

usage: tests/blunders.py [--jobs N] PLUMB CASE...

`plumb study CASE sensitivity` says which blunders a case can make, and which of them its criteria notice. Each is then
made once more: the case is solved with the blunder in it, what the probes saw is given to the case as a [[run]] without
[method], with its references as they are, and `plumb run` has to end as the study says. Prints a table of blunders
against cases:

    noticed   some criterion is not met, and `plumb run` ends with 1
    PASSED    every criterion is met all the same
    fails     the run with the blunder does not complete
    –         the case cannot make it

A star is put to what the study alone says: masses on the nodes have no key, and there are no runs of other programs over
modes and loads. Exit status 1 where a blunder is noticed by no case that can make it (a finer mesh is no mistake), where
a case does not pass with its own run, and where the run and the study do not agree.
"""

import argparse
import concurrent.futures
import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

OF_PLUMB = {"method", "uncertainty", "error_budget", "study", "sensitivity", "run"}
WITHOUT_TIME = {"modes", "statics"}
# One number, and hardly changed: the blunders are what is asked for.
FEW_NUMBERS = ['sensitivity.numbers=["cable.length"]', "sensitivity.largest=1.01"]
QUICK = ["scene.size=[32, 18]", "scene.frame_rate=1"]
AS_IT_IS = "as it is"


def run(command, cwd=None):
    return subprocess.run([str(part) for part in command], cwd=cwd, capture_output=True, text=True)


def sets(overrides):
    return [part for text in overrides for part in ("--set", text)]


def as_other_program(text):
    """The text of a case without what is Plumb's own, with a [[run]] in its place."""
    kept, keep, in_prose = [], True, False
    for line in text.splitlines():
        header = None if in_prose else re.match(r"\[\[?\s*([\w-]+)[\w.\s-]*\]", line)
        if header:
            keep = header[1] not in OF_PLUMB
        if line.count('"""') % 2:
            in_prose = not in_prose
        if keep:
            kept.append(line)
    return "\n".join(kept) + '\n[[run]]\nname = "other"\nfile = "other.csv"\nprogram = "another program"\n'


def delay(table):
    """Puts what an output saw into the next."""
    with open(table, newline="") as file:
        head, *rows = csv.reader(file)
    with open(table, "w", newline="") as file:
        csv.writer(file).writerows([head] + [now[:1] + before[1:] for now, before in zip(rows, rows[:1] + rows)])


def judged(plumb, path, overrides, late):
    """How a case takes a run with these overrides from another program."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if (path.parent / "references").is_dir():
            shutil.copytree(path.parent / "references", folder / "references")
        solved = run([plumb, "solve", path, "--csv", folder / "other.csv", "--quiet", *sets(overrides)])
        if solved.returncode == 4:
            return "fails"
        if solved.returncode != 0:
            return f"error: {solved.stderr.strip()}"
        if late:
            delay(folder / "other.csv")
        (folder / "case.toml").write_text(as_other_program(path.read_text()))
        ended = run([plumb, "run", "case.toml", "--quiet", *sets(QUICK)], folder)
        return {0: "PASSED", 1: "noticed"}.get(ended.returncode, f"error: {ended.stderr.strip()}")


def studied(plumb, path):
    """The sensitivity of a case as its study has it, or why there is none."""
    with tempfile.TemporaryDirectory() as name:
        ended = run([plumb, "study", path, "sensitivity", "--json", "--quiet", "-o", pathlib.Path(name) / "out",
                     *sets(FEW_NUMBERS)])
        if ended.returncode not in (0, 1, 4):
            return f"error: {ended.stderr.strip()}"
        return json.loads(ended.stdout)["sensitivity"]


def said(blunder):
    if blunder["why_not"]:
        return "–"
    if blunder["outcome"] != "completed":
        return "fails"
    return "noticed" if any(found["noticed"] for found in blunder["found"]) else "PASSED"


def row_of(blunder):
    return blunder["name"] if blunder["kind"] in ("density-unit", "other-sign") else blunder["kind"]


def tried(pool, plumb, path):
    """What each blunder comes to, by its name, and what is wrong with that."""
    study = studied(plumb, path)
    if isinstance(study, str) or study["left_out"]:
        return {}, [study if isinstance(study, str) else study["left_out"]]
    met = all(criterion["met"] for criterion in study["criteria"])
    over_time = tomllib.loads(path.read_text())["method"]["name"] not in WITHOUT_TIME
    cells, trouble, made = {AS_IT_IS: "PASSED" if met else "noticed"}, [], {}
    if over_time:
        made[AS_IT_IS] = pool.submit(judged, plumb, path, [], False)
    else:
        cells[AS_IT_IS] += "*"
    for blunder in study["blunders"]:
        row, expected = row_of(blunder), said(blunder)
        cells[row] = expected if expected in ("–", "fails") else expected + "*"
        late = blunder["kind"] == "late-output"
        if over_time and expected != "–" and (late or blunder["overrides"]):
            cells[row] = expected
            made[row] = pool.submit(judged, plumb, path, blunder["overrides"], late)
    for row, ended in made.items():
        expected, cells[row] = cells[row], ended.result()
        if cells[row] != expected:
            trouble.append(f"{row}: {cells[row]}, where the study says {expected}")
    if not cells[AS_IT_IS].startswith("PASSED"):
        trouble.append("its own run does not pass")
    return cells, trouble


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("plumb")
    parser.add_argument("cases", nargs="+", type=pathlib.Path)
    asked = parser.parse_args()
    plumb = pathlib.Path(asked.plumb).resolve()
    found, trouble, rows = {}, [], []
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        for path in asked.cases:
            found[path], faults = tried(pool, plumb, path.resolve())
            trouble += [f"{path}: {fault}" for fault in faults]
            rows += [row for row in found[path] if row not in rows]
    width = max(map(len, rows), default=0)
    for number, path in enumerate(found, 1):
        print(f"{number}: {path}")
    print(" " * width, *(f"{number:>9}" for number in range(1, len(found) + 1)))
    for row in rows:
        print(f"{row:<{width}}", *(f"{cells.get(row, '–')[:9]:>9}" for cells in found.values()))
    for row in rows:
        all_of = {cells.get(row, "–").rstrip("*") for cells in found.values()}
        if row not in (AS_IT_IS, "double-mesh") and all_of - {"–", "fails"} == {"PASSED"}:
            trouble.append(f"{row} is noticed by no case")
    print(*trouble, sep="\n")
    return 1 if trouble or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
