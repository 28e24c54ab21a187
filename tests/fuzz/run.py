#!/usr/bin/env python3
"""Runs the fuzz targets in turn and tells how it went.

    tests/fuzz/run.py PLUMB_FUZZ SECONDS [--only TARGET] [--merge]

SECONDS is for all targets together, shared out evenly. Each starts from tests/fuzz/corpus/TARGET, from what the program's
own writers make, and from what earlier runs found (build/fuzz/corpus/TARGET, where this one puts what it finds too), and
stops at its first crash. Prints a table of executions, new coverage and crashes; exit status 1 where there is a crash,
with the path of the input. build/fuzz/executions/TARGET adds up what all runs have executed.

--merge puts what is needed of the found inputs for the same coverage, as far as they are short, into tests/fuzz/corpus.
"""

import argparse
import os
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PLACE = HERE.parents[1] / "build" / "fuzz"
LONGEST_KEPT = 2048  # bytes; the ordinary suite reads every one that is kept
MOST_KEPT = 24 * 1024  # bytes of a target
# The library itself crashes on what others wrote: that is why a child process reads it, which may.
LIBRARY_FRAME = re.compile(r"#\d+ .*libhdf5")
ENVIRONMENT = dict(os.environ, ASAN_OPTIONS="detect_leaks=0:allocator_may_return_null=0:symbolize=1:handle_abort=1",
                   UBSAN_OPTIONS="print_stacktrace=1")


def fuzz(program, target, seconds):
    """(executions, coverage before, coverage after, crash or None)."""
    found = PLACE / "corpus" / target
    found.mkdir(parents=True, exist_ok=True)
    crashes = PLACE / "crashes" / target
    crashes.mkdir(parents=True, exist_ok=True)
    folders = [found, HERE / "corpus" / target, PLACE / "seeds" / target]
    command = [program, f"--target={target}", f"-max_total_time={seconds}", "-timeout=20", "-rss_limit_mb=3000", "-print_final_stats=1",
               f"-artifact_prefix={crashes}/", *(str(folder) for folder in folders if folder.is_dir())]
    dictionary = HERE / f"{target}.dict"
    if dictionary.exists():
        command.insert(2, f"-dict={dictionary}")
    log = PLACE / f"{target}.log"
    with open(log, "w") as file:
        ended = subprocess.run(command, stdout=file, stderr=subprocess.STDOUT, env=ENVIRONMENT, cwd=PLACE)
    text = log.read_text(errors="replace")
    executed = [int(number) for number in re.findall(r"^#(\d+)\t", text, re.M)] + \
        [int(number) for number in re.findall(r"number_of_executed_units: *(\d+)", text)]
    coverage = [int(number) for number in re.findall(r"\bcov: (\d+)", text)]
    crash = None
    if ended.returncode != 0:
        path = re.search(r"written to (\S+)", text)
        why = re.search(r"what\(\):\s*(.*)|runtime error: (.*)|ERROR: (.*)", text)
        crash = {"input": path.group(1) if path else str(log), "why": next((word for word in why.groups() if word), "") if why else "",
                 "library": bool(LIBRARY_FRAME.search(text))}
    return max(executed, default=0), coverage[0] if coverage else 0, coverage[-1] if coverage else 0, crash


def merge(program, target):
    """What is kept of a target: the shortest inputs first, as many as there is room for."""
    kept = HERE / "corpus" / target
    kept.mkdir(parents=True, exist_ok=True)
    merged = PLACE / "merged" / target
    subprocess.run(["rm", "-rf", str(merged)], check=True)
    merged.mkdir(parents=True)
    subprocess.run([program, f"--target={target}", "-merge=1", f"-max_len={LONGEST_KEPT}", str(merged), str(kept), str(PLACE / "corpus" / target)],
                   env=ENVIRONMENT, cwd=PLACE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=1800)
    room = MOST_KEPT - sum(path.stat().st_size for path in kept.iterdir())
    for path in sorted(merged.iterdir(), key=lambda path: (path.stat().st_size, path.name)):
        size = path.stat().st_size
        if size <= min(room, LONGEST_KEPT) and not (kept / path.name[:12]).exists():
            (kept / path.name[:12]).write_bytes(path.read_bytes())
            room -= size


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("seconds", type=int)
    parser.add_argument("--only", default="")
    parser.add_argument("--merge", action="store_true")
    arguments = parser.parse_args()
    program = str(Path(arguments.program).resolve())
    PLACE.mkdir(parents=True, exist_ok=True)
    names = subprocess.run([program, "--targets"], check=True, capture_output=True, text=True).stdout.split()
    if arguments.only and arguments.only not in names:
        parser.error(f"--only {arguments.only}: there are {', '.join(names)}")
    names = [arguments.only] if arguments.only else names
    subprocess.run([program, f"--seeds={PLACE / 'seeds'}"], check=True, env=ENVIRONMENT)
    each = max(1, arguments.seconds // len(names))
    counts = PLACE / "executions"
    counts.mkdir(exist_ok=True)
    total = 0

    print(f"{'target':16}{'executions':>12}{'in all runs':>13}{'coverage':>10}{'new':>7}{'crashes':>9}", flush=True)
    crashes = []
    for name in names:
        executed, before, after, crash = fuzz(program, name, each)
        count = counts / name
        in_all = executed + (int(count.read_text()) if count.exists() else 0)
        count.write_text(f"{in_all}\n")
        total += executed
        print(f"{name:16}{executed:12,}{in_all:13,}{after:10,}{after - before:7,}{1 if crash else 0:9}", flush=True)
        if crash:
            crashes.append((name, crash))
        if arguments.merge:
            merge(program, name)
    in_all = sum(int(count.read_text()) for count in counts.iterdir())
    print(f"{'all':16}{total:12,}{in_all:13,}")
    for name, crash in crashes:
        print(f"{name}: {crash['why']}{' (within libhdf5)' if crash['library'] else ''}: {crash['input']}")
    return 1 if any(not crash["library"] for _, crash in crashes) else 0


if __name__ == "__main__":
    sys.exit(main())
