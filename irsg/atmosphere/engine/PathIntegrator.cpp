#include "irsg/atmosphere/engine/PathIntegrator.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/VectorClones.h"
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

namespace {

IRSG_VECTOR_CLONES void addWeighted(double weight, const float* row, std::size_t n, double* sum) {
    for (std::size_t i = 0; i < n; ++i)
        sum[i] += weight * static_cast<double>(row[i]);
}

IRSG_VECTOR_CLONES void turnToTransmittance(double* depth, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        const double transmittance = vectorExp(-depth[i]);
        depth[i] = depth[i] < 600.0 ? transmittance : 0.0;
    }
}

} // namespace

void opticalDepth(const NodeColumn& column, std::span<const double> weights, Depth which,
                  std::span<double> depth) {
    std::ranges::fill(depth, 0.0);
    for (std::size_t level = 0; level < weights.size(); ++level) {
        const double weight = weights[level];
        if (weight == 0.0)
            continue;
        const std::span<const float> row =
            which == Depth::extinction ? column.extinction(level) : column.scattering(level);
        addWeighted(weight, row.data(), depth.size(), depth.data());
    }
}

void turnToTransmittance(std::span<double> depth) {
    turnToTransmittance(depth.data(), depth.size());
}

namespace {

/// The air at one level, per node.
struct LevelRows {
    const float *extinction, *scattering;

    LevelRows(const NodeColumn& column, std::size_t level)
        : extinction(column.extinction(level).data()),
          scattering(column.scattering(level).data()) {}
};

/// From light that is scattered into the ray to the source function, at a level.
IRSG_VECTOR_CLONES void sourceAt(const LevelRows& level, const double* planck, std::size_t n,
                                 double* mean, double* slope) {
    const float *extinction = level.extinction, *scattering = level.scattering;
    for (std::size_t i = 0; i < n; ++i) {
        const double e = static_cast<double>(extinction[i]);
        const double perExtinction = e > 0.0 ? 1.0 / e : 0.0;
        const float absorbed = std::max(extinction[i] - scattering[i], 0.0f);
        mean[i] = (static_cast<double>(absorbed) * planck[i] + mean[i]) * perExtinction;
        slope[i] *= perExtinction;
    }
}

/// The same in a layer, at its part `f`: extinction and absorption are linear in altitude.
IRSG_VECTOR_CLONES void sourceBetween(const LevelRows& lower, const LevelRows& upper, double f,
                                      const double* planck, std::size_t n, double* mean,
                                      double* slope) {
    const double g = 1.0 - f;
    const float *lowE = lower.extinction, *lowS = lower.scattering;
    const float *highE = upper.extinction, *highS = upper.scattering;
    for (std::size_t i = 0; i < n; ++i) {
        const double e = g * static_cast<double>(lowE[i]) + f * static_cast<double>(highE[i]);
        const double perExtinction = e > 0.0 ? 1.0 / e : 0.0;
        const double below = static_cast<double>(std::max(lowE[i] - lowS[i], 0.0f));
        const double above = static_cast<double>(std::max(highE[i] - highS[i], 0.0f));
        mean[i] = ((g * below + f * above) * planck[i] + mean[i]) * perExtinction;
        slope[i] *= perExtinction;
    }
}

/// a = (1 - f) a + f b
IRSG_VECTOR_CLONES void mix(double f, const double* b, std::size_t n, double* a) {
    for (std::size_t i = 0; i < n; ++i)
        a[i] = (1.0 - f) * a[i] + f * b[i];
}

/// The source function at a point of a ray: `mean` + cosine * `slope`, per node.
struct PointSource {
    std::vector<double> mean, slope;

    explicit PointSource(std::size_t nodes) : mean(nodes), slope(nodes) {}
};

/// Computes the source function at points, with what it needs to work on.
class SourceFunction {
  public:
    SourceFunction(const NodeColumn& column, const ScatteredEmission& scattered)
        : column_(column), scattered_(scattered), planck_(column.size()), above_(column.size()) {}

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
    void scatteredAt(std::size_t level, PointSource& source) const {
        if (scattered_) {
            scattered_(level, source.mean, source.slope);
        } else {
            std::ranges::fill(source.mean, 0.0);
            std::ranges::fill(source.slope, 0.0);
        }
    }
    void atLevel(std::size_t level, PointSource& source) const {
        scatteredAt(level, source);
        sourceAt(LevelRows(column_, level), column_.planck(level).data(), column_.size(),
                 source.mean.data(), source.slope.data());
    }
    /// What is scattered is linear in altitude, and so is the temperature that the air emits with.
    void between(std::size_t layer, double f, double altitude_m, PointSource& source) {
        const std::size_t n = column_.size();
        scatteredAt(layer, source);
        scatteredAt(layer + 1, above_);
        mix(f, above_.mean.data(), n, source.mean.data());
        mix(f, above_.slope.data(), n, source.slope.data());
        column_.planckAt(column_.air().profile().at(altitude_m).temperature_K, planck_);
        sourceBetween(LevelRows(column_, layer), LevelRows(column_, layer + 1), f, planck_.data(),
                      n, source.mean.data(), source.slope.data());
    }

    const NodeColumn& column_;
    const ScatteredEmission& scattered_;
    std::vector<double> planck_;
    PointSource above_;
};

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

/// A piece of a ray between two levels, and what is seen through it.
struct Crossing {
    double lowerWeight_m, upperWeight_m, sinElevation;
    const float *lower, *upper; ///< extinction at the levels
};

/// Adds what a piece of a ray sends through everything before it.
IRSG_VECTOR_CLONES void cross(const Crossing& piece, const PointSource& near,
                              const PointSource& far, PathLight& light) {
    const std::size_t n = light.radiance.size();
    const double lowerWeight = piece.lowerWeight_m, upperWeight = piece.upperWeight_m;
    const double sine = piece.sinElevation;
    const float *lower = piece.lower, *upper = piece.upper;
    const double *nearMean = near.mean.data(), *nearSlope = near.slope.data();
    const double *farMean = far.mean.data(), *farSlope = far.slope.data();
    double *transmittance = light.transmittance.data(), *radiance = light.radiance.data();
    for (std::size_t i = 0; i < n; ++i) {
        const double t = lowerWeight * static_cast<double>(lower[i]) +
                         upperWeight * static_cast<double>(upper[i]);
        const double absorbed = vectorAbsorbed(t);
        const double nearSource = nearMean[i] - sine * nearSlope[i];
        const double step = farMean[i] - sine * farSlope[i] - nearSource;
        radiance[i] += transmittance[i] * (nearSource * absorbed + step * slopeShare(t, absorbed));
        const double left = transmittance[i] * (1.0 - absorbed);
        transmittance[i] = left < 1e-150 ? 0.0 : left; // before numbers become slow
    }
}

} // namespace

PathLight lightAlong(const NodeColumn& column, const RayPath& path,
                     const ScatteredEmission& scattered) {
    const std::size_t n = column.size();
    PathLight light{std::vector<double>(n, 1.0), std::vector<double>(n, 0.0)};
    if (path.segments.empty())
        return light;

    SourceFunction source(column, scattered);
    PointSource near(n), far(n);
    const RaySegment& first = path.segments.front();
    source.at(static_cast<std::size_t>(first.layer), first.startAltitude_m, near);
    for (const RaySegment& segment : path.segments) {
        const auto layer = static_cast<std::size_t>(segment.layer);
        source.at(layer, segment.endAltitude_m, far);
        cross({segment.length_m * (1.0 - segment.meanFraction),
               segment.length_m * segment.meanFraction, segment.sinElevation,
               column.extinction(layer).data(), column.extinction(layer + 1).data()},
              near, far, light);
        std::swap(near, far);
    }
    return light;
}

} // namespace irsg
