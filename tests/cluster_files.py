#!/usr/bin/env python3
"""Does what GitHub, GitLab and Kubernetes do with the files of cases/cluster, as far as that needs none of them: each job
in a folder of its own with what it is given of others, its shell lines run as they stand, but for apt-get, which does
nothing, and the jobs that build the program.

    tests/cluster_files.py PLUMB CASE KIND RESULTS FOLDER

RESULTS is the results.json of the same study in one piece, which each must come to. Exit status 1 where one does not.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import same_results
import yaml

FILES = Path(__file__).resolve().parent.parent / "cases" / "cluster"
SHARES = 3


class Service:
    def __init__(self, plumb, case, folder):
        self.case, self.folder = case, folder
        tools = folder / "tools"
        tools.mkdir(parents=True)
        (tools / "plumb").symlink_to(plumb)
        (tools / "apt-get").symlink_to("/bin/true")
        self.path = f"{tools}:{os.environ['PATH']}"

    def checkout(self, name):
        place = self.folder / name
        place.mkdir()
        shutil.copy(self.case, place)
        return place

    def shell(self, lines, place, variables, shell=("bash", "-e", "-o", "pipefail", "-c")):
        environment = {**os.environ, "PATH": self.path, **{name: str(value) for name, value in variables.items()}}
        ended = subprocess.run([*shell, lines], cwd=place, env=environment, capture_output=True, text=True)
        if ended.returncode != 0:
            sys.exit(f"{lines!r} ends with {ended.returncode}: {ended.stdout}{ended.stderr}")


def github(service, case, kind):
    text = (FILES / "github.yml").read_text()
    given = {"inputs.case": case, "inputs.kind": kind, "inputs.shares": SHARES}

    def filled(words, matrix=None):
        known = {**given, "matrix.share": matrix}
        return re.sub(r"\$\{\{ ([\w.]+) \}\}", lambda found: str(known[found[1]]), words)

    flow = yaml.safe_load(text)
    variables = {name: filled(value) for name, value in flow["env"].items()}
    outputs = service.folder / "outputs"
    summary = service.folder / "summary"
    variables |= {"GITHUB_OUTPUT": outputs, "GITHUB_STEP_SUMMARY": summary}
    jobs = flow["jobs"]
    # An artifact of one folder is what is in it; of a pattern, what it matches. The program is there already.
    artifacts = service.folder / "artifacts"

    def run(job, name, matrix=None, steps=lambda step: True):
        place = service.checkout(name)
        for step in filter(steps, jobs[job]["steps"]):
            given_with = {key: filled(value, matrix) for key, value in step.get("with", {}).items()
                          if isinstance(value, str)}
            if "run" in step:
                service.shell(filled(step["run"], matrix), place, variables)
            elif "upload-artifact" in step["uses"]:
                if (place / given_with["path"]).is_dir():
                    shutil.copytree(place / given_with["path"], artifacts / given_with["name"])
                else:
                    for found in place.glob(given_with["path"]):
                        shutil.copytree(found, artifacts / given_with["name"] / found.name)
            elif "download-artifact" in step["uses"] and "pattern" in given_with:
                assert step["with"]["merge-multiple"] is True
                for found in sorted(artifacts.glob(given_with["pattern"])):
                    shutil.copytree(found, place / given_with["path"], dirs_exist_ok=True)

    run("build", "build", steps=lambda step: step.get("id") == "list")
    name, _, value = outputs.read_text().strip().partition("=")
    matrix = json.loads(value)
    assert name == "shares" and matrix == list(range(1, SHARES + 1)), outputs.read_text()
    assert "fromJSON(needs.build.outputs.shares)" in jobs["share"]["strategy"]["matrix"]["share"]
    for share in matrix:
        run("share", f"share {share}", share)
    run("merge", "merge")
    assert summary.read_text().strip(), "the summary of the run is empty"
    return artifacts / "study" / "study"


def gitlab(service, case, kind):
    text = (FILES / "gitlab-ci.yml").read_text()
    given = {"case": case, "kind": kind, "shares": str(SHARES)}
    inputs, _ = yaml.safe_load_all(text)
    assert given.keys() == inputs["spec"]["inputs"].keys()
    jobs = yaml.safe_load(re.sub(r"\$\[\[ inputs\.(\w+) \]\]", lambda found: given[found[1]], text.split("\n---\n")[1]))
    artifacts = service.folder / "artifacts"
    artifacts.mkdir()

    def run(job, name, variables):
        place = service.checkout(name)
        shutil.copytree(artifacts, place, dirs_exist_ok=True)  # of all earlier stages
        service.shell("\n".join(job["before_script"] + job["script"]), place, {**job["variables"], **variables})
        kept = [place / path for path in job["artifacts"]["paths"] if (place / path).is_dir()]
        return [(path, path.relative_to(place)) for path in kept]

    made = []
    for share in range(1, jobs["share"]["parallel"] + 1):
        made += run(jobs["share"], f"share {share}", {"CI_NODE_INDEX": share, "CI_NODE_TOTAL": SHARES})
    for path, name in made:
        shutil.copytree(path, artifacts / name, dirs_exist_ok=True)
    (merged, _), = run(jobs["merge"], "merge", {})
    assert (merged.parent / jobs["merge"]["artifacts"]["reports"]["junit"]).exists()
    return merged


def kubernetes(service, case, kind):
    volume = service.checkout("volume")
    shared, share, merge = yaml.safe_load_all((FILES / "kubernetes.yaml").read_text())
    assert int(shared["data"]["SHARES"]) == share["spec"]["completions"]
    assert merge["spec"]["suspend"] is True
    variables = {**shared["data"], "CASE": volume / case, "KIND": kind, "SHARES": SHARES}

    def run(job, more):
        container, = job["spec"]["template"]["spec"]["containers"]
        lines, = (text.replace("/work/", f"{volume}/") for text in container["args"])
        service.shell(lines, "/", {**variables, **more}, container["command"])

    for index in range(SHARES):
        run(share, {"JOB_COMPLETION_INDEX": index})
    run(merge, {})
    return volume / "study"


def main():
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    plumb, case, kind, results, folder = sys.argv[1:]
    different = 0
    for act in (github, gitlab, kubernetes):
        service = Service(Path(plumb).resolve(), Path(case).resolve(), Path(folder).resolve() / act.__name__)
        different |= same_results.compare_documents(results, act(service, Path(case).name, kind) / "results.json")
    return different


if __name__ == "__main__":
    sys.exit(main())
