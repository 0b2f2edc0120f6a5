#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "irsg/atmosphere/import/TextLines.h"
#include "tests/atmosphere/ModtranRuns.h"
#include "tests/support/SharedMaterial.h"

// Every MODTRAN result of the shared material against ours, in-band; docs/atmosphere-accuracy.md
// has the figures.

namespace irsg {
namespace {

using namespace modtran;

class ModtranComparisonTest : public testing::TestWithParam<PublishedFile> {};

TEST_P(ModtranComparisonTest, AgreesInBand) {
    const auto folder = smat::test::sharedMaterial("data/atmosphere/modtran");
    if (folder.empty()) {
        GTEST_SKIP() << "the MODTRAN results of the shared material are not there";
    }
    const PublishedFile& file = GetParam();
    for (const InBand& row : inBand(compare(folder, file), file)) {
        EXPECT_LE(std::abs(row.transmittanceError()), 0.015) << row.band.name;
        EXPECT_LE(row.radianceShare(), 1.0) << row.band.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, ModtranComparisonTest, testing::ValuesIn(publishedFiles()),
                         [](const auto& info) {
                             std::string name = info.param.name;
                             std::erase_if(name, [](char c) { return !std::isalnum(c); });
                             return name;
                         });

TEST(ModtranComparison, SunIsScatteredWithTheAsymmetryOfTheCards) {
    const auto folder = smat::test::sharedMaterial("data/atmosphere/modtran");
    if (folder.empty()) {
        GTEST_SKIP() << "the MODTRAN results of the shared material are not there";
    }
    // IPH 0 and G 0: isotropic. The aerosol's own phase function would be seven times as bright at
    // 20 degrees from the sun, where tape7-05 looks.
    for (const char* name : {"pyradi/tape7-03", "pyradi/tape7-05"}) {
        const auto file = std::ranges::find(publishedFiles(), name, &PublishedFile::name);
        const ModtranComparison ours = compare(folder, *file);
        std::vector<double> theirs; // column SOL_SCAT
        for (const std::string& line : TextLines::read(folder / name).lines) {
            std::istringstream words(line);
            std::vector<double> values;
            for (double value = 0.0; words >> value;) {
                values.push_back(value);
            }
            if (values.size() > 14 && values[0] >= 2050.0) {
                theirs.push_back(values[5] * values[0] * values[0]); // W m-2 sr-1 um-1
            }
        }
        ASSERT_EQ(theirs.size(), ours.wavenumbers_per_cm.size()) << name;
        const BandLimits band{"", 2050.0, 2100.0};
        EXPECT_NEAR(bandMean(ours.wavenumbers_per_cm, ours.scatteredSun, band) /
                        bandMean(ours.wavenumbers_per_cm, theirs, band),
                    1.0, 0.03)
            << name;
    }
}

TEST(ModtranComparison, SlitKeepsTheMeanOfAFlatSpectrumAndTheAreaOfAStep) {
    // A triangle of full width 10 at half height, centred on the edge of a step, takes half of it.
    const std::vector<double> wavenumbers = {1000.0, 1010.0, 1020.0};
    EXPECT_NEAR(bandMean(wavenumbers, {2.0, 2.0, 2.0}, {"", 1003.0, 1017.0}), 2.0, 1e-12);
    EXPECT_NEAR(bandMean(wavenumbers, {0.0, 1.0, 2.0}, {"", 1009.9, 1010.1}), 1.0, 1e-3);
}

} // namespace
} // namespace irsg
