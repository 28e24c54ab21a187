#!/usr/bin/env python3
"""Judges random equilibria of statics by forces and a stiffness of its own.

usage: tests/equilibria.py [PLUMB [CASES [FIRST]]]

Draws CASES (500) cables from number FIRST (0) on: supports that hold them, loads of any direction and size, EA and EI
over decades, both strains, other load steps. What is said to be a stable equilibrium is assembled from the energy of
each element: the forces as its gradient, the stiffness as their derivative by complex steps, on what the supports
leave free. It is wrong where a force is left that is more than 1e-5 of the load, or where the stiffness, scaled to
a diagonal of ones and raised by 1e-9, has no Cholesky factor. Exit status 1 where one is wrong.
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

CASE = """
title = "equilibrium"
cable = {{ length = 1, area = 1, density = 1, youngs_modulus = {EA}, second_moment = {I}, elements = {elements}, strain = "{strain}" }}
start = {{ direction = {direction} }}
supports = {{ first = "{first}", last = "{last}" }}
loads = {{ gravity = {gravity}, end_force = {force} }}
method = {{ name = "statics", step = {step} }}
time = {{ end = 1, output_interval = 1 }}
"""
PROBE = '[[probe]]\nname = "{name}"\nat = {at}\nquantity = "{quantity}"\n'
GAUSS = {3: [(0.5 * (1 + s * math.sqrt(0.6)), (8 if s == 0 else 5) / 18) for s in (-1, 0, 1)],
         5: [(0.5, 64 / 225)] + [(0.5 * (1 + s * math.sqrt(5 + t * 2 * math.sqrt(10 / 7)) / 3),
                                  (322 - t * 13 * math.sqrt(70)) / 1800) for s in (-1, 1) for t in (-1, 1)]}


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def shapes(x, l):
    """First and second derivatives of the shape functions of an element at the share x of its length l."""
    return ([(-6 * x + 6 * x * x) / l, 1 - 4 * x + 3 * x * x, (6 * x - 6 * x * x) / l, 3 * x * x - 2 * x],
            [(-6 + 12 * x) / l**2, (-4 + 6 * x) / l, (6 - 12 * x) / l**2, (6 * x - 2) / l])


def forces(case, l, q):
    """Gradient of the strain energy of an element with the coordinates q, real or complex."""
    result = [0] * 12
    green = case["strain"] == "green-geometric"

    def add(derivatives, vector, factor):
        for k, d in enumerate(derivatives):
            for i in range(3):
                result[3 * k + i] += factor * d * vector[i]

    def at(derivatives):
        return [sum(d * q[3 * k + i] for k, d in enumerate(derivatives)) for i in range(3)]

    for x, weight in GAUSS[5]:
        first, _ = shapes(x, l)
        a = at(first)
        stretch2 = dot(a, a)
        add(first, a, weight * l * case["EA"] * (0.5 * (stretch2 - 1) if green else 1 - 1 / stretch2**0.5))
    power = 3 if green else 2  # κ² = (a²b² - (a·b)²) / (a²)^power
    for x, weight in GAUSS[3]:
        first, second = shapes(x, l)
        a, b = at(first), at(second)
        aa, bb, ab = dot(a, a), dot(b, b), dot(a, b)
        turn = aa * bb - ab * ab
        scale = weight * l * case["EA"] * case["I"] / aa**power
        add(first, a, scale * (bb - power * turn / aa))
        add(first, b, -scale * ab)
        add(second, b, scale * aa)
        add(second, a, -scale * ab)
    return result


def free_directions(case):
    """The changes of the coordinates that the supports leave, each a list of places and factors."""
    nodes = case["elements"] + 1
    free = []
    for node in range(nodes):
        support = case["first"] if node == 0 else case["last"] if node == nodes - 1 else "free"
        if support == "free":
            free += [[(6 * node + i, 1.0)] for i in range(3)]
        if support == "clamped":
            free.append([(6 * node + 3 + i, case["direction"][i]) for i in range(3)])
        else:
            free += [[(6 * node + 3 + i, 1.0)] for i in range(3)]
    return free


def assembled(case, q):
    """Forces that are left, and the stiffness."""
    elements, step = case["elements"], 1e-30
    l = 1 / elements
    left = [0.0] * len(q)
    K = [[0.0] * len(q) for _ in q]
    for e in range(elements):
        own = q[6 * e:6 * e + 12]
        for i, f in enumerate(forces(case, l, own)):
            left[6 * e + i] -= f
        for j in range(12):
            shifted = list(own)
            shifted[j] += 1j * step
            for i, f in enumerate(forces(case, l, shifted)):
                K[6 * e + i][6 * e + j] += f.imag / step
        for k, share in enumerate([l / 2, l * l / 12, l / 2, -l * l / 12]):
            for i in range(3):
                left[6 * e + 3 * k + i] += share * case["gravity"][i]
    for i in range(3):
        left[6 * elements + i] += case["force"][i]
    return left, K


def is_definite(K):
    """By Cholesky's factors of a matrix with ones on its diagonal, raised a little."""
    size = len(K)
    if any(K[i][i] <= 0 for i in range(size)):
        return False
    L = [[0.0] * size for _ in range(size)]
    for i in range(size):
        for j in range(i + 1):
            scaled = K[i][j] / math.sqrt(K[i][i] * K[j][j]) + (1e-9 if i == j else 0)
            rest = scaled - sum(L[i][k] * L[j][k] for k in range(j))
            if i == j:
                if rest <= 0:
                    return False
                L[i][i] = math.sqrt(rest)
            else:
                L[i][j] = rest / L[j][j]
    return True


def drawn(number):
    draw = random.Random(number)
    way = [draw.gauss(0, 1) for _ in range(3)]
    direction = [x / math.sqrt(dot(way, way)) for x in way]
    first, last = draw.choice([("clamped", "free"), ("clamped", "free"), ("pinned", "pinned"), ("clamped", "pinned"),
                               ("pinned", "clamped"), ("clamped", "clamped")])
    I, EI = 10**draw.uniform(-7, -0.5), 10**draw.uniform(-6, 6)
    size = 10**draw.uniform(-1, 2) * EI
    along = draw.random() < 0.3  # pressed almost along the axis

    def load():
        if along:
            return [size * (-x + 1e-3 * draw.gauss(0, 1)) for x in direction]
        return [size * draw.gauss(0, 1) for _ in range(3)]

    return {"EA": EI / I, "I": I, "elements": draw.choice([2, 3, 4, 6, 8]), "direction": direction, "first": first,
            "last": last, "strain": draw.choice(["green-geometric", "engineering-material"]),
            "gravity": load() if last != "free" or draw.random() < 0.6 else [0, 0, 0],
            "force": load() if last == "free" else [0, 0, 0], "step": draw.choice([1, 0.5, 0.2, 0.1, 0.07])}


def judged(plumb, case):
    nodes = case["elements"] + 1
    names = [(f"{quantity[0]}{k}", k / case["elements"], quantity) for k in range(nodes)
             for quantity in ("position", "slope")]
    with tempfile.TemporaryDirectory() as folder:
        file, table = pathlib.Path(folder) / "case.toml", pathlib.Path(folder) / "probes.csv"
        file.write_text(CASE.format(**case) + "".join(
            PROBE.format(name=name, at=at, quantity=quantity) for name, at, quantity in names))
        done = subprocess.run([plumb, "solve", file, "--json", "--quiet", "--csv", table], capture_output=True, text=True)
        if done.returncode not in (0, 4):
            sys.exit(f"{case}\n{done.stderr}")
        result = json.loads(done.stdout)
        if result["outcome"] != "completed":
            return result["outcome"], result["message"]
        q = [float(x) for x in list(csv.reader(table.open()))[-1][1:]]
    left, K = assembled(case, q)
    free = free_directions(case)
    reduced = [[sum(a * b * K[i][j] for i, a in row for j, b in column) for column in free] for row in free]
    residual = max(abs(sum(a * left[i] for i, a in row)) for row in free)
    load = math.sqrt(dot(case["gravity"], case["gravity"])) + math.sqrt(dot(case["force"], case["force"]))
    round_off = 1e-14 * max(map(abs, (x for row in K for x in row)))
    if not residual <= 1e-5 * load + round_off:
        return "not in equilibrium", f"a force of {residual / load:.3g} of the load is left"
    if not is_definite(reduced):
        return "unstable", "the stiffness is not positive definite"
    return "right", f"{residual / load:.3g} of the load is left"


def main():
    plumb = sys.argv[1] if len(sys.argv) > 1 else "build/release/plumb"
    cases = int(sys.argv[2]) if len(sys.argv) > 2 else 500
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    counts = collections.Counter()
    for number in range(first, first + cases):
        case = drawn(number)
        verdict, why = judged(plumb, case)
        counts[verdict] += 1
        if verdict != "right":
            print(f"{number:4} {case['first']}, {case['last']}, {verdict}: {why}", flush=True)
    for verdict, count in counts.most_common():
        print(f"{count:5} {verdict}")
    return 1 if counts["unstable"] + counts["not in equilibrium"] else 0


if __name__ == "__main__":
    sys.exit(main())
