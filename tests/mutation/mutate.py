#!/usr/bin/env python3
"""Changes what decides whether a result is called good, one small thing at a time, and tells which changes no test notices.

    tests/mutation/mutate.py [--sample N] [--seed S] [--only PATTERN] [--quick] [--list]

A mutant is one changed sign, comparison, bound, constant or condition in one of the files of TABLE. It is built in a
clone of this checkout (build/mutation/tree; what is not committed is not in it), and the programs of that file's row are
run: first the quick tests that are meant for it, then, where they all pass, all quick ones, then the slow ones. A mutant is
caught where a test fails, crashes or takes far too long, and alive where none does. One that does not compile, or that
gives the same object file, is none. Those that no test can tell from the original are listed in equivalent.txt with why.

Prints a table and, for every mutant that is alive, its line; exit status 1 where one is alive that is not listed.
A sample holds of each file as large a share as all mutants do. Results are kept in build/mutation/results.jsonl:
what was caught stays so while its file is the same, what was alive while the tests are too.
PLUMB_MUTATION is another place for all this, PLUMB_MUTATION_TREE one for the clone, which may be a copy of a built checkout.
"""

import argparse
import fnmatch
import hashlib
import json
import os
import random
import re
import resource
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Where the clone and the results are.
PLACE = Path(os.environ.get("PLUMB_MUTATION", ROOT / "build" / "mutation"))
TREE = Path(os.environ.get("PLUMB_MUTATION_TREE", PLACE / "tree"))
BUILD = TREE / "build" / "release"
QUICK = 0.1  # s, the longest of a quick test
TIMED = re.compile("Interrupt")  # tests that may fail on a busy machine are tried last

# Files, and the programs of their tests in the order they are run in, with the tests that are meant for them.
TABLE = [
    ("report/verdict/verdict.cpp report/verdict/series_error.cpp report/verdict/given_distance.cpp report/page/conclusion.cpp report/verdict/coverage.cpp",
     [("test_report", "*Verdict*:*Coverage*:Conclusion*:*Given*:*Evaluat*:*Reference*:Run*:Report*:*SaidGood*:Outcome*")]),
    ("engine/run/sampled_run.cpp engine/base/known_time.cpp engine/read/given_probes.cpp engine/study/reference/comparable_times.cpp",
     [("test_engine", "*Sampled*:*KnownTime*:*Comparable*:*SaidGood*:*Budget*:*Study*"), ("test_report", "*Coverage*:*Verdict*")]),
    ("report/document/regression.cpp report/document/changes.cpp",
     [("test_report", "*Baseline*:*Regression*:*Change*:Reproduce*:*SaidGood*")]),
    ("report/diff/file_difference.cpp report/diff/number_difference.cpp report/diff/path_difference.cpp report/diff/picture_difference.cpp",
     [("test_report", "*Diff*:*SaidGood*")]),
    ("render/image/*difference*.cpp", [("test_render", "*Difference*"), ("test_report", "*Diff*:*SaidGood*")]),
    ("engine/integrate/methods/statics.cpp engine/integrate/methods/equilibrium_path.cpp engine/integrate/methods/loaded_cable.cpp engine/model/inertia.cpp", [("test_engine", "*Statics*:*Inertia*:*SaidGood*")]),
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
    """(file, [(program, filter)]) for every file of the table that there is, each once."""
    known = sorted(subprocess.run(["git", "ls-files", "*.cpp"], cwd=ROOT, check=True, capture_output=True,
                                  text=True).stdout.split())
    taken = set()
    for patterns, programs in TABLE:
        for name in known:
            fits = any(fnmatch.fnmatch(name, pattern) for pattern in patterns.split())
            if fits and name not in taken and not name.startswith("tests/") and not name.endswith("_page.cpp"):
                taken.add(name)
                yield name, programs


def sampled(plan, count, seed):
    """`count` of the mutants, of each file in proportion to what it has."""
    by_file = {}
    for entry in plan:
        by_file.setdefault(entry[0]["file"], []).append(entry)
    exact = {name: count * len(of) / len(plan) for name, of in by_file.items()}
    quota = {name: int(value) for name, value in exact.items()}
    for name in sorted(exact, key=lambda name: quota[name] - exact[name])[:count - sum(quota.values())]:
        quota[name] += 1
    draw = random.Random(seed)
    return [of[k] for name, of in by_file.items() for k in sorted(draw.sample(range(len(of)), quota[name]))]


def run(command, limit, **options):
    """The exit status; None where it took more than `limit` seconds of the processor, or waited for twenty times as long."""
    def bounded():
        resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1, int(limit) + 2))
        resource.setrlimit(resource.RLIMIT_AS, (12 << 30, 12 << 30))
    try:
        return subprocess.run(command, timeout=20 * limit, stdin=subprocess.DEVNULL, preexec_fn=bounded,
                              stdout=options.pop("out", subprocess.DEVNULL), stderr=subprocess.STDOUT, **options).returncode
    except subprocess.TimeoutExpired:
        return None


def prepare(apart):
    """Brings the clone to this commit; `apart` are the files that are compiled by themselves."""
    PLACE.mkdir(parents=True, exist_ok=True)
    head = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()
    if not TREE.exists():
        subprocess.run(["git", "clone", "-q", "--shared", str(ROOT), str(TREE)], check=True)
    subprocess.run(["git", "fetch", "-q", str(ROOT), "HEAD"], cwd=TREE, check=True)
    subprocess.run(["git", "checkout", "-q", "-f", "--detach", head], cwd=TREE, check=True)
    subprocess.run(["cmake", "--preset", "release", f"-DPLUMB_APART={';'.join(apart)}",
                    f"-DCMAKE_PROJECT_plumb_INCLUDE={TREE}/tests/mutation/apart.cmake"],
                   cwd=TREE, check=True, stdout=subprocess.DEVNULL)


class Trial:
    """Builds and tests the clone."""

    def __init__(self, jobs):
        self.jobs = jobs
        self.seconds = {}  # that each test of a program takes without a change
        self.objects = {}  # of each source, relative to the build
        self.unchanged = {}  # check sum of the object of each source without a change

    def build(self, targets):
        with open(PLACE / "build.log", "wb") as log:
            return run(["ninja", "-C", str(BUILD), f"-j{self.jobs}", *targets], 3600, out=log) == 0

    def test(self, program, tests, limit, *options):
        environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=0")
        chosen = PLACE / "tests.flags"
        chosen.write_text(f"--gtest_filter={':'.join(tests)}\n")
        with open(PLACE / "test.log", "wb") as log:
            return run([str(BUILD / "tests" / program), "--gtest_brief=1", f"--gtest_flagfile={chosen}", *options],
                       limit, cwd=BUILD / "tests", env=environment, out=log)

    def measure(self, programs):
        """Runs every test that was not measured yet; what it took is kept."""
        kept = PLACE / "times.json"
        self.seconds = json.loads(kept.read_text()) if kept.exists() else {}
        for program in programs:
            known = self.seconds.setdefault(program, {})
            suite, tests = "", []
            for line in subprocess.run([str(BUILD / "tests" / program), "--gtest_list_tests"], check=True,
                                       capture_output=True, text=True).stdout.splitlines()[1:]:
                if line.startswith(" "):
                    tests.append(suite + line.split()[0])
                else:
                    suite = line.split()[0]
            new = [test for test in tests if test not in known]
            report = PLACE / "measured.json"
            if new and self.test(program, new, 3600, f"--gtest_output=json:{report}") != 0:
                sys.exit(f"mutate.py: {program} fails without any change; see {PLACE}/test.log")
            for each in json.loads(report.read_text())["testsuites"] if new else []:
                for test in each["testsuite"]:
                    known[f"{each['name']}.{test['name']}"] = float(test["time"].rstrip("s"))
            self.seconds[program] = {test: known[test] for test in tests}
        kept.write_text(json.dumps(self.seconds))

    def object_sum(self, name):
        return hashlib.sha256((BUILD / self.objects[name]).read_bytes()).hexdigest()

    def see_objects(self, names):
        for entry in json.loads((BUILD / "compile_commands.json").read_text()):
            name = os.path.relpath(entry["file"], TREE)
            if name in names:
                self.objects[name] = re.search(r" -o (\S+)", entry["command"]).group(1)
                self.unchanged[name] = self.object_sum(name)

    def stages(self, programs, quick_only):
        """(outcome of a failure, program, tests), the likeliest and quickest first."""
        def fits(test, patterns):
            return any(fnmatch.fnmatchcase(test, pattern) for pattern in patterns.split(":"))
        quick = {program: [test for test, taken in self.seconds[program].items() if taken <= QUICK and not TIMED.search(test)]
                 for program, _ in programs}
        for program, patterns in programs:
            yield "caught", program, [test for test in quick[program] if fits(test, patterns)]
        for program, patterns in programs:
            yield "caught by all", program, [test for test in quick[program] if not fits(test, patterns)]
        for program, _ in [] if quick_only else programs:
            yield "caught by all", program, [test for test in self.seconds[program] if test not in quick[program]]

    def judge(self, mutant, programs, quick_only):
        path = TREE / mutant["file"]
        original = path.read_text()
        path.write_text(mutant["text"])
        try:
            if not self.build([self.objects[mutant["file"]]]):
                return "not built"
            if self.object_sum(mutant["file"]) == self.unchanged[mutant["file"]]:
                return "same object"
            for outcome, program, tests in self.stages(programs, quick_only):
                # What is linked is asked for its tests, some of which are made of what the changed code says.
                if not self.build([program]):
                    return outcome
                while tests:
                    limit = 10 + 5 * sum(self.seconds[program][test] for test in tests)
                    if self.test(program, tests, limit, "--gtest_fail_fast") == 0:
                        break
                    failed = re.search(r"^\[  FAILED  \] (\S+)", (PLACE / "test.log").read_text(errors="replace"), re.M)
                    mutant["by"] = failed.group(1).rstrip(",") if failed else "crash or limit"
                    # On a busy machine a test may fail by itself: it has to do so twice.
                    if not failed or self.test(program, [mutant["by"]], limit) != 0:
                        return outcome
                    tests = [test for test in tests if test != mutant["by"]]
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
    parser.add_argument("--part", default="1/1", metavar="K/N",
                        help="the K-th of N parts, for several at once, each in a place of its own")
    parser.add_argument("--quick", action="store_true", help=f"leave out tests that take more than {QUICK} s")
    parser.add_argument("--list", action="store_true", help="print the mutants and try none")
    arguments = parser.parse_args()

    table = list(rows())
    plan = [(mutant, programs) for name, programs in table if fnmatch.fnmatch(name, arguments.only)
            for mutant in mutants_of(name)]
    if 0 < arguments.sample < len(plan):
        plan = sampled(plan, arguments.sample, arguments.seed)
    part, parts = (int(number) for number in arguments.part.split("/"))
    plan = plan[(part - 1) * len(plan) // parts:part * len(plan) // parts]
    if arguments.list:
        for mutant, *_ in plan:
            print(f"{mutant['file']}:{mutant['line']}: {mutant['kind']}: {mutant['old']}  ⇒  {mutant['new']}")
        print(f"{len(plan)} mutants")
        return 0

    prepare([name for name, _ in table])
    trial = Trial(arguments.jobs)
    programs = sorted({program for _, of in plan for program, _ in of})
    if not trial.build(programs):
        sys.exit(f"mutate.py: the build fails without any change; see {PLACE}/build.log")
    trial.measure(programs)
    for program in programs:
        meant = {test for _, of in plan for outcome, name, tests in trial.stages(of, True)
                 if name == program and outcome == "caught" for test in tests}
        if trial.test(program, sorted(meant), 3600) != 0:
            sys.exit(f"mutate.py: {program} fails without any change; see {PLACE}/test.log")
    trial.see_objects({mutant["file"] for mutant, _ in plan})
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
    for number, (mutant, programs) in enumerate(plan, 1):
        base = hashlib.sha256((TREE / mutant["file"]).read_bytes()).hexdigest()
        mutated = hashlib.sha256(mutant["text"].encode()).hexdigest()
        key = f"{mutant['file']} {base[:16]} {mutated[:16]}"
        key_now = f"{key} {tests_now[:16]} {'quick' if arguments.quick else 'all'}"
        outcome = kept.get(key, kept.get(key_now))
        begin = time.monotonic()
        if outcome is None:
            outcome = trial.judge(mutant, programs, arguments.quick)
            with open(kept_file, "a") as file:
                file.write(json.dumps({"key": key_now if outcome == "alive" else key, "outcome": outcome, "by": mutant.get("by", "")}) + "\n")
        reason = equivalent.get((mutant["file"], mutant["old"], mutant["new"]))
        if outcome == "alive" and reason is not None:
            outcome = "equivalent"
        outcomes.append((mutant, outcome, reason))
        print(f"[{number}/{len(plan)}] {outcome:13} {time.monotonic() - begin:5.1f} s  {mutant['file']}:{mutant['line']}: "
              f"{mutant['old']}  ⇒  {mutant['new']}", flush=True)

    kinds = ["caught", "caught by all", "alive", "equivalent", "same object", "not built"]
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
