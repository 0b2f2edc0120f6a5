#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/image/SampledTiles.h"
#include "irsg/render/values/RadiometryError.h"

namespace irsg {

/// What the surfaces of one pair of codes add to the sums of their object.
struct SurfaceRadiometry {
    int temperature = 0, material = 0; ///< the indices that their faces carry
    double intensity_W_sr = 0.0;
    double contrastIntensity_W_sr = 0.0;
    double irradiance_W_m2 = 0.0;
    double solidAngle_sr = 0.0;
};

/// The radiometry of one object as the sensor sees it, summed in double over its samples.
struct ObjectRadiometry {
    std::string name;
    double range_m = 0.0;                ///< sensor to reference point
    double intensity_W_sr = 0.0;         ///< sum of A_pre omega d^2
    double contrastIntensity_W_sr = 0.0; ///< sum of (A_pre - alpha L_bg) omega d^2
    double irradiance_W_m2 = 0.0;        ///< sum of (A_pre - alpha L_bg) omega cos theta
    double coveredPixels = 0.0;          ///< sum of the coverage
    double solidAngle_sr = 0.0;          ///< sum of coverage omega
    /// Bound of what the air's change over the object's extent leaves wrong, as a part of what
    /// arrives from it.
    double atmosphereError = 0.0;
    std::optional<RadiometryErrors> errors; ///< where they were asked for (Outputs)
    /// Of its height, 0 to 1: what the horizon of the earth hides.
    double hiddenByHorizon = 0.0;
    /// By pair of codes, in the order of the scene's rows, where they were asked for (Outputs).
    /// Their sums are those of the object; light belongs to the surface that sends it to the
    /// sensor.
    std::vector<SurfaceRadiometry> surfaces = {};

    /// Adds what another has seen to its sums.
    void addSums(const ObjectRadiometry& other) {
        intensity_W_sr += other.intensity_W_sr;
        contrastIntensity_W_sr += other.contrastIntensity_W_sr;
        irradiance_W_m2 += other.irradiance_W_m2;
        coveredPixels += other.coveredPixels;
        solidAngle_sr += other.solidAngle_sr;
    }
};

struct RenderReport {
    double totalIrradiance_W_m2 = 0.0; ///< of the whole frame, background included
    double background_W_m2_sr = 0.0;
    std::vector<ObjectRadiometry> objects;
    /// Of all objects together: each sum is that of the objects, whose intensities are each at
    /// their own range; `range_m` is that of the first.
    ObjectRadiometry all;
    std::vector<std::string> providedBy; ///< "transmittance: vacuum"
    std::vector<std::string> warnings;   ///< each said once
    std::vector<SampledTile> tiles;      ///< what the antialiasing sampled by itself
    long flooredPixels = 0;              ///< of the background, whose sum was below 0
    /// Where the object that is looked at was sampled for all of its line of sight, as was asked
    /// for (Outputs::Reports::alongRange): how far it, and terrain that may hide some of it, reach
    /// from its reference point. 0 where it was sampled for its range alone.
    double alongRangeReach_m = 0.0;
    int layersLeftOver = 0; ///< samples with more transparent layers than are kept
    std::string renderer;   ///< GL renderer and version
};

struct RenderedImage {
    RadianceImage image; ///< "L"; with truth layers the other planes (TruthLayers.h)
    RenderReport report;
};

/// One object's part of an IntensitySpectrum, at its own range.
struct ObjectSpectrum {
    std::string name;
    std::vector<double> intensity_W_sr_um;
    std::vector<double> contrastIntensity_W_sr_um;
    std::vector<double> irradiance_W_m2_um;
    std::vector<RadiometryErrors> errors; ///< as those of IntensitySpectrum
};

/// Spectral quantities as they arrive at the sensor, through the air but without the sensor's
/// response: the sums of the objects, each at its own range.
struct IntensitySpectrum {
    std::vector<double> wavenumbers_per_cm; ///< as asked for
    std::vector<double> wavelengths_um;     ///< 1e4 / wavenumber
    std::vector<double> intensity_W_sr_um;
    std::vector<double> contrastIntensity_W_sr_um;
    std::vector<double> irradiance_W_m2_um; ///< of the contrast
    /// A wavenumber each, per um, where they were asked for (Outputs). What of the air they
    /// hold is its change over the objects' extent: its bins are the resolution of a spectrum.
    std::vector<RadiometryErrors> errors;
    std::vector<ObjectSpectrum> objects; ///< where there are several
    double coveredPixels = 0.0;
    std::vector<std::string> warnings;
};

/// Time spent in each stage, s.
struct StageTimes {
    struct Stage {
        std::string name;
        double seconds = 0.0;
        long calls = 0;
    };
    std::vector<Stage> stages;

    /// What came to them since an earlier look at the same stages.
    StageTimes since(const StageTimes& earlier) const {
        StageTimes spent;
        for (Stage stage : stages) {
            for (const Stage& before : earlier.stages)
                if (before.name == stage.name) {
                    stage.seconds -= before.seconds;
                    stage.calls -= before.calls;
                }
            if (stage.calls > 0)
                spent.stages.push_back(std::move(stage));
        }
        return spent;
    }
};

} // namespace irsg
