#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/Interpolation.h"

namespace irsg::particles {

namespace {

constexpr std::array<const char*, 4> humidities = {"_rh50", "_rh85", "_rh95", "_rh98"};
constexpr std::array<double, 4> percents = {50.0, 85.0, 95.0, 98.0};

std::string column(const char* quantity, int mode, const char* humidity) {
    return std::string("log10_") + quantity + "_mode" + std::to_string(mode) + humidity;
}

const ParticleTable& navyTable() {
    static const ParticleTable table = [] {
        std::vector<std::string> columns;
        for (const char* quantity : {"ext", "abs"})
            for (int mode = 1; mode <= 3; ++mode)
                for (const char* humidity : humidities)
                    columns.push_back(column(quantity, mode, humidity));
        return ParticleTable::read(atmosphereResource("particles-navy.csv"),
                                   ParticleTable::Kind::logarithms, columns);
    }();
    return table;
}

} // namespace

WindAerosol navyMaritime(int airMass, double wind_m_s, double wind24h_m_s,
                         double relativeHumidity) {
    // Amplitudes of the modes: continental haze, spray of the last day, fresh spray.
    const double now = std::min(wind_m_s, 20.0);
    const double day = std::min(wind24h_m_s, 20.0);
    const std::array<double, 3> amplitudes = {2000.0 * airMass * airMass,
                                              std::max(5.866 * (day - 2.2), 0.5),
                                              std::pow(10.0, 0.06 * now - 2.8)};

    // Drops grow with humidity by F = ((2 - f) / (6 (1 - f)))^(1/3).
    const double percent = std::clamp(100.0 * relativeHumidity, 50.0, 98.0);
    const double f = percent / 100.0;
    const double growth = std::cbrt((2.0 - f) / (6.0 * (1.0 - f)));
    const double factor_per_m = 1e-3 * std::numbers::pi / 1000.0 / growth;

    // The logarithms of the modes' sums are linear in humidity.
    const auto [below, above, part] = bracket(percents, percent);
    const std::size_t count = navyTable().first().size();
    auto sum = [&](const char* quantity) {
        std::vector<double> result(count, 0.0);
        for (int mode = 1; mode <= 3; ++mode) {
            const auto& drier = navyTable().column(column(quantity, mode, humidities[below]));
            const auto& moister = navyTable().column(column(quantity, mode, humidities[above]));
            for (std::size_t k = 0; k < count; ++k)
                result[k] += factor_per_m * amplitudes[static_cast<std::size_t>(mode - 1)] *
                             std::pow(10.0, lerp(drier[k], moister[k], part));
        }
        return result;
    };
    const std::vector<double> extinction = sum("ext");
    const std::vector<double> absorption = sum("abs");

    // The asymmetry is that of the maritime aerosol.
    const Optics maritime = humidOptics("maritime", f);
    const ParticleLayer phase{"", {}, {}, maritime.wavelengths_um, maritime.values};
    WindAerosol result;
    result.optics.wavelengths_um = navyTable().first();
    for (std::size_t k = 0; k < count; ++k)
        result.optics.values.push_back({extinction[k], std::min(absorption[k], extinction[k]),
                                        phase.opticsAt(result.optics.wavelengths_um[k]).asymmetry});

    const ParticleLayer spectrum{"", {}, {}, result.optics.wavelengths_um, result.optics.values};
    result.extinction550_per_m = spectrum.opticsAt(0.55).extinction;
    result.optics = normalised(std::move(result.optics));
    return result;
}

} // namespace irsg::particles
