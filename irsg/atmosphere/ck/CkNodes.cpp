#include "irsg/atmosphere/ck/CkNodes.h"

namespace irsg {

CkNodes::CkNodes(const RadiativeTransfer& transfer, const Band& band)
    : set(transfer.nodesOf(band.range())), band_(band) {
    const BinSet& bins = transfer.gases().bins(transfer.air().resolution_per_cm);
    for (const SpectralBin& own : transfer.binsOf(band.range())) {
        binOf_.insert(binOf_.end(), own.count, centres_um_.size());
        for (std::uint32_t i = own.first; i < own.first + own.count; ++i)
            weight_.push_back(static_cast<double>(bins.weights[i]));
        centres_um_.push_back(1e4 / own.centre_per_cm());
    }
    prepare();
}

CkNodes::CkNodes(const std::vector<double>& wavelengths_um, std::size_t first, const Band& band)
    : band_(band) {
    for (std::size_t i = wavelengths_um.size(); i-- > 0;) {
        set.nodes.push_back(static_cast<std::uint32_t>(first + i));
        set.wavenumbers_per_cm.push_back(1e4 / wavelengths_um[i]);
        binOf_.push_back(centres_um_.size());
        weight_.push_back(1.0);
        centres_um_.push_back(wavelengths_um[i]);
    }
    prepare();
}

void CkNodes::prepare() {
    std::vector<double> withResponse(centres_um_.size());
    widths_.assign(centres_um_.size(), 0.0);
    integrate(
        [&](double at_um) {
            return std::pair{1.0, band_.responseAt(at_um)};
        },
        withResponse, widths_, pointsOfBin);
    for (std::size_t i = 0; i < size(); ++i)
        ones_.push_back(weight_[i] * withResponse[binOf_[i]]);
}

Spectrum CkNodes::hat(std::size_t node) const {
    const std::size_t b = binOf_[node];
    std::vector<double> axis, values;
    if (b + 1 < centres_um_.size()) {
        axis.push_back(centres_um_[b + 1]);
        values.push_back(0.0);
    }
    axis.push_back(centres_um_[b]);
    values.push_back(1.0);
    if (b > 0) {
        axis.push_back(centres_um_[b - 1]);
        values.push_back(0.0);
    }
    return Spectrum(axis, values, Spectrum::Outside::zero, "hat");
}

} // namespace irsg
