#include "irsg/radiance/exchange/SceneLight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/exchange/GatheredSums.h"
#include "irsg/radiometry/DotProducts.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Bands in which integrals are kept, some kB a kind and band; a spectrum has too many outputs.
constexpr std::size_t mostOutputsCached = 128;
/// Of the integrals of kinds, 32 MiB, where other views of a sweep may ask for them again.
constexpr std::size_t mostNumbersKept = std::size_t{1} << 22;
/// A view has about thirty sums of each kind of receivers, half of which it sees (its own, and the
/// differences of its sublattices).
constexpr std::size_t mostOutputsAtReceivers = 8;

/// What a cos^N lobe sends on the whole, as a part of what it would for N = 0.
double hemispherical(double nAngleFactor) {
    return 2.0 / (2.0 + nAngleFactor);
}

} // namespace

std::vector<double> passingOf(const OccluderMaterial& pane, const LightExchange& exchange,
                              const SceneRadiometry& radiometry) {
    if (isGasColumn(pane.second))
        return radiometry.gasColumn(pane.first, pane.second).transmittance.plain;
    if (pane != groundMaterial)
        return radiometry.transmissivity(pane.first, pane.second);
    std::vector<double> reflectivity;
    for (const double wavelength_um : radiometry.wavelengths_um())
        reflectivity.push_back(exchange.groundReflectivity()->at(wavelength_um));
    return reflectivity;
}

std::vector<std::vector<double>> gasSharesOf(const LightExchange& exchange,
                                             const SceneRadiometry& radiometry) {
    std::vector<std::vector<double>> all;
    for (std::size_t pane = exchange.firstGasPane();
         pane < exchange.panes().size() && !exchange.throughGas().empty(); ++pane) {
        const auto& [entity, number] = exchange.panes()[pane];
        const GasColumnSpectra::Column& column = radiometry.gasColumn(entity, number);
        for (const LightExchange::GasSender& gas : exchange.gasSenders()) {
            const auto share = column.shares.find(gas.codes);
            const bool isIn = gas.entity == entity && share != column.shares.end();
            all.push_back(isIn ? share->second.plain
                               : std::vector<double>(radiometry.wavelengths_um().size(), 0.0));
        }
    }
    return all;
}

const std::vector<std::uint32_t>& receiversOf(int row, const SurfaceRows& rows,
                                              const LightExchange& exchange) {
    static const std::vector<std::uint32_t> none;
    const int rendered = rows.renderedOf(row);
    if (rows.isOfSurfaces(rendered))
        return exchange.reflected();
    const auto drawn = static_cast<std::size_t>(rows.surfaceOf(rendered));
    return drawn < exchange.rows() ? exchange.ofRow(static_cast<int>(drawn)) : none;
}

SceneLight::SceneLight(std::shared_ptr<const LightExchange> exchange,
                       const SceneRadiometry& radiometry, const OccluderStacks& occluderStacks,
                       const RenderSettings& settings, LightSolutions& solutions)
    : exchange_(std::move(exchange)),
      radiometry_(radiometry),
      occluderStacks_(occluderStacks),
      bounces_(settings.bounces) {
    findColumns();
    findKnots(settings);
    knotsOfNodes_.count = knots_.size();
    fillSources();
    solution_ =
        solutions.of(exchange_, columns_, knots_, settings.bounces, 0.02 * settings.lightError);
}

bool SceneLight::matters(int drawn) const {
    const SurfaceRows& rows = radiometry_.rows();
    if (rows.isLobe(drawn))
        return !rows.lobe(drawn).isOfAtmosphere() && matters(rows.surfaceOf(drawn));
    return static_cast<std::size_t>(drawn) < exchange_->rows() && exchange_->seesAnything(drawn) &&
           std::ranges::any_of(radiometry_.surfaces()[static_cast<std::size_t>(drawn)].reflectance,
                               [](double value) { return value > leastReflectance_per_sr; });
}

const std::vector<double>& SceneLight::lightOn(int drawn, int term) const {
    return *radiometry_.air(radiometry_.rows().first(drawn)).light[static_cast<std::size_t>(term)];
}

void SceneLight::fillSources() {
    sources_W_m2_um_.assign(columns_.size(), {});
    parallelFor(columns_.size(), [&](std::size_t c) {
        const LightColumn& column = columns_[c];
        const SurfaceSpectra& surface =
            radiometry_.surfaces()[static_cast<std::size_t>(column.row)];
        std::vector<double>& source = sources_W_m2_um_[c];
        source.assign(radiometry_.wavelengths_um().size(), 0.0);
        if (column.pattern == LightPattern::emission) {
            const double whole = pi * hemispherical(surface.nAngleFactor);
            for (const SurfaceSpectra::Emission& part : surface.emission)
                for (std::size_t i = 0; i < source.size(); ++i)
                    source[i] += whole * part.factor * part.radiance[i];
            return;
        }
        const std::vector<double>& light = lightOn(column.row, static_cast<int>(column.term));
        if (column.isPassed()) {
            source = light;
            return;
        }
        for (std::size_t i = 0; i < source.size(); ++i)
            source[i] = pi * surface.reflectance[i] * light[i];
    });
}

void SceneLight::turn() {
    fillSources();
    known_.clear();
    atReceivers_.clear();
    sent_.clear();
    responses_.clear();
}

std::vector<SurfaceStackId> SceneLight::inOrder(const LightSums& sums) const {
    std::vector<SurfaceStackId> kinds;
    for (const auto& [kind, numbers] : sums)
        kinds.push_back({kind.first, kind.second});
    std::ranges::sort(kinds, [&](const SurfaceStackId& a, const SurfaceStackId& b) {
        const auto &before = occluderStacks_.materials(a.stack),
                   &after = occluderStacks_.materials(b.stack);
        return before == after ? a.row < b.row : before < after;
    });
    return kinds;
}

void SceneLight::prepare(const std::vector<SurfaceStackId>& kinds) {
    if (radiometry_.outputs().size() > mostOutputsCached)
        return;
    std::vector<SurfaceStackId> missing;
    std::vector<std::vector<std::vector<double>>*> places;
    for (const SurfaceStackId& kind : kinds)
        if (matters(radiometry_.rows().renderedOf(kind.row))) {
            const auto [place, isNew] = known_.try_emplace({kind.stack, kind.row});
            if (isNew) {
                missing.push_back(kind);
                places.push_back(&place->second);
            }
        }
    std::vector<std::vector<std::vector<double>>> found = integrator().ofAll(missing);
    for (std::size_t k = 0; k < missing.size(); ++k)
        *places[k] = std::move(found[k]);
}

std::span<const double> SceneLight::integrals(const SurfaceStackId& kind, std::size_t output) {
    if (radiometry_.outputs().size() > mostOutputsCached)
        return passing_ = integrator().of(kind, output);
    const auto known = known_.find({kind.stack, kind.row});
    if (known == known_.end())
        throw LogicError("light between surfaces was asked for of a kind that was not prepared");
    return known->second[output];
}

std::vector<double> SceneLight::contracted(int row, const ReceiverSums& sums,
                                           bool withCosine) const {
    std::vector<double> all(width(), 0.0);
    const std::vector<std::uint32_t>& receivers = receiversOf(row);
    for (const ReceiverSums::Entry& seen : sums.entries()) {
        const double weight = seen.weights[withCosine ? 1 : 0];
        if (weight == 0.0)
            continue;
        const std::uint32_t receiver = receivers[seen.receiver];
        const LightExchange::Loss& loss = exchange_->loss(receiver);
        all[0] += weight * loss.sky;
        all[1] += weight * loss.ground;
        const std::span<const float> gathered = solution_->of(receiver);
        for (std::size_t k = 0; k < gathered.size(); ++k)
            all[2 + k] += weight * static_cast<double>(gathered[k]);
    }
    return all;
}

const std::vector<SceneLight::AtReceiver>*
SceneLight::findAtReceivers(const SurfaceStackId& kind) const {
    const auto place = atReceivers_.find({kind.stack, kind.row});
    return place == atReceivers_.end() ? nullptr : &place->second;
}

const std::vector<SceneLight::AtReceiver>& SceneLight::atReceivers(const SurfaceStackId& kind) {
    const auto place = atReceivers_.find({kind.stack, kind.row});
    if (place != atReceivers_.end())
        return place->second;
    prepareAtReceivers({kind});
    return atReceivers_.at({kind.stack, kind.row});
}

void SceneLight::prepareAtReceivers(const std::vector<SurfaceStackId>& kinds) {
    struct Missing {
        std::vector<std::span<const double>> integrals;
        std::vector<std::vector<AtReceiver>*> places;
    };
    prepare(kinds);
    // Kinds of the same receivers share what is read of what these gather.
    std::map<const std::vector<std::uint32_t>*, Missing> missing;
    const bool areKept = radiometry_.outputs().size() <= mostOutputsCached;
    for (const SurfaceStackId& kind : kinds) {
        const auto [place, isNew] = atReceivers_.try_emplace({kind.stack, kind.row});
        if (!isNew)
            continue;
        const std::vector<std::uint32_t>& receivers = receiversOf(kind.row);
        place->second.resize(receivers.size());
        if (!areKept) { // the next integrals take the place of these
            fillAtReceivers(receivers, {integrals(kind, 0)}, {&place->second});
            continue;
        }
        Missing& own = missing[&receivers];
        own.integrals.push_back(integrals(kind, 0));
        own.places.push_back(&place->second);
    }
    for (const auto& [receivers, own] : missing)
        fillAtReceivers(*receivers, own.integrals, own.places);
}

void SceneLight::fillAtReceivers(const std::vector<std::uint32_t>& receivers,
                                 const std::vector<std::span<const double>>& integrals,
                                 const std::vector<std::vector<AtReceiver>*>& places) const {
    GatheredSums(integrals, 2)
        .forEach(
            receivers.size(),
            [&](std::size_t n, std::span<double>) { return solution_->of(receivers[n]); },
            [&](std::size_t n, std::span<const double> sums) {
                const LightExchange::Loss& loss = exchange_->loss(receivers[n]);
                for (std::size_t k = 0; k < sums.size(); ++k)
                    (*places[k])[n] = {loss.sky * integrals[k][0], loss.ground * integrals[k][1],
                                       sums[k]};
            });
}

bool SceneLight::sumsAtReceivers() const {
    return radiometry_.outputs().size() <= mostOutputsAtReceivers;
}

void SceneLight::prepareReceivers(const std::vector<const LightSums*>& views) {
    const std::size_t outputs = radiometry_.outputs().size();
    std::map<std::pair<int, int>, std::vector<std::uint32_t>> missing; // receivers of kinds
    for (const LightSums* view : views)
        for (const auto& [kind, sums] : *view) {
            if (!matters(radiometry_.rows().renderedOf(kind.second)))
                continue;
            const auto [place, isNew] = sent_.try_emplace(kind);
            Sent& sent = place->second;
            if (isNew) {
                const std::size_t receivers = receiversOf(kind.second).size();
                sent.isKnown.resize(receivers);
                sent.radiance.resize(outputs, std::vector<double>(receivers));
            }
            for (const ReceiverSums::Entry& seen : sums.entries())
                if (!sent.isKnown[seen.receiver] && seen.weights[0] != 0.0) {
                    sent.isKnown[seen.receiver] = 1;
                    missing[kind].push_back(seen.receiver);
                }
        }
    // Others are not asked for again: what all their receivers send is known.
    std::vector<SurfaceStackId> kinds;
    kinds.reserve(missing.size());
    for (const auto& [kind, locals] : missing)
        kinds.push_back({kind.first, kind.second});
    if (known_.size() * outputs * width() > mostNumbersKept)
        known_.clear();
    prepare(kinds);
    for (const auto& [kind, locals] : missing) {
        const std::vector<std::uint32_t>& receivers = receiversOf(kind.second);
        const std::vector<std::vector<double>>& integralsOf = known_.at(kind);
        Sent& sent = sent_.at(kind);
        GatheredSums({integralsOf.begin(), integralsOf.end()}, 2)
            .forEach(
                locals.size(),
                [&](std::size_t i, std::span<double> sums) {
                    const std::uint32_t receiver = receivers[locals[i]];
                    const LightExchange::Loss& loss = exchange_->loss(receiver);
                    for (std::size_t output = 0; output < outputs; ++output)
                        sums[output] = loss.sky * integralsOf[output][0] +
                                       loss.ground * integralsOf[output][1];
                    return solution_->of(receiver);
                },
                [&](std::size_t i, std::span<const double> sums) {
                    for (std::size_t output = 0; output < outputs; ++output)
                        sent.radiance[output][locals[i]] = sums[output];
                });
    }
}

std::array<double, 2> SceneLight::sumAtReceivers(const SurfaceStackId& kind, std::size_t output,
                                                 const ReceiverSums& sums) const {
    const auto known = sent_.find({kind.stack, kind.row});
    if (known == sent_.end())
        throw LogicError("light between surfaces was summed over receivers that nobody prepared");
    std::array<double, 2> all{};
    const std::vector<double>& sent = known->second.radiance[output];
    for (const ReceiverSums::Entry& seen : sums.entries())
        for (std::size_t q = 0; q < all.size(); ++q)
            all[q] += seen.weights[q] * sent[seen.receiver];
    return all;
}

ReceiverRows::ReceiverRows(const SurfaceRows& rows, const LightExchange& exchange) {
    first_.push_back(0);
    for (int row = 0; row < rows.size(); ++row) {
        const std::size_t own = receiversOf(row, rows, exchange).size();
        first_.push_back(first_.back() + static_cast<int>(own));
    }
}

std::pair<int, std::size_t> ReceiverRows::receiverOf(int number) const {
    const auto behind = std::ranges::upper_bound(first_, number);
    const auto row = static_cast<int>(behind - first_.begin()) - 1;
    return {row, static_cast<std::size_t>(number - first_[static_cast<std::size_t>(row)])};
}

std::vector<double> radiancesOf(const std::vector<SurfaceStackId>& receivers,
                                const ReceiverRows& rows, SceneLight& light) {
    std::vector<double> all;
    for (const SurfaceStackId& kind : receivers) {
        const auto [row, local] = rows.receiverOf(kind.row);
        const SceneLight::AtReceiver& at = light.atReceivers({kind.stack, row})[local];
        all.push_back(at[0] + at[1] + at[2]);
    }
    return all;
}

SceneLight::AtReceiver lightAt(const LightExchange& exchange,
                               const std::vector<SceneLight::AtReceiver>& atReceivers,
                               const GeometrySamples::Place& place) {
    SceneLight::AtReceiver all{};
    if (place.cell == GeometrySamples::Place::none)
        return all;
    exchange.forEachReceiver(place.cell, place.u, place.v, [&](std::uint32_t receiver, float part) {
        const SceneLight::AtReceiver& at = atReceivers[exchange.localOf(receiver)];
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k] += static_cast<double>(part) * at[k];
    });
    return all;
}

double SceneLight::partOf(std::span<const double> contracted, std::size_t column,
                          std::size_t node) const {
    const LightKnots::Between& at = knotsOfNodes_.between[node];
    const std::size_t columns = columns_.size();
    return (1.0 - knotsOfNodes_.parts[node]) * contracted[2 + at.low * columns + column] +
           knotsOfNodes_.parts[node] * contracted[2 + at.high * columns + column];
}

SceneLight::Falling SceneLight::fallsOn(int row, std::span<const double> contracted,
                                        std::size_t first, std::size_t count) const {
    const int drawn = radiometry_.rows().renderedOf(row);
    Falling falling;
    falling.lost.assign(count, 0.0);
    for (const auto& [place, term] : {std::pair{0, skyTerm_}, std::pair{1, groundTerm_}})
        for (std::size_t i = 0; term >= 0 && i < count; ++i)
            falling.lost[i] -=
                contracted[static_cast<std::size_t>(place)] * lightOn(drawn, term)[first + i];
    falling.emitted.resize(radiometry_.surfaces().size());
    falling.perReflectivity.resize(radiometry_.surfaces().size());
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const LightColumn& column = columns_[c];
        if (column.isPassed()) {
            for (std::size_t i = 0; i < count; ++i)
                falling.lost[i] +=
                    sources_W_m2_um_[c][first + i] * partOf(contracted, c, first + i);
            continue;
        }
        const bool isEmission = column.pattern == LightPattern::emission;
        const std::vector<double>& source =
            isEmission ? sources_W_m2_um_[c] : lightOn(column.row, static_cast<int>(column.term));
        auto& byRow = isEmission ? falling.emitted : falling.perReflectivity;
        std::vector<double>& sum = byRow[static_cast<std::size_t>(column.row)];
        sum.resize(count, 0.0);
        for (std::size_t i = 0; i < count; ++i)
            sum[i] += source[first + i] * partOf(contracted, c, first + i);
    }
    return falling;
}

std::vector<double> SceneLight::contractedEvenly(int drawn) const {
    std::vector<double> all(width(), 0.0);
    for (const std::uint32_t receiver : exchange_->ofRow(drawn)) {
        const std::span<const float> gathered = solution_->of(receiver);
        for (std::size_t k = 0; k < gathered.size(); ++k)
            all[2 + k] += static_cast<double>(gathered[k]);
    }
    return all;
}

void SceneLight::addFromOthers(std::span<const double> contracted, std::size_t first,
                               std::vector<double>& all_W_m2_um) const {
    for (std::size_t c = 0; c < columns_.size(); ++c)
        for (std::size_t i = 0; i < all_W_m2_um.size(); ++i)
            all_W_m2_um[i] += sources_W_m2_um_[c][first + i] * partOf(contracted, c, first + i);
}

std::vector<double> SceneLight::sourcesByNode() const {
    const std::size_t columns = columns_.size();
    std::vector<double> all(columns * radiometry_.wavelengths_um().size());
    for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t i = 0; i < sources_W_m2_um_[c].size(); ++i)
            all[i * columns + c] = sources_W_m2_um_[c][i];
    return all;
}

std::array<std::vector<double>, 2>
SceneLight::reflectable(int row, const ReceiverSums& sums,
                        std::span<const double> sourcesByNode) const {
    const std::size_t nodes = radiometry_.wavelengths_um().size(), columns = columns_.size();
    const int drawn = radiometry_.rows().renderedOf(row);
    std::array<std::vector<double>, 2> falls_W_m2_um;
    for (const bool withCosine : {false, true}) {
        const std::vector<double> all = contracted(row, sums, withCosine);
        std::vector<double>& falls = falls_W_m2_um[withCosine ? 1 : 0];
        falls.assign(nodes, 0.0);
        for (const auto& [lost, term] :
             {std::pair{all[0], skyTerm_}, std::pair{all[1], groundTerm_}})
            for (std::size_t i = 0; term >= 0 && lost != 0.0 && i < nodes; ++i)
                falls[i] -= lost * lightOn(drawn, term)[i];
        for (std::size_t i = 0; i < nodes; ++i) {
            const LightKnots::Between& at = knotsOfNodes_.between[i];
            const double* const source = sourcesByNode.data() + i * columns;
            const auto knot = [&](std::size_t number) {
                return dotProduct(all.data() + 2 + number * columns, source, columns);
            };
            const double low = knot(at.low);
            falls[i] +=
                at.high == at.low ? low : std::lerp(low, knot(at.high), knotsOfNodes_.parts[i]);
        }
    }
    return falls_W_m2_um;
}

std::vector<double> SceneLight::summedSources(std::span<const std::size_t> nodes) const {
    std::vector<double> sums(width() - 2, 0.0);
    for (std::size_t c = 0; c < columns_.size(); ++c)
        for (const std::size_t i : nodes) {
            const LightKnots::Between& at = knotsOfNodes_.between[i];
            const double sent = radiometry_.weights_um()[i] * sources_W_m2_um_[c][i];
            sums[at.low * columns_.size() + c] += (1.0 - knotsOfNodes_.parts[i]) * sent;
            sums[at.high * columns_.size() + c] += knotsOfNodes_.parts[i] * sent;
        }
    return sums;
}

const LightResponse& SceneLight::response(const std::vector<std::vector<int>>& reflectors,
                                          std::pair<std::size_t, std::size_t> nodes) {
    auto& kept = responses_[{reflectors, nodes}];
    if (!kept)
        kept = std::make_unique<const LightResponse>(*this, radiometry_, reflectors, nodes);
    return *kept;
}

} // namespace irsg
