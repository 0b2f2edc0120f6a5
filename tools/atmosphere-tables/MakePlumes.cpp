#include "tools/atmosphere-tables/Command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/radiometry/Planck.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"

// The plumes of the sample models are closed shells, one inside the other, and a line of sight
// crosses both walls of each. So a wall carries half of its zone: an isothermal layer of CO2 and
// H2O in air at 1 atm. By Kirchhoff's law the wall emits (1 - tau) B(T), split into the component
// CO2, (1 - tau_CO2) B, and the component H2O, tau_CO2 (1 - tau_H2O) B. Products are formed line by
// line; a value of a file is their mean weighted by the triangle between the neighbouring points,
// as spectra are linear between them.

namespace smat::tables {

namespace {

using namespace irsg;
using namespace irsg::lbl;

constexpr double atmosphere_hPa = 1013.25;
constexpr WavenumberGrid fine{655.0, 0.002, 2'325'001}; // to 5305 cm-1

/// A zone of a plume: its emission is written to NAME.csv, its transmissivity to GAS.csv.
struct Zone {
    const char *name, *gas;
    double temperature_K;
};

/// Columns are those of half a zone.
struct Plume {
    const char* sample;
    double carbonDioxide_g_m2, water_g_m2;
    double moleFraction; ///< of either gas, for self-broadening
    double reference_m;  ///< of cold air that the emission is seen through
    std::vector<Zone> zones;
};

/// Our assumptions. Aircraft: exhaust of a lean gas turbine, 3.3 % CO2 and as much water at the
/// nozzle, thinned on the way out so that each zone holds about as much as the other. Ship: exhaust
/// of a diesel engine thinned to 2 % CO2, 1.5 m of it.
std::vector<Plume> plumes() {
    return {{"turboprop4",
             4.0,
             1.6,
             0.033,
             100.0,
             {{"plume core", "gas core", 700.0},
              {"plume mid", "gas mid", 480.0},
              {"plume outer", "gas outer", 360.0}}},
            {"ship", 38.0, 16.0, 0.02, 0.0, {{"funnel plume", "gas", 420.0}}}};
}

/// Transmittance, point by point, of a layer with a column of one gas.
std::vector<double> transmittance(const LineList& gas, const PartitionSums& partition,
                                  double temperature_K, double moleFraction, double column_g_m2) {
    const double molecules_per_cm2 = column_g_m2 / molarMass_g(gas.gas, 1) * 6.02214076e23 * 1e-4;
    std::vector<double> values =
        crossSection_cm2(gas, partition, fine, temperature_K, atmosphere_hPa, moleFraction,
                         defaultLineShape(gas.gas));
    for (double& value : values)
        value = std::exp(-value * molecules_per_cm2);
    return values;
}

/// From 1.9 to 15.2 um, so that bands to 14 um lie within; fine where the 4.3 um band is.
std::vector<double> axis_per_cm() {
    std::vector<double> axis;
    for (double nu = 660.0; nu <= 5300.0;) {
        axis.push_back(nu);
        nu += nu >= 2080.0 && nu < 2460.0 ? 4.0 : nu < 4200.0 ? 20.0 : 100.0;
    }
    return axis;
}

/// Means of a function of the points, weighted by the triangles between the axis's neighbours.
template <typename Function>
std::vector<double> means(const std::vector<double>& axis, Function at) {
    std::vector<double> sums(axis.size()), weights(axis.size());
    for (std::size_t a = 0; a + 1 < axis.size(); ++a) {
        const auto first =
            static_cast<std::size_t>((axis[a] - fine.first_per_cm) / fine.step_per_cm + 0.5);
        const auto last =
            static_cast<std::size_t>((axis[a + 1] - fine.first_per_cm) / fine.step_per_cm + 0.5);
        for (std::size_t i = first; i < last; ++i) {
            const double part =
                (fine.at(i) + 0.5 * fine.step_per_cm - axis[a]) / (axis[a + 1] - axis[a]);
            const double value = at(i);
            sums[a] += (1.0 - part) * value;
            weights[a] += 1.0 - part;
            sums[a + 1] += part * value;
            weights[a + 1] += part;
        }
    }
    for (std::size_t a = 0; a < axis.size(); ++a)
        sums[a] /= weights[a];
    return sums;
}

struct Gases {
    LineList carbonDioxide, water;
    PartitionSums partition;
};

/// Air of 288 K at 1 atm with 400 ppm of CO2 and 50 % humidity.
std::vector<double> coldAir(const Gases& gases, double range_m) {
    AtmosphericState air;
    air.temperature_K = 288.0;
    air.moleFraction[static_cast<std::size_t>(Gas::CO2)] = 4e-4;
    air.moleFraction[static_cast<std::size_t>(Gas::H2O)] = 0.0084;
    air.moleFraction[static_cast<std::size_t>(Gas::O2)] = 0.209;
    auto layer = [&](const LineList& gas) {
        const double column_g_m2 =
            air.density_per_m3(gas.gas) * range_m * molarMass_g(gas.gas, 1) / 6.02214076e23;
        return transmittance(gas, gases.partition, air.temperature_K, air.fraction(gas.gas),
                             column_g_m2);
    };
    std::vector<double> values = layer(gases.carbonDioxide);
    const std::vector<double> water = layer(gases.water);
    constexpr std::size_t coarse = 500; // continua vary slowly
    double continuum = 1.0;
    for (std::size_t i = 0; i < fine.count; ++i) {
        if (i % coarse == 0)
            continuum = std::exp(-continuumAbsorption_per_m(air, fine.at(i)) * range_m);
        values[i] *= water[i] * continuum;
    }
    return values;
}

std::string line(double x, std::initializer_list<double> values, const char* xFormat) {
    char text[32];
    std::snprintf(text, sizeof text, xFormat, x);
    std::string all = text;
    for (const double value : values) {
        std::snprintf(text, sizeof text, ",%.6g", value);
        all += text;
    }
    return all + "\n";
}

/// Over 3 to 5 um, W m-2 sr-1.
double inBand(const std::vector<double>& emissivity, double temperature_K) {
    double sum = 0.0;
    for (std::size_t i = 0; i < fine.count; ++i) {
        const double wavelength_um = 1e4 / fine.at(i);
        if (wavelength_um >= 3.0 && wavelength_um <= 5.0)
            sum += emissivity[i] * planckRadiance_W_m2_sr_um(wavelength_um, temperature_K) *
                   wavelength_um / fine.at(i) * fine.step_per_cm;
    }
    return sum;
}

void makePlume(const Plume& plume, const Gases& gases, const std::filesystem::path& folder) {
    const std::vector<double> axis = axis_per_cm();
    const std::vector<double> air =
        plume.reference_m > 0.0 ? coldAir(gases, plume.reference_m) : std::vector<double>();
    for (const Zone& zone : plume.zones) {
        const std::vector<double> co2 =
            transmittance(gases.carbonDioxide, gases.partition, zone.temperature_K,
                          plume.moleFraction, plume.carbonDioxide_g_m2);
        const std::vector<double> water = transmittance(
            gases.water, gases.partition, zone.temperature_K, plume.moleFraction, plume.water_g_m2);
        auto atmosphereAt = [&](std::size_t i) { return air.empty() ? 1.0 : air[i]; };
        const auto fromCo2 =
            means(axis, [&](std::size_t i) { return (1.0 - co2[i]) * atmosphereAt(i); });
        const auto fromWater =
            means(axis, [&](std::size_t i) { return co2[i] * (1.0 - water[i]) * atmosphereAt(i); });
        const auto through = means(axis, [&](std::size_t i) { return co2[i] * water[i]; });

        char head[256];
        std::snprintf(head, sizeof head,
                      "# unit: W cm-2 sr-1 (cm-1)-1\n# reference_distance_m: %g\n"
                      "# wall of an isothermal shell at %g K, line by line (atmosphere-tables "
                      "plumes)\ncm-1,CO2,H2O\n",
                      plume.reference_m, zone.temperature_K);
        std::string emission = head;
        std::string gas = "# wall of a gas shell, line by line (atmosphere-tables plumes); "
                          "emissivity = 1 - transmissivity\num,transmissivity\n";
        for (std::size_t a = 0; a < axis.size(); ++a) {
            const double wavelength_um = 1e4 / axis[a];
            const double black = planckRadiance_W_m2_sr_um(wavelength_um, zone.temperature_K) *
                                 wavelength_um / axis[a] * 1e-4; // W cm-2 sr-1 / cm-1
            emission += line(axis[a], {fromCo2[a] * black, fromWater[a] * black}, "%g");
        }
        for (std::size_t a = axis.size(); a-- > 0;)
            gas += line(1e4 / axis[a], {through[a]}, "%.8g");
        writeFileDurably(folder / (std::string(zone.name) + ".csv"), emission);
        writeFileDurably(folder / (std::string(zone.gas) + ".csv"), gas);

        std::vector<double> emissivity(fine.count);
        for (std::size_t i = 0; i < fine.count; ++i)
            emissivity[i] = 1.0 - co2[i] * water[i];
        std::printf("%s, %s: a wall at %g K emits %.4g W m-2 sr-1 in 3-5 um\n", plume.sample,
                    zone.name, zone.temperature_K, inBand(emissivity, zone.temperature_K));
        std::fflush(stdout);
    }
}

} // namespace

void makePlumes(const Folders& folders) {
    const Gases gases{completeLineList(Gas::CO2, folders.data),
                      completeLineList(Gas::H2O, folders.data),
                      PartitionSums::read(folders.data / "lines" / "partition")};
    for (const Plume& plume : plumes())
        makePlume(plume, gases, folders.out / plume.sample);
}

} // namespace smat::tables
