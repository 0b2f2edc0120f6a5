#include "irsg/gas/GasColumn.h"

#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/gas/GasSpectrum.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

using namespace irsg;

namespace {

GasLayer gasAt(double temperature_K, double co2, double h2o, double length_m) {
    GasLayer gas;
    gas.temperature_K = temperature_K;
    gas.fraction(HotGas::CO2) = co2;
    gas.fraction(HotGas::H2O) = h2o;
    gas.soot_ppmv = 0.01;
    gas.length_m = length_m;
    return gas;
}

/// Two gases, and a line of sight that goes into the second and out again.
struct Nest {
    std::vector<GasLayer> gases{gasAt(500.0, 0.03, 0.05, 0.0), gasAt(1100.0, 0.1, 0.1, 0.0)};
    std::vector<GasStretch> column{{0, 0.2}, {1, 0.5}, {0, 0.3}};
    GasRequest request{.layers = {gasAt(500.0, 0.03, 0.05, 0.2), gasAt(1100.0, 0.1, 0.1, 0.5),
                                  gasAt(500.0, 0.03, 0.05, 0.3)},
                       .band = {3.0, 5.0}};
};

TEST(GasColumns, SendWhatTheirLayersSend) {
    const Nest nest;
    const GasSpectrum spectrum = gasSpectrum(nest.request);
    std::vector<double> places_per_cm;
    for (const GasSpectrum::Cell& cell : spectrum.cells) {
        places_per_cm.push_back(cell.wavenumber_per_cm);
    }
    const GasColumns columns(nest.gases, places_per_cm);
    const auto shares = columns.shares(nest.column);
    for (std::size_t i = 0; i < places_per_cm.size(); ++i) {
        const double at_um = wavelengthFromWavenumber_um(places_per_cm[i]);
        double radiance = 0.0;
        for (std::size_t g = 0; g < 2; ++g) {
            radiance +=
                shares[g][i] * planckRadiance_W_m2_sr_um(at_um, nest.gases[g].temperature_K);
        }
        const GasSpectrum::Cell& cell = spectrum.cells[i];
        EXPECT_NEAR(radiance, cell.radiance_W_m2_sr_um, 1e-9 * cell.radiance_W_m2_sr_um + 1e-15);
        EXPECT_NEAR(1.0 - shares[0][i] - shares[1][i], cell.transmittance, 1e-9);
    }
}

TEST(GasColumns, AreThePartsThatTheyAreCutInto) {
    const Nest nest;
    const GasColumns columns(nest.gases, {2150.0, 2200.0, 2300.0, 3500.0});
    const auto whole = columns.shares(nest.column);
    const auto behind = columns.shares(nest.column, 2);
    const auto before = columns.shares(std::span(nest.column).first(2));
    for (std::size_t g = 0; g < 2; ++g) {
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(before[g][i] + behind[g][i], whole[g][i], 1e-12);
        }
    }
}

TEST(GasColumns, RefuseWhatIsOutOfReach) {
    EXPECT_THROW(GasColumns({gasAt(3200.0, 0.1, 0.1, 1.0)}, {2000.0}), InputError);
    EXPECT_THROW(GasColumns({gasAt(900.0, 0.6, 0.5, 1.0)}, {2000.0}), InputError);
}

} // namespace
