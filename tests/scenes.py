#!/usr/bin/env python3
"""Holds what --economy chooses for random scenes against finer runs, through a projection of its own.

usage: tests/scenes.py [PLUMB [SCENES [FIRST]]]

Draws SCENES (200) scenes from number FIRST (0) on: upright cables, motions shorter than a frame, cameras that miss,
close-ups, long motions of the stiff pendulum, every pair of supports, soft to stiff. Where a choice is said to hold,
it is run again with outputs between the frames, and held against a run on four times its mesh with tight tolerances,
at the frames, at three times between any two, and at the end. A second run on half that mesh tells how far the first
may be off; a third, whose start is turned by 1e-9, whether the motion depends on what nobody states. Prints what is
wrongly held, and the counts: held and right, held and wrong, held where the finer runs do not tell, not held.
Exit status 1 where one is wrongly held.
"""

import collections
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import time

PLACES = 24  # along the cable, where it is looked at
CASE = """
title = "scene"
cable = {{ length = 1, area = {area}, density = {density}, youngs_modulus = {E}, second_moment = {I}, elements = {elements} }}
start = {{ direction = {direction}, angular_velocity = {omega} }}
supports = {{ first = "{first}", last = "{last}" }}
loads = {{ gravity = [0, -9.81, 0], end_force = {force} }}
method = {{ name = "arkode-erk", rtol = 1e-8 }}
time = {{ end = {end}, output_interval = {end} }}
scene = {{ size = {size}, frame_rate = {rate}, tolerance = {tolerance}, camera = {camera} }}
"""
SHAPES = ["upright"] * 3 + ["short"] * 4 + ["missed"] * 3 + ["long"] + ["close"] * 4 + ["any"] * 5
SUPPORTS = ["free", "pinned", "clamped"]


def sum_of(a, b, factor=1.0):
    return [x + factor * y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def on_sphere(draw):
    return unit([draw.gauss(0, 1) for _ in range(3)])


class View:
    """A camera and what it makes of places: pixels from the top left corner, or nothing behind it."""

    def __init__(self, scene):
        camera = scene["camera"]
        self.width, self.height = scene["size"]
        self.eye = camera["eye"]
        self.back = unit(sum_of(self.eye, camera["target"], -1))
        self.right = unit(cross(camera["up"], self.back))
        self.up = cross(self.back, self.right)
        self.parallel = "view_height" in camera
        self.focal = self.height / camera["view_height"] if self.parallel else self.height / 2 / math.tan(
            math.radians(camera["field_of_view"]) / 2)
        self.radius = max(math.sqrt(scene["area"] / math.pi), 1 / 150)

    def pixel(self, place):
        """Where it is seen, and how many pixels a metre has there."""
        way = sum_of(place, self.eye, -1)
        depth = -dot(way, self.back)
        if not self.parallel and depth <= 0:
            return None
        scale = self.focal if self.parallel else self.focal / depth
        return [self.width / 2 + scale * dot(way, self.right), self.height / 2 - scale * dot(way, self.up)], scale

    def sees(self, seen):
        if seen is None:
            return False
        (x, y), around = seen[0], self.radius * seen[1]
        return -around < x < self.width + around and -around < y < self.height + around

    def distance(self, run, other):
        """Greatest on the picture between the same places of two runs; none where neither is ever seen."""
        greatest = None
        for state, reference in zip(run, other):
            for place, true in zip(state, reference):
                a, b = self.pixel(place), self.pixel(true)
                if not self.sees(a) and not self.sees(b):
                    continue
                off = math.dist(a[0], b[0]) if a and b else math.inf
                greatest = max(off, greatest or 0)
        return greatest


def camera_of(draw, shape, direction, first):
    target = [0.5 * x for x in direction]
    if shape == "close":
        target = [draw.choice([0.25, 0.5, 1]) * x for x in direction]
    elif shape == "any" and first != "free":
        target = [0.2 * x for x in on_sphere(draw)]
    away = draw.uniform(0.15, 0.5) if shape == "close" else draw.uniform(1.5, 4)
    back = on_sphere(draw)
    eye = sum_of(target, back, away)
    if shape == "missed":
        miss = draw.choice(["behind", "beside", "at its edge"])
        if miss == "behind":
            target = sum_of(eye, back)
        else:
            across = unit(cross(back, on_sphere(draw)))
            target = sum_of(target, across, (3 if miss == "beside" else 0.7) * away)
    up = [0, 1, 0] if abs(back[1]) < 0.9 else [1, 0, 0]
    camera = {"eye": eye, "target": target, "up": up}
    if shape != "missed" and draw.random() < 0.3:
        camera["view_height"] = 1.2 * away
    else:
        camera["field_of_view"] = draw.uniform(20, 70)
    return camera


def scene_of(number):
    draw = random.Random(number)
    shape = draw.choice(SHAPES)
    f = 1 if shape == "long" else math.exp(draw.uniform(math.log(5), math.log(30)))
    direction, omega = on_sphere(draw), [0, 0, 0]
    first, last = draw.choice(SUPPORTS), draw.choice(["free", "free", "free", "pinned", "clamped"])
    stiffer = draw.choice([1, 1, 3, 10])
    if shape == "upright":
        direction, first, last = [0, 1, 0], draw.choice(["pinned", "clamped"]), "free"
        if draw.random() < 0.3:  # leaning by this
            direction = unit([10**draw.uniform(-9, -1), 1, 0])
    elif shape == "long":
        direction, first, last, stiffer = [1, 0, 0], "pinned", "free", 1
    if first != "clamped" and last == "free":
        omega = [draw.choice([0, 1, 4, 8]) * x for x in on_sphere(draw)]
    if shape == "upright":
        omega = [0, draw.choice([0, 0, 3]) * (first == "pinned"), 0]
    rate = draw.choice([1, 5, 10, 25, 30, 60])
    end = draw.uniform(0.05, 0.7)
    if shape == "short":
        rate = draw.choice([0.5, 1, 2, 5, 10, 25])
        end = draw.uniform(0.1, 0.95) * min(1 / rate, 1)
    elif shape == "long":
        end, omega = 3, [0, 4, 0]
    width = draw.choice([160, 320, 640, 1280])
    return {"shape": shape, "area": 1e-6 * f**2, "density": 8000 / f**2, "E": 1e9 / f**4,
            "I": stiffer * 1e-12 * f**4 / 4 / math.pi, "elements": draw.choice([2, 4, 8]),
            "direction": direction, "omega": omega, "first": first, "last": last,
            "force": [draw.choice([0, 0, 0.02, 0.1]) * x for x in on_sphere(draw)] if last == "free" else [0, 0, 0],
            "end": end, "rate": rate, "size": [width, round(width * 9 / 16)], "tolerance": draw.choice([0.5, 1, 2, 4]),
            "camera": camera_of(draw, shape, direction, first)}


def toml(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(x)}" for key, x in value.items()) + " }"
    return "[" + ", ".join(repr(float(x)) for x in value) + "]" if isinstance(value, list) else repr(float(value))


def text_of(scene):
    written = {key: toml(value) if isinstance(value, dict) else value for key, value in scene.items()}
    return CASE.format(**written) + "".join(
        f'[[probe]]\nname = "p{k}"\nat = {k / PLACES}\nquantity = "position"\n' for k in range(PLACES + 1))


class Scene:
    def __init__(self, plumb, scene, folder):
        self.plumb, self.scene, self.folder = plumb, scene, pathlib.Path(folder)
        self.case = self.folder / "case.toml"
        self.case.write_text(text_of(scene))

    def solve(self, *arguments, settings=()):
        """The result, and the places of the cable at each output."""
        table = self.folder / "probes.csv"
        command = [self.plumb, "solve", self.case, "--json", "--quiet", "--csv", table, *arguments]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 1, 4):
            sys.exit(f"{self.scene}\n{command}\n{done.stderr}")
        rows = list(csv.reader(table.open()))[1:]
        runs = [[[float(x) for x in row[k:k + 3]] for k in range(1, len(row), 3)] for row in rows]
        return json.loads(done.stdout), runs

    def often(self):
        """Outputs between the frames."""
        return f"time.output_interval={min(1 / self.scene['rate'], self.scene['end']) / 4!r}"

    def again(self, chosen):
        cable, method = chosen["cable"], chosen["method"]
        settings = [f"cable.model={cable['model']}", f"cable.elements={cable['elements']}", self.often()]
        if cable["model"] == "cable":
            settings += [f"cable.quadrature={cable['quadrature']}", f"cable.second_moment={cable['second_moment']!r}"]
        settings += [f"method.{key}={method[key]}" for key in ("name", "step", "rtol", "atol") if method.get(key)]
        return self.solve(settings=settings)

    def truth(self, elements, *more):
        # Fine meshes by long steps, longer on the half mesh so that they are in its doubt too.
        step = min(2e-5, self.scene["end"] / 5000) * (1 if elements == self.finest else 2)
        methods = [f"{{ name = 'generalized-alpha', step = {h!r} }}" for h in (step, step / 5)]
        if self.finest <= 32:
            methods.insert(0, "{ name = 'arkode-erk', rtol = 1e-8 }")
        for method in methods:
            ended = self.solve(settings=[f"cable.elements={elements}", self.often(), f"method={method}", *more])
            if ended[0]["outcome"] == "completed":
                break
        return ended


def judged(plumb, scene):
    """"not held", "right", "wrong" or "untold", and why."""
    with tempfile.TemporaryDirectory() as folder:
        run = Scene(plumb, scene, folder)
        economy = run.solve("--economy")[0]["economy"]
        if not economy["holds"]:
            return "not held", economy["uncertain"]
        chosen = economy["tried"][economy["chosen"]]
        result, drawn = run.again(chosen)
        said = f"{chosen['in_words']}, said to be {chosen['estimated_picture_error']:.3g} px off"
        if result["outcome"] != "completed":
            return "wrong", f"{said}: {result['outcome']}"
        fine = run.finest = 4 * (chosen["cable"]["elements"] if chosen["cable"]["model"] == "cable" else 4)
        turned = sum_of(scene["direction"], cross(scene["direction"], [0.6, 0, 0.8]), 1e-9)
        truths = [run.truth(fine), run.truth(fine // 2), run.truth(fine // 2, f"start.direction={turned}")]
        for outcome, places in truths:
            if outcome["outcome"] != "completed" or len(places) != len(drawn):
                return "untold", f"{said}: the finer run ended {outcome['outcome']}"
        truth, half, disturbed = (places for _, places in truths)
        view = View(scene)
        off = view.distance(drawn, truth)
        if off is None:
            return "wrong", said + ": nothing is seen"
        doubt, parted = view.distance(half, truth) or 0, view.distance(half, disturbed) or 0
        known = f"{said}, is {off:.3g} px off, tolerance {scene['tolerance']} px"
        if parted > scene["tolerance"]:
            return "wrong", f"{known}: one turned by 1e-9 is {parted:.3g} px away"
        if off - doubt / 3 > scene["tolerance"]:
            return "wrong", known
        if off + doubt / 3 > scene["tolerance"]:
            return "untold", f"{known}: half the finer mesh is {doubt:.3g} px away"
        return "right", known


def main():
    plumb = sys.argv[1] if len(sys.argv) > 1 else "build/release/plumb"
    scenes = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    counts = collections.defaultdict(collections.Counter)
    for number in range(first, first + scenes):
        scene, began = scene_of(number), time.monotonic()
        verdict, why = judged(plumb, scene)
        counts[scene["shape"]][verdict] += 1
        if verdict != "right":
            print(f"{number:4} {scene['shape']:8} {verdict}, {time.monotonic() - began:.1f} s: {why}", flush=True)
    verdicts = ["right", "wrong", "untold", "not held"]
    print(f"{'':10}" + "".join(f"{verdict:>10}" for verdict in verdicts))
    for shape, of_shape in sorted(counts.items()):
        print(f"{shape:10}" + "".join(f"{of_shape[verdict]:10}" for verdict in verdicts))
    total = sum(counts.values(), collections.Counter())
    print(f"{'all':10}" + "".join(f"{total[verdict]:10}" for verdict in verdicts))
    return 1 if total["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
