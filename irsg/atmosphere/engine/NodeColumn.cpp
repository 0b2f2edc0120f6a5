#include "irsg/atmosphere/engine/NodeColumn.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/SolarSpectrum.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

/// Where slowly varying quantities are computed: a grid over the wavenumbers, or these themselves.
std::vector<double> smoothPointsOf(const std::vector<double>& wavenumbers_per_cm) {
    std::vector<double> own = wavenumbers_per_cm;
    std::ranges::sort(own);
    own.erase(std::ranges::unique(own).begin(), own.end());

    const auto step_per_cm = [](double wavenumber_per_cm) {
        return wavenumber_per_cm < 1e4 ? 10.0 : 50.0;
    };
    const double firstStep_per_cm = step_per_cm(own.front());
    std::vector<double> grid{std::floor(own.front() / firstStep_per_cm) * firstStep_per_cm};
    while (grid.back() < own.back() && grid.size() < own.size())
        grid.push_back(grid.back() + step_per_cm(grid.back()));
    return grid.back() < own.back() ? own : grid;
}

double henyeyGreenstein(double asymmetry, double cosine) {
    const double g2 = asymmetry * asymmetry;
    const double spread = std::max(1.0 + g2 - 2.0 * asymmetry * cosine, 1e-12);
    return (1.0 - g2) / (spread * std::sqrt(spread));
}

} // namespace

NodeColumn::NodeColumn(const AtmosphericColumn& air, std::vector<std::uint32_t> nodes,
                       std::vector<double> wavenumbers_per_cm, double sunWidth_per_cm)
    : air_(air),
      nodes_(std::move(nodes)),
      wavenumbers_per_cm_(std::move(wavenumbers_per_cm)),
      sunWidth_per_cm_(sunWidth_per_cm),
      absorption_(air.gases(), nodes_),
      smoothPoints_per_cm_(smoothPointsOf(wavenumbers_per_cm_)),
      continua_(smoothPoints_per_cm_),
      levels_(air.levelCount()) {
    Bracket at;
    for (const double wavenumber_per_cm : wavenumbers_per_cm_) {
        wavelengths_um_.push_back(1e4 / wavenumber_per_cm);
        at = bracketNear(at.below, smoothPoints_per_cm_, wavenumber_per_cm);
        // The last point begins no interval: it is taken alone.
        const bool isLast = at.fraction == 1.0;
        smoothBelow_.push_back(static_cast<std::uint32_t>(isLast ? at.above : at.below));
        smoothPart_.push_back(isLast ? 0.0 : at.fraction);
    }
    for (const ParticleLayer& kind : air_.particles()) {
        Optics optics;
        for (const double wavenumber_per_cm : smoothPoints_per_cm_) {
            const ParticleOptics here = kind.opticsAt(1e4 / wavenumber_per_cm);
            optics.extinction.push_back(here.extinction);
            optics.scattering.push_back(std::max(here.extinction - here.absorption, 0.0));
            optics.asymmetry.push_back(here.asymmetry);
        }
        optics_.push_back(std::move(optics));
    }
}

NodeColumn::Smooth NodeColumn::smoothAt(std::size_t level) const {
    const AtmosphericState& air = air_.level(level);
    const std::size_t points = smoothPoints_per_cm_.size();
    Smooth smooth;
    smooth.extinction.resize(points);
    smooth.rayleigh.resize(points);
    continua_.absorption_per_m(air, smooth.extinction);
    for (std::size_t i = 0; i < points; ++i) {
        smooth.rayleigh[i] = rayleighScattering_per_m(air, smoothPoints_per_cm_[i]);
        smooth.extinction[i] += smooth.rayleigh[i];
    }
    smooth.scattering = smooth.rayleigh;
    smooth.asymmetry.assign(points, 0.0);
    smooth.forwardPeak.assign(points, 0.0);
    for (std::size_t kind = 0; kind < optics_.size(); ++kind) {
        const double density_per_m = air_.particleExtinction550_per_m(kind, level);
        if (density_per_m <= 0.0)
            continue;
        const Optics& optics = optics_[kind];
        for (std::size_t i = 0; i < points; ++i) {
            const double scattering = density_per_m * optics.scattering[i];
            const double g = optics.asymmetry[i];
            smooth.extinction[i] += density_per_m * optics.extinction[i];
            smooth.scattering[i] += scattering;
            smooth.asymmetry[i] += scattering * g;
            smooth.forwardPeak[i] += scattering * g * g;
        }
    }
    return smooth;
}

template <typename Number>
void NodeColumn::spread(const std::vector<double>& smooth, std::span<Number> out) const {
    const std::size_t last = smooth.size() - 1;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::size_t below = smoothBelow_[i];
        const double low = smooth[below];
        const double high = smooth[std::min(below + 1, last)];
        out[i] = static_cast<Number>(low + smoothPart_[i] * (high - low));
    }
}

NodeColumn::Level& NodeColumn::withExtinction(std::size_t index) const {
    Level& level = levels_.at(index);
    level.extinctionOnce.call([&] {
        level.smooth = smoothAt(index);
        std::vector<float> smooth(size());
        spread<float>(level.smooth.extinction, smooth);
        std::vector<float> extinction(size());
        absorption_.at(air_.level(index), extinction);
        for (std::size_t i = 0; i < extinction.size(); ++i)
            extinction[i] += smooth[i];
        level.extinction = std::move(extinction);
        level.scattering.resize(size());
        spread<float>(level.smooth.scattering, level.scattering);
    });
    return level;
}

NodeColumn::Level& NodeColumn::withPhase(std::size_t index) const {
    Level& level = withExtinction(index);
    level.phaseOnce.call([&] {
        level.asymmetry.resize(size());
        level.forwardPeak.resize(size());
        if (std::ranges::all_of(level.smooth.asymmetry, [](double v) { return v == 0.0; }) &&
            std::ranges::all_of(level.smooth.forwardPeak, [](double v) { return v == 0.0; }))
            return; // no particles
        spread<float>(level.smooth.asymmetry, level.asymmetry);
        spread<float>(level.smooth.forwardPeak, level.forwardPeak);
    });
    return level;
}

std::span<const float> NodeColumn::extinction(std::size_t level) const {
    return withExtinction(level).extinction;
}

std::span<const float> NodeColumn::scattering(std::size_t level) const {
    return withExtinction(level).scattering;
}

std::span<const float> NodeColumn::asymmetry(std::size_t level) const {
    return withPhase(level).asymmetry;
}

std::span<const float> NodeColumn::forwardPeak(std::size_t level) const {
    return withPhase(level).forwardPeak;
}

void NodeColumn::planckAt(double temperature_K, std::span<double> radiance) const {
    planckRadiances_W_m2_sr_um(wavelengths_um_, temperature_K, radiance);
}

std::span<const double> NodeColumn::planck(std::size_t index) const {
    Level& level = levels_.at(index);
    level.planckOnce.call([&] {
        level.planck.resize(size());
        planckAt(air_.level(index).temperature_K, level.planck);
    });
    return level.planck;
}

std::span<const double> NodeColumn::sun() const {
    sunOnce_.call([&] {
        std::vector<double> sun;
        sun.reserve(wavenumbers_per_cm_.size());
        for (const double wavenumber_per_cm : wavenumbers_per_cm_)
            sun.push_back(solarIrradiance_W_m2_per_cm(wavenumber_per_cm - 0.5 * sunWidth_per_cm_,
                                                      wavenumber_per_cm + 0.5 * sunWidth_per_cm_) *
                          wavenumber_per_cm * wavenumber_per_cm * 1e-4);
        sun_ = std::move(sun);
    });
    return sun_;
}

double SunAngle::cosine() const {
    const double up = std::sin(sunElevation_rad) * std::sin(sightElevation_rad);
    const double across = std::cos(sunElevation_rad) * std::cos(sightElevation_rad);
    return std::clamp(up + across * std::cos(relativeAzimuth_rad), -1.0, 1.0);
}

bool NodeColumn::scatteringBy(std::size_t kind, std::size_t index, std::span<double> out) const {
    const Level& level = withExtinction(index);
    if (kind == 0) {
        spread<double>(level.smooth.rayleigh, out);
        return true;
    }
    const double density_per_m = air_.particleExtinction550_per_m(kind - 1, index);
    if (!(density_per_m > 0.0))
        return false;
    std::vector<double> scattering = optics_[kind - 1].scattering;
    for (double& value : scattering)
        value *= density_per_m;
    spread<double>(scattering, out);
    return true;
}

void NodeColumn::phaseOf(std::size_t kind, double cosine, std::span<double> out) const {
    if (kind == 0) {
        std::ranges::fill(out, 0.75 * (1.0 + cosine * cosine));
        return;
    }
    std::vector<double> phase;
    for (const double asymmetry : optics_[kind - 1].asymmetry)
        phase.push_back(henyeyGreenstein(asymmetry, cosine));
    spread<double>(phase, out);
}

} // namespace irsg
