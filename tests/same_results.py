#!/usr/bin/env python3
"""Holds two builds of the program against each other: every case must give the same results.json.

    same_results.py OLD NEW [CASE...]

Runs each case (those of cases/ unless named) by both programs and prints every value that differs, but for times and
provenance. Ends with 1 where one does. What only one of them writes is a difference too.
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
            if not UNLIKE.search(key):
                yield from values(value, f"{path}.{key}")
    elif isinstance(node, list):
        for index, value in enumerate(node):
            yield from values(value, f"{path}[{index}]")
    else:
        yield path, node


def results(program, case, folder):
    ended = subprocess.run([program, "run", case, "-o", folder, "--quiet"], capture_output=True, text=True)
    file = pathlib.Path(folder) / "results.json"
    return ended.returncode, dict(values(json.loads(file.read_text()))) if file.exists() else {"": ended.stderr}


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    old, new, *cases = sys.argv[1:]
    cases = cases or sorted(str(path) for path in (ROOT / "cases").rglob("*.toml") if path.parent.name != "references")
    different = 0
    for case in cases:
        with tempfile.TemporaryDirectory() as folder:
            (status, a), (new_status, b) = (results(p, case, f"{folder}/{n}") for p, n in ((old, "old"), (new, "new")))
        moved = [key for key in a.keys() | b.keys() if a.get(key) != b.get(key)]
        print(f"{case}: ends with {status} and {new_status}, {len(a)} values, {len(moved)} differ")
        for key in sorted(moved)[:20]:
            print(f"  {key}: {a.get(key)} and {b.get(key)}")
        different += len(moved) + (status != new_status)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
