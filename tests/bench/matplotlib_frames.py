"""Frames of a finished run by matplotlib (3D lines, Agg), for comparison: python3 matplotlib_frames.py PROBES FRAMES.

A straightforward script: the cable as a line through its probes, the tip's trail, the time as the title.
"""

import csv
import sys
import tempfile
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

with open(sys.argv[1], newline="") as file:
    rows = list(csv.reader(file))
table = [[float(cell) for cell in row] for row in rows[1:]]
points = (len(rows[0]) - 1) // 3
count = int(sys.argv[2])

figure = plt.figure(figsize=(9.6, 5.4), dpi=100)
with tempfile.TemporaryDirectory() as folder:
    started = time.perf_counter()
    for k in range(count):
        row = table[k % len(table)]
        axes = figure.add_subplot(projection="3d")
        xyz = [[0.0] + row[1 + c :: 3] for c in range(3)]
        axes.plot(xyz[0], xyz[2], xyz[1], linewidth=3)
        trail = table[max(0, k % len(table) - 32) : k % len(table) + 1]
        axes.plot([r[-3] for r in trail], [r[-1] for r in trail], [r[-2] for r in trail])
        axes.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1), title=f"t = {row[0]:.2f} s")
        figure.savefig(f"{folder}/{k:04}.png")
        figure.clear()
    seconds = time.perf_counter() - started
print(f"matplotlib: {count / seconds:.1f} frames a second of 960 x 540")
