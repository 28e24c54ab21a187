#!/usr/bin/env python3
"""Holds two builds of the program against each other: every case must give the same results.json.

    same_results.py OLD NEW [CASE...]
    same_results.py A/results.json B/results.json

Runs each case (those of cases/ unless named) by both programs, or takes two documents that are there, and prints every
value that differs, but for times and provenance. Ends with 1 where one does. What only one of them has is a difference
too.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Times and what is drawn over them, and what names the build or the folder.
UNLIKE = re.compile(
    r"(seconds|(^|_)time$|provenance|check_sum|sha256|machine|memory|stages|repeats|stored_in|changes|study_figures|explained)")


def values(node, path=""):
    """All numbers and texts of a document, by their path."""
    if isinstance(node, dict):
        # How far a run came in the time allowed, and a figure over the cost of runs, tell of the machine.
        if "the time allowed" in str(node.get("message", "")) or "economy" in str(node.get("file", "")):
            return
        for key, value in node.items():
            if not UNLIKE.search(key) and f"{path}.{key}" != ".case.file":
                yield from values(value, f"{path}.{key}")
    elif isinstance(node, list):
        for index, value in enumerate(node):
            yield from values(value, f"{path}[{index}]")
    else:
        yield path, node


def of_document(file):
    return dict(values(json.loads(pathlib.Path(file).read_text())))


def results(program, case, folder):
    ended = subprocess.run([program, "run", case, "-o", folder, "--quiet"], capture_output=True, text=True)
    file = pathlib.Path(folder) / "results.json"
    return ended.returncode, of_document(file) if file.exists() else {"": ended.stderr}


def differences(a, b):
    """A line for each value that differs."""
    return [f"{key}: {a.get(key)} and {b.get(key)}" for key in sorted(a.keys() | b.keys()) if a.get(key) != b.get(key)]


def compare_documents(old, new):
    a, b = of_document(old), of_document(new)
    moved = differences(a, b)
    print(f"{old} and {new}: {len(a)} values, {len(moved)} differ")
    for line in moved[:20]:
        print(f"  {line}")
    return 1 if moved or not a else 0


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    old, new, *cases = sys.argv[1:]
    if old.endswith(".json") and new.endswith(".json"):
        return compare_documents(old, new)
    cases = cases or sorted(str(path) for path in (ROOT / "cases").rglob("*.toml") if path.parent.name != "references")
    different = 0
    for case in cases:
        with tempfile.TemporaryDirectory() as folder:
            (status, a), (new_status, b) = (results(p, case, f"{folder}/{n}") for p, n in ((old, "old"), (new, "new")))
        moved = differences(a, b)
        print(f"{case}: ends with {status} and {new_status}, {len(a)} values, {len(moved)} differ")
        for line in moved[:20]:
            print(f"  {line}")
        different += len(moved) + (status != new_status)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
