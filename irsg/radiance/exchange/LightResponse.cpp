#include "irsg/radiance/exchange/LightResponse.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiance/exchange/SceneLight.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Width of a sub-band as a part of its wavelength.
constexpr double subBandPart = 0.13;
/// Of what a change brings on, as a part of the largest.
constexpr double error = 1e-3;

} // namespace

WavelengthBins::WavelengthBins(std::span<const double> wavelengths_um, double part) {
    std::map<long, std::size_t> places;
    for (const double wavelength_um : wavelengths_um) {
        const long number = std::lround(std::floor(std::log(wavelength_um) / part));
        of.push_back(places.try_emplace(number, places.size()).first->second);
    }
    count = places.size();
}

LightResponse::LightResponse(const SceneLight& light, const SceneRadiometry& radiometry,
                             std::vector<std::vector<int>> reflectors,
                             std::pair<std::size_t, std::size_t> nodes)
    : light_(light),
      radiometry_(radiometry),
      reflectors_(std::move(reflectors)),
      subBands_(
          std::span(radiometry.wavelengths_um()).subspan(nodes.first, nodes.second - nodes.first),
          subBandPart) {
    const std::size_t count = nodes.second - nodes.first, width = reflectors_.size();
    const LightExchange& exchange = light.exchange();
    std::vector<std::vector<double>> inSubBand; // by reflector and sub-band
    for (const std::vector<int>& rows : reflectors_) {
        std::vector<double>& shape = shapes_um_.emplace_back(count, 0.0);
        for (const int row : rows)
            light.addFromOthers(light.contractedEvenly(row), nodes.first, shape);
        std::vector<double>& sums = inSubBand.emplace_back(subBands_.count, 0.0);
        for (std::size_t i = 0; i < count; ++i)
            sums[subBands_.of[i]] += radiometry.weights_um()[nodes.first + i] * shape[i];
        for (std::size_t i = 0; i < count; ++i)
            shape[i] = sums[subBands_.of[i]] > 0.0 ? shape[i] / sums[subBands_.of[i]] : 0.0;
    }
    for (std::size_t band = 0; band < subBands_.count; ++band) {
        std::vector<std::size_t> own;
        for (std::size_t i = 0; i < count; ++i)
            if (subBands_.of[i] == band)
                own.push_back(nodes.first + i);
        const std::vector<double> sources = light.summedSources(own);
        std::vector<float> sent(exchange.sendersWithGas() * width, 0.0f), largest_W_m2(width, 0.0f);
        for (std::size_t g = 0; g < width; ++g)
            for (std::size_t s = 0; s < exchange.senders(); ++s) {
                if (!exchange.isSeen(s) ||
                    std::ranges::find(reflectors_[g], exchange.rowOfSender(s)) ==
                        reflectors_[g].end())
                    continue;
                const std::span<const float> gathered = light.solution().ofSender(s);
                double falls_W_m2 = 0.0;
                for (std::size_t k = 0; k < gathered.size(); ++k)
                    falls_W_m2 += static_cast<double>(gathered[k]) * sources[k];
                sent[s * width + g] = static_cast<float>(falls_W_m2);
                largest_W_m2[g] = std::max(largest_W_m2[g], sent[s * width + g]);
            }
        for (std::size_t i = 0; i < sent.size(); ++i)
            if (largest_W_m2[i % width] > 0.0f)
                sent[i] /= largest_W_m2[i % width];
        LightKnot knot;
        for (const SurfaceSpectra& surface : radiometry.surfaces())
            knot.reflectivities.push_back(
                pi / static_cast<double>(own.size()) *
                std::accumulate(own.begin(), own.end(), 0.0, [&](double sum, std::size_t i) {
                    return surface.reflectance.empty() ? 0.0 : sum + surface.reflectance[i];
                }));
        for (const OccluderMaterial& pane : exchange.panes()) {
            const std::vector<double> passes = passingOf(pane, exchange, radiometry);
            double& mean = knot.transmissivities.emplace_back();
            for (const std::size_t i : own)
                mean += passes[i] / static_cast<double>(own.size());
        }
        for (const std::vector<double>& share : gasSharesOf(exchange, radiometry)) {
            double& mean = knot.shares.emplace_back();
            for (const std::size_t i : own)
                mean += share[i] / static_cast<double>(own.size());
        }
        // What a row reflects once more has one bounce less to go.
        const int bounces = light.bounces() > 0 ? light.bounces() - 1 : light.bounces();
        std::vector<float>& more = more_W_m2_.emplace_back(light.solution().places() * width, 0.0f);
        if (bounces == 0)
            continue;
        more = light.solution().arriving(exchange, knot, sent, width, bounces, error);
        for (std::size_t i = 0; i < more.size(); ++i)
            more[i] *= largest_W_m2[i % width];
    }
}

std::vector<std::vector<double>> LightResponse::of(int row, const ReceiverSums& sums,
                                                   bool withCosine) const {
    const std::size_t width = reflectors_.size();
    std::vector<std::vector<double>> inSubBands(subBands_.count, std::vector<double>(width, 0.0));
    const std::vector<std::uint32_t>& receivers =
        receiversOf(row, radiometry_.rows(), light_.exchange());
    for (const ReceiverSums::Entry& seen : sums.entries()) {
        const double weight = seen.weights[withCosine ? 1 : 0];
        const std::size_t place = light_.solution().placeOf(receivers[seen.receiver]);
        if (weight == 0.0 || place == LightSolution::none)
            continue;
        for (std::size_t band = 0; band < inSubBands.size(); ++band)
            for (std::size_t g = 0; g < width; ++g)
                inSubBands[band][g] +=
                    weight * static_cast<double>(more_W_m2_[band][place * width + g]);
    }
    std::vector<std::vector<double>> more(width);
    for (std::size_t g = 0; g < width; ++g)
        for (std::size_t i = 0; i < shapes_um_[g].size(); ++i)
            more[g].push_back(inSubBands[subBands_.of[i]][g] * shapes_um_[g][i]);
    return more;
}

} // namespace irsg
