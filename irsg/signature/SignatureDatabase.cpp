#include "irsg/signature/SignatureDatabase.h"

#include "irsg/radiometry/Units.h"

namespace irsg {

double Material::reflectivityAt(double wavelength_um) const {
    return 1.0 - emissivity.at(wavelength_um) - transmissivity.at(wavelength_um);
}

std::vector<std::string> tablesHeld(const SignatureDatabase& database, const EntityState& state) {
    std::vector<std::string> held;
    const auto check = [&](const std::string& path, const LookupTable& table, double x) {
        if (table.isOutside(x)) {
            held.push_back(path);
        }
    };
    for (const auto& [index, entry] : database.temperatures) {
        const std::string path = "temperatures." + std::to_string(index);
        if (entry.mode == EmissionMode::temperature) {
            check(path + ".terms.time_s", entry.terms.time, state.time_s);
            check(path + ".terms.power", entry.terms.power, state.power);
            check(path + ".terms.altitude_m", entry.terms.altitude, state.altitude_m);
            check(path + ".terms.mach", entry.terms.mach, state.mach);
            continue;
        }
        for (std::size_t i = 0; i < entry.factors.size(); ++i) {
            const ComponentFactor& factor = entry.factors[i];
            const std::string at = path + ".factors[" + std::to_string(i) + "]";
            check(at + ".time_s", factor.time, state.time_s);
            check(at + ".angle_deg", factor.angle, degrees(state.aspectAngle_rad));
        }
    }
    return held;
}

} // namespace irsg
