#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "tests/support/SceneFixtures.h"

namespace irsg::test {

/// Computed air of a model atmosphere (1 to 6) over a band, which answers every view on the fly.
std::shared_ptr<AtmosphereSmart> smartAtmosphere(int model, double min_um = 3.0,
                                                 double max_um = 5.0, int scattering = 2,
                                                 int resolution_per_cm = 5);
/// It alone, with the sun in the east, 34 deg high.
Environment environmentOf(std::shared_ptr<const Atmosphere> atmosphere);

/// Hot carbon dioxide in lines 1.6 cm-1 apart, as the air's own are; radiance, W m-2 sr-1 um-1.
Spectrum hotGas();
/// Entry 1: grey skin. Entry 2: 40 K hotter, a paint whose emissivity falls in the middle of the
/// band.
SignatureDatabase painted(const Band& band, double temperature_K);
/// Entry 1: grey skin of 320 K. Entry 2: the hot gas, measured from a reference distance.
SignatureDatabase withGas(double reference_m);

/// A sphere of entry 1, and a box whose sides take turns between entries 1 and 2.
std::shared_ptr<const Model> ball();
std::shared_ptr<const Model> box();

/// The scenes that compare the wideband mode with the spectral one (F17): five in each of four
/// airs.
struct WidebandAtmosphere {
    const char* name;
    int model;
    double min_um, max_um;

    Band band() const { return Band::topHat(min_um, max_um); }
    Environment environment(int resolution_per_cm = 5) const;
};
inline void PrintTo(const WidebandAtmosphere& air, std::ostream* out) {
    *out << air.name;
}
std::vector<WidebandAtmosphere> widebandAtmospheres();

struct WidebandScene {
    std::string name;
    Entity entity;
    View view;
};
std::vector<WidebandScene> widebandScenes(const Band& band);

} // namespace irsg::test
