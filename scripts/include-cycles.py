#!/usr/bin/env python3
"""Rooms that include each other: include-cycles.py [--folders] [--limit NUMBER] [TREE]

A room is a header with its source, the sources beside it that do a part of it (BeerLambertCk.cpp, which has no header
of its own, belongs to BeerLambert.h) and its hidden header (RendererImpl.h). Of the product in TREE, this one where
none is named, prints every group of rooms, each of which leads to each by includes, that has more than NUMBER of them (3),
with the includes inside it, and ends with 1 where there is one. --folders prints, too, which folders' headers include
each other, for information.
"""
import argparse
import os
import re
import sys

parser = argparse.ArgumentParser()
parser.add_argument("--folders", action="store_true")
parser.add_argument("--limit", type=int, default=3)
parser.add_argument("tree", nargs="?", default=os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
asked = parser.parse_args()
sys.setrecursionlimit(10000)
product = ("irsg", "smatcore", "gui", "apps", "tools")


def files():
    for top in product:
        for folder, _, names in os.walk(os.path.join(asked.tree, top)):
            for name in names:
                if name.endswith((".h", ".cpp")):
                    yield os.path.relpath(os.path.join(folder, name), asked.tree)


def room_of(path, headers):
    """The path without extension of the header that a file belongs to, or else of the file."""
    stem, extension = os.path.splitext(path)
    hidden = extension == ".h" and stem.endswith("Impl")
    if stem + ".h" in headers and not hidden:
        return stem
    folder, name = os.path.split(stem)
    words = re.findall(r"[A-Z][a-z0-9]*|[A-Z]+(?![a-z])|[a-z0-9]+", name)
    for count in range(len(words) - 1, 0, -1):
        owner = os.path.join(folder, "".join(words[:count]))
        if owner + ".h" in headers:
            return owner
    return stem


def includes(path):
    with open(os.path.join(asked.tree, path), encoding="utf-8") as source:
        for number, line in enumerate(source, 1):
            if match := re.match(r'\s*#\s*include\s+"([^"]+)"', line):
                yield number, match[1]


def groups(graph):
    """The strongly connected components of more than one node (Tarjan), the largest first."""
    index, low, stack, on_stack, found = {}, {}, [], set(), []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        on_stack.add(node)
        for other in sorted(graph[node]):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in on_stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            group = set()
            while node not in group:
                group.add(stack.pop())
            on_stack.difference_update(group)
            found.append(group)

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return sorted((group for group in found if len(group) > 1), key=lambda group: (-len(group), min(group)))


def tell(what, group, places):
    print(f"{len(group)} {what} include each other: {', '.join(sorted(group))}")
    for (here, there), lines in sorted(places.items()):
        if here in group and there in group:
            print("\n".join("    " + line for line in lines))


known = sorted(files())
if not known:
    sys.exit(f"{asked.tree}: no sources of {', '.join(product)}")
headers = {path for path in known if path.endswith(".h")}
rooms = {path: room_of(path, headers) for path in known}
graph = {room: set() for room in rooms.values()}
folders = {os.path.dirname(path): set() for path in known}
edges, folder_edges = {}, {}
for path in known:
    for line, included in includes(path):
        if included not in rooms:
            continue
        here, there = rooms[path], rooms[included]
        if here != there:
            graph[here].add(there)
            edges.setdefault((here, there), []).append(f"{path}:{line}: {included}")
        here, there = os.path.dirname(path), os.path.dirname(included)
        if here != there and path.endswith(".h"):
            folders[here].add(there)
            folder_edges.setdefault((here, there), []).append(f"{path}:{line}: {included}")

if asked.folders:
    for group in groups(folders):
        tell("folders, by their headers,", group, folder_edges)
large = [group for group in groups(graph) if len(group) > asked.limit]
for group in large:
    tell("rooms", group, edges)
sys.exit(1 if large else 0)
