// Measured tables of reflectance: what they reflect, their files and what is wrong with them.
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/ReflectanceCsv.h"
#include "tests/signature/SurfaceSums.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {

namespace {

using namespace test;
using smat::test::TemporaryFolder;
using testing::HasSubstr;

/// A table of a Lambertian part and a broad lobe that is reciprocal.
double measured(double incidence_deg, double reflection_deg, double azimuth_deg) {
    const SurfaceDirection facet =
        halfway(direction(incidence_deg), direction(reflection_deg, azimuth_deg));
    return 0.2 / pi + 0.1 * std::pow(facet.z, 20);
}

ReflectanceTable measuredTable(double step_deg, double skew = 0.0) {
    std::vector<ReflectanceTable::Row> rows;
    for (double i = 0.0; i <= 90.0; i += step_deg) {
        for (double r = 0.0; r <= 90.0; r += step_deg) {
            for (double a = 0.0; a <= 180.0; a += step_deg) {
                // Straight up and opposite has no facet half way.
                const bool grazing = i == 90.0 && r == 90.0 && a == 180.0;
                rows.push_back(
                    {i,
                     r,
                     a,
                     {grazing ? 0.2 / pi + 0.1 : measured(i, r, a) * (1.0 + skew * i / 90.0)}});
            }
        }
    }
    return {true, {4.0}, std::move(rows)};
}

Material tabulated(ReflectanceTable table) {
    Material material;
    material.surfaceModel = "tabulated";
    material.reflectanceTable = std::move(table);
    material.emissivity = Spectrum::constant(1.0 - reflectanceOverAngle(material, 1.0, 4.0));
    return material;
}

} // namespace

TEST(TabulatedModel, ReflectsAsItWasMeasured) {
    const Material material = tabulated(measuredTable(5.0));
    DirectionSamples draws;
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const double a = 80.0 * draws.next(), b = 80.0 * draws.next(), c = 180.0 * draws.next();
        worst = std::max(worst, std::abs(brdf_per_sr(material, direction(b, c), direction(a), 4.0) /
                                             measured(a, b, c) -
                                         1.0));
    }
    EXPECT_LT(worst, 0.05); // straight lines over 5 degrees
    EXPECT_LT(worstReciprocity(material), 1e-9);
    for (const double angle_deg : {0.0, 40.0, 70.0}) {
        EXPECT_NEAR(reflectanceOverAngle(material, std::cos(radians(angle_deg)), 4.0),
                    reflectedOf(material, angle_deg), 1e-3);
    }
    EXPECT_EQ(findingsOf(material), "");
    EXPECT_THAT(findingsOf(tabulated(measuredTable(10.0, 0.3))), HasSubstr("not reciprocal"));
}

TEST(TabulatedModel, OfHemisphericalReflectanceIsReciprocalAndReflectsAsMuch) {
    const Material material = tabulated(
        {false, {3.0, 5.0}, {{0, 0, 0, {0.2, 0.4}}, {60, 0, 0, {0.3, 0.5}}, {90, 0, 0, {1, 1}}}});
    EXPECT_LT(worstReciprocity(material), 1e-9);
    for (const double angle_deg : {0.0, 30.0, 50.0, 80.0}) {
        const double expected = angle_deg <= 60.0 ? 0.3 + 0.1 * angle_deg / 60.0
                                                  : 0.4 + 0.6 * (angle_deg - 60.0) / 30.0;
        EXPECT_NEAR(reflectanceOverAngle(material, std::cos(radians(angle_deg)), 4.0), expected,
                    2e-3);
        EXPECT_NEAR(reflectedOf(material, angle_deg), expected, 2e-3);
    }
    // Between its wavelengths straight, beyond them held.
    EXPECT_NEAR(reflectanceOverAngle(material, 1.0, 3.5), 0.25, 1e-9);
    EXPECT_NEAR(reflectanceOverAngle(material, 1.0, 9.0), 0.4, 1e-9);
}

TEST(TabulatedModel, WithoutATableIsRefused) {
    Material material;
    material.surfaceModel = "tabulated";
    EXPECT_THROW(surfaceModelOf(material), InputError);
    EXPECT_THAT(findingsOf(material), HasSubstr("no table"));
}

TEST(ReflectanceTable, RefusesWhatIsNoTable) {
    struct Wrong {
        const char* name;
        bool isBrdf;
        std::vector<double> wavelengths_um;
        std::vector<ReflectanceTable::Row> rows;
        const char* told;
    };
    for (const Wrong& wrong :
         {Wrong{"nothing", false, {4.0}, {}, "at least one row"},
          Wrong{"no wavelength", false, {}, {{0, 0, 0, {}}}, "1 to 8"},
          Wrong{"descending", false, {4.0, 3.0}, {{0, 0, 0, {0.1, 0.1}}}, "ascend"},
          Wrong{"percent", false, {4.0}, {{0, 0, 0, {40.0}}}, "from 0 to 1"},
          Wrong{"negative", true, {4.0}, {{0, 0, 0, {-0.1}}}, "at least 0 sr-1"},
          Wrong{"angle", false, {4.0}, {{95, 0, 0, {0.4}}}, "0 to 90"},
          Wrong{"azimuth", true, {4.0}, {{0, 0, 190, {0.4}}}, "0 to 180"},
          Wrong{"twice", false, {4.0}, {{10, 0, 0, {0.4}}, {10, 0, 0, {0.5}}}, "once"},
          Wrong{"holes", true, {4.0}, {{0, 0, 0, {1}}, {10, 20, 0, {1}}}, "every direction"},
          Wrong{"short", false, {4.0, 5.0}, {{10, 0, 0, {0.4}}}, "one for each"}}) {
        try {
            const ReflectanceTable made(wrong.isBrdf, wrong.wavelengths_um, wrong.rows);
            ADD_FAILURE() << wrong.name;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(wrong.told)) << wrong.name;
        }
    }
}

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

const char* const zemax = R"(# Data of a scatterometer
Source  Measured
Symmetry  PlaneSymmetrical
SpectralContent  Monochrome
ScatterType  BRDF
SampleRotation  1
0
AngleOfIncidence  2
0 60
ScatterAzimuth 3
0 90 180
ScatterRadial 3
0 30 90

Monochrome
DataBegin
TIS 0.5
0.8 0.4 0.1
0.8 0.4 0.1
0.8 0.4 0.1
TIS 0.6
1.2 0.6 0.2
1.2 0.5 0.1
1.2 0.3 0.0
DataEnd
)";

} // namespace

TEST(ReflectanceCsv, IsWrittenAndReadWithoutLoss) {
    const TemporaryFolder folder;
    for (const ReflectanceTable& table :
         {measuredTable(30.0),
          ReflectanceTable(false, {3.0, 5.0}, {{0, 0, 0, {0.2, 0.4}}, {80, 0, 0, {0.7, 0.8}}})}) {
        writeReflectanceCsv(table, folder / "a.csv");
        EXPECT_TRUE(readReflectanceTable(folder / "a.csv") == table);
    }
}

TEST(ReflectanceCsv, RefusesWhatItIsNotByLineAndColumn) {
    const TemporaryFolder folder;
    const auto told = [&](const std::string& text) -> std::string {
        write(folder / "wrong.csv", text);
        try {
            readReflectanceTable(folder / "wrong.csv");
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(told("um,4\n0,0.2\n"), HasSubstr("line 1, column 1"));
    EXPECT_THAT(told("incidence_deg,4\n0,x\n"), HasSubstr("line 2, column 2"));
    EXPECT_THAT(told("incidence_deg,4\n0\n"), HasSubstr("line 2"));
    EXPECT_THAT(told("incidence_deg\n0\n"), HasSubstr("wavelengths in um"));
    EXPECT_THAT(told("incidence_deg,reflection_deg,4\n0,0,1\n"), HasSubstr("azimuth_deg"));
    EXPECT_THAT(told("incidence_deg,4\n0,40\n"), HasSubstr("wrong.csv"));
    EXPECT_THAT(told(""), HasSubstr("row of names"));
}

TEST(ZemaxBsdf, IsReadAboutTheMirrorDirection) {
    const TemporaryFolder folder;
    write(folder / "a.bsdf", zemax);
    const ReflectanceTable table = readReflectanceTable(folder / "a.bsdf");
    ASSERT_TRUE(table.isBrdf());
    EXPECT_THAT(table.incidences_deg(), testing::ElementsAre(0.0, 60.0));
    // Along the normal: by the angle alone.
    EXPECT_NEAR(table.at(0, 0.0, 30.0, 55.0), 0.4, 1e-9);
    EXPECT_NEAR(table.at(0, 0.0, 90.0, 10.0), 0.1, 1e-9);
    // From 60 deg: the mirror direction, 30 deg from it towards the normal, to the other side, and
    // across the plane of incidence.
    EXPECT_NEAR(table.at(0, 60.0, 60.0, 180.0), 1.2, 1e-9);
    EXPECT_NEAR(table.at(0, 60.0, 30.0, 180.0), 0.6, 1e-9);
    EXPECT_NEAR(table.at(0, 60.0, 90.0, 180.0), 0.3, 1e-9);
    EXPECT_NEAR(table.at(0, 60.0, 30.0, 0.0), 0.2, 1e-9); // 90 deg from it, behind the normal
    EXPECT_NEAR(table.at(0, 60.0, 90.0, 90.0), 0.1, 1e-9);
}

TEST(ZemaxBsdf, RefusesWhatItIsNotByLine) {
    const std::string whole = zemax;
    const auto told = [&](const std::string& from, const std::string& to) -> std::string {
        std::string text = whole;
        text.replace(text.find(from), from.size(), to);
        try {
            parseZemaxBsdf(text, "a.bsdf");
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(told("PlaneSymmetrical", "Asymmetrical4D"), HasSubstr("line 3"));
    EXPECT_THAT(told("BRDF", "BTDF"), HasSubstr("'ScatterType BRDF'"));
    EXPECT_THAT(told("0 60", "0 60 70"), HasSubstr("line 9"));
    EXPECT_THAT(told("0 90 180", "0 90 80"), HasSubstr("ascend"));
    EXPECT_THAT(told("0.8 0.4 0.1", "0.8 0.4"), HasSubstr("line 18"));
    EXPECT_THAT(told("0.8 0.4 0.1", "0.8 nan 0.1"), HasSubstr("line 18"));
    EXPECT_THAT(told("0.8 0.4 0.1", "0.8 -0.4 0.1"), HasSubstr("a.bsdf"));
    EXPECT_THAT(told("DataEnd", ""), HasSubstr("its end"));
}

} // namespace irsg
