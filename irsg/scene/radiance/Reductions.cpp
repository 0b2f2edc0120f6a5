#include "irsg/scene/radiance/Reductions.h"

#include <algorithm>
#include <array>

#include "irsg/radiometry/ParallelFor.h"
#include "irsg/scene/radiance/LayerWalk.h"

namespace irsg {

namespace {

/// Pieces that samples are divided into, whatever the number of cores.
constexpr std::size_t parts = 16;

/// Sum of what factors make of a kind; `numbers` begin with the coverage.
template <typename Real>
double radianceOf(const KindRadiance& kind, const Real* numbers) {
    double sum = kind.constant * static_cast<double>(numbers[0]);
    for (std::size_t f = 0; f < kind.perFactor.size(); ++f)
        sum += kind.perFactor[f] * static_cast<double>(numbers[1 + f]);
    return sum;
}

} // namespace

std::vector<ObjectSums> objectSums(const ViewFactors& view, KindRadiances& radiances,
                                   const SurfaceRows& rows, const std::vector<double>& ranges_m,
                                   const std::vector<int>& varying) {
    radiances.prepare(view.field.kinds());
    const ViewLayout& layout = view.layout;
    struct Seen {
        std::size_t entity;
        const double* numbers;
        KindRadiances::InOutputs radiance;
    };
    std::vector<Seen> seen;
    view.field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const FactorKind& kind = view.field.kinds()[number];
        const int drawn = rows.drawnOf(kind.row);
        seen.push_back(
            {static_cast<std::size_t>(rows.keys()[static_cast<std::size_t>(drawn)].first),
             numbers.data(), radiances.inOutputs(kind)});
    });
    std::vector<ObjectSums> result(radiances.outputs());
    for (ObjectSums& sums : result)
        sums.objects.resize(ranges_m.size());

    const auto add = [&](const Seen& one, std::size_t output) {
        const KindRadiance radiance = one.radiance.at(output);
        const double* plain = one.numbers + layout.coverage();
        const double* cosine = one.numbers + layout.withCosine(layout.coverage());

        // The background that this surface hides, as seen through what is in front of it.
        double hidden_W_m2 = radiance.hidden * *plain;
        double hiddenCos_W_m2 = radiance.hidden * *cosine;
        if (const int k = varying[output]; k >= 0) {
            const auto background = static_cast<std::size_t>(k);
            hidden_W_m2 = radiance.opacity * one.numbers[layout.background(background)];
            hiddenCos_W_m2 = radiance.opacity * one.numbers[layout.backgroundCosine(background)];
        }
        const double square_m2 = ranges_m[one.entity] * ranges_m[one.entity];
        const double sent_W_m2 = radianceOf(radiance, plain);
        ObjectRadiometry& object = result[output].objects[one.entity];
        object.intensity_W_sr += sent_W_m2 * square_m2;
        object.contrastIntensity_W_sr += (sent_W_m2 - hidden_W_m2) * square_m2;
        object.irradiance_W_m2 += radianceOf(radiance, cosine) - hiddenCos_W_m2;
        object.coveredPixels += radiance.opacity * one.numbers[layout.pixels()];
        object.solidAngle_sr += radiance.opacity * *plain;
    };
    // Outputs do not meet, so that some can be summed on a core of their own.
    parallelFor(parts, [&](std::size_t part) {
        const std::size_t first = beginOfPart(part, parts, result.size());
        const std::size_t last = beginOfPart(part + 1, parts, result.size());
        for (const Seen& one : seen)
            for (std::size_t output = first; output < last; ++output)
                add(one, output);
    });
    for (ObjectSums& sums : result)
        for (const ObjectRadiometry& object : sums.objects) {
            sums.all.intensity_W_sr += object.intensity_W_sr;
            sums.all.contrastIntensity_W_sr += object.contrastIntensity_W_sr;
            sums.all.irradiance_W_m2 += object.irradiance_W_m2;
            sums.all.coveredPixels += object.coveredPixels;
            sums.all.solidAngle_sr += object.solidAngle_sr;
        }
    return result;
}

SampleRadiances::SampleRadiances(const SurfaceRows& rows, Fronts& fronts, KindRadiances& radiances)
    : rows_(rows), fronts_(fronts), radiances_(radiances) {}

void SampleRadiances::evaluate(const FactorSamples& samples, RadianceSamples& result) {
    const std::size_t count = samples.size();
    result.width = samples.width;
    result.height = samples.height;
    result.layersLeftOver = samples.layersLeftOver;
    result.planes.assign(2 * count, 0.0f);

    // Which kinds there are, numbered by each part for itself.
    struct Part {
        explicit Part(const SurfaceRows& rows) : walk(rows) {}
        LayerWalk walk;
        FactorField<double> kinds; // for its numbers of kinds alone
        std::vector<KindRadiance> radiances;
    };
    std::vector<Part> all(parts, Part(rows_));
    parallelFor(parts, [&](std::size_t p) {
        for (std::size_t i = beginOfPart(p, parts, count); i < beginOfPart(p + 1, parts, count);
             ++i)
            all[p].walk.forEachLayer(
                samples, i, [&](const FactorKind& kind, float, const FactorSamples::Layer&) {
                    all[p].kinds.kindOf(kind);
                });
    });
    const auto shared = [&](const Part& part, const FactorKind& kind) {
        return FactorKind{fronts_.numberOf(part.walk.fronts().materials(kind.front)), kind.row};
    };
    std::vector<FactorKind> kinds;
    for (const Part& part : all)
        for (const FactorKind& kind : part.kinds.kinds())
            kinds.push_back(shared(part, kind));
    radiances_.prepare(kinds);
    for (Part& part : all)
        for (const FactorKind& kind : part.kinds.kinds())
            part.radiances.push_back(radiances_.of(shared(part, kind)));

    parallelFor(parts, [&](std::size_t p) {
        Part& part = all[p];
        for (std::size_t i = beginOfPart(p, parts, count); i < beginOfPart(p + 1, parts, count);
             ++i) {
            double sent = 0.0, opacity = 0.0;
            part.walk.forEachLayer(
                samples, i,
                [&](const FactorKind& kind, float weight, const FactorSamples::Layer& layer) {
                    const KindRadiance& radiance =
                        part.radiances[static_cast<std::size_t>(part.kinds.kindOf(kind))];
                    const auto coverage = static_cast<double>(layer.coverage);
                    double own = coverage * radiance.constant;
                    for (std::size_t f = 0; f < layer.factors.size(); ++f)
                        own += radiance.perFactor[f] * static_cast<double>(layer.factors[f]);
                    sent += static_cast<double>(weight) * own;
                    opacity += static_cast<double>(weight) * coverage * radiance.opacity;
                });
            result.planes[2 * i] = static_cast<float>(sent);
            result.planes[2 * i + 1] = static_cast<float>(opacity);
        }
    });
}

void addPixels(const FactorField<float>& pixels, int width_px, KindRadiances& radiances,
               FrameReduction& frame) {
    radiances.prepare(pixels.kinds());
    std::vector<KindRadiance> known;
    for (const FactorKind& kind : pixels.kinds())
        known.push_back(radiances.of(kind));
    for (std::size_t cell = 0; cell < pixels.cells(); ++cell) {
        double sent = 0.0, opacity = 0.0;
        bool isSeen = false;
        pixels.forEach(cell, [&](std::size_t kind, std::span<const float> numbers) {
            sent += radianceOf(known[kind], numbers.data());
            opacity += known[kind].opacity * static_cast<double>(numbers[0]);
            isSeen = true;
        });
        if (isSeen)
            frame.addPoint(static_cast<int>(cell) % width_px, static_cast<int>(cell) / width_px,
                           sent, opacity);
    }
}

void addPointToPixel(const FactorField<double>& atUnitDistance_sr_m2, const SurfaceRows& rows,
                     const PointPlace& place, KindRadiances& radiances, FrameReduction& frame) {
    const double scale = 1.0 / (place.distance_m * place.distance_m * place.solidAngle_sr);
    double sent = 0.0, opacity = 0.0;
    atUnitDistance_sr_m2.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const FactorKind& drawn = atUnitDistance_sr_m2.kinds()[number];
        const FactorKind kind{drawn.front, rows.first(drawn.row)};
        radiances.prepare({kind});
        const KindRadiance radiance = radiances.of(kind);
        sent += scale * radianceOf(radiance, numbers.data());
        opacity += scale * radiance.opacity * numbers[0];
    });
    frame.addPoint(place.x, place.y, sent, opacity);
}

} // namespace irsg
