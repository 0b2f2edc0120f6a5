#include "irsg/signature/SpectrumCsv.h"

#include <cmath>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

#include "Support.h"
#include "tests/support/SharedMaterial.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

const SpectralRadianceUnit perWavenumber{1e4, true};

double inBand(const Spectrum& radiance, SpectralRange band) {
    const Spectrum* const factors[] = {&radiance};
    return integrateProduct(factors, band);
}

/// Both forms of one spectrum on the nodes of a wavenumber axis.
struct Pair {
    UserSpectrum overWavenumber;
    UserSpectrum overWavelength;
};

template <typename Radiance>
Pair writeAndRead(const TemporaryFolder& folder, double from_per_cm, double to_per_cm,
                  double step_per_cm, Radiance radiance_W_m2_sr_um) {
    std::string overWavenumber = "# unit: W cm-2 sr-1 (cm-1)-1\ncm-1,L\n";
    std::string overWavelength = "# unit: W m-2 sr-1 um-1\num,L\n";
    for (double nu = from_per_cm; nu <= to_per_cm; nu += step_per_cm) {
        const double lambda_um = 1e4 / nu;
        const double radiance = radiance_W_m2_sr_um(lambda_um);
        overWavenumber += numberText(nu) + "," +
                          numberText(1e-4 * perWavenumberFromPerMicrometre(radiance, lambda_um)) +
                          "\n";
        overWavelength += numberText(lambda_um) + "," + numberText(radiance) + "\n";
    }
    return {readSpectrumCsv(writeBytes(folder / "nu.csv", overWavenumber)),
            readSpectrumCsv(writeBytes(folder / "um.csv", overWavelength))};
}

TEST(SpectrumCsv, GivesOneInBandRadianceOverMicrometresAndOverWavenumbers) {
    const TemporaryFolder folder;
    for (const double step_per_cm : {0.5, 1.0, 2.0}) {
        const Pair pair = writeAndRead(folder, 1900.0, 3400.0, step_per_cm, [](double lambda_um) {
            return (1.5 + std::sin(40.0 * lambda_um)) * planckRadiance_W_m2_sr_um(lambda_um, 700.0);
        });
        for (const SpectralRange band : {SpectralRange{3.0, 5.0}, SpectralRange{4.2, 4.5}}) {
            const double a = inBand(pair.overWavenumber.components[0].radiance, band);
            const double b = inBand(pair.overWavelength.components[0].radiance, band);
            EXPECT_NEAR(a / b, 1.0, 1e-6) << step_per_cm << " cm-1";
        }
    }
}

TEST(SpectrumCsv, OfABlackBodyHasTheInBandRadianceOfPlancksLaw) {
    const TemporaryFolder folder;
    const Pair pair = writeAndRead(folder, 1900.0, 3400.0, 1.0, [](double lambda_um) {
        return planckRadiance_W_m2_sr_um(lambda_um, 600.0);
    });
    const double expected = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 600.0);
    EXPECT_NEAR(inBand(pair.overWavenumber.components[0].radiance, {3.0, 5.0}) / expected, 1.0,
                1e-6);
}

TEST(SpectrumCsv, OverWavenumbersKeepsTheIntegralOverWavenumbers) {
    // A constant 1 W m-2 sr-1 per cm-1 over 500 cm-1.
    const TemporaryFolder folder;
    std::string text = "# unit: W m-2 sr-1 (cm-1)-1\ncm-1,L\n";
    for (int nu = 2000; nu <= 2500; nu += 2) {
        text += std::to_string(nu) + ",1\n";
    }
    const UserSpectrum spectrum = readSpectrumCsv(writeBytes(folder / "one.csv", text));
    EXPECT_NEAR(inBand(spectrum.components[0].radiance, {4.0, 5.0}), 500.0, 500.0 * 1e-6);
}

TEST(SpectrumCsv, AppliesTheJacobian) {
    // 361 at 1900 cm-1, 625 at 2500 cm-1, whatever the axis is written in.
    const TemporaryFolder folder;
    for (const char* const axis :
         {"cm-1,L\n1900,1\n2500,1\n", "um,L\n4,1\n5.2631578947368425,1\n"}) {
        const UserSpectrum spectrum =
            readSpectrumCsv(writeBytes(folder / "jacobian.csv", axis),
                            SpectralRadianceUnit::parse("W m-2 sr-1 (cm-1)-1"));
        const Spectrum& radiance = spectrum.components[0].radiance;
        ASSERT_EQ(radiance.size(), 2U);
        EXPECT_NEAR(radiance.values()[0], 625.0, 1e-9) << axis;
        EXPECT_NEAR(radiance.values()[1], 361.0, 1e-9) << axis;
        EXPECT_EQ(radiance.wavelengths_um()[0], 4.0);
        EXPECT_NEAR(radiance.wavelengths_um()[1], 1e4 / 1900.0, 1e-12);
    }
}

TEST(SpectrumCsv, EmitsNothingOutsideItsAxis) {
    const TemporaryFolder folder;
    const UserSpectrum spectrum =
        readSpectrumCsv(writeBytes(folder / "a.csv", "um,L\n4,1\n5,3\n"), SpectralRadianceUnit{});
    const Spectrum& radiance = spectrum.components[0].radiance;
    EXPECT_EQ(radiance.at(3.999), 0.0);
    EXPECT_EQ(radiance.at(4.5), 2.0);
    EXPECT_EQ(radiance.at(5.001), 0.0);
}

TEST(SpectrumCsv, ReadsDescendingAxesAsAscendingOnes) {
    const TemporaryFolder folder;
    const auto read = [&](const char* text) {
        return readSpectrumCsv(writeBytes(folder / "axis.csv", text), SpectralRadianceUnit{});
    };
    EXPECT_TRUE(read("um,a,b\n5,3,30\n4.5,2,20\n4,1,10\n") ==
                read("um,a,b\n4,1,10\n4.5,2,20\n5,3,30\n"));
    EXPECT_TRUE(read("cm-1,a\n2500,1\n2000,3\n") == read("cm-1,a\n2000,3\n2500,1\n"));
}

TEST(SpectrumCsv, TakesTheUnitFromTheFileUnlessAnotherIsChosen) {
    const TemporaryFolder folder;
    const fs::path file =
        writeBytes(folder / "units.csv",
                   "# unit: uW cm-2 sr-1 um-1\n# reference_distance_m: 2.5\num,L\n4,100\n5,100\n");
    const UserSpectrum stated = readSpectrumCsv(file);
    EXPECT_DOUBLE_EQ(stated.components[0].radiance.at(4.5), 1.0);
    EXPECT_EQ(stated.importedUnit, "uW cm-2 sr-1 um-1");
    EXPECT_EQ(stated.referenceDistance_m, 2.5);
    EXPECT_EQ(stated.name, "units");

    const UserSpectrum chosen =
        readSpectrumCsv(file, SpectralRadianceUnit::parse("W cm-2 sr-1 um-1"), 7.0);
    EXPECT_DOUBLE_EQ(chosen.components[0].radiance.at(4.5), 1e6);
    EXPECT_EQ(chosen.importedUnit, "W cm-2 sr-1 um-1");
    EXPECT_EQ(chosen.referenceDistance_m, 7.0);
}

TEST(SpectrumCsv, IsWrittenAsItIsCalibrated) {
    const TemporaryFolder folder;
    UserSpectrum spectrum =
        readSpectrumCsv(writeBytes(folder / "a.csv", "um,L\n4,1\n5,3\n"), SpectralRadianceUnit{});
    spectrum.calibrationFactor = 0.5;
    writeSpectrumCsv(spectrum, folder / "b.csv");
    const UserSpectrum back = readSpectrumCsv(folder / "b.csv");
    EXPECT_EQ(back.components[0].radiance.values(), (std::vector{0.5, 1.5}));
    EXPECT_EQ(back.calibrationFactor, 1.0);
}

TEST(SpectrumCsv, ReadsEveryUnitToTheSameRadiance) {
    const TemporaryFolder folder;
    for (const std::string& name : SpectralRadianceUnit::known()) {
        const auto unit = SpectralRadianceUnit::parse(name);
        const double one = 1.0 / unit.toW_m2 / (unit.perWavenumber ? 625.0 : 1.0);
        const fs::path file = writeBytes(folder / "unit.csv", "# unit: " + name + "\num,L\n4," +
                                                                  numberText(one) + "\n5,0\n");
        EXPECT_NEAR(readSpectrumCsv(file).components[0].radiance.at(4.0), 1.0, 1e-14) << name;
    }
}

TEST(SpectrumCsv, ComesBackAsItWasWritten) {
    const TemporaryFolder folder;
    UserSpectrum spectrum = completeDatabase().spectra.at("plume core");
    spectrum.components[0].name = "CO2, \"hot\" #4";
    writeSpectrumCsv(spectrum, folder / "plume core.csv");
    UserSpectrum again = readSpectrumCsv(folder / "plume core.csv");
    EXPECT_EQ(again.importedUnit, "W m-2 sr-1 um-1");
    again.importedUnit = spectrum.importedUnit;
    again.notes = spectrum.notes;
    EXPECT_TRUE(again == spectrum);
    EXPECT_THAT(readBytes(folder / "plume core.csv"), HasSubstr("# unit: W m-2 sr-1 um-1\n"));
}

TEST(SpectrumCsv, ThatCannotBeWrittenIsNamed) {
    const TemporaryFolder folder;
    const auto diagnostics = refusalOf([&] {
        writeSpectrumCsv(completeDatabase().spectra.at("plume core"), folder / "nowhere/a.csv");
    });
    EXPECT_EQ(diagnostics[0].file, (folder / "nowhere/a.csv").string());
}

TEST(SpectrumCsv, OfTheReportsTable18HasItsNumbers) {
    const fs::path file = smat::test::sharedMaterial("data/karma/spectra_table18.csv");
    if (!fs::exists(file)) {
        GTEST_SKIP() << "the report's table 18 is not at hand";
    }
    EXPECT_THAT(refusalOf([&] { readSpectrumCsv(file); })[0].expected, HasSubstr("# unit:"));

    const UserSpectrum spectrum =
        readSpectrumCsv(file, SpectralRadianceUnit::parse("W cm-2 sr-1 (cm-1)-1"), 10.0);
    std::vector<std::string> names;
    for (const SpectrumComponent& component : spectrum.components) {
        names.push_back(component.name);
    }
    EXPECT_THAT(names, ElementsAre("BB(T1)", "BB(T2)", "BB(T3)", "CO2(T4)", "H2O"));
    EXPECT_EQ(spectrum.referenceDistance_m, 10.0);
    EXPECT_EQ(spectrum.importedUnit, "W cm-2 sr-1 (cm-1)-1");
    EXPECT_EQ(spectrum.find("no such"), nullptr);

    // Rows of the file: wavenumber, BB(T1), CO2(T4), H2O, in W cm-2 sr-1 (cm-1)-1.
    struct Row {
        double nu;
        double bb;
        double co2;
        double h2o;
    };
    const Row rows[] = {{1900, 7.76e-5, 4.55e-5, 1.59e-4},
                        {1902, 6.75e-5, 5.00e-5, 1.34e-4},
                        {1904, 4.53e-5, 5.43e-5, 9.03e-5},
                        {1906, 2.08e-5, 5.25e-5, 4.59e-5},
                        {1908, 1.46e-5, 4.46e-5, 3.26e-5}};
    const Spectrum& bb = spectrum.components[0].radiance;
    ASSERT_EQ(bb.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const Row& row = rows[4 - i];
        const double factor = 1e4 * row.nu * row.nu / 1e4;
        EXPECT_NEAR(bb.wavelengths_um()[i], 1e4 / row.nu, 1e-14);
        EXPECT_NEAR(bb.values()[i] / (row.bb * factor), 1.0, 1e-14);
        EXPECT_NEAR(spectrum.components[3].radiance.values()[i] / (row.co2 * factor), 1.0, 1e-14);
        EXPECT_NEAR(spectrum.components[4].radiance.values()[i] / (row.h2o * factor), 1.0, 1e-14);
    }
    EXPECT_NEAR(bb.values()[4], 280.136, 1e-9) << "7.76e-5 W cm-2 per cm-1 at 1900 cm-1";
}

TEST(SpectrumCsv, UnitsInHeadsAndPerNanometreGiveTheSameRadiance) {
    const std::filesystem::path strangers =
        std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/strangers/radiance-per-nm";
    for (const auto& [name, component] :
         {std::pair("rad_w_nm.csv", "CO2"), std::pair("radis.csv", "radiance")}) {
        const UserSpectrum spectrum = readSpectrumCsv(strangers / name);
        ASSERT_EQ(spectrum.components.size(), 1U) << name;
        EXPECT_EQ(spectrum.components[0].name, component);
        EXPECT_NEAR(spectrum.components[0].radiance.at(4.4), 60.0, 1e-9) << name;
        EXPECT_NEAR(spectrum.components[0].radiance.at(4.6), 10.0, 1e-9) << name;
    }
    const TemporaryFolder folder;
    const auto file = writeBytes(folder / "a.csv", "wavelength [um],CO2 [mW m-2 sr-1 cm],soot "
                                                   "(mW m-2 sr-1 cm)\n4,1,2\n5,1,2\n");
    const UserSpectrum spectrum = readSpectrumCsv(file);
    EXPECT_EQ(spectrum.components[1].name, "soot");
    EXPECT_NEAR(spectrum.components[1].radiance.at(5.0), 2e-3 * 2000.0 * 2000.0 / 1e4, 1e-12);
    const auto two = writeBytes(folder / "b.csv", "um,a [W m-2 sr-1 um-1],b [W m-2 sr-1 nm-1]\n"
                                                  "4,1,2\n5,1,2\n");
    EXPECT_FALSE(refusalOf([&] { readSpectrumCsv(two); }).empty());
}

struct BadCsv {
    const char* name;
    const char* text;
    const char* position;
    const char* value;
    const char* expected;
};
void PrintTo(const BadCsv& row, std::ostream* out) {
    *out << row.name;
}

class RefusedSpectrumCsv : public testing::TestWithParam<BadCsv> {};

TEST_P(RefusedSpectrumCsv, NamesFilePlaceValueAndExpectation) {
    const TemporaryFolder folder;
    const fs::path file = writeBytes(folder / "bad.csv", GetParam().text);
    const auto diagnostics = refusalOf([&] { readSpectrumCsv(file); });
    bool found = false;
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) {
        EXPECT_EQ(diagnostic.file, file.string());
        all += diagnostic.message() + "\n";
        found |= diagnostic.position == GetParam().position &&
                 diagnostic.value.find(GetParam().value) != std::string::npos &&
                 diagnostic.expected.find(GetParam().expected) != std::string::npos;
    }
    EXPECT_TRUE(found) << all;
}

INSTANTIATE_TEST_SUITE_P(
    SpectrumCsv, RefusedSpectrumCsv,
    testing::Values(
        BadCsv{"Empty", "", "", "0 rows", "at least 2 rows"},
        BadCsv{"OneNode", "# unit: W m-2 sr-1 um-1\num,a\n4,1\n", "", "2 rows", "at least 2 rows"},
        BadCsv{"NoUnit", "um,a\n4,1\n5,1\n", "", "no unit", "# unit:"},
        BadCsv{"UnknownUnit", "# unit: W cm-2\num,a\n4,1\n5,1\n", "line 1", "W cm-2",
               "W cm-2 sr-1 um-1"},
        BadCsv{"UnknownAxis", "# unit: W m-2 sr-1 um-1\neV,a\n4,1\n5,1\n", "line 2, column 1",
               "'eV'", "'um', 'nm'"},
        BadCsv{"NoAxis", "# unit: W m-2 sr-1 um-1\n,a\n4,1\n5,1\n", "line 2, column 1", "nothing",
               "'um', 'nm'"},
        BadCsv{"NoComponent", "# unit: W m-2 sr-1 um-1\num\n4\n5\n", "line 2", "um", "one name"},
        BadCsv{"NamelessComponent", "# unit: W m-2 sr-1 um-1\num,a,\n4,1,1\n5,1,1\n",
               "line 2, column 3", "nothing", "name of a component"},
        BadCsv{"ComponentTwice", "# unit: W m-2 sr-1 um-1\num,a,a\n4,1,1\n5,1,1\n",
               "line 2, column 3", "'a'", "once"},
        BadCsv{"RowTooShort", "# unit: W m-2 sr-1 um-1\num,a,b\n4,1,1\n5,1\n", "line 4", "2 cells",
               "3 cells"},
        BadCsv{"RowTooLong", "# unit: W m-2 sr-1 um-1\num,a\n4,1,9\n5,1\n", "line 3", "3 cells",
               "2 cells"},
        BadCsv{"TextForRadiance", "# unit: W m-2 sr-1 um-1\num,a\n4,1\n5,much\n",
               "line 4, column 2", "'much'", "finite number"},
        BadCsv{"NotANumber", "# unit: W m-2 sr-1 um-1\num,a\n4,nan\n5,1\n", "line 3, column 2",
               "'nan'", "finite number"},
        BadCsv{"Infinite", "# unit: W m-2 sr-1 um-1\num,a\n4,1\n5,inf\n", "line 4, column 2",
               "'inf'", "finite number"},
        BadCsv{"EmptyCell", "# unit: W m-2 sr-1 um-1\num,a\n4,\n5,1\n", "line 3, column 2",
               "nothing", "finite number"},
        BadCsv{"AxisNotANumber", "# unit: W m-2 sr-1 um-1\num,a\nx,1\n5,1\n", "line 3, column 1",
               "'x'", "finite number"},
        BadCsv{"AxisZero", "# unit: W m-2 sr-1 um-1\num,a\n0,1\n5,1\n", "line 3, column 1", "'0'",
               "positive"},
        BadCsv{"AxisNegative", "# unit: W m-2 sr-1 um-1\ncm-1,a\n-5,1\n5,1\n", "line 3, column 1",
               "'-5'", "positive"},
        BadCsv{"AxisDuplicated", "# unit: W m-2 sr-1 um-1\num,a\n4,1\n4,1\n5,1\n",
               "line 4, column 1", "'4'", "strictly ascending"},
        BadCsv{"AxisTurnsBack", "# unit: W m-2 sr-1 um-1\num,a\n4,1\n5,1\n4.5,1\n",
               "line 5, column 1", "'4.5'", "above 5"},
        BadCsv{"DescendingAxisTurnsBack", "# unit: W m-2 sr-1 um-1\ncm-1,a\n9,1\n8,1\n8.5,1\n",
               "line 5, column 1", "'8.5'", "below 8"},
        BadCsv{"CommaForPoint", "# unit: W m-2 sr-1 um-1\num,a\n4,1,5\n5,1,5\n", "line 3",
               "3 cells", "2 cells"},
        BadCsv{"QuoteLeftOpen", "# unit: W m-2 sr-1 um-1\num,\"a\n4,1\n5,1\n", "line 2", "a",
               "closing quote"},
        BadCsv{"BadDistance",
               "# unit: W m-2 sr-1 um-1\n# reference_distance_m: -3\num,a\n4,1\n5,1\n", "line 2",
               "-3", "at least 0 m"},
        BadCsv{"DistanceOfText",
               "# unit: W m-2 sr-1 um-1\n# reference_distance_m: far\num,a\n4,1\n5,1\n", "line 2",
               "far", "at least 0 m"}),
    [](const auto& row) { return row.param.name; });

TEST(SpectrumCsv, ReportsAllDiagnosticsAtOnce) {
    const TemporaryFolder folder;
    const fs::path file = writeBytes(folder / "many.csv", "eV,a,a,\n4,x,1,1\n5,1,y\n");
    EXPECT_EQ(refusalOf([&] { readSpectrumCsv(file); }).size(), 6U);
}

TEST(SpectrumCsv, ThatIsMissingOrAFolderIsNamed) {
    const TemporaryFolder folder;
    EXPECT_EQ(refusalOf([&] { readSpectrumCsv(folder / "absent.csv"); })[0].file,
              (folder / "absent.csv").string());
    EXPECT_EQ(refusalOf([&] { readSpectrumCsv(folder.path()); })[0].value, "a folder");
}

TEST(SpectrumCsv, RefusesAReferenceDistanceThatIsNone) {
    const TemporaryFolder folder;
    const fs::path file = writeBytes(folder / "a.csv", "um,L\n4,1\n5,3\n");
    for (const double distance_m : {-1.0, std::nan(""), HUGE_VAL}) {
        const auto diagnostics =
            refusalOf([&] { readSpectrumCsv(file, perWavenumber, distance_m); });
        EXPECT_EQ(diagnostics[0].position, "reference distance");
    }
}

} // namespace
} // namespace irsg
