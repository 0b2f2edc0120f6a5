#!/bin/bash
# What one would guess: an OpenEXR file with one float plane, named L or after its quantity, is shown in grey by what shows
# OpenEXR; the name is the writer's to choose.
# What it is: FFmpeg's decoder knows R, G, B, A and Y. A plane of any other name is passed over, and the file is refused because red,
# green and blue are missing ("Unsupported channel", "Missing red channel"). The same plane named Y is decoded as grey floats, with its values.
# Version: av 12.3.0 (with FFmpeg 6.1), OpenEXR 3.2.4, numpy 1.26.4 (Python's index). Source: OpenEXR, "Technical Introduction",
# conventions for channel names, where Y is luminance and L is not named; the behaviour printed below.
# Why it matters here: a radiance image that our programs wrote as L opened nowhere but in them. The first plane is Y now, and its
# quantity stands in attributes.
set -euo pipefail

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work"
python3 -m venv env >/dev/null
env/bin/pip install --quiet --disable-pip-version-check 'av==12.3.0' 'OpenEXR==3.2.4' 'numpy==1.26.4'
env/bin/python - <<'PYTHON'
import sys

import av
import Imath
import numpy
import OpenEXR

av.logging.set_level(av.logging.PANIC)
print("av", av.__version__, "with libavcodec", ".".join(map(str, av.library_versions["libavcodec"])))
values = numpy.linspace(0.0, 19.0, 16 * 16, dtype=numpy.float32).reshape(16, 16)


def seen(name):
    header = OpenEXR.Header(16, 16)
    header["channels"] = {name: Imath.Channel(Imath.PixelType(Imath.PixelType.FLOAT))}
    file = OpenEXR.OutputFile(name + ".exr", header)
    file.writePixels({name: values.tobytes()})
    file.close()
    try:
        with av.open(name + ".exr") as container:
            frame = next(container.decode(video=0))
    except (av.error.FFmpegError, StopIteration) as error:
        return f"refused ({type(error).__name__})", None
    plane = numpy.frombuffer(bytes(frame.planes[0]), numpy.float32)[: 16 * 16]
    return frame.format.name, float(plane.max())


failed = False
for name, expected in (("Y", "grayf32le"), ("L", "refused"), ("radiance", "refused")):
    form, most = seen(name)
    print(f"{name}: {form}" + ("" if most is None else f", largest {most:g}"))
    failed = failed or not form.startswith(expected) or (name == "Y" and most != 19.0)
sys.exit(failed)
PYTHON
