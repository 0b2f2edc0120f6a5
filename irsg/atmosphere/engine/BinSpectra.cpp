#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// The bins whose centres enclose a range, as far as there are any.
std::pair<std::size_t, std::size_t> enclosing(const BinSet& set, const SpectralRange& range) {
    const double lower_per_cm = 1e4 / range.max_um;
    const double upper_per_cm = 1e4 / range.min_um;
    auto [first, last] = set.range(lower_per_cm, upper_per_cm);
    if (first == last)
        throw LogicError("the table of gases has no bins from " + numberText(range.min_um) +
                         " to " + numberText(range.max_um) + " um");
    if (first > 0 && set.bins[first].centre_per_cm() > lower_per_cm)
        --first;
    if (last < set.bins.size() && set.bins[last - 1].centre_per_cm() < upper_per_cm)
        ++last;
    return {first, last};
}

} // namespace

std::span<const SpectralBin> RadiativeTransfer::binsOf(const SpectralRange& range) const {
    const BinSet& set = gases().bins(air().resolution_per_cm);
    const auto [first, last] = enclosing(set, range);
    return std::span(set.bins).subspan(first, last - first);
}

NodeSet RadiativeTransfer::nodesOf(const SpectralRange& range) const {
    const BinSet& set = gases().bins(air().resolution_per_cm);
    NodeSet nodes;
    for (const SpectralBin& bin : binsOf(range))
        for (std::size_t i = 0; i < bin.count; ++i) {
            nodes.nodes.push_back(set.nodes[bin.first + i]);
            nodes.wavenumbers_per_cm.push_back(gases().wavenumber_per_cm(nodes.nodes.back()));
        }
    return nodes;
}

Spectrum RadiativeTransfer::spectrum(const SpectralRange& range,
                                     std::span<const double> nodeValues) const {
    const BinSet& set = gases().bins(air().resolution_per_cm);
    const auto [first, last] = enclosing(set, range);
    std::vector<double> wavelengths_um, means;
    std::size_t next = 0;
    for (std::size_t bin = first; bin < last; ++bin) {
        double mean = 0.0;
        for (std::size_t i = 0; i < set.bins[bin].count; ++i, ++next) {
            if (next >= nodeValues.size())
                throw LogicError("a spectrum was asked for with the values of other nodes");
            mean += static_cast<double>(set.weights[set.bins[bin].first + i]) * nodeValues[next];
        }
        wavelengths_um.push_back(1e4 / set.bins[bin].centre_per_cm());
        means.push_back(mean);
    }
    if (next != nodeValues.size())
        throw LogicError("a spectrum was asked for with the values of other nodes");
    std::ranges::reverse(wavelengths_um);
    std::ranges::reverse(means);

    // At the ends of the table the outer half of the last bin has the mean of the bin.
    if (wavelengths_um.front() > range.min_um) {
        wavelengths_um.insert(wavelengths_um.begin(), range.min_um);
        means.insert(means.begin(), means.front());
    }
    if (wavelengths_um.back() < range.max_um) {
        wavelengths_um.push_back(range.max_um);
        means.push_back(means.back());
    }
    return Spectrum(std::move(wavelengths_um), std::move(means));
}

} // namespace irsg
