#!/usr/bin/env python3
"""Gives the built program inputs, command lines and surroundings that nobody means well with, and tells how it ended.

    tests/hostile.py PROGRAM [--count N] [--seconds S] [--seed K] [--only KIND] [--keep FOLDER]

Each trial has a folder of its own with good inputs, one of which is changed, and files that are none of the program's.
A trial has failed where the program ends by a signal, has to be killed, ends in a status that is not documented,
says more than one line on standard error under --quiet (or nothing where it refuses), speaks of an internal error,
leaves a temporary file behind, or changes or loses a file that is not its own. Failed trials are kept with their command.
Prints a table of kinds of input by how the program ended; exit status 1 where a trial has failed.
"""

import argparse
import hashlib
import os
import random
import resource
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

DOCUMENTED = {0, 1, 2, 3, 4, 5, 130}

CASE = """title = "Given"
[[run]]
name = "g"
file = "g.csv"
program = "P 1"
[cable]
length = 2
area = 1e-6
density = 1000
youngs_modulus = 1e6
[time]
end = 2.0
[[probe]]
name = "tip"
at = 1.0
[[reference]]
name = "known"
file = "ref.toml"
compare = { x = "tip.x" }
tolerance = 0.125
[scene]
size = [64, 36]
frame_rate = 2
"""
SOLVED = """title = "Solved"
[parameters]
f = 5
[cable]
length = 1.0
area = "1e-6 * f^2"
density = 320
youngs_modulus = 1.6e6
elements = 2
[start]
angular_velocity = [0, 4, 0]
[supports]
first = "pinned"
[loads]
gravity = [0, -9.81, 0]
[method]
name = "rk4"
step = 1e-3
[time]
end = 0.05
output_interval = 0.01
[[probe]]
name = "tip"
at = 1.0
[scene]
size = [64, 36]
frame_rate = 20
"""
REFERENCE = """title = "known"
kind = "published"
source = "a book"
obtained = "by hand"
time_unit = "s"
columns = ["t", "x"]
rows = [[0.0, 1.0], [0.5, 1.5], [1.0, 2.0], [1.5, 2.5], [2.0, 3.0]]
[[series]]
name = "x"
description = "along x"
figure = "Fig. 1"
unit = "m"
uncertainty = 0.01
uncertainty_basis = "guess"
"""
TABLE = "t [s],tip.x [m],tip.y [m],tip.z [m]\n" + "".join(f"{k / 10},{1 + k / 10},0,0\n" for k in range(21))

NUMBERS = ["0.5", "1", "2", "3", "1.25", "1e-3", "0.0", "0", "-1", "1e308", "-1e308", "1e-320", "nan", "inf", "-inf", "9223372036854775808", "1e999", "0x10", "1_0", "00", "\"f\"",
           "\"1/0\"", "[]", "{}", "true", "1979-05-27", "\"\"", "'''x'''", "4294967297", "2147483648", "1000000"]
TEXT_PARTS = ["[", "]", "{", "}", "[[", "]]", "=", ",", ".", "\"", "'", "\"\"\"", "#", "\\", "\\u0000", "\n", "\r", "\t", "\0", "\x7f",
              "\u2028", "\ufffe", "é", "a.b.c", "x = 1\n", "[[run]]\n", "[study.sweep]\n", "file = \"/etc/passwd\"\n", "file = \"../x\"\n",
              "null", ":", ";", "e9", "1e9999", "-", "+", "^", "(", ")", "sin(", "\"schema_version\": 2,", "\U0001f600"]
HUGE = ["b." * 30000, "[" * 30000, "{" * 30000, "(" * 20000, "9" * 100000, "x" * 200000, "\n" * 100000, "a=1\n" * 20000, "{\"a\":" * 30000,
        "," * 100000, "0," * 50000]


def sha(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def changed_text(rng, text):
    for _ in range(rng.choice([1, 1, 1, 2, 3, 5])):
        at = rng.randrange(len(text) + 1)
        kind = rng.choice([0, 1, 2, 3, 4, 4, 4, 4, 5, 6, 7])
        if kind == 0:
            text = text[:at] + rng.choice(TEXT_PARTS) + text[at:]
        elif kind == 1:
            text = text[:at] + text[at + rng.randrange(1, 40):]
        elif kind == 2:
            part = text[at:at + rng.randrange(1, 80)]
            text = text[:at] + part * rng.choice([1, 2, 50]) + text[at:]
        elif kind == 3:
            text = text[:at]
        elif kind == 4:
            words = [k for k, c in enumerate(text) if c.isdigit() and (k == 0 or not text[k - 1].isalnum())]
            if words:
                begin = end = rng.choice(words)
                while end < len(text) and (text[end].isalnum() or text[end] in ".-"):
                    end += 1
                text = text[:begin] + rng.choice(NUMBERS) + text[end:]
        elif kind == 5:
            lines = text.split("\n")
            a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
            lines[a], lines[b] = lines[b], lines[a]
            text = "\n".join(lines)
        elif kind == 6 and rng.randrange(4) == 0:
            text = text[:at] + rng.choice(HUGE) + text[at:]
        else:
            text = text[:at] + chr(rng.choice([0, 1, 9, 10, 13, 27, 34, 39, 46, 61, 91, 92, 93, 123, 125, 127, 200, 0xfffe])) + text[at + 1:]
    data = text.encode("utf-8", "surrogatepass")
    return changed_bytes(rng, data, 1) if rng.randrange(6) == 0 else data


def changed_bytes(rng, data, most=6):
    data = bytearray(data)
    for _ in range(rng.randrange(1, most + 1)):
        if not data:
            break
        at = rng.randrange(len(data))
        kind = rng.randrange(6)
        if kind == 0:
            data[at] ^= 1 << rng.randrange(8)
        elif kind == 1:
            data[at] = rng.choice([0, 1, 0x7f, 0x80, 0xff, rng.randrange(256)])
        elif kind == 2:
            form = rng.choice(["<H", ">H", "<I", ">I", "<Q", ">Q"])
            value = rng.choice([0, 1, 2, -1, -2, 1 << 15, 1 << 31, 1 << 32, 1 << 40, 1 << 63]) % (1 << (8 * struct.calcsize(form)))
            data[at:at + struct.calcsize(form)] = struct.pack(form, value)
        elif kind == 3:
            del data[at:at + rng.choice([1, 4, 16, 1000])]
        elif kind == 4:
            data[at:at] = data[at:at + rng.choice([1, 8, 64, 512])]
        else:
            data[at:at + rng.choice([1, 8, 64])] = bytes(rng.choice([1, 8, 64]))
    if rng.randrange(12) == 0:
        del data[rng.randrange(len(data) + 1):]
    return bytes(data)


def png_chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(rng, wild):
    """A small picture, animated or not; a wild one is of any kind and wrong somewhere, with right check sums."""
    width, height = rng.randrange(1, 9), rng.randrange(1, 9)
    depth, color = rng.choice([(8, 0), (8, 2), (8, 6), (16, 6), (8, 4), (1, 0), (16, 2)]) if wild else (8, 6)
    claimed = rng.choice([(width, height)] * 5 + [(32768, 32768), (1 << 31, 1), (0, 0), (40000, 40000)]) if wild else (width, height)
    row = (width * depth * {0: 1, 2: 3, 4: 2, 6: 4}[color] + 7) // 8
    pixels = lambda: zlib.compress(b"".join(b"\0" + rng.randbytes(row) for _ in range(height)))
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", *claimed, depth, color, 0, 0, rng.randrange(2) if wild else 0))]
    animated = rng.randrange(2)
    sequence = 0

    def control():
        nonlocal sequence
        sequence += 1
        return b"fcTL", struct.pack(">IIIIIHHBB", sequence - 1, width, height, 0, 0, 1, rng.choice([0, 10, 25]), rng.randrange(3), rng.randrange(2))
    if animated:
        chunks.append((b"acTL", struct.pack(">II", 2, 0)))
        if rng.randrange(3):
            chunks.append(control())
    chunks.append((b"tEXt", b"Renderer\0test"))
    chunks.append((b"IDAT", pixels()))
    if animated:
        chunks.append(control())
        chunks.append((b"fdAT", struct.pack(">I", sequence) + pixels()))
    chunks.append((b"IEND", b""))
    if wild:
        for _ in range(rng.randrange(3)):
            at = rng.randrange(len(chunks))
            what = rng.randrange(4)
            if what == 0:
                del chunks[at]
            elif what == 1:
                chunks.insert(at, rng.choice(chunks))
            elif what == 2:
                chunks[at] = (chunks[at][0], changed_bytes(rng, chunks[at][1]))
            else:
                chunks[at] = (rng.choice([b"acTL", b"fcTL", b"fdAT", b"IDAT", b"PLTE", b"tRNS", b"abcd"]), chunks[at][1])
            if not chunks:
                break
    data = b"\x89PNG\r\n\x1a\n" + b"".join(png_chunk(*chunk) for chunk in chunks)
    return changed_bytes(rng, data, 2) if wild and rng.randrange(5) == 0 else data


def with_check_sum(data):
    return data + b"plumb-crc32 " + b"%08x" % zlib.crc32(data)


class Good:
    """What the program makes of good inputs, made once."""

    def __init__(self, program, folder):
        self.folder = folder
        folder.mkdir()
        for name, text in (("case.toml", CASE), ("solved.toml", SOLVED), ("ref.toml", REFERENCE), ("g.csv", TABLE)):
            (folder / name).write_text(text)
        for command in (["solve", "solved.toml", "-o", "solved", "--quiet"], ["run", "case.toml", "-o", "report", "--quiet"]):
            ended = subprocess.run([program, *command], cwd=folder, capture_output=True, stdin=subprocess.DEVNULL)
            if ended.returncode not in (0, 1):
                sys.exit(f"hostile.py: {' '.join(command)} of good inputs ends in {ended.returncode}: {ended.stderr.decode()}")
        study = subprocess.Popen([program, "study", "solved.toml", "-o", "out", "--quiet"], cwd=folder, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        journal = folder / "out.unfinished.jsonl"
        for _ in range(100):  # one of some lines
            time.sleep(0.1)
            if study.poll() is not None or (journal.exists() and journal.read_bytes().count(b"\n") > 3):
                break
        study.send_signal(signal.SIGINT)
        study.wait()
        self.journal = journal.read_text() if journal.exists() else "{}\n"
        self.run_file = (folder / "solved" / "run.h5").read_bytes()
        self.results = (folder / "report" / "results.json").read_text()


class Trial:
    """A folder with good inputs and files of others, the command to be run in it and its surroundings."""

    def __init__(self, good, folder, rng):
        self.good, self.folder, self.rng = good, folder, rng
        folder.mkdir()
        for name in ("case.toml", "solved.toml", "ref.toml", "g.csv"):
            shutil.copy(good.folder / name, folder / name)
        (folder / "docs").mkdir()
        (folder / "thesis.txt").write_text("years of work\n")
        (folder / "docs" / "a.txt").write_text("not to be lost\n")
        self.command, self.environment, self.limits, self.interrupt_after = [], {}, {}, None
        self.stdout = subprocess.DEVNULL

    def path(self, name):
        return self.folder / name

    def add_report(self, name="report"):
        shutil.copytree(self.good.folder / "report", self.folder / name)

    def add_run(self, name="solved"):
        shutil.copytree(self.good.folder / "solved", self.folder / name)


def over_case(t):
    """A command that reads the case of an external run."""
    t.command = t.rng.choice([["check", "case.toml"]] * 6 + [["run", "case.toml", "-o", "out"]])


def case(t):
    if t.rng.randrange(2):
        t.path("case.toml").write_bytes(changed_text(t.rng, CASE))
        over_case(t)
    else:
        t.path("solved.toml").write_bytes(changed_text(t.rng, SOLVED))
        t.command = t.rng.choice([["check", "solved.toml"]] * 3 + [["solve", "solved.toml", "-o", "out"]])
        t.interrupt_after = 4  # a case that was changed may be a long one


def reference(t):
    t.path("ref.toml").write_bytes(changed_text(t.rng, REFERENCE))
    over_case(t)


def csv(t):
    t.path("g.csv").write_bytes(changed_text(t.rng, TABLE))
    over_case(t)


def hdf5(t):
    t.path("g.h5").write_bytes(changed_bytes(t.rng, t.good.run_file))
    t.path("case.toml").write_text(CASE.replace("g.csv", "g.h5").replace("[time]\nend = 2.0\n", ""))
    over_case(t)


def run_file(t):
    t.add_run()
    body = t.good.run_file[:-20]
    data = changed_bytes(t.rng, t.good.run_file) if t.rng.randrange(2) else with_check_sum(changed_bytes(t.rng, body))
    t.path("solved/run.h5").write_bytes(data)
    t.command = ["report", t.rng.choice(["solved", "solved/run.h5"]), "-o", "out"]


def results_json(t):
    t.add_report()
    t.path("report/results.json").write_bytes(changed_text(t.rng, t.good.results))
    t.command = t.rng.choice([["report", "--from", "report/results.json", "-o", "out"], ["report", "--from", "report/results.json"],
                              ["run", "case.toml", "-o", "out", "--baseline", "report"], ["run", "case.toml", "-o", "report"]])


def other_json(t):
    """Files beside a run, and the manifest of a folder that is to be replaced."""
    t.add_report("out")
    names = [path.name for path in t.path("out").glob("*.json") if path.name != "results.json"] or ["manifest.json"]
    name = t.rng.choice(names + ["study.json", "assessment.json", "choice.json"])
    text = t.path(f"out/{name}").read_text() if t.path(f"out/{name}").exists() else \
        '{"kind": "sweep", "version": 1, "case": {"file": {"name": "a.toml", "text": ""}, "overrides": [], "references": []}}'
    t.path(f"out/{name}").write_bytes(changed_text(t.rng, text))
    t.command = ["report", "out/study.json", "-o", "again"] if name == "study.json" else ["run", "case.toml", "-o", "out"]


def picture(t):
    t.path("a.png").write_bytes(png(t.rng, True))
    t.path("b.png").write_bytes(t.path("a.png").read_bytes() if t.rng.randrange(5) == 0 else png(t.rng, t.rng.randrange(2)))
    t.command = t.rng.choice([["diff", "a.png", "b.png"]] * 4 + [["diff", "a.png", "b.png", "--html", "page.html"]])


def folder_difference(t):
    t.add_report("a")
    t.add_report("b")
    names = sorted(path for path in t.path("b").rglob("*") if path.is_file())
    changed = t.rng.choice(names)
    changed.write_bytes(changed_bytes(t.rng, changed.read_bytes()))
    t.command = ["diff", "a", "b"] + t.rng.choice([[], ["--html", "page.html"], ["--accept"]])


def journal(t):
    t.path("out.unfinished.jsonl").write_bytes(changed_text(t.rng, t.good.journal))
    t.command = ["study", "solved.toml", "-o", "out"]
    t.interrupt_after = 0.25


def odd_word(rng):
    return rng.choice(NUMBERS + TEXT_PARTS + ["", " ", "-", "--", "a" * 5000, "x\ny", "\x1b[31m", "../" * 50, "/dev/full", "/proc/self/mem",
                                              "%s%n", "1:0", "0x0", "99999x99999", "99999999999:", "--set", "-o", "scene.size=[16,16]"])


def command_line(t):
    t.add_report()
    t.add_run()
    verbs = ["run", "solve", "render", "report", "study", "check", "diff", "doctor"]
    options = ["--set", "-o", "--json", "--csv", "--frames", "--size", "--camera", "--video", "--over", "--beside", "--points", "--html",
               "--channel", "--density", "--numbers", "--baseline", "--economy", "--explain", "--from", "--accept", "--help", "--version",
               "--limit"]
    places = ["case.toml", "solved.toml", "solved", "report", "report/results.json", "g.csv", "."]
    words = [t.rng.choice(verbs)] if t.rng.randrange(10) else []
    for _ in range(t.rng.randrange(0, 6)):
        words.append(t.rng.choice([t.rng.choice(options), t.rng.choice(places), odd_word(t.rng),
                                   t.rng.choice(["cable.elements", "time.end", "title", "scene.size", "probe.0.at", "a.b.c.d"]) + "=" + odd_word(t.rng)]))
    t.command = [word.replace("\0", "") for word in words]
    # None of these may be written over.
    t.interrupt_after = 3


def file_kind(t):
    """Something that is no regular file where an input should be."""
    t.add_report()
    t.add_run()
    name, command = t.rng.choice([
        ("case.toml", ["check", "case.toml"]), ("ref.toml", ["check", "case.toml"]), ("g.csv", ["check", "case.toml"]),
        ("solved/run.h5", ["report", "solved", "-o", "out"]), ("report/results.json", ["report", "--from", "report/results.json", "-o", "out"]),
        ("report/results.json", ["run", "case.toml", "-o", "out", "--baseline", "report"]), ("report", ["run", "case.toml", "-o", "out", "--baseline", "report"]),
        ("a.png", ["diff", "a.png", "report/figures/energy.png"])])
    path = t.path(name)
    if path.is_dir():
        shutil.rmtree(path)
    elif path.exists():
        path.unlink()
    kind = t.rng.randrange(9)
    if kind == 0:
        os.mkfifo(path)
    elif kind == 1:
        path.mkdir()
    elif kind == 2:
        path.symlink_to(path.name)
    elif kind == 3:
        path.symlink_to("nowhere")
    elif kind == 4:
        path.symlink_to(t.rng.choice(["/dev/zero", "/dev/full", "/dev/random", "/dev/tty", "/proc/self/mem", "/proc/kmsg", "/dev/stdin"]))
    elif kind == 5:
        server = socket.socket(socket.AF_UNIX)
        here = os.open(".", os.O_RDONLY)
        os.chdir(path.parent)  # a socket's path must be short
        server.bind(path.name)
        os.fchdir(here)
        os.close(here)
        server.close()
    elif kind == 6:
        with open(path, "wb") as file:
            file.truncate(1 << 40)
    elif kind == 7:
        path.write_bytes(b"")
    t.command = command


def output_place(t):
    """Output to where something else is, or nothing can be."""
    t.add_report()
    t.path("file").write_text("mine\n")
    t.path("link").symlink_to("docs")
    t.path("readonly").mkdir(mode=0o500)
    place = t.rng.choice([".", "..", "docs", "file", "link", "file/x", "/dev/full", "/dev/null", "/proc", "/proc/self", "report", "a" * 300, "x\ny",
                          "", "case.toml", "docs/a.txt", "docs/deep/er", "/", "./report/../docs", "\x1b]0;x"])
    if place in ("..", "/"):
        place = "docs"  # what is outside of the trial's folder is not to be played with
    t.command = t.rng.choice([["solve", "solved.toml", "-o", place], ["solve", "solved.toml", "--csv", place], ["run", "case.toml", "-o", place],
                              ["report", "--from", "report/results.json", "-o", place], ["diff", "report", "docs", "--html", place]])


def surroundings(t):
    """Good inputs in a poor place."""
    t.command = t.rng.choice([["solve", "solved.toml", "-o", "out"], ["check", "case.toml"], ["run", "case.toml", "-o", "out"], ["doctor"]])
    kind = t.rng.randrange(8)
    if kind == 0:
        # Not OMP_NUM_THREADS, of which a library speaks before the program begins.
        t.environment = {t.rng.choice(["PLUMB_GL", "TMPDIR", "HOME", "LANG", "LC_ALL", "NO_COLOR", "COLUMNS"]):
                         t.rng.choice(["", "bad", "/nonexistent", "0", "-1", "999999999", "x" * 5000])}
    elif kind == 1:
        t.limits[resource.RLIMIT_NOFILE] = t.rng.choice([3, 4, 5, 6, 8, 12, 16])
    elif kind == 2:
        t.limits[resource.RLIMIT_AS] = t.rng.choice([40, 60, 80, 100, 150, 250, 400]) << 20
    elif kind == 3:
        t.limits[resource.RLIMIT_FSIZE] = t.rng.choice([0, 1, 100, 4096, 50000])
    elif kind == 4:
        t.limits[resource.RLIMIT_NPROC] = 0
    elif kind == 5:
        t.stdout = "full"
        t.command = t.rng.choice([["doctor"], ["check", "case.toml"], ["solve", "solved.toml", "--csv", "-"], ["--help"], ["check", "case.toml", "--json"]])
    elif kind == 6:
        t.stdout = "closed"
    else:
        t.limits[resource.RLIMIT_STACK] = 128 << 10


KINDS = [case, reference, csv, hdf5, run_file, results_json, other_json, picture, folder_difference, journal, command_line, file_kind,
         output_place, surroundings]


class Ended:
    def __init__(self):
        self.status, self.signal, self.killed, self.lines, self.text, self.seconds, self.faults = None, None, False, 0, "", 0, []


def files_of_others(folder):
    """What is there before the program runs, and is not in an output folder of its own: path to content."""
    found = {}
    for path in folder.rglob("*"):
        if path.is_file() and not path.is_symlink() and path.stat().st_size < 1 << 24:
            found[path] = sha(path)
    return found


def ours(folder, path, t):
    """Whether the program may change it: a file it made, in a folder that the command names."""
    top = path.relative_to(folder).parts[0]
    if top in ("report", "out", "a", "solved") and (top in t.command or f"{top}/results.json" in t.command):
        return True
    # A file that was named for output, or the journal of a study under way.
    return path.name in t.command or path.name.endswith(".unfinished.jsonl")


def run_trial(t, program, memory, patience):
    def prepare():
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if memory and resource.RLIMIT_AS not in t.limits:
            resource.setrlimit(resource.RLIMIT_AS, (memory << 20, memory << 20))
        for limit, value in t.limits.items():
            resource.setrlimit(limit, (value, value))
        if t.stdout == "closed":
            os.close(1)

    ended = Ended()
    before = files_of_others(t.folder)
    stdout = open("/dev/full", "wb") if t.stdout == "full" else subprocess.DEVNULL
    command = [program, *t.command] + (["--quiet"] if t.command and not t.command[0].startswith("-") else [])
    begin = time.monotonic()
    child = subprocess.Popen([os.fsencode(word) if isinstance(word, str) else word for word in command], cwd=t.folder, stdin=subprocess.DEVNULL,
                             stdout=stdout, stderr=subprocess.PIPE, preexec_fn=prepare, env={**os.environ, **t.environment})
    try:
        raw = child.communicate(timeout=t.interrupt_after or patience)[1]
    except subprocess.TimeoutExpired:
        os.kill(child.pid, signal.SIGINT if t.interrupt_after else signal.SIGKILL)
        try:
            raw = child.communicate(timeout=patience)[1]
            ended.killed = not t.interrupt_after
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            raw = child.communicate()[1]
            ended.killed = True
    ended.seconds = time.monotonic() - begin
    ended.text = raw.decode("utf-8", "replace")
    # A library of the system says so itself where it runs out of files.
    ended.lines = sum(1 for line in raw.splitlines() if not line.startswith((b"libEGL warning", b"MESA")))
    if child.returncode < 0:
        ended.signal = -child.returncode
    else:
        ended.status = child.returncode

    if ended.killed:
        ended.faults.append("does not end")
    elif ended.signal == signal.SIGINT and t.interrupt_after and not raw:
        pass  # before the program itself begins, or forced by a second one
    elif ended.signal:
        ended.faults.append(f"ends by signal {ended.signal}")
    elif ended.status == 127 and "error while loading shared libraries" in ended.text:
        pass  # before the program itself begins
    elif ended.status not in DOCUMENTED:
        ended.faults.append(f"ends in status {ended.status}")
    elif ended.status >= 2 and ended.lines != 1 and t.stdout != "closed":
        ended.faults.append(f"{ended.lines} lines of error in status {ended.status}")
    if ended.status in (0, 1) and ended.lines > 1:
        ended.faults.append(f"{ended.lines} lines of error under --quiet")
    if "internal error" in ended.text or "terminate called" in ended.text or "Sanitizer" in ended.text:
        ended.faults.append("an internal error")
    try:
        raw.decode("utf-8")
    except UnicodeDecodeError:
        ended.faults.append("an error that is no UTF-8")
    if len(raw) > 4000:
        ended.faults.append(f"an error of {len(raw)} bytes")
    for path in t.folder.rglob(".*part*"):
        if not ended.killed:
            ended.faults.append(f"leaves {path.name} behind")
    for path, content in before.items():
        if not ours(t.folder, path, t) and (not path.exists() or sha(path) != content):
            ended.faults.append(f"{path.relative_to(t.folder)} is {'changed' if path.exists() else 'lost'}")
    return ended


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=1000, help="trials")
    parser.add_argument("--seconds", type=float, default=0, help="begin no trial after so many; default: no limit")
    parser.add_argument("--seed", type=int, default=1, help="trial k depends on the seed and k alone")
    parser.add_argument("--only", default="", help="a kind of trial: " + ", ".join(kind.__name__ for kind in KINDS))
    parser.add_argument("--trial", type=int, help="this one alone")
    parser.add_argument("--keep", default="", help="where failed trials are kept; default: nowhere")
    parser.add_argument("--memory", type=int, default=6000, help="of the program, MB; 0: no limit")
    parser.add_argument("--patience", type=float, default=20, help="s, after which a program is killed")
    arguments = parser.parse_args()
    program = str(Path(arguments.program).resolve())
    kinds = [kind for kind in KINDS if arguments.only in ("", kind.__name__)]
    if not kinds:
        parser.error(f"--only {arguments.only}: no such kind")

    rows = {kind.__name__: {"trials": 0, "statuses": {}, "signals": {}, "killed": 0, "lines": 0, "slowest": 0.0, "failed": 0} for kind in kinds}
    failures = []
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="plumb-hostile-") as scratch:
        good = Good(program, Path(scratch) / "good")
        numbers = range(arguments.count) if arguments.trial is None else [arguments.trial]
        for number in numbers:
            if arguments.seconds and time.monotonic() - begin > arguments.seconds:
                break
            kind = kinds[number % len(kinds)]
            folder = Path(scratch) / f"{number}"
            trial = Trial(good, folder, random.Random(f"{arguments.seed} {number}"))
            kind(trial)
            ended = run_trial(trial, program, arguments.memory, arguments.patience)
            row = rows[kind.__name__]
            row["trials"] += 1
            if ended.killed:
                row["killed"] += 1
            elif ended.signal:
                row["signals"][ended.signal] = row["signals"].get(ended.signal, 0) + 1
            else:
                row["statuses"][ended.status] = row["statuses"].get(ended.status, 0) + 1
            row["lines"] = max(row["lines"], ended.lines)
            row["slowest"] = max(row["slowest"], ended.seconds)
            if ended.faults:
                row["failed"] += 1
                words = " ".join(repr(word[:60]) if not word.isprintable() or len(word) > 60 or not word else word for word in trial.command)
                failures.append(f"trial {number}, {kind.__name__}: plumb {words}: {'; '.join(ended.faults)}: {ended.text[:200]!r}")
                if arguments.keep:
                    kept = Path(arguments.keep) / f"{arguments.seed}-{number}-{kind.__name__}"
                    shutil.rmtree(kept, ignore_errors=True)
                    Path(arguments.keep).mkdir(parents=True, exist_ok=True)
                    shutil.move(folder, kept)
                    (kept / "TRIAL").write_text(f"{trial.command!r}\n{trial.environment!r}\n{trial.limits!r}\n{failures[-1]}\n")
            shutil.rmtree(folder, ignore_errors=True)

    statuses = sorted({status for row in rows.values() for status in row["statuses"]})
    print(f"{'kind':18}{'trials':>8}" + "".join(f"{'exit ' + str(status):>9}" for status in statuses)
          + f"{'signals':>10}{'killed':>8}{'lines':>7}{'slowest':>9}{'failed':>8}")
    for name, row in rows.items():
        signals = " ".join(f"{count}×{signal.Signals(which).name}" for which, count in row["signals"].items()) or "0"
        print(f"{name:18}{row['trials']:8}" + "".join(f"{row['statuses'].get(status, 0):9}" for status in statuses)
              + f"{signals:>10}{row['killed']:8}{row['lines']:7}{row['slowest']:7.1f} s{row['failed']:8}")
    for failure in failures[:200]:
        print(failure)
    trials = sum(row["trials"] for row in rows.values())
    print(f"{trials} trials, {len(failures)} failed, {time.monotonic() - begin:.0f} s, seed {arguments.seed}")
    return 1 if failures or trials == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
