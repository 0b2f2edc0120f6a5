#include "irsg/atmosphere/AtmosphereNodes.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// The function 1 at a centre and 0 at its neighbours, where there are any; the outer half of the
/// last bin of a table has the mean of the bin.
Spectrum hatOver(std::span<const SpectralBin> bins, std::size_t bin, const SpectralRange& range) {
    const auto centre_um = [&](std::size_t b) { return 1e4 / bins[b].centre_per_cm(); };
    std::vector<double> axis, values;
    const auto add = [&](double wavelength_um, double value) {
        if (!axis.empty() && !(wavelength_um > axis.back()))
            return;
        axis.push_back(wavelength_um);
        values.push_back(value);
    };
    if (bin + 1 < bins.size())
        add(centre_um(bin + 1), 0.0);
    else
        add(std::min(range.min_um, 0.5 * centre_um(bin)), 1.0);
    add(centre_um(bin), 1.0);
    if (bin > 0)
        add(centre_um(bin - 1), 0.0);
    else
        add(std::max(range.max_um, 2.0 * centre_um(bin)), 1.0);
    return Spectrum(std::move(axis), std::move(values), Spectrum::Outside::zero, "hat");
}

SpectralRange around(const std::vector<double>& wavelengths_um) {
    return SpectralPoints(wavelengths_um).range();
}

SpectralRange around(const std::vector<Band>& bands) {
    if (bands.empty())
        throw LogicError("nodes of the air were asked for without a band");
    return {bands.front().range().min_um, bands.back().range().max_um};
}

} // namespace

AtmosphereNodes::AtmosphereNodes(std::shared_ptr<const RadiativeTransfer> transfer,
                                 const std::vector<Band>& bands)
    : transfer_(std::move(transfer)), set_(transfer_->nodesOf(around(bands))), bands_(bands) {
    for (std::size_t number = 0; number < bands_.size(); ++number) {
        const std::size_t first = ofSet_.size();
        addBand(number);
        outputs_.emplace_back(first, ofSet_.size());
    }
    finish(around(bands_));
}

void AtmosphereNodes::addBand(std::size_t number) {
    const Band& band = bands_[number];
    const SpectralRange& range = band.range();
    const std::span<const SpectralBin> bins = transfer_->binsOf(range);
    const Spectrum itself({range.min_um, range.max_um}, {range.min_um, range.max_um},
                          Spectrum::Outside::zero, "wavelength");
    // Bins ascend in wavenumber, as the nodes of the set do: those below the band come first.
    std::size_t firstOfSet = 0;
    for (const SpectralBin& bin : transfer_->binsOf(around(bands_))) {
        if (&bin == bins.data())
            break;
        firstOfSet += bin.count;
    }
    for (const SpectralBin& bin : bins)
        firstOfSet += bin.count;
    // Wavelengths ascend where wavenumbers fall.
    for (std::size_t b = bins.size(); b-- > 0;) {
        firstOfSet -= bins[b].count;
        Group group;
        group.hat = hatOver(bins, b, range);
        group.band = number;
        group.area_um = integralOver(group.hat, Spectrum::constant(1.0), band);
        if (!(group.area_um > 0.0))
            continue;
        group.wavelength_um = integralOver(group.hat, itself, band) / group.area_um;
        group.first = ofSet_.size();
        groups_.push_back(std::move(group));
        addNodes(bins[b], groups_.back().area_um, firstOfSet);
    }
}

AtmosphereNodes::AtmosphereNodes(std::shared_ptr<const RadiativeTransfer> transfer,
                                 const std::vector<double>& wavelengths_um)
    : transfer_(std::move(transfer)), set_(transfer_->nodesOf(around(wavelengths_um))) {
    const SpectralRange range = around(wavelengths_um);
    const std::span<const SpectralBin> bins = transfer_->binsOf(range);
    std::vector<std::size_t> firsts;
    for (std::size_t b = 0, first = 0; b < bins.size(); first += bins[b++].count)
        firsts.push_back(first);
    for (const double wavelength_um : wavelengths_um) {
        // Linear in wavelength between the centres, and clamped beyond the last.
        const auto [below, above, part] =
            bracket(bins, wavelength_um, Beyond::clamp,
                    [](const SpectralBin& bin) { return 1e4 / bin.centre_per_cm(); });
        groups_.push_back({.wavelength_um = wavelength_um, .first = ofSet_.size()});
        addNodes(bins[below], 1.0 - part, firsts[below]);
        addNodes(bins[above], part, firsts[above]);
        outputs_.emplace_back(groups_.back().first, ofSet_.size());
    }
    finish(range);
}

const AtmosphereNodes* AtmosphereNodes::of(const SpectralSampling& sampling) {
    return dynamic_cast<const AtmosphereNodes*>(&sampling);
}

double AtmosphereNodes::integralOver(const Spectrum& hat, const Spectrum& other, const Band& band) {
    const SpectralRange held{std::max(band.range().min_um, hat.wavelengths_um().front()),
                             std::min(band.range().max_um, hat.wavelengths_um().back())};
    if (!(held.min_um < held.max_um))
        return 0.0;
    const Spectrum* const factors[] = {&hat, &band.response(), &other};
    return integrateProduct(factors, held);
}

void AtmosphereNodes::addNodes(const SpectralBin& bin, double weight, std::size_t firstOfSet) {
    if (!(weight > 0.0))
        return;
    const BinSet& set = transfer_->gases().bins(transfer_->air().resolution_per_cm);
    for (std::size_t i = 0; i < bin.count; ++i) {
        ofSet_.push_back(firstOfSet + i);
        nodeWeights_.push_back(weight * static_cast<double>(set.weights[bin.first + i]));
    }
    groups_.back().count = ofSet_.size() - groups_.back().first;
}

void AtmosphereNodes::finish(const SpectralRange& range) {
    std::vector<double> wavelengths_um;
    for (const Group& group : groups_)
        wavelengths_um.insert(wavelengths_um.end(), group.count, group.wavelength_um);
    setNodes(std::move(wavelengths_um), std::move(nodeWeights_), range);
}

std::vector<double> AtmosphereNodes::arranged(std::span<const double> ofSet) const {
    if (ofSet.size() != set_.nodes.size())
        throw LogicError("nodes of the air were given the values of others");
    std::vector<double> values;
    values.reserve(size());
    for (const std::size_t place : ofSet_)
        values.push_back(ofSet[place]);
    return values;
}

std::vector<double> AtmosphereNodes::sampled(const Spectrum& spectrum) const {
    if (spectrum.isConstant())
        return std::vector<double>(size(), spectrum.values().front());
    std::vector<double> values;
    values.reserve(size());
    for (const Group& group : groups_) {
        const double value =
            group.area_um > 0.0
                ? integralOver(group.hat, spectrum, bands_[group.band]) / group.area_um
                : spectrum.at(group.wavelength_um);
        values.insert(values.end(), group.count, value);
    }
    return values;
}

AxisToNodes AtmosphereNodes::fromAxis(const std::vector<double>& wavelengths_um) const {
    const std::size_t last = wavelengths_um.size() - 1;
    // 1 at a place of the axis and 0 at the others.
    const auto unitAt = [&](std::size_t place) {
        const std::size_t from = place > 0 ? place - 1 : 0, to = std::min(place + 1, last);
        std::vector<double> axis(wavelengths_um.begin() + static_cast<std::ptrdiff_t>(from),
                                 wavelengths_um.begin() + static_cast<std::ptrdiff_t>(to) + 1);
        std::vector<double> values(axis.size(), 0.0);
        values[place - from] = 1.0;
        return Spectrum(std::move(axis), std::move(values));
    };
    AxisToNodes toNodes;
    std::vector<double> weights;
    for (const Group& group : groups_) {
        weights.clear();
        if (!(group.area_um > 0.0)) {
            const Bracket at = bracket(wavelengths_um, group.wavelength_um);
            weights = {1.0 - at.fraction, at.fraction};
            toNodes.add(group.count, at.below, weights);
            continue;
        }
        const std::vector<double>& hat_um = group.hat.wavelengths_um();
        const std::size_t first = bracket(wavelengths_um, hat_um.front()).below;
        const std::size_t end = bracket(wavelengths_um, hat_um.back()).above + 1;
        for (std::size_t place = first; place < end; ++place)
            weights.push_back(integralOver(group.hat, unitAt(place), bands_[group.band]) /
                              group.area_um);
        toNodes.add(group.count, first, weights);
    }
    return toNodes;
}

} // namespace irsg
