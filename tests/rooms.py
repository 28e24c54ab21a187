#!/usr/bin/env python3
"""Holds the includes of engine, render and report against the order of their rooms.

    rooms.py [ROOT]

Each room may include itself and what stands before it in its folder; of a folder within a room, what stands in the room
itself too, but no neighbour. Prints every include that runs back up and ends with 1 where there is one.
"""

import pathlib
import re
import sys

# From the ground up. A folder that is not listed within a room is a room of its own beside its neighbours: it may be
# included by no other of the same room, unless it is listed here before them.
ROOMS = {
    "engine": "base case kernels model integrate read run study",
    "render": "image gl plot scene",
    "report": "base verdict figure exports document page diff index study library program",
}
TOPS = ["engine", "render", "report"]
WITHIN = {"engine/study": ["reference"], "engine/integrate": [], "report/study": []}
# What lists the folders of its room, and so may know of all of them.
REGISTRIES = {"engine/integrate/methods/method_registry.cpp": "engine/integrate"}


def place(path):
    top, *rest = path.split("/")[:-1]
    return top, (rest[0] if rest else None), "/".join(rest[1:])


def fault(source, target):
    """Why `source` must not include `target`, or nothing."""
    (top, room, inner), (to_top, to_room, to_inner) = place(source), place(target)
    if to_top not in TOPS:
        return f"{to_top}/ is no part of the program"
    if TOPS.index(top) != TOPS.index(to_top):
        return f"{top} stands below {to_top}" if TOPS.index(top) < TOPS.index(to_top) else None
    if room is None:  # main.cpp
        return None
    order = ROOMS[top].split()
    for name, whose in ((room, source), (to_room, target)):
        if name not in order:
            return f"{whose} is in no room of {top}"
    if order.index(room) < order.index(to_room):
        return f"{top}/{room} stands below {top}/{to_room}"
    if room != to_room or inner == to_inner or not to_inner:
        return None
    if REGISTRIES.get(source) == f"{top}/{room}":
        return None
    listed = WITHIN.get(f"{top}/{room}", [])
    if to_inner in listed and (inner not in listed or listed.index(to_inner) < listed.index(inner)) and inner:
        return None
    return f"{top}/{room}/{inner or ''} may not know of {top}/{room}/{to_inner}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    found = seen = 0
    for top in TOPS:
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            source = path.relative_to(root).as_posix()
            for number, line in enumerate(path.read_text().splitlines(), 1):
                include = re.match(r'\s*#include "([^"]+)"', line)
                if not include:
                    continue
                seen += 1
                target = include[1]
                why = fault(source, target) if (root / target).is_file() else "there is no such file"
                if why:
                    found += 1
                    print(f"{source}:{number}: includes {target}: {why}")
    print(f"{seen} includes, {found} against the order of the rooms")
    return 1 if found or seen == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
