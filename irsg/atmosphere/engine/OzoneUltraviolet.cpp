#include <algorithm>

#include "irsg/atmosphere/engine/ContinuumParts.h"
#include "irsg/atmosphere/engine/EvenTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"

namespace irsg::continuum {

namespace {

struct OzoneTables {
    EvenTable visible, huggins, ultraviolet, nitricAcid;
};

const OzoneTables& ozoneTables() {
    static const OzoneTables shipped = [] {
        auto read = [](const char* name, const std::vector<std::string>& columns) {
            return EvenTable::read(atmosphereResource(name), columns);
        };
        return OzoneTables{
            read("continuum-ozone-visible.csv", {"k [atm-1 cm-1]"}),
            read("continuum-ozone-huggins.csv", {"c0 [1e-20 cm2]", "c1 [K-1]", "c2 [K-2]"}),
            read("continuum-ozone-ultraviolet.csv", {"sigma [1e-20 cm2]"}),
            read("continuum-nitric-acid.csv", {"k [atm-1 cm-1]"})};
    }();
    return shipped;
}

} // namespace

double ozone_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    const OzoneTables& all = ozoneTables();
    double cross_cm2 = 0.0;
    if (const auto huggins = all.huggins.place(wavenumber_per_cm); huggins.inside) {
        const double dT = clampedTemperature_K(air) - 273.15;
        cross_cm2 = 1e-20 * all.huggins.at(0, huggins) *
                    (1.0 + all.huggins.at(1, huggins) * dT + all.huggins.at(2, huggins) * dT * dT);
    } else if (const auto far = all.ultraviolet.place(wavenumber_per_cm); far.inside) {
        cross_cm2 = 1e-20 * all.ultraviolet.at(0, far);
    } else if (const auto visible = all.visible.place(wavenumber_per_cm); visible.inside) {
        cross_cm2 = all.visible.at(0, visible) / loschmidt_per_cm3;
    }
    return 100.0 * std::max(cross_cm2, 0.0) * air.fraction(Gas::O3) * number_per_cm3(air);
}

double nitricAcid_per_m(const AtmosphericState& air, double wavenumber_per_cm) {
    const EvenTable& table = ozoneTables().nitricAcid;
    return 100.0 * table.at(0, table.place(wavenumber_per_cm)) * air.fraction(Gas::HNO3) *
           amagats(air);
}

} // namespace irsg::continuum
