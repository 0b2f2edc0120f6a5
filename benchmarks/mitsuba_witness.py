#!/usr/bin/env python3
"""Intensities of Mitsuba 3 beside the library and the path tracer of the tests, and the processor
time that each takes for an error of 0.1 % of the total.

    python3 -m venv V && V/bin/pip install mitsuba==3.9.1 numpy
    bench_exchange --case corner --write DIR
    V/bin/python benchmarks/mitsuba_witness.py DIR [--error 0.001] [--variant llvm_ad_mono]

Mitsuba 3.9.1 needs LLVM 17 or later, though it loads older ones: on Debian 12 libllvm19, named in
DRJIT_LIBLLVM_PATH.

Mitsuba renders in parallel projection with its path integrator. A two-sided facet that emits is
two that stand 1e-4 radii apart, since its emitters have one side; nearer ones its single precision
takes for each other. Only samples are timed: the scene is built and its kernel compiled before.
Mitsuba's time for the error follows from the scatter of independent renderings, which falls as the
square root of the samples; that of the library is its time for the whole view, at the error it has.
"""
import argparse
import json
import math
import os
import pathlib
import time

import numpy as np


def flipped(mi, mesh, offset_m):
    """The same facets seen from behind, `offset_m` behind the first."""
    parameters = mi.traverse(mesh)
    corners = np.array(parameters["vertex_positions"]).reshape(-1, 3, 3)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    corners = (corners - offset_m * normals[:, None, :])[:, ::-1, :]
    parameters["vertex_positions"] = corners.astype(np.float32).ravel()
    parameters.update()
    return mesh


def scene_of(mi, document, folder, pixels):
    radius_m = document["radius_m"]
    towards = np.array(document["towards_viewer"])
    up = [0, 0, 1] if abs(towards[2]) < 0.99 else [0, 1, 0]
    to_world = mi.ScalarTransform4f().look_at(
        origin=list(3 * radius_m * towards), target=[0, 0, 0], up=up
    ) @ mi.ScalarTransform4f().scale([1.01 * radius_m, 1.01 * radius_m, 1])
    scene = {
        "type": "scene",
        "integrator": {
            "type": "path",
            "max_depth": -1 if document["bounces"] < 0 else document["bounces"] + 2,
            "rr_depth": 8,
        },
        "sensor": {
            "type": "orthographic",
            "to_world": to_world,
            "near_clip": 1e-3 * radius_m,
            "far_clip": 10 * radius_m,
            "film": {
                "type": "hdrfilm", "width": pixels, "height": pixels,
                "rfilter": {"type": "box"}, "pixel_format": "luminance",
                "component_format": "float32",
            },
            "sampler": {"type": "independent"},
        },
    }
    if document["sun_W_m2"] > 0:
        scene["sun"] = {
            "type": "directional",
            "direction": [-c for c in document["towards_sun"]],
            "irradiance": {"type": "uniform", "value": document["sun_W_m2"]},
        }
    number = 0
    for kind in document["kinds"]:
        emits = kind["emitted_W_m2_sr"] > 1e-30  # of cold bodies below single precision
        bsdf = {"type": "diffuse",
                "reflectance": {"type": "uniform", "value": kind["reflectivity"]}}
        if kind["two_sided"] and not emits:
            bsdf = {"type": "twosided", "material": bsdf}
        for is_back in [False, True] if kind["two_sided"] and emits else [False]:
            shape = {"type": "ply", "filename": str(folder / kind["file"]), "face_normals": True,
                     "bsdf": bsdf}
            if emits:
                shape["emitter"] = {
                    "type": "area",
                    "radiance": {"type": "uniform", "value": kind["emitted_W_m2_sr"]},
                }
            made = mi.load_dict(shape)
            scene[f"shape{number}"] = flipped(mi, made, 1e-4 * radius_m) if is_back else made
            number += 1
    return mi.load_dict(scene), (2.02 * radius_m) ** 2


def judged(mi, document, folder, arguments):
    scene, area_m2 = scene_of(mi, document, folder, arguments.pixels)

    def intensity(samples, seed):
        image = np.array(mi.render(scene, spp=samples, seed=seed))
        return float(image.mean()) * area_m2

    intensity(arguments.samples, 0)  # compiles
    values, spent_s = [], 0.0
    for seed in range(1, arguments.renderings + 1):
        start_s = time.process_time()
        values.append(intensity(arguments.samples, seed))
        spent_s += time.process_time() - start_s
    mean = float(np.mean(values))
    scatter = float(np.std(values, ddof=1)) / abs(mean)
    needed_s = spent_s / len(values) * (scatter / arguments.error) ** 2
    return mean, scatter * abs(mean) / math.sqrt(len(values)), needed_s


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--error", type=float, default=0.001)
    parser.add_argument("--variant", default="llvm_ad_mono")
    parser.add_argument("--pixels", type=int, default=128)
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--renderings", type=int, default=8)
    arguments = parser.parse_args()
    import mitsuba as mi

    mi.set_variant(arguments.variant)
    print(f"Mitsuba {mi.__version__}, {arguments.variant}, {os.cpu_count()} processors")
    print("| case | variant | tracer, W/sr | ± | Mitsuba | ± | off, % | library | stated ± | off, % "
          "| Mitsuba for the error, s | library, s |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    off, of_mitsuba_s, of_library_s = [], 0.0, 0.0
    for file in sorted(arguments.folder.glob("*.json"), key=lambda one: int(one.stem)):
        document = json.loads(file.read_text())
        value, error, needed_s = judged(mi, document, arguments.folder, arguments)
        truth = document["truth_W_sr"]
        off.append(document["library_W_sr"] / truth - 1)
        of_mitsuba_s += needed_s
        of_library_s += document["library_s"]
        print(f"| {document['name']} | {document['variant']} | {truth:.6g} | "
              f"{document['truth_error_W_sr']:.1g} | {value:.6g} | {error:.1g} | "
              f"{100 * (value / truth - 1):+.3f} | {document['library_W_sr']:.6g} | "
              f"{document['stated_error_W_sr']:.1g} | {100 * off[-1]:+.3f} | {needed_s:.3f} | "
              f"{document['library_s']:.3f} |", flush=True)
    if off:
        rms = math.sqrt(sum(one * one for one in off) / len(off))
        print(f"{len(off)} views: the library is off by {100 * rms:.3f} % (rms) in "
              f"{of_library_s:.2f} s, Mitsuba by {100 * arguments.error:.3g} % in {of_mitsuba_s:.2f} s")


if __name__ == "__main__":
    main()
