#!/usr/bin/env python3
"""Stops runs at random moments and checks that the whole result of before stays.

    benchmarks/stops.py SMAT_BATCH PROJECT FOLDER [COUNT]

Makes a whole result of a sweep in FOLDER, then begins COUNT (200) longer runs into the same file.
Each is ended after a random time by SIGINT, SIGTERM or SIGKILL. After each of them the file must
have the bytes of before, or be whole with exit code 0; a partial result must say so of itself.
Prints how each kind of end came out; the exit code is 1 where a result was lost.
"""

import collections
import pathlib
import random
import signal
import subprocess
import sys
import time


def command(program, project, out, step):
    return [program, "polar", project, "--step", str(step), "--width", "64", "--height", "64",
            "--out", str(out)]


def main():
    program, project, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 200
    folder.mkdir(parents=True, exist_ok=True)
    result, partial = folder / "table.csv", folder / "table.partial.csv"
    subprocess.run(command(program, project, result, 30), check=True, stdout=subprocess.DEVNULL)
    begun = time.monotonic()
    subprocess.run(command(program, project, folder / "long.csv", 0.5), check=True,
                   stdout=subprocess.DEVNULL)
    longest_s = time.monotonic() - begun
    ends, lost = collections.Counter(), 0
    chance = random.Random(48)
    for _ in range(count):
        before = result.read_bytes()
        process = subprocess.Popen(command(program, project, result, 0.5),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(chance.uniform(0.0, 1.1 * longest_s))
        kind = chance.choice([signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
        process.send_signal(kind)
        code = process.wait()
        after = result.read_bytes()
        is_whole = b"state: complete" in after and (after == before or code in (0, -signal.SIGKILL))
        if after != before and code == 0:
            ends["whole before the signal"] += 1
        else:
            ends[kind.name + ", exit code " + str(code)] += 1
        if not is_whole or (partial.exists() and b"state: partial" not in partial.read_bytes()):
            lost += 1
            print("lost:", kind.name, code)
    for end, times in sorted(ends.items()):
        print(f"{times:5} {end}")
    left = sorted(one.name for one in folder.iterdir())
    print("beside the result:", ", ".join(left))
    print(f"{lost} of {count} lost")
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
