#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

namespace irsg::lbl {
namespace {

/// A gas of the tropical model at the ground, 5 km of it, and where MODTRAN was run with the lines
/// that we have.
struct Stretch {
    Gas gas;
    double fraction;
    std::size_t column; ///< of the MODTRAN file
    double lower_per_cm, upper_per_cm, rms;
};

/// Root mean square of the difference of 10 cm-1 transmittances (triangular slit, every 5 cm-1).
double difference(const Stretch& at) {
    constexpr double temperature_K = 299.7, pressure_hPa = 1013.0, slit_per_cm = 10.0;
    const auto lines = smat::test::sharedMaterial("data/atmosphere/lines");
    const LineList list = readLineList(
        at.gas, lines / (std::string(gasNames[static_cast<std::size_t>(at.gas)]) + ".par.gz"));
    const WavenumberGrid grid{
        at.lower_per_cm - slit_per_cm, 0.005,
        static_cast<std::size_t>((at.upper_per_cm - at.lower_per_cm + 2.0 * slit_per_cm) / 0.005) +
            1};
    std::vector<double> transmittance =
        crossSection_cm2(list, PartitionSums::read(lines / "partition"), grid, temperature_K,
                         pressure_hPa, at.fraction, defaultLineShape(at.gas));
    const double column_per_cm2 =
        at.fraction * 1e-4 * pressure_hPa / (1.380649e-23 * temperature_K) * 5e5;
    for (double& value : transmittance) {
        value = std::exp(-value * column_per_cm2);
    }

    std::ifstream file(
        smat::test::sharedMaterial("data/atmosphere/modtran/pyradi/horizon5kmtropical.fl7"));
    double sum = 0.0;
    int count = 0;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::vector<double> row;
        for (double number = 0.0; words >> number;) {
            row.push_back(number);
        }
        if (row.size() < 20 || row[0] < at.lower_per_cm || row[0] > at.upper_per_cm) {
            continue;
        }
        double mean = 0.0, weights = 0.0;
        for (std::size_t i = 0; i < grid.count; ++i) {
            const double weight = 1.0 - std::abs(grid.at(i) - row[0]) / slit_per_cm;
            if (weight > 0.0) {
                mean += weight * transmittance[i];
                weights += weight;
            }
        }
        sum += std::pow(mean / weights - row[at.column], 2.0);
        ++count;
    }
    return std::sqrt(sum / count);
}

TEST(LineAbsorption, AgreesWithModtranWhereTheListsAreComplete) {
    if (smat::test::sharedMaterial("data/atmosphere/lines").empty() ||
        smat::test::sharedMaterial("data/atmosphere/modtran").empty()) {
        GTEST_SKIP() << "the line lists and MODTRAN results of the shared material are not here";
    }
    const Stretch stretches[] = {
        {Gas::CO, 0.15e-6, 14, 2050.0, 2200.0, 0.006},
        {Gas::N2O, 0.32e-6, 16, 2150.0, 2270.0, 0.025},
        {Gas::CO2, 365e-6, 13, 2300.0, 2500.0, 0.02}, // the wing beyond the band head
    };
    for (const Stretch& stretch : stretches) {
        EXPECT_LT(difference(stretch), stretch.rms)
            << gasNames[static_cast<std::size_t>(stretch.gas)];
    }
}

} // namespace
} // namespace irsg::lbl
