#!/usr/bin/env python3
"""Which source files take processor time, in per mille of each of some runs, and which of them are compiled lightly.

    benchmarks/profile_sources.py build/dev [--above SHARE]

The programs of the build folder need lines, as preset dev gives them. perf samples what README's polar, other
sweeps, draws, an image, the self-test and a check of a database do; addr2line says of each sample in which .cpp of
ours the function stands that was compiled, whatever was inlined into it. Printed are the files whose share is above
SHARE (0.5 per mille) in any run, those of cmake/LightSources.txt marked. A file of that list that is marked here
with more than a few per mille is to leave it.
"""
import argparse
import collections
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
RUNS = {
    "polar": "polar turboprop4/turboprop4.smat --step 45 --steps fixed --out OUT/polar.csv",
    "heron": "polar heron/heron.smat --step 90 --steps fixed --out OUT/heron.csv",
    "draws": "montecarlo turboprop4/turboprop4.smat --kind polar --set polar.step=60 --set polar.steps=fixed "
             "--samples 16384 --ranking --out OUT/draws.csv",
    "image": "image turboprop4/turboprop4.smat --out OUT/image.exr --out OUT/image.tif --out OUT/image.png",
    "selftest": "selftest",
    "lint": "database lint turboprop4/turboprop4.sigdb",
}


def samples_of(data):
    """How often each place of a file was sampled: {(file, offset): count}, and all samples."""
    text = subprocess.run(["perf", "script", "-i", data, "--show-mmap-events", "-F", "pid,event,ip,dso"],
                          capture_output=True, text=True, check=True).stdout
    maps, counts, total = collections.defaultdict(list), collections.Counter(), 0
    for line in text.splitlines():
        mapped = re.search(r"PERF_RECORD_MMAP2? (\d+)/\d+: \[0x([0-9a-f]+)\(0x([0-9a-f]+)\) @ (0x[0-9a-f]+|0) .*"
                           r"r-xp (\S+)$", line)
        if mapped:
            pid, start, size, offset, file = mapped.groups()
            maps[pid].append((int(start, 16), int(size, 16), int(offset, 16), file))
            continue
        sample = re.match(r"\s*(\d+)\s+\S+\s+([0-9a-f]+) ", line)
        if not sample or "PERF_RECORD" in line:
            continue
        total += 1
        place = int(sample[2], 16)
        for start, size, offset, file in reversed(maps[sample[1]]):
            if start <= place < start + size:
                counts[file, place - start + offset] += 1
                break
    return counts, total


def code_shift(file):
    """What leads from offsets of a file's code to its addresses."""
    for line in subprocess.run(["readelf", "-lW", file], capture_output=True, text=True).stdout.splitlines():
        part = line.split()
        if part[:1] == ["LOAD"] and "E" in "".join(part[6:-1]):
            return int(part[2], 16) - int(part[1], 16)
    return 0


def sources_of(file, offsets):
    """Of each offset the source of ours whose compilation its function belongs to, or none."""
    shift = code_shift(file)
    text = subprocess.run(["addr2line", "-a", "-i", "-e", file] + [hex(o + shift) for o in offsets],
                          capture_output=True, text=True, check=True).stdout
    blocks = re.split(r"^0x[0-9a-f]+\n", text, flags=re.M)[1:]
    for block in blocks:
        ours = [line.rsplit(":", 1)[0] for line in block.splitlines() if line.startswith(str(ROOT) + "/")]
        files = [str(pathlib.Path(o).relative_to(ROOT)) for o in ours]
        yield next((f for f in reversed(files) if f.endswith(".cpp")), files[-1] if files else None)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--above", type=float, default=0.5)
    given = parser.parse_args()
    program = given.build.resolve() / "bin" / "smat-batch"
    light = set((ROOT / "cmake" / "LightSources.txt").read_text().split())
    shares = collections.defaultdict(dict)
    with tempfile.TemporaryDirectory() as out:
        for name, line in RUNS.items():
            data = f"{out}/{name}.data"
            subprocess.run(["perf", "record", "-q", "-e", "cpu-clock", "-F", "997", "-o", data, program] +
                           line.replace("OUT", out).split(), cwd=ROOT / "samples",
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            counts, total = samples_of(data)
            by_file = collections.defaultdict(dict)
            for (file, offset), count in counts.items():
                if file.startswith(str(given.build.resolve())):
                    by_file[file][offset] = count
            for file, offsets in by_file.items():
                for source, count in zip(sources_of(file, offsets), offsets.values()):
                    key = source or f"({pathlib.Path(file).name})"
                    shares[key][name] = shares[key].get(name, 0.0) + 1000.0 * count / max(total, 1)
            print(f"{name}: {total} samples", flush=True)
    print(f"{'':60} " + " ".join(f"{name:>8}" for name in RUNS))
    for source, of_run in sorted(shares.items(), key=lambda entry: -max(entry[1].values())):
        if max(of_run.values()) > given.above:
            mark = "light" if source in light else ""
            print(f"{source:60} " + " ".join(f"{of_run.get(name, 0.0):8.2f}" for name in RUNS) + f" {mark}")


if __name__ == "__main__":
    main()
