#include "irsg/scene/radiance/Reductions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "irsg/radiometry/ParallelFor.h"
#include "irsg/scene/radiance/LayerWalk.h"

namespace irsg {

namespace {

/// Pieces that samples are divided into, whatever the number of cores.
constexpr std::size_t reductionParts = 16;

/// Sum of what factors make of a kind; `numbers` begin with the coverage.
template <typename Real>
double radianceOf(const KindRadiance& kind, const Real* numbers) {
    double sum = kind.constant * static_cast<double>(numbers[0]);
    for (std::size_t f = 0; f < kind.perFactor.size(); ++f)
        sum += kind.perFactor[f] * static_cast<double>(numbers[1 + f]);
    return sum;
}

double dotProduct(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

/// Adds the light between surfaces to the sums over objects.
void addLightBetween(const LightSums& sums, SceneLight& light, const SurfaceRows& rows,
                     const std::vector<double>& ranges_m, std::vector<ObjectSums>& result) {
    const std::vector<FactorKind> kinds = light.inOrder(sums);
    light.prepare(kinds);
    std::vector<std::array<std::vector<double>, 2>> all(kinds.size());
    parallelFor(kinds.size(), [&](std::size_t k) {
        const std::vector<double>& own = sums.at({kinds[k].front, kinds[k].row});
        for (const bool withCosine : {false, true})
            all[k][withCosine ? 1 : 0] = light.contracted(kinds[k].row, own, withCosine);
    });
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto entity = static_cast<std::size_t>(rows.keyOf(rows.drawnOf(kinds[k].row)).first);
        const double square_m2 = ranges_m[entity] * ranges_m[entity];
        for (std::size_t output = 0; output < result.size(); ++output) {
            const std::span<const double> integrals = light.integrals(kinds[k], output);
            const double plain_W_m2 = dotProduct(all[k][0], integrals);
            ObjectRadiometry& object = result[output].objects[entity];
            object.intensity_W_sr += plain_W_m2 * square_m2;
            object.contrastIntensity_W_sr += plain_W_m2 * square_m2;
            object.irradiance_W_m2 += dotProduct(all[k][1], integrals);
        }
    }
}

} // namespace

namespace {

/// Of factors whose kinds are prepared.
std::vector<ObjectSums> sumsOf(const ViewFactors& view, const KindRadiances& radiances,
                               SceneLight* light, const SurfaceRows& rows,
                               const std::vector<double>& ranges_m,
                               const std::vector<int>& varying) {
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
        seen.push_back({static_cast<std::size_t>(rows.keyOf(drawn).first), numbers.data(),
                        radiances.inOutputs(kind)});
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
    parallelFor(reductionParts, [&](std::size_t part) {
        const std::size_t first = beginOfPart(part, reductionParts, result.size());
        const std::size_t last = beginOfPart(part + 1, reductionParts, result.size());
        for (const Seen& one : seen)
            for (std::size_t output = first; output < last; ++output)
                add(one, output);
    });
    if (light)
        addLightBetween(view.light, *light, rows, ranges_m, result);
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

} // namespace

std::vector<ObjectSums> objectSums(const ViewFactors& view, KindRadiances& radiances,
                                   SceneLight* light, const SurfaceRows& rows,
                                   const std::vector<double>& ranges_m,
                                   const std::vector<int>& varying) {
    radiances.prepare(view.field.kinds());
    return sumsOf(view, radiances, light, rows, ranges_m, varying);
}

std::vector<std::vector<ObjectSums>> contrastSums(const ViewFactors& view, KindRadiances& radiances,
                                                  SceneLight* light, const SurfaceRows& rows,
                                                  const std::vector<double>& ranges_m,
                                                  const std::vector<int>& varying) {
    for (const ViewFactors& contrast : view.contrasts)
        radiances.prepare(contrast.field.kinds());
    std::vector<std::vector<ObjectSums>> all(view.contrasts.size());
    const auto sum = [&](std::size_t k) {
        all[k] = sumsOf(view.contrasts[k], radiances, light, rows, ranges_m, varying);
    };
    // Light between surfaces is prepared as it is asked for.
    if (light == nullptr)
        parallelFor(all.size(), sum);
    for (std::size_t k = 0; light != nullptr && k < all.size(); ++k)
        sum(k);
    return all;
}

namespace {

/// Radiances of the nodes of the tables in which lobes lie, of one part of the samples.
class MirrorRadiances {
  public:
    /// Of what one row of a surface mirrors, behind a front.
    struct OfRow {
        FactorKind first; ///< of its places
        int rowsOfPlace = 1;
        std::vector<double> ofNodes; ///< by component; NaN where not known yet

        /// W m-2 sr-1; `ofPlace(kind)` is the radiance of a place.
        template <typename OfPlace>
        double at(const FactorSamples& samples, const FactorSamples::Mirror& mirror,
                  OfPlace ofPlace) {
            const MirrorTable& table = *samples.mirrorTables[mirror.table];
            double sum = 0.0;
            for (std::size_t n = 0; n < mirror.nodes.size(); ++n) {
                const std::size_t begin = mirror.nodes[n] * table.components;
                if (begin + table.components > ofNodes.size())
                    ofNodes.resize(begin + table.components,
                                   std::numeric_limits<double>::quiet_NaN());
                double own = 0.0;
                for (std::size_t k = 0; k < table.components; ++k) {
                    double& radiance = ofNodes[begin + k];
                    if (std::isnan(radiance)) {
                        radiance = 0.0;
                        const float* shares = table.of(mirror.nodes[n]);
                        for (std::size_t i = k * table.places; i < (k + 1) * table.places; ++i)
                            radiance +=
                                static_cast<double>(shares[i]) *
                                ofPlace(FactorKind{first.front,
                                                   first.row + static_cast<int>(i) * rowsOfPlace});
                    }
                    own += static_cast<double>(samples.mirrorScales[mirror.scales + k]) * radiance;
                }
                sum += static_cast<double>(mirror.weights[n]) * own;
            }
            return sum;
        }
    };
    /// The one row of a layer, or the two between which it lies.
    struct Found {
        OfRow *own = nullptr, *behind = nullptr;
        double next = 0.0;

        template <typename OfPlace>
        double sum(const FactorSamples& samples, const FactorSamples::Mirror& mirror,
                   OfPlace ofPlace) const {
            double radiance = (1.0 - next) * own->at(samples, mirror, ofPlace);
            if (behind)
                radiance += next * behind->at(samples, mirror, ofPlace);
            return radiance;
        }
    };

    /// Calls `isNew(kind)` for the places of a row that is asked for for the first time.
    template <typename IsNew>
    Found of(int front, const SurfaceRows& rows, const FactorSamples& samples,
             const FactorSamples::Layer& layer, const FactorSamples::Mirror& mirror, IsNew isNew) {
        const SurfaceRows::Between between = rows.at(mirror.row, layer.distance_m);
        if (front != front_ || between.row != row_ || mirror.table != table_) {
            front_ = front;
            row_ = between.row;
            table_ = mirror.table;
            const int rowsOfPlace = rows.first(mirror.row + 1) - rows.first(mirror.row);
            const auto take = [&](int row) {
                OfRow& own = known_[{front, row, mirror.table}];
                if (own.first.row < 0) {
                    own.first = {front, row};
                    own.rowsOfPlace = rowsOfPlace;
                    const std::size_t places = samples.mirrorTables[mirror.table]->valuesOfNode();
                    for (std::size_t i = 0; i < places; ++i)
                        isNew(FactorKind{front, row + static_cast<int>(i) * rowsOfPlace});
                }
                return &own;
            };
            last_.own = take(between.row);
            last_.behind = rows.isSliced(mirror.row) ? take(between.row + 1) : nullptr;
        }
        last_.next = static_cast<double>(between.next);
        return last_;
    }

  private:
    struct Unknown : OfRow {
        Unknown() { first.row = -1; }
    };
    std::map<std::tuple<int, int, std::uint32_t>, Unknown> known_; // front, row, table
    int front_ = -1, row_ = -1;
    std::uint32_t table_ = 0;
    Found last_;
};

} // namespace

SampleRadiances::SampleRadiances(const SurfaceRows& rows, Fronts& fronts, KindRadiances& radiances,
                                 SceneLight* light)
    : rows_(rows), fronts_(fronts), radiances_(radiances), light_(light) {}

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
        MirrorRadiances mirrors;
        std::vector<KindRadiance> radiances;
        std::vector<const std::vector<SceneLight::AtReceiver>*> light; // null where it is no matter
    };
    std::vector<Part> all(reductionParts, Part(rows_));
    parallelFor(reductionParts, [&](std::size_t p) {
        for (std::size_t i = beginOfPart(p, reductionParts, count);
             i < beginOfPart(p + 1, reductionParts, count); ++i)
            all[p].walk.forEachLayer(
                samples, i,
                [&](const FactorKind& kind, float, const FactorSamples::Layer&) {
                    all[p].kinds.kindOf(kind);
                },
                [&](int front, const FactorSamples::Layer& layer,
                    const FactorSamples::Mirror& mirror) {
                    all[p].mirrors.of(front, rows_, samples, layer, mirror,
                                      [&](const FactorKind& kind) { all[p].kinds.kindOf(kind); });
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
    if (light_) {
        light_->prepare(kinds);
        for (Part& part : all)
            for (const FactorKind& kind : part.kinds.kinds())
                part.light.push_back(light_->matters(rows_.drawnOf(kind.row))
                                         ? &light_->atReceivers(shared(part, kind))
                                         : nullptr);
    }

    parallelFor(reductionParts, [&](std::size_t p) {
        Part& part = all[p];
        for (std::size_t i = beginOfPart(p, reductionParts, count);
             i < beginOfPart(p + 1, reductionParts, count); ++i) {
            double sent = 0.0, opacity = 0.0;
            part.walk.forEachLayer(
                samples, i,
                [&](const FactorKind& kind, float weight, const FactorSamples::Layer& layer) {
                    const auto number = static_cast<std::size_t>(part.kinds.kindOf(kind));
                    const KindRadiance& radiance = part.radiances[number];
                    const auto coverage = static_cast<double>(layer.coverage);
                    double own = coverage * radiance.constant;
                    if (light_ && part.light[number] && layer.place)
                        for (const double of :
                             lightAt(light_->exchange(), *part.light[number], *layer.place))
                            own += coverage * of;
                    for (std::size_t f = 0; f < layer.factors.size(); ++f)
                        own += radiance.perFactor[f] * static_cast<double>(layer.factors[f]);
                    sent += static_cast<double>(weight) * own;
                    opacity += static_cast<double>(weight) * coverage * radiance.opacity;
                },
                [&](int front, const FactorSamples::Layer& layer,
                    const FactorSamples::Mirror& mirror) {
                    const auto ofPlace = [&](const FactorKind& kind) {
                        return part.radiances[static_cast<std::size_t>(part.kinds.kindOf(kind))]
                            .constant;
                    };
                    sent += part.mirrors
                                .of(front, rows_, samples, layer, mirror, [](const FactorKind&) {})
                                .sum(samples, mirror, ofPlace);
                });
            result.planes[2 * i] = static_cast<float>(sent);
            result.planes[2 * i + 1] = static_cast<float>(opacity);
        }
    });
}

void addPixels(const PixelFactors& pixels, int width_px, KindRadiances& radiances,
               SceneLight* light, FrameReduction& frame) {
    radiances.prepare(pixels.field.kinds());
    std::vector<KindRadiance> known;
    for (const FactorKind& kind : pixels.field.kinds())
        known.push_back(radiances.of(kind));
    std::vector<double> ofReceivers;
    if (light)
        ofReceivers = radiancesOf(pixels.light.kinds(), pixels.receivers, *light);
    for (std::size_t cell = 0; cell < pixels.field.cells(); ++cell) {
        double sent = 0.0, opacity = 0.0;
        bool isSeen = false;
        if (light)
            pixels.light.forEach(cell, [&](std::size_t kind, std::span<const float> numbers) {
                sent += ofReceivers[kind] * static_cast<double>(numbers[0]);
            });
        pixels.field.forEach(cell, [&](std::size_t kind, std::span<const float> numbers) {
            sent += radianceOf(known[kind], numbers.data());
            opacity += known[kind].opacity * static_cast<double>(numbers[0]);
            isSeen = true;
        });
        if (isSeen)
            frame.addPoint(static_cast<int>(cell) % width_px, static_cast<int>(cell) / width_px,
                           sent, opacity);
    }
}

double lightOfPoint(const PointFactors& atUnitDistance, const SurfaceRows& rows,
                    SceneLight& light) {
    double sent = 0.0;
    for (const auto& [drawn, sums] : atUnitDistance.light_sr_m2) {
        const FactorKind kind{drawn.first, rows.first(drawn.second)};
        if (!light.matters(rows.drawnOf(kind.row)))
            continue;
        light.prepare({kind});
        sent += dotProduct(light.contracted(kind.row, sums, false), light.integrals(kind, 0));
    }
    return sent;
}

void addPointToPixel(const PointFactors& atUnitDistance, const SurfaceRows& rows,
                     const PointPlace& place, KindRadiances& radiances, SceneLight* light,
                     FrameReduction& frame) {
    const double scale = 1.0 / (place.distance_m * place.distance_m * place.solidAngle_sr);
    double sent = 0.0, opacity = 0.0;
    if (light)
        sent += scale * lightOfPoint(atUnitDistance, rows, *light);
    const FactorField<double>& field = atUnitDistance.sums_sr_m2;
    field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const FactorKind& drawn = field.kinds()[number];
        const FactorKind kind{drawn.front, rows.first(drawn.row)};
        radiances.prepare({kind});
        const KindRadiance radiance = radiances.of(kind);
        sent += scale * radianceOf(radiance, numbers.data());
        opacity += scale * radiance.opacity * numbers[0];
    });
    frame.addPoint(place.x, place.y, sent, opacity);
}

} // namespace irsg
