#include "irsg/atmosphere/engine/TwoStream.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/VectorExp.h"

namespace irsg {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double thermalDiffusivity = 1.66;
constexpr double solarDiffusivity = std::numbers::sqrt3;

/// What a layer does to light that falls on it, from either side, and what it gives by itself.
struct LayerRow {
    std::vector<double> reflectance, transmittance, upSource, downSource; ///< [layer][column]

    explicit LayerRow(std::size_t size)
        : reflectance(size), transmittance(size), upSource(size), downSource(size) {}
};

/// The homogeneous solution of one layer. With k = sqrt(g1^2 - g2^2) and e = exp(-k t):
/// a = (1 - e^2) / 2k, D' = (1 + e^2) / 2 + g1 a, R = g2 a / D', T = e / D'.
struct Response {
    double gamma1, gamma2;
    double k;
    double decay;       ///< e
    double decayed;     ///< 1 - e
    double decayedOver; ///< (1 - e) / (k t), 1 for a layer without optical depth
    double a;
    double perDenominator; ///< 1 / D'

    Response(double diffusivity, double opticalDepth, double albedo, double asymmetry) {
        gamma1 = diffusivity * (1.0 - 0.5 * albedo * (1.0 + asymmetry));
        gamma2 = diffusivity * 0.5 * albedo * (1.0 - asymmetry);
        // (1 - w) and (1 - w g) rather than differences of the gammas keep the digits of w near 1.
        k = diffusivity * std::sqrt((1.0 - albedo) * (1.0 - albedo * asymmetry));
        const double x = k * opticalDepth;
        decayed = vectorAbsorbed(x);
        decay = 1.0 - decayed;
        decayedOver = x > 1e-9 ? decayed / x : 1.0;
        a = 0.5 * opticalDepth * decayedOver * (1.0 + decay);
        perDenominator = 1.0 / (0.5 * (1.0 + decay * decay) + gamma1 * a);
    }
    double reflectance() const { return gamma2 * a * perDenominator; }
    double transmittance() const { return decay * perDenominator; }
};

/// A layer between what is below and above it, [column]; `factor` counts the light that goes to and
/// fro between the layer and the albedo below, 1 / (1 - R albedo).
struct Join {
    const double *reflectance, *transmittance, *upSource, *downSource;
    const double *albedoBelow, *sourceBelow;
};

/// The albedo and the upward light of everything below the layer's upper face.
IRSG_VECTOR_CLONES void joinUpwards(const Join& layer, std::size_t n, double* __restrict factor,
                                    double* __restrict albedoAbove,
                                    double* __restrict sourceAbove) {
    const double *R = layer.reflectance, *T = layer.transmittance;
    const double *upSource = layer.upSource, *downSource = layer.downSource;
    const double *albedo = layer.albedoBelow, *source = layer.sourceBelow;
    for (std::size_t i = 0; i < n; ++i) {
        const double toAndFro = 1.0 / (1.0 - R[i] * albedo[i]);
        factor[i] = toAndFro;
        albedoAbove[i] = R[i] + T[i] * T[i] * albedo[i] * toAndFro;
        sourceAbove[i] = upSource[i] + T[i] * (source[i] + albedo[i] * downSource[i]) * toAndFro;
    }
}

/// The fluxes at the layer's lower face from the flux that falls on its upper one.
IRSG_VECTOR_CLONES void joinDownwards(const Join& layer, const double* factor, const double* above,
                                      std::size_t n, double* __restrict down,
                                      double* __restrict up) {
    const double *R = layer.reflectance, *T = layer.transmittance, *downSource = layer.downSource;
    const double *albedo = layer.albedoBelow, *source = layer.sourceBelow;
    for (std::size_t i = 0; i < n; ++i) {
        const double falling = (T[i] * above[i] + R[i] * source[i] + downSource[i]) * factor[i];
        down[i] = falling;
        up[i] = albedo[i] * falling + source[i];
    }
}

/// Joins the layers: first the albedo and the upward light of everything below each level, from the
/// ground up, then the fluxes from the top down.
TwoStreamFluxes join(const TwoStreamLayers& layers, const LayerRow& rows,
                     const std::vector<double>& surfaceSource, const std::vector<double>* top) {
    const std::size_t n = layers.columns;
    const std::size_t levels = layers.layers + 1;
    TwoStreamFluxes fluxes{std::vector<double>(levels * n), std::vector<double>(levels * n)};
    std::vector<double> albedoBelow(levels * n);
    std::vector<double> sourceBelow(levels * n);
    std::vector<double> between(layers.layers * n);
    std::ranges::copy(layers.surfaceAlbedo, albedoBelow.begin());
    std::ranges::copy(surfaceSource, sourceBelow.begin());

    const auto rowsOf = [&](std::size_t layer) {
        const std::size_t at = layer * n;
        return Join{&rows.reflectance[at], &rows.transmittance[at], &rows.upSource[at],
                    &rows.downSource[at],  &albedoBelow[at],        &sourceBelow[at]};
    };
    for (std::size_t layer = 0; layer < layers.layers; ++layer)
        joinUpwards(rowsOf(layer), n, &between[layer * n], &albedoBelow[(layer + 1) * n],
                    &sourceBelow[(layer + 1) * n]);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t at = layers.layers * n + i;
        fluxes.down[at] = top ? pi * (*top)[i] : 0.0;
        fluxes.up[at] = albedoBelow[at] * fluxes.down[at] + sourceBelow[at];
    }
    for (std::size_t layer = layers.layers; layer-- > 0;)
        joinDownwards(rowsOf(layer), &between[layer * n], &fluxes.down[(layer + 1) * n], n,
                      &fluxes.down[layer * n], &fluxes.up[layer * n]);
    return fluxes;
}

} // namespace

TwoStreamLayers::TwoStreamLayers(std::size_t layerCount, std::size_t columnCount)
    : layers(layerCount),
      columns(columnCount),
      opticalDepth(layerCount * columnCount),
      albedo(layerCount * columnCount),
      asymmetry(layerCount * columnCount),
      surfaceAlbedo(columnCount) {}

namespace {

/// One layer of many columns, and what it emits or scatters out of the beam.
struct LayerInput {
    const double *depth, *albedo, *asymmetry;

    LayerInput(const TwoStreamLayers& layers, std::size_t layer)
        : depth(&layers.opticalDepth[layer * layers.columns]),
          albedo(&layers.albedo[layer * layers.columns]),
          asymmetry(&layers.asymmetry[layer * layers.columns]) {}
};

IRSG_VECTOR_CLONES void thermalLayer(const LayerInput& layer, const double* below,
                                     const double* above, std::size_t n, double* __restrict R,
                                     double* __restrict T, double* __restrict up,
                                     double* __restrict down) {
    const double *depth = layer.depth, *albedo = layer.albedo, *asymmetry = layer.asymmetry;
    for (std::size_t i = 0; i < n; ++i) {
        const Response layerOf(thermalDiffusivity, depth[i], albedo[i], asymmetry[i]);
        R[i] = layerOf.reflectance();
        T[i] = layerOf.transmittance();

        // Emissivity 1 - R - T, and what the slope of B adds to the upper face and takes from
        // the lower: both as sums of positive terms.
        const double absorption = thermalDiffusivity * (1.0 - albedo[i]);
        const double over = layerOf.decayedOver;
        const double emissivity =
            (0.5 * layerOf.decayed * layerOf.decayed + absorption * layerOf.a) *
            layerOf.perDenominator;
        const double slope = (0.5 * absorption * depth[i] * over * over +
                              0.5 * over * (1.0 + layerOf.decay) - layerOf.decay) *
                             layerOf.perDenominator;
        const double step = below[i] - above[i];
        up[i] = pi * (above[i] * emissivity + step * slope);
        down[i] = pi * (below[i] * emissivity - step * slope);
    }
}

IRSG_VECTOR_CLONES void solarLayer(const LayerInput& layer, const double* slant,
                                   const double* entering, double mu0, std::size_t n,
                                   double* __restrict R, double* __restrict T,
                                   double* __restrict up, double* __restrict down) {
    const double *depth = layer.depth, *albedo = layer.albedo, *asymmetry = layer.asymmetry;
    for (std::size_t i = 0; i < n; ++i) {
        const double w = std::min(albedo[i], 1.0 - 1e-12);
        const double t = depth[i];
        const Response layerOf(solarDiffusivity, t, w, asymmetry[i]);
        R[i] = layerOf.reflectance();
        T[i] = layerOf.transmittance();

        // Light scattered out of the beam at depth s leaves a face with the flux that unit flux
        // through that face would have at s (reciprocity), so both sources are integrals over
        // products of exponentials: `same` of exp(-(k + m) s), `across` of
        // exp(-k (t - s) - m s), which is finite where k and the slant m agree.
        const double k = layerOf.k;
        const double m = slant[i];
        const double e = layerOf.decay;
        const double beamTaken = vectorAbsorbed(m * t);
        const double beamLeft = 1.0 - beamTaken;
        const double same = (layerOf.decayed + e * beamTaken) / (k + m);
        const double y = (k - m) * t;
        const double y2 = y * y;
        const double across =
            y2 < 4e-4 ? std::sqrt(e * beamLeft) * t * (1.0 + y2 * (1.0 / 24.0 + y2 / 1920.0))
                      : (beamLeft - e) / (k - m);

        const double backward = 0.5 * (1.0 - solarDiffusivity * asymmetry[i] * mu0);
        const double forward = 1.0 - backward;
        const double scattered = w * entering[i] * layerOf.perDenominator;
        const double perK = 0.5 / k;
        up[i] = scattered * (0.5 * backward * (same + e * across) +
                             (backward * layerOf.gamma1 + forward * layerOf.gamma2) *
                                 (same - e * across) * perK);
        down[i] = scattered * (0.5 * forward * (across + e * same) +
                               (forward * layerOf.gamma1 + backward * layerOf.gamma2) *
                                   (across - e * same) * perK);
    }
}

} // namespace

TwoStreamFluxes thermalFluxes(const TwoStreamLayers& layers, const ThermalSource& source) {
    const std::size_t n = layers.columns;
    LayerRow rows(layers.layers * n);
    for (std::size_t layer = 0; layer < layers.layers; ++layer) {
        const std::size_t at = layer * n;
        thermalLayer(LayerInput(layers, layer), &source.planck[at], &source.planck[at + n], n,
                     &rows.reflectance[at], &rows.transmittance[at], &rows.upSource[at],
                     &rows.downSource[at]);
    }
    std::vector<double> surface(n);
    for (std::size_t i = 0; i < n; ++i)
        surface[i] = pi * (1.0 - layers.surfaceAlbedo[i]) * source.surfacePlanck[i];
    return join(layers, rows, surface, source.topPlanck.empty() ? nullptr : &source.topPlanck);
}

TwoStreamFluxes solarFluxes(const TwoStreamLayers& layers, const SolarBeam& beam) {
    const std::size_t n = layers.columns;
    const double mu0 = beam.sinElevation;
    LayerRow rows(layers.layers * n);
    for (std::size_t layer = 0; layer < layers.layers; ++layer) {
        const std::size_t at = layer * n;
        solarLayer(LayerInput(layers, layer), &beam.slant[at], &beam.irradiance[at + n], mu0, n,
                   &rows.reflectance[at], &rows.transmittance[at], &rows.upSource[at],
                   &rows.downSource[at]);
    }
    std::vector<double> surface(n);
    for (std::size_t i = 0; i < n; ++i)
        surface[i] = layers.surfaceAlbedo[i] * mu0 * beam.irradiance[i];
    return join(layers, rows, surface, nullptr);
}

} // namespace irsg
