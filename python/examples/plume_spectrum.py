"""The spectrum of an aircraft with its plume, beside the transmittance of the air."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import smat

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"


def main(quick: bool) -> None:
    project = smat.Project(SAMPLES / "turboprop4" / "turboprop4.smat")
    quicker = {"sensor.width": 48, "sensor.height": 32, "render.bounces": 0} if quick else {}
    near = project.with_settings({**quicker, "environment.atmospheres": "none", "camera.azimuth": 150})
    table = near.spectrum(band=(3, 5), resolution=50 if quick else 5).table
    air = smat.Environment(SAMPLES.parent / "resources" / "atmospheres" / "temperate-maritime.xml")
    spectra = air.spectra(
        ["transmittance"],
        band=smat.Band("3-5"),
        sensor_altitude_m=1000,
        target_altitude_m=1000,
        range_m=2000,
    )
    figure, axes = plt.subplots()
    axes.plot(table["wavelength"], table["spectral_intensity"])
    axes.set_xlabel("wavelength, um")
    axes.set_ylabel("spectral intensity, W sr$^{-1}$ um$^{-1}$")
    other = axes.twinx()
    other.plot(spectra["wavelength"], spectra["transmittance"], color="grey", linewidth=0.5)
    other.set_ylabel("transmittance of 2 km")
    figure.savefig("plume.png")
    print(f"{table.rows} wavelengths")


if __name__ == "__main__":
    main("--quick" in sys.argv)
