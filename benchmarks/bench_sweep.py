#!/usr/bin/env python3
"""Times of whole runs of smat-batch: sweeps in several bands, Monte Carlo, a simulation.

    bench_sweep BEFORE [AFTER] [--release] [--repeat 3] [--only polar --only range]
                [--aspects 360] [--bands 1,10,100] [--source DIR] [--before-options=WORDS]
                [--after-options=WORDS]

With two programs each case is run by both in alternation, and ratios before / after of the least and
the median wall time are printed; with one program its times alone. For every case follow processor
time, peak memory (resident, of the child) and the stages of `--timing` of its quickest run.

A program that takes one band a run is asked for the first, the middle and the last of N bands; their
mean times N stands for N runs, which the table says ("x N"). Its peak memory is that of one run.

--release runs, in place of all that, the four that versions are compared by: the polar sweep of the
README, that of the heron, Monte Carlo with 256 samples and the self-test, with ratios after / before of
processor time (user and system; of the least, and the median of pairs that ran one after the other)
and their geometric mean. Processor time tells more than the clock on a machine that others use, too.
There BEFORE and AFTER may be folders with bin/smat-batch and the libraries it finds in lib.

Where two programs do not compute the same by default, options make them: words that are added to
every command of one of them. A program of before shadows and light between surfaces is compared with
one of now as the published figures were, in air whose cost is not what is measured:

    bench_sweep BEFORE AFTER
        --before-options="--atmosphere ../resources/atmospheres/haze-23km.csv"
        --after-options="--atmosphere ../resources/atmospheres/haze-23km.csv
                         --set render.shadows=off --set render.bounces=0"

The programs run in the folder of the sample projects, from which names of files in options start,
and write to a temporary folder. The standard library is all that is needed.
"""

import argparse
import math
import os
import pathlib
import re
import shlex
import statistics
import subprocess
import sys
import tempfile
import time

STAGE = re.compile(r"^(.+?)\s+(\d*)\s+([0-9.]+)\s+([0-9.]+)$")


class Failure(Exception):
    """What a program said before it ended with an error."""


class Run:
    """One run: wall and processor time in s, peak memory in MiB, seconds by stage."""

    def __init__(self, wall_s, processor_s, peak_MiB, stages):
        self.wall_s = wall_s
        self.processor_s = processor_s
        self.peak_MiB = peak_MiB
        self.stages = stages

    @staticmethod
    def mean_of(runs, times):
        """`times` runs that cost what these do on average, one after the other."""
        def scaled(values):
            return times * statistics.fmean(values)
        stages = {name: scaled([run.stages.get(name, 0.0) for run in runs])
                  for name in runs[0].stages}
        return Run(scaled([run.wall_s for run in runs]), scaled([run.processor_s for run in runs]),
                   max(run.peak_MiB for run in runs), stages)


def stages_of(text):
    """{"drawing": 0.12, ...} of a table of --timing, without its sum."""
    stages = {}
    inside = False
    for line in text.splitlines():
        if line.split() == ["stage", "calls", "s", "%"]:
            inside = True
            continue
        found = STAGE.match(line) if inside else None
        if found and found.group(1).strip() != "sum":
            stages[found.group(1).strip()] = float(found.group(3))
    return stages


def run(program, arguments, folder, timing=True, environment=None):
    """One run of `program --timing` in `folder`; Failure unless it ends with 0."""
    words = ["--timing"] if timing else []
    with tempfile.TemporaryFile() as said, tempfile.TemporaryFile() as printed:
        start = time.perf_counter()
        child = subprocess.Popen([program, *arguments, *words], cwd=folder, stdout=printed,
                                 stderr=said, env=environment)
        _, status, usage = os.wait4(child.pid, 0)
        wall_s = time.perf_counter() - start
        child.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read().decode(errors="replace")
    if child.returncode != 0:
        raise Failure(f"{program} {' '.join(arguments)} ended with {child.returncode}:\n{text}")
    return Run(wall_s, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, stages_of(text))


def bands_of(number):
    """Equal parts of 3 to 5 um."""
    edges = [round(3.0 + 2.0 * i / number, 9) for i in range(number + 1)]
    return [f"{low:g}-{high:g}" for low, high in zip(edges, edges[1:])]


class Program:
    """A smat-batch, and whether it takes several bands in one run."""

    def __init__(self, path, options, samples):
        path = pathlib.Path(path).resolve()
        self.path = str(path / "bin" / "smat-batch" if path.is_dir() else path)
        # Of the release cases: nothing that one run keeps helps the next.
        self.environment = dict(os.environ, SMAT_CACHE="")
        if path.is_dir():
            self.environment["LD_LIBRARY_PATH"] = str(path / "lib")
        self.options = options
        self.samples = samples
        try:
            run(self.path, ["polar", "turboprop4/turboprop4.smat", "--dry-run", "--band=3-4,4-5",
                            *options], samples)
            self.takes_bands = True
        except Failure:
            self.takes_bands = False

    def run(self, arguments, bands, out):
        arguments = [*arguments, *self.options]
        if not bands:
            return run(self.path, [*arguments, "--out", out], self.samples)
        if self.takes_bands or len(bands) == 1:
            return run(self.path, [*arguments, "--band=" + ",".join(bands), "--out", out],
                       self.samples)
        chosen = [bands[0], bands[len(bands) // 2], bands[-1]]
        return Run.mean_of([run(self.path, [*arguments, "--band=" + band, "--out", out],
                                self.samples) for band in chosen], len(bands))

    def note(self, bands):
        several = bands and len(bands) > 1
        return f" (x {len(bands)})" if several and not self.takes_bands else ""


def cases_of(options):
    """[(name, arguments, bands or None, name of the result)]"""
    project = "turboprop4/turboprop4.smat"
    cases = []
    for number in options.bands:
        word = f"{number} band" + ("" if number == 1 else "s")
        cases.append((f"polar, {options.aspects} aspects, {word}",
                      ["polar", project, f"--step={360.0 / options.aspects:.12g}"],
                      bands_of(number), "polar.csv"))
        cases.append((f"range, 40 ranges, {word}",
                      ["range", project, "--points=40", "--from=1000", "--to=10000"],
                      bands_of(number), "range.csv"))
    # A time analysis whose step is longer than its span has one case.
    one_aspect = ["--kind=time", "--set=time.from=0", "--set=time.to=0.5", "--set=time.step=1",
                  "--phases=1"]
    cases += [
        ("montecarlo, 1024 draws of 36 aspects",
         ["montecarlo", project, "--analysis=polar", "--samples=1024", "--phases=1"], None,
         "draws.csv"),
        ("montecarlo, 10000 band sums of one aspect",
         ["montecarlo", project, *one_aspect, "--samples=10000"], None, "sums.csv"),
        ("montecarlo, ranking of the sample's README",
         ["montecarlo", project, "--analysis=polar", "--ranking"], None, "bands.csv"),
        ("simulate, flyby of two aircraft, two sensors",
         ["simulate", "flyby/flyby.json", "--format=exr"], None, "frames"),
    ]
    return [case for case in cases
            if not options.only or any(case[0].startswith(word) for word in options.only)]


def release_cases():
    """[(name, arguments, name of the result or None)]"""
    project = "turboprop4/turboprop4.smat"
    return [
        ("polar of the README", ["polar", project], "polar.csv"),
        ("polar of the heron", ["polar", "heron/heron.smat", "--set=environment.terrain="], "polar.csv"),
        ("montecarlo, 256 samples",
         ["montecarlo", project, "--analysis=polar", "--samples=256"], "montecarlo.csv"),
        ("selftest", ["selftest"], None),
    ]


def measure_release(programs, options):
    """Processor time of the release cases; their geometric mean where there are two programs."""
    ratios = []
    width = max(len(name) for name, _, _ in release_cases())
    print(f"{'':<{width}}     before [s]  after [s]   least  median" if len(programs) == 2 else
          f"{'':<{width}}   processor [s]")
    for name, arguments, result in release_cases():
        if options.only and not any(name.startswith(word) for word in options.only):
            continue
        seconds = [[] for _ in programs]
        for repetition in range(options.repeat):
            order = range(len(programs)) if repetition % 2 == 0 else reversed(range(len(programs)))
            for i in order:
                with tempfile.TemporaryDirectory() as out:
                    words = ["--out", os.path.join(out, result)] if result else []
                    one = run(programs[i].path, [*arguments, *programs[i].options, *words],
                              programs[i].samples, False, programs[i].environment)
                    seconds[i].append(one.processor_s)
        if len(programs) == 1:
            print(f"{name:<{width}}   {min(seconds[0]):13.2f}")
        else:
            least = min(seconds[1]) / min(seconds[0])
            pairs = statistics.median(b / a for a, b in zip(*seconds))
            ratios.append((least, pairs))
            print(f"{name:<{width}}   {min(seconds[0]):12.2f} {min(seconds[1]):10.2f}   "
                  f"{least:5.3f}   {pairs:5.3f}")
        sys.stdout.flush()
    if ratios:
        means = [math.exp(statistics.fmean(math.log(one) for one in column))
                 for column in zip(*ratios)]
        print(f"{'geometric mean':<{width}}   {'':12} {'':10}   {means[0]:5.3f}   {means[1]:5.3f}")


def least_and_median(runs):
    walls = [one.wall_s for one in runs]
    return min(walls), statistics.median(walls)


def print_stages(programs, runs):
    """Stages of each program's quickest run, side by side."""
    best = [min(of_one, key=lambda one: one.wall_s) for of_one in runs]
    names = list(dict.fromkeys(name for one in best for name in one.stages))
    for name in names:
        seconds = [one.stages.get(name, 0.0) for one in best]
        if max(seconds) < 0.0005:
            continue
        line = f"    {name:<24}" + "".join(f"{value:>10.3f} s" for value in seconds)
        if len(programs) == 2 and min(seconds) > 0.0:
            line += f"   x {seconds[0] / seconds[1]:.2f}"
        print(line)


def measure(case, programs, options):
    name, arguments, bands, result = case
    runs = [[] for _ in programs]
    for repetition in range(options.repeat):
        # Who begins changes, so that a drift of the machine hits both alike.
        order = range(len(programs)) if repetition % 2 == 0 else reversed(range(len(programs)))
        for i in order:
            with tempfile.TemporaryDirectory() as out:
                runs[i].append(programs[i].run(arguments, bands, os.path.join(out, result)))
    print(f"\n{name}")
    for label, program, of_one in zip(("before", "after"), programs, runs):
        least, median = least_and_median(of_one)
        print(f"  {label if len(programs) == 2 else 'time':<7} least {least:9.3f} s   median "
              f"{median:9.3f} s   processor {min(one.processor_s for one in of_one):9.3f} s   peak "
              f"{max(one.peak_MiB for one in of_one):7.1f} MiB{program.note(bands)}")
    if len(programs) == 2:
        (least_a, median_a), (least_b, median_b) = map(least_and_median, runs)
        print(f"  ratio   least {least_a / least_b:9.2f}     median {median_a / median_b:9.2f}")
    print_stages(programs, runs)
    sys.stdout.flush()


def checkout():
    """The folder with the samples above this script, which also lies in build/PRESET/bin."""
    above = pathlib.Path(__file__).resolve().parents
    return next((one for one in above if (one / "samples" / "turboprop4").is_dir()), above[0])


def main():
    parser = argparse.ArgumentParser(
        prog="bench_sweep", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", metavar="BEFORE", help="a smat-batch")
    parser.add_argument("after", metavar="AFTER", nargs="?", help="another one to compare it with")
    parser.add_argument("--release", action="store_true",
                        help="processor time of the four runs that versions are compared by")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each case and program (3)")
    parser.add_argument("--only", action="append", metavar="WORD",
                        help="cases whose name begins so: polar, range, montecarlo, simulate; may "
                             "be given more than once (with --release also selftest)")
    parser.add_argument("--aspects", type=int, default=360, help="of the polar cases (360)")
    parser.add_argument("--bands", default="1,10,100", metavar="LIST",
                        help="numbers of bands (1,10,100)")
    parser.add_argument("--source", type=pathlib.Path, default=checkout(),
                        help="checkout whose samples are used (the one this script lies in)")
    for which in ["before", "after"]:
        parser.add_argument(f"--{which}-options", type=shlex.split, default=[], metavar="WORDS",
                            help=f"added to every command of {which.upper()}; write "
                                 f"--{which}-options=\"--set KEY=VALUE\"")
    options = parser.parse_args()
    if options.after_options and not options.after:
        parser.error("--after-options: there is no AFTER")
    try:
        options.bands = [int(word) for word in options.bands.split(",")]
    except ValueError:
        parser.error(f"--bands: {options.bands}, expected whole numbers separated by commas")
    if options.repeat < 1 or options.aspects < 2 or min(options.bands) < 1:
        parser.error("expected --repeat >= 1, --aspects >= 2 and --bands >= 1")
    samples = options.source / "samples"
    if not (samples / "turboprop4").is_dir():
        parser.error(f"--source: there is no {samples / 'turboprop4'}")
    cases = cases_of(options)
    if not cases and not options.release:
        parser.error(f"--only: {', '.join(options.only)}, expected the beginning of a case's name")
    try:
        programs = [Program(path, words, samples)
                    for path, words in ((options.before, options.before_options),
                                        (options.after, options.after_options)) if path]
        if options.release:
            measure_release(programs, options)
            return 0
        for case in cases:
            measure(case, programs, options)
    except (Failure, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
