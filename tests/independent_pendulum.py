#!/usr/bin/env python3
"""The cable pendulum of cases/bring_your_own.toml by other means than Plumb's, as a table for it to report on.

Point masses on straight elastic links, with elastic hinges between them, integrated by the classical Runge-Kutta
method. It shares no code with Plumb and needs nothing but Python. Usage: independent_pendulum.py > FILE.csv
"""

import math
import sys

LENGTH = 1.0  # m
AXIAL_STIFFNESS = 40.0  # EA, N
BENDING_STIFFNESS = 1.6e6 * 2.5e-5**2 / (4 * math.pi)  # EI of a circular section, N m²
MASS_PER_LENGTH = 8e-3  # kg/m
GRAVITY = -9.81  # m/s², along y
ROTATION = 4.0  # rad/s, about y
END = 2.0  # s

LINKS = 24
STEPS_PER_ROW = 16
ROWS = 250  # after the one at 0 s: one in 8 ms
SHARES = {"Quarter": 0.25, "Middle": 0.5, "Three quarters": 0.75, "Tip": 1.0}
PLACES = {place: round(share * LINKS) for place, share in SHARES.items()}


def set_up(links=LINKS, steps_per_row=STEPS_PER_ROW, end=END):
    """Another number of links, of steps and another end (s) than those above; rows stay as far apart."""
    global LINKS, STEPS_PER_ROW, END, ROWS, PLACES  # pylint: disable=global-statement
    ROWS = round(ROWS * end / END)
    LINKS, STEPS_PER_ROW, END = links, steps_per_row, end
    PLACES = {place: round(share * links) for place, share in SHARES.items()}


def accelerations(r):
    """Of all points, for their positions [x0, y0, z0, x1, …]; the first is held."""
    rest = LENGTH / LINKS
    force = [0.0] * len(r)
    before = None  # unit vector along the link before, and its length
    for k in range(LINKS):
        i = 3 * k
        dx, dy, dz = r[i + 3] - r[i], r[i + 4] - r[i + 1], r[i + 5] - r[i + 2]
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        stretch = length / rest
        # Green strain ε = (λ² − 1)/2: energy EA ε²/2 a unit length, so that the tension is EA ε λ.
        tension = AXIAL_STIFFNESS * 0.5 * (stretch * stretch - 1) * stretch
        ux, uy, uz = dx / length, dy / length, dz / length
        for j, u in ((0, ux), (1, uy), (2, uz)):
            force[i + j] += tension * u
            force[i + 3 + j] -= tension * u
        if before is not None:
            # Energy EI/(2 l) |u − w|² of the hinge between two unit vectors w and u.
            wx, wy, wz, earlier = before
            stiffness = BENDING_STIFFNESS / rest
            cosine = ux * wx + uy * wy + uz * wz
            a, b = stiffness / length, stiffness / earlier
            for j, u, w in ((0, ux, wx), (1, uy, wy), (2, uz, wz)):
                on_later = a * (w - cosine * u)
                on_earlier = b * (u - cosine * w)
                force[i + 3 + j] += on_later
                force[i + j] += on_earlier - on_later
                force[i - 3 + j] -= on_earlier
        before = (ux, uy, uz, length)
    mass = MASS_PER_LENGTH * rest
    result = [f / mass for f in force]
    for j in range(3):
        result[-3 + j] *= 2  # the last point carries half a link only
        result[j] = 0.0
    for k in range(1, LINKS + 1):
        result[3 * k + 1] += GRAVITY
    return result


def moved(x, rate, h):
    return [a + h * b for a, b in zip(x, rate)]


def step(r, v, h):
    a1 = accelerations(r)
    v2 = moved(v, a1, h / 2)
    a2 = accelerations(moved(r, v, h / 2))
    v3 = moved(v, a2, h / 2)
    a3 = accelerations(moved(r, v2, h / 2))
    v4 = moved(v, a3, h)
    a4 = accelerations(moved(r, v3, h))
    mean_v = [(p + 2 * q + 2 * s + t) / 6 for p, q, s, t in zip(v, v2, v3, v4)]
    mean_a = [(p + 2 * q + 2 * s + t) / 6 for p, q, s, t in zip(a1, a2, a3, a4)]
    return moved(r, mean_v, h), moved(v, mean_a, h)


def row(t, r):
    numbers = [f"{1000 * t:.6g}"]
    for node in PLACES.values():
        numbers += [f"{1000 * x:.6f}" for x in r[3 * node : 3 * node + 3]]
    return ",".join(numbers)


def write(file):
    r, v = [], []
    for k in range(LINKS + 1):
        x = LENGTH * k / LINKS
        r += [x, 0.0, 0.0]
        v += [0.0, 0.0, -ROTATION * x]
    print("Time [ms]," + ",".join(f"{place} {axis} [mm]" for place in PLACES for axis in "XYZ"), file=file)
    print(row(0.0, r), file=file)
    h = END / (ROWS * STEPS_PER_ROW)
    for k in range(1, ROWS + 1):
        for _ in range(STEPS_PER_ROW):
            r, v = step(r, v, h)
        print(row(END * k / ROWS, r), file=file)


if __name__ == "__main__":
    write(sys.stdout)
