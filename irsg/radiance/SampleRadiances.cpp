#include "irsg/radiance/SampleRadiances.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/LayerWalk.h"

namespace irsg {

namespace {

/// Pieces that samples are divided into, whatever the number of cores.
constexpr std::size_t evaluationParts = 16;

/// Radiances of the nodes of the tables in which lobes lie, of one part of the samples.
class SpecularRadiances {
  public:
    /// Of what one row of a surface mirrors, behind a front.
    struct OfRow {
        SurfaceStackId first; ///< of its places
        int rowsOfPlace = 1;
        std::vector<double> ofNodes; ///< by component; NaN where not known yet

        /// W m-2 sr-1; `ofPlace(kind)` is the radiance of a place.
        template <typename OfPlace>
        double at(const GeometrySamples& samples, const GeometrySamples::Specular& mirror,
                  OfPlace ofPlace) {
            const SpecularEnvironmentTable& table = *samples.specularTables[mirror.table];
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
                                ofPlace(SurfaceStackId{
                                    first.stack, first.row + static_cast<int>(i) * rowsOfPlace});
                    }
                    own +=
                        static_cast<double>(samples.specularScales[mirror.scales + k]) * radiance;
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
        double sum(const GeometrySamples& samples, const GeometrySamples::Specular& mirror,
                   OfPlace ofPlace) const {
            double radiance = (1.0 - next) * own->at(samples, mirror, ofPlace);
            if (behind)
                radiance += next * behind->at(samples, mirror, ofPlace);
            return radiance;
        }
    };

    /// Calls `isNew(kind)` for the places of a row that is asked for for the first time.
    template <typename IsNew>
    Found of(int stack, const SurfaceRows& rows, const GeometrySamples& samples,
             const GeometrySamples::Layer& layer, const GeometrySamples::Specular& mirror,
             IsNew isNew) {
        const SurfaceRows::Between between = rows.at(mirror.row, layer.distance_m);
        if (stack != stack_ || between.row != row_ || mirror.table != table_) {
            stack_ = stack;
            row_ = between.row;
            table_ = mirror.table;
            const int rowsOfPlace = rows.first(mirror.row + 1) - rows.first(mirror.row);
            const auto take = [&](int row) {
                OfRow& own = known_[{stack, row, mirror.table}];
                if (own.first.row < 0) {
                    own.first = {stack, row};
                    own.rowsOfPlace = rowsOfPlace;
                    const std::size_t places = samples.specularTables[mirror.table]->valuesOfNode();
                    for (std::size_t i = 0; i < places; ++i)
                        isNew(SurfaceStackId{stack, row + static_cast<int>(i) * rowsOfPlace});
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
    int stack_ = -1, row_ = -1;
    std::uint32_t table_ = 0;
    Found last_;
};

/// Some of the samples, and the kinds that they show, under numbers of its own.
class SamplesOfPart {
  public:
    SamplesOfPart(const SurfaceRows& rows, const OccluderStacks& occluderStacks,
                  const SurfaceRadianceTable& radiances, const SceneLight* light)
        : rows_(rows),
          occluderStacks_(occluderStacks),
          radiances_(radiances),
          light_(light),
          walk_(rows) {}

    /// Samples `first` to before `last`; false where some of their kinds are not prepared, which
    /// are all known by then.
    bool evaluate(const GeometrySamples& samples, std::size_t first, std::size_t last,
                  std::vector<float>& planes) {
        isPrepared_ = true;
        std::fill(planes.data() + 2 * first, planes.data() + 2 * last, 0.0f);
        for (std::size_t i = first; i < last; ++i)
            if (!samples.isEmpty(i))
                evaluateSample(samples, i, &planes[2 * i]);
        return isPrepared_;
    }
    const std::vector<SurfaceStackId>& kinds() const { return kinds_.kinds(); }
    const std::vector<OccluderMaterial>& materials(int stack) const {
        return walk_.occluderStacks().materials(stack);
    }
    /// Looks for kinds again, which have been prepared.
    void takePrepared() {
        for (std::size_t number = 0; number < known_.size(); ++number)
            known_[number] = find(kinds_.kinds()[number]);
    }

  private:
    struct Known {
        bool isPrepared = false;
        SurfaceStackRadiance radiance;
        const std::vector<SceneLight::AtReceiver>* light = nullptr; // where it matters
    };

    Known find(const SurfaceStackId& kind) const {
        const SurfaceStackId shared{occluderStacks_.find(materials(kind.stack)), kind.row};
        if (shared.stack < 0 || !radiances_.isPrepared(shared))
            return {};
        Known known{true, radiances_.of(shared), nullptr};
        if (light_ && light_->matters(rows_.renderedOf(kind.row))) {
            known.light = light_->findAtReceivers(shared);
            known.isPrepared = known.light != nullptr;
        }
        return known;
    }
    [[gnu::always_inline]] const Known& knownOf(const SurfaceStackId& kind) {
        const auto number = static_cast<std::size_t>(kinds_.kindOf(kind));
        if (number == known_.size())
            take(kind);
        return known_[number];
    }
    [[gnu::noinline]] void take(const SurfaceStackId& kind) {
        known_.push_back(find(kind));
        isPrepared_ = isPrepared_ && known_.back().isPrepared;
    }

    /// What a layer sends of what other surfaces send it.
    [[gnu::always_inline]] double received(const Known& known,
                                           const GeometrySamples::Layer& layer) const {
        double sum = 0.0;
        if (known.light && layer.place)
            for (const double of : lightAt(light_->exchange(), *known.light, *layer.place))
                sum += static_cast<double>(layer.coverage) * of;
        return sum;
    }

    void evaluateSample(const GeometrySamples& samples, std::size_t i, float* radianceAndOpacity) {
        double sent = 0.0, opacity = 0.0;
        walk_.forEachLayer(
            samples, i,
            [&](const SurfaceStackId& kind, float weight, const GeometrySamples::Layer& layer)
                __attribute__((always_inline)) {
                    const Known& known = knownOf(kind);
                    if (!isPrepared_)
                        return;
                    const SurfaceStackRadiance& radiance = known.radiance;
                    const auto coverage = static_cast<double>(layer.coverage);
                    double own = coverage * radiance.constant;
                    own += received(known, layer);
                    for (std::size_t f = 0; f < layer.factors.size(); ++f)
                        own += radiance.perFactor[f] * static_cast<double>(layer.factors[f]);
                    sent += static_cast<double>(weight) * own;
                    opacity += static_cast<double>(weight) * coverage * radiance.opacity;
                },
            [&](const SurfaceStackId& kind, float weight, const GeometrySamples::Layer& layer) {
                const Known& known = knownOf(kind);
                if (isPrepared_)
                    sent += static_cast<double>(weight) * received(known, layer);
            },
            [&](int stack, const GeometrySamples::Layer& layer,
                const GeometrySamples::Specular& mirror) {
                const auto found = mirrors_.of(stack, rows_, samples, layer, mirror,
                                               [&](const SurfaceStackId& kind) { knownOf(kind); });
                if (isPrepared_)
                    sent += found.sum(samples, mirror, [&](const SurfaceStackId& kind) {
                        return knownOf(kind).radiance.constant;
                    });
            });
        radianceAndOpacity[0] = static_cast<float>(sent);
        radianceAndOpacity[1] = static_cast<float>(opacity);
    }

    const SurfaceRows& rows_;
    const OccluderStacks& occluderStacks_;
    const SurfaceRadianceTable& radiances_;
    const SceneLight* light_;
    LayerWalk walk_;
    GeometryBuffer<double> kinds_; // for its numbers of kinds alone
    std::vector<Known> known_;     // by number
    bool isPrepared_ = true;       // every kind so far
    SpecularRadiances mirrors_;
};

} // namespace

SampleRadiances::SampleRadiances(const SurfaceRows& rows, OccluderStacks& occluderStacks,
                                 SurfaceRadianceTable& radiances, SceneLight* light)
    : rows_(rows), occluderStacks_(occluderStacks), radiances_(radiances), light_(light) {}

void SampleRadiances::evaluate(const GeometrySamples& samples, RadianceSamples& result) {
    const std::size_t count = samples.size();
    result.width = samples.width;
    result.height = samples.height;
    result.layersLeftOver = samples.layersLeftOver;
    result.planes.resize(2 * count);

    std::vector<SamplesOfPart> all(evaluationParts,
                                   SamplesOfPart(rows_, occluderStacks_, radiances_, light_));
    std::array<char, evaluationParts> isDone{};
    const auto evaluate = [&] {
        parallelFor(evaluationParts, [&](std::size_t p) {
            if (!isDone[p])
                isDone[p] =
                    all[p].evaluate(samples, beginOfPart(p, evaluationParts, count),
                                    beginOfPart(p + 1, evaluationParts, count), result.planes);
        });
        return std::ranges::find(isDone, 0) == isDone.end();
    };
    if (evaluate())
        return;

    std::vector<SurfaceStackId> kinds;
    for (std::size_t p = 0; p < evaluationParts; ++p)
        for (const SurfaceStackId& kind : all[p].kinds())
            if (!isDone[p])
                kinds.push_back({occluderStacks_.numberOf(all[p].materials(kind.stack)), kind.row});
    radiances_.prepare(kinds);
    if (light_) {
        std::vector<SurfaceStackId> lit;
        for (const SurfaceStackId& kind : kinds)
            if (light_->matters(rows_.renderedOf(kind.row)))
                lit.push_back(kind);
        light_->prepareAtReceivers(lit);
    }
    for (SamplesOfPart& part : all)
        part.takePrepared();
    if (!evaluate())
        throw LogicError("samples were evaluated of kinds that could not be prepared");
}

} // namespace irsg
