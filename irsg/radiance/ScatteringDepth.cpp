#include "irsg/radiance/ScatteringDepth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "irsg/atmosphere/AtmosphereScatteringLut.h"

namespace irsg {

namespace {

double meanOver(const Band& band, const Spectrum& spectrum) {
    const std::array<const Spectrum*, 2> factors{&spectrum, &band.response()};
    return integrateProduct(factors, band.range()) / band.area_um();
}

} // namespace

PathScattering scatteringAlong(AtmosphericQueryCache& answers, const AtmosphericPath& path,
                               const Band& band) {
    const Environment& environment = answers.environment();
    const AtmosphericQuery query = AtmosphericQuery::scatteringOpticalDepth(path);
    const AtmosphereScatteringLut* lut = scatteringLutOf(environment);
    if (lut && lut->accept(band.range(), query.quantity))
        return {meanOver(band, lut->spectrum(query, band.range())), lut->name()};
    if (environment.find(band.range(), query.quantity)) {
        const Provided<Spectrum>& answer = answers.spectrum(query, band.range());
        return {std::max(meanOver(band, answer.value), 0.0), answer.providedBy};
    }
    const Provided<Spectrum>& through =
        answers.spectrum(AtmosphericQuery::transmittance(path), band.range());
    const double mean = meanOver(band, through.value);
    return {mean > 0.0 ? std::max(-std::log(mean), 0.0) : std::numeric_limits<double>::infinity(),
            through.providedBy, true};
}

} // namespace irsg
