#!/usr/bin/env python3
"""What the program says to a folder of damaged files, as a table.

    scripts/fuzz/damaged.py BUILD [FOLDER]        FOLDER is ../shared/data/damaged unless given

For each file: the command that reads its kind, exit code, seconds of the clock and of the processor,
memory (of the program or of the process that it reads in, whichever took more), and the sentence.
Exit code 1 where a file is not refused with exit code 2 and a sentence that names it, within 2 s of
the processor and 500 MB; a file in SOUND is not damaged, and is read.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

# What the import of a published run of MODTRAN gives, number by number (tests/cli/DamagedFilesTest.cpp):
# a sanitizer found a fault of the reader over it, and none is in the file.
SOUND = {"atmosphere2.dat"}
BOX = pathlib.Path(__file__).resolve().parents[2] / "samples/box/box.sigdb"


def command_for(file, database):
    if file.name.startswith("model-"):
        return ["model", "info", file]
    return {
        ".dat": ["atmosphere", "info", file],
        ".csv": ["db", "import", file, database],
        ".smat": ["image", file, "--out", "o.exr"],
        ".json": ["simulate", file, "--out", "out", "--dry-run"],
        ".exr": ["compare", file, file],
    }.get(file.suffix)


def run(program, words, folder):
    """Exit code, seconds, seconds of the processor, MB, standard error."""
    errors = folder / "errors"
    with open(errors, "wb") as stream:
        began = time.monotonic()
        process = subprocess.Popen([program] + [str(word) for word in words], cwd=folder,
                                   stdout=subprocess.DEVNULL, stderr=stream)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return (process.returncode, time.monotonic() - began, used.ru_utime + used.ru_stime,
            used.ru_maxrss / 1024.0, errors.read_text("utf-8", "replace"))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    program = str(pathlib.Path(sys.argv[1]).resolve() / "bin/smat-batch")
    damaged = pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else "../shared/data/damaged").resolve()
    bad = 0
    print("| file | command | exit code | s | s of the processor | MB | what is said |")
    print("|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copy(BOX, folder / "box.sigdb")
        for file in sorted(damaged.iterdir()):
            words = command_for(file, folder / "box.sigdb")
            if words is None:
                continue
            code, seconds, processor_s, megabytes, said = run(program, words, folder)
            said = said.replace(str(file), file.name)
            sentences = [line for line in said.splitlines() if "error: " in line]
            told = sentences[0].removeprefix("error: ") if sentences else "(read)"
            is_refused = code == 2 and told.startswith(file.name) and "expected" in told
            met = code == 0 if file.name in SOUND else is_refused
            met = met and processor_s < 2 and megabytes < 500
            bad += not met
            print("| %s%s | %s | %d | %.2f | %.2f | %.0f | %s |" % (
                "" if met else "**", file.name, " ".join(map(str, words[:2])) if
                words[1] in ("info", "import") else words[0], code, seconds, processor_s,
                megabytes, told.replace("|", "\\|")))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
