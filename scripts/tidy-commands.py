#!/usr/bin/env python3
"""Compile commands for clang-tidy: tidy-commands.py BASE COMPILE_COMMANDS FOLDER

Writes FOLDER/compile_commands.json with a command for each source that differs from the commit BASE, as its target
compiles it, but without precompiled headers and flags of gcc alone, and FOLDER/lines.json, the lines that differ, as
--line-filter takes them; prints the sources, a line each.
"""
import json
import os
import re
import shlex
import subprocess
import sys

root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
base, commands_file, folder = sys.argv[1:4]
commands = json.load(open(commands_file))

by_file, of_unity = {}, {}
for command in commands:
    by_file.setdefault(os.path.realpath(command["file"]), command)
    if "/Unity/" in command["file"] and os.path.exists(command["file"]):
        for included in re.findall(r'#include "([^"]+)"', open(command["file"]).read()):
            of_unity.setdefault(os.path.realpath(included), command)

lines = {}
difference = ["git", "-C", root, "diff", "-U0", "--diff-filter=d", base, "--", "*.cpp", "*.h"]
for line in subprocess.run(difference, check=True, capture_output=True, text=True).stdout.splitlines():
    if line.startswith("+++ b/"):
        name = line[6:]
    elif match := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
        first, count = int(match[1]), int(match[2] or 1)
        if count > 0:
            lines.setdefault(name, []).append([first, first + count - 1])

written = []
for source in sorted(name for name in lines if name.endswith(".cpp")):
    path = os.path.join(root, source)
    command = by_file.get(os.path.realpath(path)) or of_unity.get(os.path.realpath(path))
    if command is None:
        continue
    words = shlex.split(command["command"])
    kept, skip = ["clang++-16"], False
    for word in words[next(i for i, w in enumerate(words) if re.search(r"(g|clang)\+\+|/c\+\+$", w)) + 1 :]:
        if skip:
            skip = False
        elif word in ("-o", "-include", "-c", "-MF", "-MT"):
            skip = True
        elif not re.fullmatch(r"-fpch-preprocess|-Winvalid-pch|-W.*|-Werror|-MD", word):
            kept.append(word)
    written.append({"directory": command["directory"], "file": path, "arguments": kept + ["-c", path]})
    print(source)
json.dump(written, open(os.path.join(folder, "compile_commands.json"), "w"))
json.dump([{"name": name, "lines": ranges} for name, ranges in lines.items()], open(os.path.join(folder, "lines.json"), "w"))
