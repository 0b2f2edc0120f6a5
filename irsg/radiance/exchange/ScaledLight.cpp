#include "irsg/radiance/exchange/ScaledLight.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Width of a bin as a part of its wavelength.
constexpr double binPart = 0.025;

double emissivityAt(double scale, double emissivity, double absorbedAtMost) {
    return std::clamp(scale * emissivity, 0.0, absorbedAtMost);
}

} // namespace

struct ScaledLight::Making {
    const SceneRadiometry& radiometry;
    const SurfaceRadianceTable& radiances;
    SceneLight& light;
    const std::vector<ScaledRow>& rows;
    const std::vector<double>& ranges_m;
    std::pair<std::size_t, std::size_t> nodes;

    std::vector<std::size_t> receiversOf{};      // by drawn row
    std::vector<int> senderOf{};                 // by drawn row; -1 where no input scales it
    std::vector<std::size_t> renderedOf{};       // by sender
    std::vector<std::vector<int>> reflectors{};  // drawn rows of each input of emissivity
    std::vector<std::size_t> firstOfReflector{}; // one sender for all of them
    const LightResponse* response = nullptr;     // null without such inputs
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> shareOf{}; // by receivers and sender
    std::vector<std::vector<double>> receiverWeights{}, senderWeights{};  // by bin

    const SurfaceSpectra& surface(std::size_t drawn) const { return radiometry.surfaces()[drawn]; }
};

ScaledLight::ScaledLight(const ViewGeometry& view, const SceneRadiometry& radiometry,
                         const SurfaceRadianceTable& radiances, SceneLight& light,
                         const std::vector<ScaledRow>& rows, const std::vector<double>& ranges_m,
                         std::pair<std::size_t, std::size_t> nodes, std::size_t inputs,
                         bool isSpectrum, std::optional<int> only)
    : isSpectrum_(isSpectrum) {
    Making making{radiometry, radiances, light, rows, ranges_m, nodes};
    makeBins(making);
    for (const SurfaceStackId& kind : light.inOrder(view.light)) {
        const int drawn = radiometry.rows().renderedOf(kind.row);
        if (!only || radiometry.rows().keyOf(drawn).first == *only)
            gather(making, kind.stack, kind.row, view.light.at({kind.stack, kind.row}));
    }
    close(making);
    evaluate(std::vector<double>(inputs, 1.0), atOne_);
}

void ScaledLight::makeBins(Making& making) {
    const auto [first, last] = making.nodes;
    WavelengthBins bins(std::span(making.radiometry.wavelengths_um()).subspan(first, last - first),
                        binPart);
    if (isSpectrum_) {
        bins.count = bins.of.size();
        for (std::size_t i = 0; i < bins.of.size(); ++i)
            bins.of[i] = i;
    }
    bins_ = bins.count;
    binOf_ = std::move(bins.of);

    std::map<std::pair<int, int>, std::size_t> byInput; // receivers; lobes by themselves
    std::map<int, std::size_t> reflectorOf;
    const std::size_t lit = making.light.exchange().rows();
    for (std::size_t drawn = 0; drawn < making.rows.size(); ++drawn) {
        const ScaledRow& inputs = making.rows[drawn];
        const bool isLobe = making.radiometry.rows().isLobe(static_cast<int>(drawn));
        const std::pair key{inputs.emissivityInput, isLobe ? static_cast<int>(drawn) : -1};
        const auto [group, isNew] = byInput.try_emplace(key, receivers_.size());
        if (isNew) {
            Receivers& made = receivers_.emplace_back();
            made.input = inputs.emissivityInput;
            made.emissivity.resize(bins_);
            made.absorbedAtMost.resize(bins_);
            made.constant.resize(bins_);
            making.receiverWeights.emplace_back(bins_);
        }
        making.receiversOf.push_back(group->second);
        making.senderOf.push_back(-1);
        // Of a mirror that others mirror, each component takes emission away.
        const bool isComponent =
            isLobe && making.light.exchange().areMirrorsFollowed() &&
            making.radiometry.rows().lobe(static_cast<int>(drawn)).light == LobeQuadratureRow::none;
        if ((drawn >= lit && !isComponent) ||
            (inputs.temperatureInput < 0 && inputs.emissivityInput < 0))
            continue;
        making.senderOf.back() = static_cast<int>(senders_.size());
        making.renderedOf.push_back(drawn);
        Sender& sender = senders_.emplace_back();
        sender.inputs = inputs;
        sender.isComponent = isComponent;
        sender.temperature_K = making.surface(drawn).temperature_K;
        sender.wavelength_um.resize(bins_);
        sender.emissivity.resize(bins_);
        sender.absorbedAtMost.resize(bins_);
        making.senderWeights.emplace_back(2 * bins_);
        if (isComponent || inputs.emissivityInput < 0 ||
            !making.light.matters(static_cast<int>(drawn)))
            continue;
        const auto [reflector, isFirst] =
            reflectorOf.try_emplace(inputs.emissivityInput, making.reflectors.size());
        if (isFirst) {
            making.reflectors.emplace_back();
            making.firstOfReflector.push_back(senders_.size() - 1);
        }
        making.reflectors[reflector->second].push_back(static_cast<int>(drawn));
    }
    if (!making.reflectors.empty())
        making.response = &making.light.response(making.reflectors, making.nodes);
}

void ScaledLight::gather(Making& making, int stack, int row, const ReceiverSums& sums) {
    const auto drawn = static_cast<std::size_t>(making.radiometry.rows().renderedOf(row));
    if (!making.light.matters(static_cast<int>(drawn)))
        return;
    const std::size_t first = making.nodes.first, group = making.receiversOf[drawn];
    Receivers& receivers = receivers_[group];
    const double range_m = making.ranges_m[static_cast<std::size_t>(
        making.radiometry.rows().keyOf(static_cast<int>(drawn)).first)];
    const SurfaceSpectra& own = making.surface(drawn);
    const std::vector<double>& through = *making.radiometry.air(row).transmittance;
    std::vector<double> unit = making.radiances.passed(stack, making.nodes, true);
    std::vector<double> reflectivity(unit.size());
    for (std::size_t i = 0; i < unit.size(); ++i) {
        unit[i] *= through[first + i] / pi;
        reflectivity[i] = pi * own.reflectance[first + i];
        if (receivers.input < 0)
            unit[i] *= reflectivity[i];
        else
            reflectivity[i] = std::max(reflectivity[i], 1e-3); // a weight, even of a black body
    }

    for (std::size_t quantity = 0; quantity < 2; ++quantity) {
        const bool withCosine = quantity == 1;
        const double scale = withCosine ? 1.0 : range_m * range_m;
        const SceneLight::Falling falling = making.light.fallsOn(
            row, making.light.contracted(row, sums, withCosine), first, unit.size());
        const auto addTo = [&](std::vector<Pair>& byBin, const std::vector<double>& falls) {
            for (std::size_t i = 0; i < falls.size(); ++i)
                byBin[binOf_[i]][quantity] += scale * unit[i] * falls[i];
        };
        const auto shareOf = [&](std::size_t sender) -> Share& {
            const auto [known, isNew] = making.shareOf.try_emplace({group, sender}, shares_.size());
            if (isNew)
                shares_.push_back({group, sender, std::vector<Pair>(bins_),
                                   std::vector<Pair>(bins_), std::vector<Pair>(bins_)});
            return shares_[known->second];
        };
        addTo(receivers.constant, falling.lost);
        std::vector<double> all(unit.size(), 0.0);
        for (std::size_t k = 0; k < falling.emitted.size(); ++k) {
            const std::vector<double>& emitted = falling.emitted[k];
            const std::vector<double>& reflected = falling.perReflectivity[k];
            const std::vector<double>& reflectance = making.surface(k).reflectance;
            for (std::size_t i = 0; i < all.size(); ++i)
                all[i] += (emitted.empty() ? 0.0 : emitted[i]) +
                          (reflected.empty() ? 0.0 : pi * reflectance[first + i] * reflected[i]);
            if (making.senderOf[k] < 0) {
                addTo(receivers.constant, emitted);
                for (std::size_t i = 0; i < reflected.size(); ++i)
                    receivers.constant[binOf_[i]][quantity] +=
                        scale * unit[i] * pi * reflectance[first + i] * reflected[i];
                continue;
            }
            const auto number = static_cast<std::size_t>(making.senderOf[k]);
            if (!emitted.empty())
                addTo(shareOf(number).emitted, emitted);
            if (!reflected.empty())
                addTo(shareOf(number).perReflectivity, reflected);
            if (withCosine)
                continue;
            // Means over bins are those of what the sender gives.
            Sender& sender = senders_[number];
            std::vector<double>& weights = making.senderWeights[number];
            const SurfaceSpectra& spectra = making.surface(k);
            for (std::size_t i = 0; i < unit.size(); ++i) {
                const std::size_t bin = binOf_[i];
                const double given = scale * unit[i] * reflectivity[i];
                // Lobes take away as well as they give; means over a bin do not mind.
                const double ofEmission = emitted.empty() ? 0.0 : std::abs(given * emitted[i]);
                const double weight =
                    ofEmission + (reflected.empty() ? 0.0 : std::abs(given * reflected[i]));
                weights[bin] += weight;
                weights[bins_ + bin] += ofEmission;
                sender.emissivity[bin] += weight * spectra.emissivity[first + i];
                sender.absorbedAtMost[bin] += weight * spectra.absorbsAtMost(first + i);
                sender.wavelength_um[bin] +=
                    ofEmission * making.radiometry.wavelengths_um()[first + i];
            }
        }
        for (std::size_t i = 0; i < all.size() && receivers.input >= 0 && !withCosine; ++i) {
            const std::size_t bin = binOf_[i];
            const double weight = std::abs(scale * unit[i] * all[i]);
            making.receiverWeights[group][bin] += weight;
            receivers.emissivity[bin] += weight * own.emissivity[first + i];
            receivers.absorbedAtMost[bin] += weight * own.absorbsAtMost(first + i);
        }
        if (making.response == nullptr)
            continue;
        const auto more = making.response->of(row, sums, withCosine);
        for (std::size_t r = 0; r < more.size(); ++r)
            addTo(shareOf(making.firstOfReflector[r]).perChange, more[r]);
    }
}

void ScaledLight::close(Making& making) {
    // What gives nothing of itself may still reflect on the way: plain means.
    std::vector<double> plain(bins_, 0.0);
    for (const std::size_t bin : binOf_)
        plain[bin] += 1.0;
    for (std::size_t s = 0; s < senders_.size(); ++s) {
        const SurfaceSpectra& spectra = making.surface(making.renderedOf[s]);
        for (std::size_t i = 0; i < binOf_.size(); ++i) {
            const std::size_t bin = binOf_[i], node = making.nodes.first + i;
            if (making.senderWeights[s][bin] > 0.0)
                continue;
            senders_[s].emissivity[bin] += spectra.emissivity[node] / plain[bin];
            senders_[s].absorbedAtMost[bin] += spectra.absorbsAtMost(node) / plain[bin];
        }
    }
    const auto divide = [](double& sum, double weight) {
        if (weight > 0.0)
            sum /= weight;
    };
    for (std::size_t bin = 0; bin < bins_; ++bin) {
        for (std::size_t g = 0; g < receivers_.size(); ++g) {
            divide(receivers_[g].emissivity[bin], making.receiverWeights[g][bin]);
            divide(receivers_[g].absorbedAtMost[bin], making.receiverWeights[g][bin]);
        }
        for (std::size_t s = 0; s < senders_.size(); ++s) {
            divide(senders_[s].emissivity[bin], making.senderWeights[s][bin]);
            divide(senders_[s].absorbedAtMost[bin], making.senderWeights[s][bin]);
            divide(senders_[s].wavelength_um[bin], making.senderWeights[s][bins_ + bin]);
        }
    }
    for (Share& share : shares_) {
        const Sender& sender = senders_[share.sender];
        std::vector<Pair>& constant = receivers_[share.receivers].constant;
        for (std::size_t bin = 0; bin < bins_; ++bin) {
            const double most = sender.absorbedAtMost[bin];
            const double nominal = most - emissivityAt(1.0, sender.emissivity[bin], most);
            for (std::size_t q = 0; q < 2; ++q) {
                constant[bin][q] -= nominal * share.perChange[bin][q];
                share.perReflectivity[bin][q] += share.perChange[bin][q];
            }
        }
        share.perChange = {};
    }
}

void ScaledLight::evaluate(std::span<const double> scales, std::vector<Pair>& byBin) const {
    const auto scaleOf = [&](int input) {
        return input < 0 ? 1.0 : scales[static_cast<std::size_t>(input)];
    };
    // By sender and bin: its emission beside that at scales of 1, and its reflectivity.
    std::vector<double> emission(senders_.size() * bins_, 1.0), reflectivity(emission.size());
    for (std::size_t s = 0; s < senders_.size(); ++s) {
        const Sender& sender = senders_[s];
        const double scaleT = scaleOf(sender.inputs.temperatureInput);
        const double scaleE = scaleOf(sender.inputs.emissivityInput);
        const bool isBody = sender.temperature_K > 0.0;
        for (std::size_t bin = 0; bin < bins_; ++bin) {
            const double most = sender.absorbedAtMost[bin], nominal = sender.emissivity[bin];
            const double emissivity = emissivityAt(scaleE, nominal, most);
            double& ratio = emission[s * bins_ + bin];
            if (!isBody)
                ratio = scaleE;
            else if (const double atOne = emissivityAt(1.0, nominal, most); sender.isComponent)
                ratio = most > atOne ? (most - emissivity) / (most - atOne) : 1.0;
            else if (atOne > 0.0)
                ratio = emissivity / atOne;
            if (const double wavelength_um = sender.wavelength_um[bin];
                isBody && scaleT != 1.0 && wavelength_um > 0.0)
                ratio *= planckRadiance_W_m2_sr_um(wavelength_um, scaleT * sender.temperature_K) /
                         planckRadiance_W_m2_sr_um(wavelength_um, sender.temperature_K);
            reflectivity[s * bins_ + bin] = most - emissivity;
        }
    }
    std::vector<std::vector<Pair>> falling;
    falling.reserve(receivers_.size());
    for (const Receivers& group : receivers_)
        falling.push_back(group.constant);
    for (const Share& share : shares_) {
        std::vector<Pair>& sum = falling[share.receivers];
        const double* emitted = &emission[share.sender * bins_];
        const double* reflected = &reflectivity[share.sender * bins_];
        for (std::size_t bin = 0; bin < bins_; ++bin)
            for (std::size_t q = 0; q < 2; ++q)
                sum[bin][q] += emitted[bin] * share.emitted[bin][q] +
                               reflected[bin] * share.perReflectivity[bin][q];
    }
    byBin.assign(bins_, Pair{});
    for (std::size_t g = 0; g < receivers_.size(); ++g) {
        const Receivers& group = receivers_[g];
        for (std::size_t bin = 0; bin < bins_; ++bin) {
            const double most = group.absorbedAtMost[bin];
            const double reflects =
                group.input < 0
                    ? 1.0
                    : most - emissivityAt(scaleOf(group.input), group.emissivity[bin], most);
            for (std::size_t q = 0; q < 2; ++q)
                byBin[bin][q] += reflects * falling[g][bin][q];
        }
    }
}

void ScaledLight::addTo(std::span<const double> scales, ScaledValues& values) const {
    std::vector<Pair> byBin;
    evaluate(scales, byBin);
    for (std::size_t bin = 0; bin < bins_; ++bin) {
        const std::size_t at = isSpectrum_ ? bin : 0;
        const double intensity = byBin[bin][0] - atOne_[bin][0];
        values.intensity[at] += intensity;
        values.contrastIntensity[at] += intensity;
        values.irradiance[at] += byBin[bin][1] - atOne_[bin][1];
    }
}

} // namespace irsg
