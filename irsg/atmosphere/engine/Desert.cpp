#include <algorithm>
#include <array>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/atmosphere/engine/ResourceFile.h"

namespace irsg::particles {

WindAerosol desert(double wind_m_s) {
    constexpr std::array<const char*, 4> suffixes = {"_w0", "_w10", "_w20", "_w30"};
    static const ParticleTable table =
        ParticleTable::read(atmosphereResource("particles-desert.csv"), ParticleTable::Kind::optics,
                            opticsColumns({"desert"}, {suffixes.begin(), suffixes.end()}));

    // Logarithms of extinction and absorption and the asymmetry are linear in the wind.
    const double steps = std::clamp(wind_m_s, 0.0, 30.0) / 10.0;
    const std::size_t i = std::min(static_cast<std::size_t>(steps), suffixes.size() - 2);
    WindAerosol result;
    result.optics = opticsOf(table, "desert", suffixes[i]);
    const Optics windier = opticsOf(table, "desert", suffixes[i + 1]);
    for (std::size_t k = 0; k < result.optics.values.size(); ++k)
        result.optics.values[k] =
            between(result.optics.values[k], windier.values[k], steps - static_cast<double>(i));

    const ParticleLayer spectrum{"", {}, {}, result.optics.wavelengths_um, result.optics.values};
    result.extinction550_per_m = spectrum.opticsAt(0.55).extinction;
    result.optics = normalised(std::move(result.optics));
    return result;
}

} // namespace irsg::particles
