#include "irsg/atmosphere/engine/PathIntegrator.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/VectorClones.h"
#include "irsg/radiometry/VectorExp.h"

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
struct SourceRows {
    const float *extinction, *scattering;

    SourceRows(const NodeColumn& column, std::size_t level)
        : extinction(column.extinction(level).data()),
          scattering(column.scattering(level).data()) {}
};

/// From light that is scattered into the ray to the source function, at a level.
IRSG_VECTOR_CLONES void sourceAt(const SourceRows& level, const double* planck, std::size_t n,
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
IRSG_VECTOR_CLONES void sourceBetween(const SourceRows& lower, const SourceRows& upper, double f,
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

} // namespace

LevelSources::LevelSources(const NodeColumn& column, ScatteredEmission scattered)
    : column_(column), scattered_(std::move(scattered)), levels_(column.air().levelCount()) {}

void LevelSources::scatteredAt(std::size_t level, Rows& rows) const {
    if (scattered_) {
        scattered_(level, rows.mean, rows.slope);
    } else {
        std::ranges::fill(rows.mean, 0.0);
        std::ranges::fill(rows.slope, 0.0);
    }
}

const LevelSources::Rows& LevelSources::at(std::size_t index) const {
    Level& level = levels_.at(index);
    level.once.call([&] {
        Rows rows(column_.size());
        scatteredAt(index, rows);
        sourceAt(SourceRows(column_, index), column_.planck(index).data(), column_.size(),
                 rows.mean.data(), rows.slope.data());
        level.rows = std::move(rows);
    });
    return level.rows;
}

void LevelSources::between(std::size_t layer, double f, Rows& rows) const {
    const std::size_t n = column_.size();
    Rows above(n);
    scatteredAt(layer, rows);
    scatteredAt(layer + 1, above);
    mix(f, above.mean.data(), n, rows.mean.data());
    mix(f, above.slope.data(), n, rows.slope.data());
    const std::vector<double>& altitudes_m = column_.air().altitudes_m();
    const double altitude_m =
        altitudes_m[layer] + f * (altitudes_m[layer + 1] - altitudes_m[layer]);
    std::vector<double> planck(n);
    column_.planckAt(column_.air().profile().at(altitude_m).temperature_K, planck);
    sourceBetween(SourceRows(column_, layer), SourceRows(column_, layer + 1), f, planck.data(), n,
                  rows.mean.data(), rows.slope.data());
}

BeamSources::BeamSources(const NodeColumn& column, std::size_t kinds, BeamEmission emission)
    : column_(column),
      kinds_(kinds),
      emission_(std::move(emission)),
      levels_(kinds * column.air().levelCount()) {}

BeamSources::Row BeamSources::emittedAt(std::size_t level, std::size_t kind) const {
    Row row(column_.size());
    return emission_(level, kind, row) ? row : Row();
}

const BeamSources::Row& BeamSources::at(std::size_t index, std::size_t kind) const {
    Level& level = levels_.at(index * kinds_ + kind);
    level.once.call([&] {
        Row row = emittedAt(index, kind);
        const float* extinction = column_.extinction(index).data();
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = extinction[i] > 0.0f ? row[i] / static_cast<double>(extinction[i]) : 0.0;
        level.row = std::move(row);
    });
    return level.row;
}

BeamSources::Row BeamSources::between(std::size_t layer, double f, std::size_t kind) const {
    // From the sources at the levels back to what they emit.
    const Row &below = at(layer, kind), &above = at(layer + 1, kind);
    if (below.empty() && above.empty())
        return {};
    const float* lower = column_.extinction(layer).data();
    const float* upper = column_.extinction(layer + 1).data();
    Row row(column_.size(), 0.0);
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double low = (1.0 - f) * static_cast<double>(lower[i]);
        const double high = f * static_cast<double>(upper[i]);
        if (low + high > 0.0)
            row[i] =
                ((below.empty() ? 0.0 : low * below[i]) + (above.empty() ? 0.0 : high * above[i])) /
                (low + high);
    }
    return row;
}

namespace {

/// Where an end of a piece stands in its layer, 0 to 1; what is next to a level is at it.
double partOf(const NodeColumn& column, std::size_t layer, double altitude_m) {
    const std::vector<double>& altitudes_m = column.air().altitudes_m();
    const double f = std::clamp((altitude_m - altitudes_m[layer]) /
                                    (altitudes_m[layer + 1] - altitudes_m[layer]),
                                0.0, 1.0);
    constexpr double same = 1e-9;
    return f < same ? 0.0 : f > 1.0 - same ? 1.0 : f;
}

/// The source function where a ray enters or leaves a piece: that of a level, or in `room`.
const LevelSources::Rows& sourceAtEnd(const LevelSources& sources, std::size_t layer,
                                      double altitude_m, LevelSources::Rows& room) {
    const double f = partOf(sources.column(), layer, altitude_m);
    if (f == 0.0 || f == 1.0)
        return sources.at(f == 0.0 ? layer : layer + 1);
    if (room.mean.empty())
        room = LevelSources::Rows(sources.column().size());
    sources.between(layer, f, room);
    return room;
}

/// The same of the beam.
const BeamSources::Row& beamAtEnd(const BeamSources& beams, const NodeColumn& column,
                                  std::size_t layer, double altitude_m, std::size_t kind,
                                  BeamSources::Row& room) {
    const double f = partOf(column, layer, altitude_m);
    if (f == 0.0 || f == 1.0)
        return beams.at(f == 0.0 ? layer : layer + 1, kind);
    return room = beams.between(layer, f, kind);
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

/// A piece of a ray between two levels, and what is seen through it.
struct Crossing {
    double lowerWeight_m, upperWeight_m, sinElevation;
    const float *lower, *upper; ///< extinction at the levels
};

/// How much the sources at the near end of a piece, and their difference to the far end, add to
/// what is seen, per node.
struct Shares {
    std::vector<double> near, difference;
};

/// Source functions at an end of a piece, per node.
struct EndSources {
    const double *mean, *slope;
};

/// Adds what a piece of a ray sends through everything before it. What is written lies over nothing
/// else, which compilers need to be told to make vectors of so many places.
IRSG_VECTOR_CLONES void cross(const Crossing& piece, const EndSources& near, const EndSources& far,
                              std::size_t n, double* __restrict transmittance,
                              double* __restrict radiance, double* __restrict ofNear,
                              double* __restrict ofDifference) {
    const double lowerWeight = piece.lowerWeight_m, upperWeight = piece.upperWeight_m;
    const double sine = piece.sinElevation;
    const float *lower = piece.lower, *upper = piece.upper;
    const double *nearMean = near.mean, *nearSlope = near.slope;
    const double *farMean = far.mean, *farSlope = far.slope;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = lowerWeight * static_cast<double>(lower[i]) +
                         upperWeight * static_cast<double>(upper[i]);
        const double absorbed = vectorAbsorbed(t);
        const double nearSource = nearMean[i] - sine * nearSlope[i];
        const double step = farMean[i] - sine * farSlope[i] - nearSource;
        const double through = transmittance[i];
        const double share = through * absorbed, shareOfStep = through * slopeShare(t, absorbed);
        ofNear[i] = share;
        ofDifference[i] = shareOfStep;
        radiance[i] += share * nearSource + shareOfStep * step;
        const double left = through * (1.0 - absorbed);
        transmittance[i] = left < 1e-150 ? 0.0 : left; // before numbers become slow
    }
}

IRSG_VECTOR_CLONES void addWeighted(const double* weight, double sign, const double* row,
                                    std::size_t n, double* sum) {
    for (std::size_t i = 0; i < n; ++i)
        sum[i] += sign * weight[i] * row[i];
}

/// Adds one kind of the beam over a piece between sources that may be nothing.
void crossBeam(const BeamSources::Row& near, const BeamSources::Row& far, const Shares& shares,
               std::vector<double>& radiance) {
    if (!near.empty()) {
        addWeighted(shares.near.data(), 1.0, near.data(), near.size(), radiance.data());
        addWeighted(shares.difference.data(), -1.0, near.data(), near.size(), radiance.data());
    }
    if (!far.empty())
        addWeighted(shares.difference.data(), 1.0, far.data(), far.size(), radiance.data());
}

} // namespace

PathLight integratePath(const LevelSources& sources, const RayPath& path,
                        const BeamSources* beams) {
    const NodeColumn& column = sources.column();
    const std::size_t n = column.size();
    const std::size_t kinds = beams ? beams->kinds() : 0;
    PathLight light{std::vector<double>(n, 1.0), std::vector<double>(n, 0.0),
                    std::vector<std::vector<double>>(kinds, std::vector<double>(n, 0.0))};
    if (path.segments.empty())
        return light;

    LevelSources::Rows rooms[2]; // for the ends of a path, between levels, in turn
    std::vector<BeamSources::Row> beamRooms[2] = {std::vector<BeamSources::Row>(kinds),
                                                  std::vector<BeamSources::Row>(kinds)};
    Shares shares{std::vector<double>(n), std::vector<double>(n)};
    const RaySegment& first = path.segments.front();
    const auto firstLayer = static_cast<std::size_t>(first.layer);
    const LevelSources::Rows* near =
        &sourceAtEnd(sources, firstLayer, first.startAltitude_m, rooms[0]);
    std::vector<const BeamSources::Row*> nearBeams(kinds), farBeams(kinds);
    for (std::size_t kind = 0; kind < kinds; ++kind)
        nearBeams[kind] =
            &beamAtEnd(*beams, column, firstLayer, first.startAltitude_m, kind, beamRooms[0][kind]);
    std::size_t room = 1;
    for (const RaySegment& segment : path.segments) {
        const auto layer = static_cast<std::size_t>(segment.layer);
        const LevelSources::Rows& far =
            sourceAtEnd(sources, layer, segment.endAltitude_m, rooms[room]);
        cross({segment.length_m * (1.0 - segment.meanFraction),
               segment.length_m * segment.meanFraction, segment.sinElevation,
               column.extinction(layer).data(), column.extinction(layer + 1).data()},
              {near->mean.data(), near->slope.data()}, {far.mean.data(), far.slope.data()}, n,
              light.transmittance.data(), light.radiance.data(), shares.near.data(),
              shares.difference.data());
        near = &far;
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            farBeams[kind] = &beamAtEnd(*beams, column, layer, segment.endAltitude_m, kind,
                                        beamRooms[room][kind]);
            crossBeam(*nearBeams[kind], *farBeams[kind], shares, light.beams[kind]);
        }
        std::swap(nearBeams, farBeams);
        room = 1 - room;
    }
    return light;
}

PathLight integratePath(const NodeColumn& column, const RayPath& path,
                        ScatteredEmission scattered) {
    return integratePath(LevelSources(column, std::move(scattered)), path);
}

} // namespace irsg
