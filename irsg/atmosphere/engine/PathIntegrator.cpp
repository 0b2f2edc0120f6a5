#include "irsg/atmosphere/engine/PathIntegrator.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/VectorExp.h"

namespace irsg {

std::vector<double> levelWeights(const RayPath& path, std::size_t levels) {
    std::vector<double> weights(levels, 0.0);
    for (const RaySegment& segment : path.segments) {
        const auto layer = static_cast<std::size_t>(segment.layer);
        weights.at(layer) += segment.length_m * (1.0 - segment.meanFraction);
        weights.at(layer + 1) += segment.length_m * segment.meanFraction;
    }
    return weights;
}

void opticalDepth(const NodeColumn& column, std::span<const double> weights, Depth which,
                  std::span<double> depth) {
    std::ranges::fill(depth, 0.0);
    for (std::size_t level = 0; level < weights.size(); ++level) {
        const double weight = weights[level];
        if (weight == 0.0)
            continue;
        const std::span<const float> row =
            which == Depth::extinction ? column.extinction(level) : column.scattering(level);
        for (std::size_t i = 0; i < depth.size(); ++i)
            depth[i] += weight * static_cast<double>(row[i]);
    }
}

namespace {

/// The source function at a point of a ray: `mean` + cosine * `slope`, per node. The slope is empty
/// where nothing scatters.
struct PointSource {
    std::vector<double> mean, slope;
};

/// Computes the source function at points, with what it needs to work on.
class SourceFunction {
  public:
    SourceFunction(const NodeColumn& column, const ScatteredEmission& scattered)
        : column_(column),
          scattered_(scattered),
          planck_(column.size()),
          above_(made()),
          perExtinction_(column.size()) {}

    PointSource made() const {
        return {std::vector<double>(column_.size()),
                std::vector<double>(scattered_ ? column_.size() : 0)};
    }

    void at(std::size_t layer, double altitude_m, PointSource& source) {
        const std::vector<double>& altitudes_m = column_.air().altitudes_m();
        const double f = std::clamp((altitude_m - altitudes_m[layer]) /
                                        (altitudes_m[layer + 1] - altitudes_m[layer]),
                                    0.0, 1.0);
        constexpr double same = 1e-9;
        if (f < same || f > 1.0 - same)
            atLevel(f < same ? layer : layer + 1, source);
        else
            between(layer, f, altitude_m, source);
    }

  private:
    void atLevel(std::size_t level, PointSource& source) {
        if (scattered_)
            scattered_(level, source.mean, source.slope);
        else
            std::ranges::fill(source.mean, 0.0);
        const float* extinction = column_.extinction(level).data();
        const float* scattering = column_.scattering(level).data();
        const double* planck = column_.planck(level).data();
        double* mean = source.mean.data();
        for (std::size_t i = 0; i < perExtinction_.size(); ++i) {
            const double e = static_cast<double>(extinction[i]);
            perExtinction_[i] = e > 0.0 ? 1.0 / e : 0.0;
            const float absorbed = std::max(extinction[i] - scattering[i], 0.0f);
            mean[i] = (static_cast<double>(absorbed) * planck[i] + mean[i]) * perExtinction_[i];
        }
        for (std::size_t i = 0; i < source.slope.size(); ++i)
            source.slope[i] *= perExtinction_[i];
    }

    /// Extinction, absorption and what is scattered are linear in altitude, and so is the
    /// temperature that the air emits with.
    void between(std::size_t layer, double f, double altitude_m, PointSource& source) {
        const double g = 1.0 - f;
        if (scattered_) {
            scattered_(layer, source.mean, source.slope);
            scattered_(layer + 1, above_.mean, above_.slope);
            for (std::size_t i = 0; i < source.mean.size(); ++i) {
                source.mean[i] = g * source.mean[i] + f * above_.mean[i];
                source.slope[i] = g * source.slope[i] + f * above_.slope[i];
            }
        } else {
            std::ranges::fill(source.mean, 0.0);
        }
        const float* lower = column_.extinction(layer).data();
        const float* upper = column_.extinction(layer + 1).data();
        const float* lowerScattering = column_.scattering(layer).data();
        const float* upperScattering = column_.scattering(layer + 1).data();
        column_.planckAt(column_.air().profile().at(altitude_m).temperature_K, planck_);
        for (std::size_t i = 0; i < perExtinction_.size(); ++i) {
            const double e = g * static_cast<double>(lower[i]) + f * static_cast<double>(upper[i]);
            perExtinction_[i] = e > 0.0 ? 1.0 / e : 0.0;
            const double below = static_cast<double>(std::max(lower[i] - lowerScattering[i], 0.0f));
            const double above = static_cast<double>(std::max(upper[i] - upperScattering[i], 0.0f));
            source.mean[i] =
                ((g * below + f * above) * planck_[i] + source.mean[i]) * perExtinction_[i];
        }
        for (std::size_t i = 0; i < source.slope.size(); ++i)
            source.slope[i] *= perExtinction_[i];
    }

    const NodeColumn& column_;
    const ScatteredEmission& scattered_;
    std::vector<double> planck_;
    PointSource above_;
    std::vector<double> perExtinction_;
};

/// The source function towards the sensor along a segment.
const double* towardsSensor(const PointSource& source, double sinElevation,
                            std::vector<double>& room) {
    if (source.slope.empty())
        return source.mean.data();
    for (std::size_t i = 0; i < room.size(); ++i)
        room[i] = source.mean[i] - sinElevation * source.slope[i];
    return room.data();
}

/// What the slope of a source that is linear in optical depth adds, per difference of its ends:
/// (1 - exp(-t)) / t - exp(-t), by its series where that would cancel.
inline double slopeShare(double t, double absorbed) {
    const double series =
        t * (1.0 / 2.0 -
             t * (1.0 / 3.0 -
                  t * (1.0 / 8.0 - t * (1.0 / 30.0 - t * (1.0 / 144.0 - t * (1.0 / 840.0))))));
    const double closed = absorbed / (t > 0.0 ? t : 1.0) - (1.0 - absorbed);
    return t < 0.03 ? series : closed;
}

} // namespace

PathLight lightAlong(const NodeColumn& column, const RayPath& path,
                     const ScatteredEmission& scattered) {
    const std::size_t n = column.size();
    PathLight light{std::vector<double>(n, 1.0), std::vector<double>(n, 0.0)};
    if (path.segments.empty())
        return light;

    SourceFunction source(column, scattered);
    PointSource near = source.made(), far = source.made();
    std::vector<double> nearRoom(n), farRoom(n);
    const RaySegment& first = path.segments.front();
    source.at(static_cast<std::size_t>(first.layer), first.startAltitude_m, near);
    for (const RaySegment& segment : path.segments) {
        const auto layer = static_cast<std::size_t>(segment.layer);
        source.at(layer, segment.endAltitude_m, far);
        const double* nearSource = towardsSensor(near, segment.sinElevation, nearRoom);
        const double* farSource = towardsSensor(far, segment.sinElevation, farRoom);
        const double lowerWeight = segment.length_m * (1.0 - segment.meanFraction);
        const double upperWeight = segment.length_m * segment.meanFraction;
        const float* lower = column.extinction(layer).data();
        const float* upper = column.extinction(layer + 1).data();
        double* transmittance = light.transmittance.data();
        double* radiance = light.radiance.data();
        for (std::size_t i = 0; i < n; ++i) {
            const double t = lowerWeight * static_cast<double>(lower[i]) +
                             upperWeight * static_cast<double>(upper[i]);
            const double absorbed = vectorAbsorbed(t);
            const double step = farSource[i] - nearSource[i];
            radiance[i] +=
                transmittance[i] * (nearSource[i] * absorbed + step * slopeShare(t, absorbed));
            const double left = transmittance[i] * (1.0 - absorbed);
            transmittance[i] = left < 1e-150 ? 0.0 : left; // before numbers become slow
        }
        std::swap(near, far);
    }
    return light;
}

} // namespace irsg
