#!/usr/bin/env python3
"""Changes what decides whether a result is called good, one small thing at a time, and tells which changes no test notices.

    tests/mutation/mutate.py [--sample N] [--seed S] [--only PATTERN] [--list]

A mutant is one changed sign, comparison, bound, constant or condition in one of the files of TABLE. It is built in a
clone of this checkout (build/mutation/tree; what is not committed is not in it), and the tests of that file's row are run:
first those that are meant for it, then, where they all pass, the whole programs. A mutant is caught where a test
fails, crashes or takes far too long, and alive where none does. One that does not compile, or that gives the same object
file, is none. Those that cannot be told from the original by any test are listed in equivalent.txt with the reason.

Prints a table and, for every mutant that is alive, its line; exit status 1 where one is alive that is not listed.
Results are kept in build/mutation/results.jsonl: a mutant whose file and tests are the same is not tried again.
"""

import argparse
import fnmatch
import hashlib
import json
import os
import random
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Where the clone and the results are.
PLACE = Path(os.environ.get("PLUMB_MUTATION", ROOT / "build" / "mutation"))
TREE = PLACE / "tree"
BUILD = TREE / "build" / "release"

# Files, the test program and the tests in it that are meant for them, and the programs that are run whole after those.
TABLE = [
    ("report/verdict.cpp report/series_error.cpp report/given_distance.cpp report/conclusion.cpp report/*coverage*.cpp"
     " engine/output/sampled_run.cpp engine/output/known_time.cpp engine/study/comparable_times.cpp",
     "test_report", "*Verdict*:*Coverage*:Conclusion*:*Given*:*Evaluat*:*Reference*:Run*:Report*", ["test_report"]),
    ("report/regression.cpp report/changes.cpp report/baseline*.cpp",
     "test_report", "*Baseline*:*Regression*:*Change*:Reproduce*", ["test_report"]),
    ("report/file_difference.cpp report/number_difference.cpp report/path_difference.cpp report/*png_difference*.cpp"
     " report/picture_difference*.cpp",
     "test_report", "*Diff*", ["test_report"]),
    ("render/image_difference.cpp render/*difference*.cpp", "test_render", "*Difference*", ["test_render", "test_report"]),
    ("engine/integrate/statics.cpp engine/model/inertia.cpp engine/*/*inertia*.cpp", "test_engine", "Statics*:*Inertia*",
     ["test_engine"]),
]

SWAPS = [  # operators stand between blanks, as the formatter leaves them; what is in angle brackets of templates does not
    ("comparison", " < ", [" <= ", " > "]),
    ("comparison", " <= ", [" < ", " > "]),
    ("comparison", " > ", [" >= ", " < "]),
    ("comparison", " >= ", [" > ", " < "]),
    ("comparison", " == ", [" != "]),
    ("comparison", " != ", [" == "]),
    ("condition", " && ", [" || "]),
    ("condition", " || ", [" && "]),
    ("sign", " + ", [" - "]),
    ("sign", " - ", [" + "]),
    ("sign", " * ", [" / "]),
    ("sign", " / ", [" * "]),
    ("sign", " += ", [" -= "]),
    ("sign", " -= ", [" += "]),
    ("bound", "std::min(", ["std::max("]),
    ("bound", "std::max(", ["std::min("]),
    ("bound", "std::all_of(", ["std::any_of("]),
    ("bound", "std::any_of(", ["std::all_of("]),
    ("bound", "std::none_of(", ["std::any_of("]),
    ("bound", ".front()", [".back()"]),
    ("bound", ".back()", [".front()"]),
    ("bound", "std::lower_bound(", ["std::upper_bound("]),
    ("bound", "std::upper_bound(", ["std::lower_bound("]),
    ("constant", "true", ["false"]),
    ("constant", "false", ["true"]),
    ("condition", "continue;", ["break;"]),
    ("condition", "break;", ["continue;"]),
]
WORDS = {"true", "false"}
NUMBER = re.compile(r"(?<![\w.'])(\d[\d']*)(\.\d*)?([eE][+-]?\d+)?(?=[UuLl]*(?![\w.']))")
STATEMENT_IF = re.compile(r"\b(if|while) (constexpr )?\(")


def blanked(text):
    """The text with comments, strings, characters and directives overwritten, of the same length."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9])\'(?:\\.|[^\'\\\n])\'|^#[^\n]*',
                         re.S | re.M)
    return pattern.sub(lambda found: re.sub(r"[^\n]", "~", found.group()), text)


def closing(text, opening):
    depth = 0
    for at in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return -1


def changed_number(found):
    whole, fraction, power = found.groups()
    if fraction is None and power is None:
        value = int(whole.replace("'", ""))
        return [str(value + 1)] + ([str(value - 1)] if value > 1 else [])
    return [f"({found.group()} * 2)"] if float(found.group().replace("'", "")) else ["1.0"]


def mutants_of(name):
    """All changes of a file, in the order of their places: (from, to, new text, kind)."""
    text = (ROOT / name).read_text()
    code = blanked(text)
    found = []
    for kind, old, news in SWAPS:
        at = code.find(old)
        while at >= 0:
            if old not in WORDS or not re.match(r"\w", code[at - 1]) and not re.match(r"\w", code[at + len(old)]):
                found += [(at, at + len(old), new, kind) for new in news]
            at = code.find(old, at + 1)
    for match in STATEMENT_IF.finditer(code):
        opening = match.end() - 1
        end = closing(code, opening)
        # What declares a name cannot be negated in place; behind its ';' stands the condition.
        start = opening + 1 + code[opening + 1:end].rfind(";") + 1 if ";" in code[opening + 1:end] else opening + 1
        if re.search(r"(?<![=!<>])=(?!=)", code[start:end]):
            continue
        condition = text[start:end].strip()
        # Of one comparison alone the opposite is among those above.
        alone = len(re.findall(r" [=!]= ", code[start:end])) == 1 and not re.search(r"&&|\|\|", code[start:end])
        if condition and not alone:
            found.append((start, end, f"{' ' if start > opening + 1 else ''}!({condition})", "condition"))
    for match in re.finditer(r"!(?=[\w(])", code):
        found.append((match.start(), match.end(), "", "condition"))
    for match in re.finditer(r"(?:(?<=[(\[])|(?<=, )|(?<=[=?:] )|(?<=return ))-(?=[\w(])", code):
        found.append((match.start(), match.end(), "", "sign"))
    for match in NUMBER.finditer(code):
        line = code[code.rfind("\n", 0, match.start()) + 1:match.start()]
        if not re.search(r"<[^<>;()]*$", line):  # an argument of a template
            found += [(match.start(), match.end(), new, "constant") for new in changed_number(match)]
    unique = sorted(set(found))
    result = []
    for begin, end, new, kind in unique:
        changed = text[:begin] + new + text[end:]
        line = text.count("\n", 0, begin) + 1
        first = text.rfind("\n", 0, begin) + 1
        old_line = text[first:text.find("\n", end)]
        new_line = changed[first:changed.find("\n", begin + len(new))]
        result.append({"file": name, "line": line, "kind": kind, "old": " ".join(old_line.split()),
                       "new": " ".join(new_line.split()), "text": changed})
    return result


def rows():
    """(file, program, filter, programs) for every file of the table that there is, each once."""
    known = sorted(subprocess.run(["git", "ls-files", "*.cpp"], cwd=ROOT, check=True, capture_output=True,
                                  text=True).stdout.split())
    taken = set()
    for patterns, program, tests, whole in TABLE:
        for name in known:
            fits = any(fnmatch.fnmatch(name, pattern) for pattern in patterns.split())
            if fits and name not in taken and not name.startswith("tests/") and not name.endswith("_page.cpp"):
                taken.add(name)
                yield name, program, tests, whole


def run(command, limit, **options):
    """The exit status; None where it took too long."""
    try:
        return subprocess.run(command, timeout=limit, stdin=subprocess.DEVNULL, stdout=options.pop("out", subprocess.DEVNULL),
                              stderr=subprocess.STDOUT, **options).returncode
    except subprocess.TimeoutExpired:
        return None


def prepare():
    PLACE.mkdir(parents=True, exist_ok=True)
    head = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()
    if not TREE.exists():
        subprocess.run(["git", "clone", "-q", "--shared", str(ROOT), str(TREE)], check=True)
    subprocess.run(["git", "fetch", "-q", str(ROOT), "HEAD"], cwd=TREE, check=True)
    subprocess.run(["git", "checkout", "-q", "-f", "--detach", head], cwd=TREE, check=True)
    subprocess.run(["cmake", "--preset", "release"], cwd=TREE, check=True, stdout=subprocess.DEVNULL)
    return head


class Trial:
    """Builds and tests the clone."""

    def __init__(self, jobs):
        self.jobs = jobs
        self.seconds = {}  # that the tests take without a change

    def build(self, programs):
        with open(PLACE / "build.log", "wb") as log:
            return run(["ninja", "-C", str(BUILD), f"-j{self.jobs}", *programs], 3600, out=log) == 0

    def test(self, program, tests, limit):
        environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=0")
        with open(PLACE / "test.log", "wb") as log:
            return run([str(BUILD / "tests" / program), "--gtest_brief=1", "--gtest_fail_fast", f"--gtest_filter={tests}"],
                       limit, cwd=BUILD / "tests", env=environment, out=log)

    def baseline(self, program, tests):
        if (program, tests) not in self.seconds:
            begin = time.monotonic()
            status = self.test(program, tests, 1800)
            if status != 0:
                sys.exit(f"mutate.py: {program} --gtest_filter={tests} fails without any change; see {PLACE}/test.log")
            self.seconds[program, tests] = time.monotonic() - begin
        return self.seconds[program, tests]

    def judge(self, mutant, program, tests, whole):
        path = TREE / mutant["file"]
        original = path.read_text()
        path.write_text(mutant["text"])
        try:
            if not self.build([program]):
                return "not built"
            for k, (name, some) in enumerate([(program, tests)] + [(other, "*") for other in whole]):
                if k > 0 and not self.build([name]):
                    return "not built"
                if self.test(name, some, 20 + 5 * self.baseline_of[name, some]) != 0:
                    return "caught" if k == 0 else "caught by all"
            return "alive"
        finally:
            path.write_text(original)


def listed():
    """The mutants that no test can tell: {(file, old line, new line): reason}."""
    result = {}
    for line in (Path(__file__).parent / "equivalent.txt").read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            name, old, new, reason = (part.strip() for part in line.split(" ⇒ "))
            result[name, old, new] = reason
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, default=0, help="try N mutants, drawn by the seed; default: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="*", help="files that fit the pattern")
    parser.add_argument("--jobs", type=int, default=2, help="of a build")
    parser.add_argument("--list", action="store_true", help="print the mutants and try none")
    arguments = parser.parse_args()

    plan = [(mutant, program, tests, whole) for name, program, tests, whole in rows()
            if fnmatch.fnmatch(name, arguments.only) for mutant in mutants_of(name)]
    if 0 < arguments.sample < len(plan):
        chosen = sorted(random.Random(arguments.seed).sample(range(len(plan)), arguments.sample))
        plan = [plan[k] for k in chosen]
    if arguments.list:
        for mutant, *_ in plan:
            print(f"{mutant['file']}:{mutant['line']}: {mutant['kind']}: {mutant['old']}  ⇒  {mutant['new']}")
        print(f"{len(plan)} mutants")
        return 0

    prepare()
    trial = Trial(arguments.jobs)
    programs = sorted({program for _, program, _, _ in plan} | {other for *_, whole in plan for other in whole})
    if not trial.build(programs):
        sys.exit(f"mutate.py: the build fails without any change; see {PLACE}/build.log")
    trial.baseline_of = {}
    for _, program, tests, whole in plan:
        for pair in [(program, tests)] + [(other, "*") for other in whole]:
            trial.baseline_of[pair] = trial.baseline(*pair)
    tests_now = hashlib.sha256(subprocess.run(["git", "ls-files", "-s", "tests"], cwd=ROOT, check=True,
                                              capture_output=True).stdout).hexdigest()
    kept_file = PLACE / "results.jsonl"
    kept = {}
    if kept_file.exists():
        for line in kept_file.read_text().splitlines():
            result = json.loads(line)
            kept[result["key"]] = result["outcome"]

    equivalent = listed()
    outcomes = []
    for number, (mutant, program, tests, whole) in enumerate(plan, 1):
        base = hashlib.sha256((TREE / mutant["file"]).read_bytes()).hexdigest()
        mutated = hashlib.sha256(mutant["text"].encode()).hexdigest()
        key = f"{mutant['file']} {base[:16]} {mutated[:16]} {tests_now[:16]}"
        # What was caught once is caught by the same tests and more.
        outcome = kept.get(key)
        begin = time.monotonic()
        if outcome is None:
            outcome = trial.judge(mutant, program, tests, whole)
            with open(kept_file, "a") as file:
                file.write(json.dumps({"key": key, "outcome": outcome}) + "\n")
        reason = equivalent.get((mutant["file"], mutant["old"], mutant["new"]))
        if outcome == "alive" and reason is not None:
            outcome = "equivalent"
        outcomes.append((mutant, outcome, reason))
        print(f"[{number}/{len(plan)}] {outcome:13} {time.monotonic() - begin:5.1f} s  {mutant['file']}:{mutant['line']}: "
              f"{mutant['old']}  ⇒  {mutant['new']}", flush=True)

    kinds = ["caught", "caught by all", "alive", "equivalent", "not built"]
    print(f"\n{'file':38}{'mutants':>9}" + "".join(f"{kind:>15}" for kind in kinds) + f"{'of those alive or caught':>27}")
    names = list(dict.fromkeys(mutant["file"] for mutant, *_ in outcomes)) + ["all"]
    for name in names:
        of = [outcome for mutant, outcome, _ in outcomes if name in ("all", mutant["file"])]
        counts = [of.count(kind) for kind in kinds]
        judged = counts[0] + counts[1] + counts[2]
        share = f"{100 * (counts[0] + counts[1]) / judged:.1f} %" if judged else "–"
        print(f"{name:38}{len(of):9}" + "".join(f"{count:15}" for count in counts) + f"{share:>27}")
    for kind in ("alive", "equivalent"):
        for mutant, outcome, reason in outcomes:
            if outcome == kind:
                print(f"{kind}: {mutant['file']}:{mutant['line']}: {mutant['old']}  ⇒  {mutant['new']}"
                      + (f"  ({reason})" if reason else ""))
    return 1 if any(outcome == "alive" for _, outcome, _ in outcomes) else 0


if __name__ == "__main__":
    sys.exit(main())
