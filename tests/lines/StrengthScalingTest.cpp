#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/RandomNumbers.h"
#include "tools/atmosphere-tables/lines/StrengthScaling.h"

namespace irsg::lbl {
namespace {

constexpr ScalingWindows windows{5000.0, 5200.0, 50.0};

/// A line every 1 cm-1 on the average, of which a kilometre of air transmits about half.
LineList randomLines() {
    LineList list{Gas::CH4, {}, {}};
    RandomNumbers random(7);
    for (int i = 0; i < 240; ++i) {
        Line line;
        line.wavenumber_per_cm = 4980.0 + i + random.next();
        line.intensity = 4e-23 * std::exp(2.0 * random.next());
        list.lines.push_back(line);
    }
    return list;
}

AtmosphericState air() {
    AtmosphericState state;
    state.moleFraction[static_cast<std::size_t>(Gas::CH4)] = 0.01;
    return state;
}

/// What a list transmits along a kilometre, every 5 cm-1, each the mean over 5 cm-1.
KnownPath transmitted(const LineList& list) {
    KnownPath path{air(), 1e5, {}, {}};
    for (double nu_per_cm = 5002.5; nu_per_cm < 5200.0; nu_per_cm += 5.0) {
        const WavenumberGrid grid{nu_per_cm - 2.495, 0.01, 500};
        const auto cross =
            crossSection_cm2(list, PartitionSums::rigidRotor(), grid, air().temperature_K,
                             air().pressure_hPa, 0.01, defaultLineShape(Gas::CH4));
        double mean = 0.0;
        for (const double value : cross) {
            mean += std::exp(-value * air().density_per_m3(Gas::CH4) * 1e-6 * path.length_cm) /
                    static_cast<double>(cross.size());
        }
        path.wavenumbers_per_cm.push_back(nu_per_cm);
        path.transmittances.push_back(mean);
    }
    return path;
}

TEST(StrengthScaling, FindsTheFactorByWhichAllLinesAreTooWeak) {
    LineList list = randomLines();
    const KnownPath known = transmitted(list);
    for (Line& line : list.lines) {
        line.intensity *= 0.6;
    }
    scaleStrengths(list, known, windows);
    const LineList original = randomLines();
    for (std::size_t i = 0; i < list.lines.size(); ++i) {
        const double nu_per_cm = original.lines[i].wavenumber_per_cm;
        const bool inside = nu_per_cm >= windows.lower_per_cm && nu_per_cm <= windows.upper_per_cm;
        EXPECT_NEAR(list.lines[i].intensity / original.lines[i].intensity, inside ? 1.0 : 0.6,
                    inside ? 0.02 : 1e-12)
            << nu_per_cm;
    }
}

TEST(StrengthScaling, BringsTheMeanOfEveryWindowToTheKnownOne) {
    LineList list = randomLines();
    for (Line& line : list.lines) {
        line.intensity *= std::exp(0.4 * std::sin(line.wavenumber_per_cm / 60.0));
    }
    const KnownPath known = transmitted(list);
    list = randomLines();
    scaleStrengths(list, known, windows);
    const KnownPath scaled = transmitted(list);
    for (std::size_t window = 0; window < 4; ++window) {
        double difference = 0.0;
        for (std::size_t i = 10 * window; i < 10 * window + 10; ++i) {
            difference += (scaled.transmittances[i] - known.transmittances[i]) / 10.0;
        }
        EXPECT_NEAR(difference, 0.0, 5e-4) << window;
    }
}

TEST(StrengthScaling, ChangesNothingWhereNothingIsAbsorbedAndNeverMoreThanThreefold) {
    KnownPath known = transmitted(randomLines());
    for (double& value : known.transmittances) {
        value = 1.0;
    }
    LineList list = randomLines();
    scaleStrengths(list, known, windows);
    for (std::size_t i = 0; i < list.lines.size(); ++i) {
        EXPECT_EQ(list.lines[i].intensity, randomLines().lines[i].intensity);
    }

    for (double& value : known.transmittances) {
        value = 0.0;
    }
    scaleStrengths(list, known, windows);
    for (std::size_t i = 0; i < list.lines.size(); ++i) {
        EXPECT_LE(list.lines[i].intensity, 3.0001 * randomLines().lines[i].intensity);
    }
}

TEST(StrengthScaling, NeedsWholeWindowsWithKnownValues) {
    LineList list = randomLines();
    const KnownPath known = transmitted(list);
    EXPECT_THROW(scaleStrengths(list, known, {5000.0, 5200.0, 60.0}), LogicError);
    EXPECT_THROW(scaleStrengths(list, known, {5000.0, 5000.0, 50.0}), LogicError);
    EXPECT_THROW(scaleStrengths(list, known, {5000.0, 5300.0, 50.0}), LogicError);
}

} // namespace
} // namespace irsg::lbl
