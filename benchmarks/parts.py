#!/usr/bin/env python3
"""What runs in parts cost, and whether they survive being killed.

    benchmarks/parts.py SMAT_BATCH PROJECT states [AZIMUTH_STEP ELEVATION_STEP]
        one table of 4 bands and 3 power settings against one run a band and state
    benchmarks/parts.py SMAT_BATCH PROJECT shards [AZIMUTH_STEP ELEVATION_STEP]
        two and four shards against one run, each with one thread; two of them side by side, in turns with it
    benchmarks/parts.py SMAT_BATCH PROJECT kills [COUNT] [SEED]
        kills a table at random moments, goes on with it and compares the bytes

Seconds of the processor do not depend on what else a machine does, seconds of the clock do: the load is told, too.
"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

program, project, what = sys.argv[1:4]
numbers = [float(word) for word in sys.argv[4:]]
bands = ["3-5", "3.5-4.2", "4.4-5", "8-12"]
powers = ["0.3", "0.7", "1"]


def table(out, *more):
    return [program, "table", project, "--out", str(out), *more]


def grid():
    azimuth, elevation = numbers or (5.0, 5.0)
    return [f"--azimuth-step={azimuth:g}", f"--elevation-step={elevation:g}"]


class Run:
    """A command with its seconds of processor and clock."""

    def __init__(self, command):
        self.began = time.monotonic()
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def end(self):
        error = self.process.stderr.read()
        _, status, usage = os.wait4(self.process.pid, 0)
        self.process.returncode = os.waitstatus_to_exitcode(status)
        self.clock_s = time.monotonic() - self.began
        self.cpu_s = usage.ru_utime + usage.ru_stime
        if self.process.returncode:
            sys.exit(error.decode())
        return self


def told(name, runs):
    print(f"{name}: {sum(r.cpu_s for r in runs):.1f} s of processor, {max(r.clock_s for r in runs):.1f} s of clock, "
          f"load {os.getloadavg()[0]:.1f}", flush=True)
    return sum(r.cpu_s for r in runs)


def withoutCommand(file):
    return b"".join(line for line in file.read_bytes().splitlines(True) if not line.startswith(b"# command"))


def states(folder):
    one = told("one table of 4 bands and 3 states",
               [Run(table(folder / "all.csv", *grid(), "--band", ",".join(bands), "--powers", ",".join(powers))).end()])
    each = [Run(table(folder / "one.csv", *grid(), "--band", band, "--powers", power)).end()
            for power in powers for band in bands]
    print(f"12 runs take {told('a run a band and state', each) / one:.1f} times the processor time", flush=True)


def shards(folder):
    def shard(i, n):
        return Run(table(folder / "s.csv", *grid(), "--threads=1", "--shard", f"{i}/{n}"))

    ratios = []
    for turn in range(3):
        one = Run(table(folder / "one.csv", *grid(), "--threads=1")).end()
        whole = told(f"one run, turn {turn + 1}", [one])
        pair = [shard(i, 2) for i in (1, 2)]
        pair = [run.end() for run in pair]
        cpu = told("two shards side by side", pair)
        ratios.append((max(r.clock_s for r in pair) / one.clock_s, cpu / whole))
        four = told("four shards in turn", [shard(i, 4).end() for i in (1, 2, 3, 4)])
        print(f"clock of two {ratios[-1][0]:.2f}, processor of two {ratios[-1][1]:.2f}, of four {four / whole:.2f}",
              flush=True)
        parts = sorted(folder.glob("s.csv.part*of4"))
        subprocess.run([program, "merge", *map(str, parts), "--out", str(folder / "s.csv")], check=True,
                       stdout=subprocess.DEVNULL)
        print("same bytes" if withoutCommand(folder / "s.csv") == withoutCommand(folder / "one.csv") else "OTHER BYTES",
              flush=True)


def kills(folder):
    small = ["--azimuth-step=15", "--elevation-step=15", "--width=64", "--height=64", "--errors=sum"]
    whole = Run(table(folder / "one.csv", *small)).end()
    count = int(numbers[0]) if numbers else 100
    dice = random.Random(int(numbers[1]) if len(numbers) > 1 else 1)
    done = same = gone = finished = 0
    while done < count:
        out = folder / "k.csv"
        out.unlink(missing_ok=True)
        while done < count:
            run = subprocess.Popen(table(out, *small, "--resume"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                run.wait(timeout=dice.uniform(0.0, 0.8 * whole.clock_s))
                finished += 1
                break
            except subprocess.TimeoutExpired:
                run.send_signal(signal.SIGKILL)
                run.wait()
                done += 1
                gone += (folder / "k.csv.cases").exists()
        if not out.exists():
            Run(table(out, *small, "--resume")).end()
        if withoutCommand(out) != withoutCommand(folder / "one.csv"):
            sys.exit(f"other bytes after {done} kills")
        same += 1
    print(f"{done} kills, {gone} with cases behind them; {same} tables with the bytes of one undisturbed", flush=True)


with tempfile.TemporaryDirectory() as name:
    {"states": states, "shards": shards, "kills": kills}[what](pathlib.Path(name))
