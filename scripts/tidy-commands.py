#!/usr/bin/env python3
"""Compile commands for clang-tidy: tidy-commands.py BASE COMPILE_COMMANDS FOLDER

Writes FOLDER/compile_commands.json with commands for the sources that differ from the commit BASE, as their targets
compile them, but without precompiled headers and flags of gcc alone, and FOLDER/lines.json, the lines that differ, as
--line-filter takes them. Sources that a target compiles together are looked at together, which reads the headers they
share once. Prints what is to be looked at, a line each.
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys

root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
base, commands_file, folder = sys.argv[1:4]
commands = json.load(open(commands_file))

by_file, of_unity, place = {}, {}, {}
for command in commands:
    by_file.setdefault(os.path.realpath(command["file"]), command)
    if "/Unity/" in command["file"] and os.path.exists(command["file"]):
        for included in re.findall(r'#include "([^"]+)"', open(command["file"]).read()):
            of_unity.setdefault(os.path.realpath(included), command)
            place.setdefault(os.path.realpath(included), len(place))

lines = {}
difference = ["git", "-C", root, "diff", "-U0", "--diff-filter=d", base, "--", "*.cpp", "*.h"]
for line in subprocess.run(difference, check=True, capture_output=True, text=True).stdout.splitlines():
    if line.startswith("+++ b/"):
        name = line[6:]
    elif match := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
        first, count = int(match[1]), int(match[2] or 1)
        if count > 0:
            lines.setdefault(name, []).append([first, first + count - 1])

together = 25


def clang_command(command):
    words = shlex.split(command["command"])
    kept, skip = ["clang++-16"], False
    for word in words[next(i for i, w in enumerate(words) if re.search(r"(g|clang)\+\+|/c\+\+$", w)) + 1 :]:
        if skip:
            skip = False
        elif word in ("-o", "-include", "-c", "-MF", "-MT"):
            skip = True
        elif not re.fullmatch(r"-fpch-preprocess|-Winvalid-pch|-W.*|-Werror|-MD|--param=.*", word):
            kept.append(word)
    return kept


def config_folder(source):
    """Where a group of sources beside this one finds the checks that hold for it."""
    nearest = os.path.dirname(source)
    while not os.path.exists(os.path.join(nearest, ".clang-tidy")):
        nearest = os.path.dirname(nearest)
    path = os.path.normpath(os.path.join(folder, os.path.relpath(nearest, root)))
    os.makedirs(path, exist_ok=True)
    for config in {os.path.join(root, ".clang-tidy"), os.path.join(nearest, ".clang-tidy")}:
        shutil.copy(config, os.path.join(folder, os.path.relpath(config, root)))
    return path


written, groups = [], {}


def write(path, command):
    written.append({"directory": command["directory"], "file": path, "arguments": clang_command(command) + ["-c", path]})
    print(path)


for source in sorted(name for name in lines if name.endswith(".cpp")):
    path = os.path.join(root, source)
    known = os.path.realpath(path)
    if known in by_file:
        write(path, by_file[known])
    elif known in of_unity:
        groups.setdefault(of_unity[known]["file"], []).append(path)
for unity, paths in sorted(groups.items()):
    paths.sort(key=lambda path: place[os.path.realpath(path)])
    for first in range(0, len(paths), together):
        group = os.path.join(config_folder(paths[first]), f"group-{len(written)}.cpp")
        with open(group, "w") as file:
            file.writelines(f'#include "{path}"\n' for path in paths[first : first + together])
        write(group, of_unity[os.path.realpath(paths[first])])
json.dump(written, open(os.path.join(folder, "compile_commands.json"), "w"))
json.dump([{"name": name, "lines": ranges} for name, ranges in lines.items()], open(os.path.join(folder, "lines.json"), "w"))
