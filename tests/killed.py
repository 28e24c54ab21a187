#!/usr/bin/env python3
"""Kills studies, tears their journals and runs their parts in every wrong order: nothing that is done may be lost, and
in the end there must be what one undisturbed process gives.

    tests/killed.py PLUMB [--only KIND] [--seed K] [--long]

KIND is mpi, shares or refused. Of mpi, which needs mpirun, each rank, mpirun itself and the shell around it are ended
by SIGKILL, SIGTERM, SIGINT and SIGHUP. --long takes a study of some seconds instead of one of half a second, so that
more is under way at that moment. Prints a row a trial: how it ended, what the program said, how many lines its journal
has of points that it had already, and what differs from the undisturbed study. Exit status 1 where a trial has failed;
77 where there is no mpirun for --only mpi.
"""

import argparse
import contextlib
import io
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import same_results

CASES = Path(__file__).resolve().parent.parent / "cases"
SHORT = ["study.sweep.cases=24", "study.sweep.seed=1", "time.end=0.05", "study.sweep.time_limit=60"]
LONG = ["study.sweep.cases=60", "study.sweep.seed=3", "study.sweep.time_limit=60"]
PATIENCE = 600  # s, for all that must end
INVALID, OUTPUT, INTERRUPTED = 3, 5, 130


class Wrong(Exception):
    """What a trial has found."""


def expect(right, text):
    if not right:
        raise Wrong(text)


def settings(texts):
    return [word for text in texts for word in ("--set", text)]


class Study:
    """One study, in a folder of its own."""

    def __init__(self, plumb, folder, sets):
        self.plumb, self.folder, self.sets = plumb, Path(folder), sets
        self.case = str(CASES / "failure" / "random_sweep.toml")

    def command(self, *more, sets=None):
        return [self.plumb, "study", self.case, "sweep", *settings(sets or self.sets), *more]

    def start(self, command):
        # Open MPI lets root start nothing unless it is told to.
        environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        return subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                stdin=subprocess.DEVNULL, start_new_session=True, env=environment)

    def end(self, process):
        said, _ = process.communicate(timeout=PATIENCE)
        return process.returncode, said

    def run(self, *more, sets=None):
        return self.end(self.start(self.command(*more, sets=sets)))

    def text(self, name):
        file = self.folder / name
        return file.read_bytes() if file.exists() else b""

    def await_points(self, name, count, process):
        """Until a journal has so many points, or the program has ended."""
        until = time.monotonic() + PATIENCE
        while len(points(self.text(name))) < count and process.poll() is None:
            expect(time.monotonic() < until, f"{name} does not get {count} points")
            time.sleep(0.002)

    def await_no_process(self):
        """How long the last process with our folder as its own takes to go, s."""
        begin = time.monotonic()
        while left := self.processes():
            expect(time.monotonic() < begin + 10, f"processes left: {left}")
            time.sleep(0.02)
        return time.monotonic() - begin

    def processes(self):
        found = []
        for entry in Path("/proc").iterdir():
            with contextlib.suppress(OSError):
                if entry.name.isdigit() and os.readlink(entry / "cwd") == str(self.folder.resolve()):
                    found.append(int(entry.name))
        return found

    def rank(self, wanted):
        """The process of a rank."""
        mark = f"OMPI_COMM_WORLD_RANK={wanted}".encode()
        for process in self.processes():
            with contextlib.suppress(OSError):
                program = os.path.basename(os.readlink(f"/proc/{process}/exe"))
                parent = os.path.basename(os.readlink(f"/proc/{parent_of(process)}/exe"))
                variables = Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
                if program == "plumb" and parent != "plumb" and mark in variables:
                    return process
        raise Wrong(f"there is no process of rank {wanted}")


def parent_of(process):
    return int(Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[1])


def points(text):
    """The keys of the points of a journal, whole lines only."""
    found = []
    for line in text.split(b"\n")[:-1]:
        with contextlib.suppress(ValueError):
            entry = json.loads(line[9:])
            if isinstance(entry, dict) and "point" in entry:
                found.append(entry["point"])
    return found


def twice(keys):
    return sum(count - 1 for count in Counter(keys).values())


def plumb_lines(said):
    return [line.strip() for line in said.splitlines() if line.startswith("plumb: ")]


def differing(a, b):
    with contextlib.redirect_stdout(io.StringIO()) as said:
        same = same_results.compare_documents(a / "results.json", b / "results.json")
    return None if same == 0 else said.getvalue()


class Row:
    def __init__(self, what):
        self.what, self.ended, self.said, self.twice, self.kept = what, "", [], "", ""


def finish_and_compare(study, row, undisturbed, folder, *wrapped):
    """Starts the same study again, and holds its end against the undisturbed one."""
    journal = f"{folder}.unfinished.jsonl"
    before = study.text(journal)
    row.kept = len(points(before))
    watched = open(study.folder / journal, "rb") if before else None
    status, said = study.end(study.start([*wrapped, *study.command("-o", folder)]))
    expect(status == 0, f"started again it ends with {status}: {said}")
    if watched:  # the file is removed when all is done, not what is open of it
        expect("going on with what" in said, f"it does not say that it goes on: {said}")
        with watched:
            keys = points(watched.read())
        row.twice = twice(keys)
        expect(keys[:row.kept] == points(before) and row.twice == 0, f"{row.twice} points are in the journal twice")
    expect(not study.text(journal), f"{journal} is left behind")
    wrong = differing(undisturbed, study.folder / folder)
    expect(wrong is None, f"the result differs: {wrong}")


MPIRUN = ["mpirun", "--oversubscribe", "-n", "3"]


def killed_under_mpi(study, row, undisturbed, draw, victim, sent, statuses):
    journal = "a.unfinished.jsonl"
    command = [*MPIRUN, *study.command("-o", "a")]
    if victim.startswith("the shell"):
        command = ["sh", "-c", '"$@"; exit $?', "sh", *command]
    process = study.start(command)
    study.await_points(journal, draw.randint(3, 20), process)
    expect(process.poll() is None, "it ended before it could be killed")
    if victim.startswith("rank"):
        os.kill(study.rank(int(victim[-1])), sent)
    elif victim == "the shell and all of its group":
        os.killpg(process.pid, sent)
    else:
        os.kill(process.pid, sent)
    if victim == "the shell" and sent == signal.SIGKILL:
        # What it started goes on, and a second one is refused.
        status, said = study.end(study.start([*MPIRUN, *study.command("-o", "a")]))
        process.communicate(timeout=PATIENCE)
        row.ended, row.said = f"goes on; a second one {status}", plumb_lines(said)
        expect(status == OUTPUT and "another plumb is at work" in said, f"a second one ends with {status}: {said}")
        study.await_no_process()
        wrong = differing(undisturbed, study.folder / "a")
        expect(wrong is None, f"the result differs: {wrong}")
        return
    status, said = study.end(process)
    rest = study.await_no_process()
    row.ended, row.said = f"{status}, all gone after {rest:.1f} s", plumb_lines(said)
    expect(status in statuses, f"ends with {status}, not one of {statuses}: {said}")
    expect(study.text(journal), "its journal is gone")
    errors = [line for line in row.said if not line.startswith("plumb: note: ")]
    expect(len(errors) <= 1, f"more than one process says why it ends: {said}")
    finish_and_compare(study, row, undisturbed, "a", *MPIRUN)


def share(k, count):
    return ["--share", f"{k}/{count}", "-o", f"s{k}"]


def compute_share(study, k, count):
    status, said = study.run(*share(k, count))
    expect(status == 0, f"share {k} ends with {status}: {said}")
    return said


def merge(study, folders, wanted=0, into="merged"):
    shutil.rmtree(study.folder / into, ignore_errors=True)
    status, said = study.run("--merge", *folders, "-o", into)
    expect(status == wanted, f"--merge ends with {status}, not {wanted}: {said}")
    return said


def expect_merged_same(study, undisturbed, folders):
    merge(study, folders)
    wrong = differing(undisturbed, study.folder / "merged")
    expect(wrong is None, f"put together it differs: {wrong}")


def shares_killed(study, row, undisturbed, draw):
    kills = 0
    for k in (1, 2, 3):
        for _ in range(3):
            process = study.start(study.command(*share(k, 3)))
            study.await_points(f"s{k}.unfinished.jsonl", draw.randint(1, 6), process)
            time.sleep(draw.uniform(0, 0.02))
            if process.poll() is None:
                process.kill()
                kills += 1
            process.communicate(timeout=PATIENCE)
            study.await_no_process()
        compute_share(study, k, 3)
    row.ended = f"killed {kills} times"
    row.twice = twice([key for k in (1, 2, 3) for key in points(study.text(f"s{k}/points.jsonl"))])
    expect(row.twice == 0, f"{row.twice} points are there twice")
    expect(kills > 0, "all ended before they could be killed")
    folders = ["s1", "s2", "s3"]
    draw.shuffle(folders)
    expect_merged_same(study, undisturbed, folders)


def shares_in_any_order(study, row, undisturbed, draw):
    for k in (1, 2):
        compute_share(study, k, 2)
    for folders in (["s1", "s2"], ["s2", "s1"], ["s1", "s2", "s1"]):
        expect_merged_same(study, undisturbed, folders)


def more_shares_than_points(study, row, undisturbed, draw):
    for k in range(1, 13):
        compute_share(study, k, 12)
    own = [len(points(study.text(f"s{k}/points.jsonl"))) for k in range(1, 13)]
    row.ended = f"points of each: {own}"
    expect(0 in own, f"none is without points: {own}")
    expect_merged_same(study, undisturbed, [f"s{k}" for k in range(1, 13)])


def torn_unfinished(study, row, undisturbed, draw):
    process = study.start(study.command("-o", "a"))
    study.await_points("a.unfinished.jsonl", 8, process)
    process.kill()
    process.communicate(timeout=PATIENCE)
    study.await_no_process()
    journal = study.folder / "a.unfinished.jsonl"
    text = journal.read_bytes()
    expect(len(points(text)) >= 8, "it ended before it could be killed")
    last = text.rstrip(b"\n").rfind(b"\n") + 1
    journal.write_bytes(text[:draw.randint(last + 1, len(text) - 1)])
    finish_and_compare(study, row, undisturbed, "a")


def torn_share(study, row, undisturbed, draw):
    for k in (1, 2):
        compute_share(study, k, 2)
    journal = study.folder / "s2" / "points.jsonl"
    text = journal.read_bytes()
    lines = text.split(b"\n")
    lines[len(lines) // 2] = lines[len(lines) // 2][:-5] + b"00000"
    journal.write_bytes(b"\n".join(lines)[:-7])
    said = merge(study, ["s1", "s2"], INVALID)
    row.said = plumb_lines(said)
    expect("2 of " in said and "damaged line" in said, f"it does not tell of one torn and one damaged line: {said}")
    told = re.search("they are listed in .*: (plumb .*) computes them", said)
    expect(told, f"it does not say how they are computed: {said}")
    command = told[1].replace("plumb", '"$0"', 1) + " -o rest"
    status, said = study.end(study.start(["sh", "-c", command, study.plumb]))
    expect(status == 0, f"{told[1]} ends with {status}: {said}")
    expect(len(points(study.text("rest/points.jsonl"))) == 2, f"--only has not computed two points: {said}")
    expect_merged_same(study, undisturbed, ["s1", "s2", "rest"])


def same_share_again(study, row, undisturbed, draw):
    compute_share(study, 1, 2)
    before = study.text("s1/points.jsonl")
    begin = os.times()
    said = compute_share(study, 1, 2)
    row.ended = f"computes nothing, {os.times().children_user - begin.children_user:.2f} s"
    expect(study.text("s1/points.jsonl") == before, f"its journal has changed: {said}")
    compute_share(study, 2, 2)
    expect_merged_same(study, undisturbed, ["s1", "s2"])


def same_share_at_once(study, row, undisturbed, draw):
    first = study.start(study.command(*share(1, 2)))
    study.await_points("s1.unfinished.jsonl", 1, first)
    expect(first.poll() is None, "the first ended before the second began")
    status, said = study.run(*share(1, 2))
    row.ended, row.said = f"the second {status}", plumb_lines(said)
    expect(status == OUTPUT and "another plumb is at work" in said, f"the second ends with {status}: {said}")
    status, said = study.end(first)
    expect(status == 0, f"the first ends with {status}: {said}")
    compute_share(study, 2, 2)
    expect_merged_same(study, undisturbed, ["s1", "s2"])


def merged_while_at_work(study, row, undisturbed, draw):
    compute_share(study, 1, 2)
    second = study.start(study.command(*share(2, 2)))
    study.await_points("s2.unfinished.jsonl", 2, second)
    expect(second.poll() is None, "it ended before the merge began")
    said = merge(study, ["s1", "s2"], INVALID)
    row.said = plumb_lines(said)
    expect("points are missing" in said, f"it does not say what is missing: {said}")
    status, said = study.end(second)
    expect(status == 0, f"the share ends with {status}: {said}")
    expect_merged_same(study, undisturbed, ["s1", "s2"])


def refused(study, row, text, *more, sets=None):
    status, said = study.run(*more, "-o", "refused", sets=sets)
    row.ended, row.said = str(status), plumb_lines(said)
    expect(status == INVALID and text in said, f"ends with {status}, and does not say {text!r}: {said}")
    expect(not (study.folder / "refused").exists(), "an output folder is made all the same")


def refused_case(study, row, undisturbed, draw):
    compute_share(study, 1, 2)
    other = study.folder / "other.toml"
    other.write_text(Path(study.case).read_text().replace("length = 1.0", "length = 1.5"))
    study.case = str(other)
    refused(study, row, "s1/points.jsonl: is of another case", "--merge", "s1")


def refused_set(study, row, undisturbed, draw):
    compute_share(study, 1, 2)
    refused(study, row, "s1/points.jsonl: is of another case", "--merge", "s1", sets=[*study.sets, "cable.length=1.5"])


def refused_revision(study, row, undisturbed, draw):
    compute_share(study, 1, 2)
    journal = study.folder / "s1" / "points.jsonl"
    first, _, rest = journal.read_text().partition("\n")
    heading = json.loads(first)
    heading["program"] = "revision 0123456789ab, another compiler"
    journal.write_text(json.dumps(heading, separators=(",", ":")) + "\n" + rest)
    refused(study, row, "s1/points.jsonl: is of another program: revision 0123456789ab", "--merge", "s1")


def refused_without_journal(study, row, undisturbed, draw):
    (study.folder / "empty").mkdir()
    refused(study, row, "empty: there is no journal of a share", "--merge", "empty")


def refused_list(study, row, undisturbed, draw):
    compute_share(study, 1, 2)
    merge(study, ["s1"], INVALID)
    refused(study, row, "merged.missing.jsonl: is of another case", "--only", "merged.missing.jsonl",
            sets=[*study.sets, "cable.length=1.5"])


SHARES = {
    "three shares, SIGKILL at random moments": shares_killed,
    "two shares in any order, one of them twice": shares_in_any_order,
    "more shares than there is to share": more_shares_than_points,
    "last line of a journal torn": torn_unfinished,
    "a share with a torn and a damaged line": torn_share,
    "the same share twice": same_share_again,
    "the same share twice at once": same_share_at_once,
    "merged while a share is at work": merged_while_at_work,
}
REFUSED = {
    "a share of another case": refused_case,
    "a share with another --set": refused_set,
    "a share of another revision": refused_revision,
    "a folder without a journal": refused_without_journal,
    "--only with the list of another case": refused_list,
}


def under_mpi():
    """Each who is ended by what, and with which status that may end."""
    kill, term, interrupt, hang_up = signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP
    failed = range(1, 256)
    trials = [(f"rank {k}", kill, failed) for k in (1, 2, 0)]
    trials += [(f"rank {k}", sent, failed) for k in (0, 1) for sent in (term, interrupt)]
    trials += [("mpirun", kill, [-kill]), ("mpirun", term, failed), ("mpirun", interrupt, failed)]
    trials += [("the shell", kill, [])]
    group = "the shell and all of its group"
    trials += [(group, sent, [*failed, -sent]) for sent in (term, interrupt, hang_up, kill)]
    return {f"{victim}, {sent.name}": lambda study, row, undisturbed, draw, t=(victim, sent, statuses):
            killed_under_mpi(study, row, undisturbed, draw, *t) for victim, sent, statuses in trials}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plumb")
    parser.add_argument("--only", choices=["mpi", "shares", "refused"])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--long", action="store_true")
    options = parser.parse_args()
    plumb = str(Path(options.plumb).resolve())
    if options.only == "mpi" and not shutil.which("mpirun"):
        print("killed: there is no mpirun")
        return 77
    trials = {}
    if options.only in (None, "shares"):
        trials |= SHARES
    if options.only in (None, "refused"):
        trials |= REFUSED
    if options.only == "mpi" or (options.only is None and shutil.which("mpirun")):
        trials |= under_mpi()

    draw = random.Random(options.seed)
    sets = LONG if options.long else SHORT
    failed = 0
    with tempfile.TemporaryDirectory() as root:
        base = Study(plumb, root, sets)
        status, said = base.run("-o", "undisturbed")
        if status != 0:
            print(f"killed: the undisturbed study ends with {status}: {said}")
            return 1
        for number, (name, trial) in enumerate(trials.items()):
            folder = Path(root) / str(number)
            folder.mkdir()
            study, row = Study(plumb, folder, sets), Row(name)
            try:
                trial(study, row, Path(root) / "undisturbed", draw)
                verdict = "refused" if name in REFUSED else "the same"
            except (Wrong, subprocess.TimeoutExpired) as fault:
                failed += 1
                verdict = f"FAILED: {fault}"
            for process in study.processes():
                os.kill(process, signal.SIGKILL)
            kept = f"; {row.kept} points kept, {row.twice} twice" if row.kept != "" else ""
            print(f"{name}: {row.ended or 'done'}{kept}; {verdict}", flush=True)
            for line in row.said:
                print(f"    {line.replace(root, '')}", flush=True)
    print(f"{len(trials) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
