#include "irsg/radiometry/Band.h"

#include <cmath>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

double areaOf(const Spectrum& response, const SpectralRange& range) {
    const Spectrum* const factors[] = {&response};
    return integrateProduct(factors, range);
}

} // namespace

Band::Band(std::string name, SpectralRange range, Spectrum response)
    : name_(std::move(name)), range_(range), response_(std::move(response)) {}

Band Band::topHat(double min_um, double max_um) {
    const std::string found = numberText(min_um) + " to " + numberText(max_um) + " um";
    if (!(min_um > 0.0 && min_um < max_um && std::isfinite(max_um)))
        throw InputError({"band", "", found, "0 < minimum < maximum, both finite"});
    return {numberText(min_um) + "-" + numberText(max_um) + " um",
            {min_um, max_um},
            Spectrum::constant(1.0)};
}

Band Band::fromResponse(Spectrum response, std::string name) {
    if (response.isConstant())
        throw InputError({name, "", "a constant", "a sampled response with at least two nodes"});
    std::vector<Diagnostic> diagnostics;
    for (std::size_t i = 0; i < response.size(); ++i) {
        if (response.values()[i] < 0.0) {
            diagnostics.push_back({name, "node " + std::to_string(i + 1),
                                   "response " + numberText(response.values()[i]),
                                   "a response of at least 0"});
        }
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));

    const SpectralRange range{response.wavelengths_um().front(), response.wavelengths_um().back()};
    Spectrum zeroOutside(response.wavelengths_um(), response.values(), Spectrum::Outside::zero,
                         name);
    const double area_um = areaOf(zeroOutside, range);
    if (!(area_um > 0.0 && std::isfinite(area_um))) {
        throw InputError({name, "", "a response of area " + numberText(area_um) + " um",
                          "a positive and finite area"});
    }
    return {std::move(name), range, std::move(zeroOutside)};
}

double Band::responseAt(double wavelength_um) const {
    const bool inside = wavelength_um >= range_.min_um && wavelength_um <= range_.max_um;
    return inside ? response_.at(wavelength_um) : 0.0;
}

double Band::area_um() const {
    return areaOf(response_, range_);
}

} // namespace irsg
