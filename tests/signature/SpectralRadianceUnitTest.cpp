#include "irsg/signature/SpectrumCsv.h"

#include "Support.h"

namespace irsg {
namespace {

struct Row {
    const char* text;
    double toW_m2;
    bool perWavenumber;
};

TEST(SpectralRadianceUnit, HasTheseFactors) {
    const Row rows[] = {
        {"W m-2 sr-1 um-1", 1.0, false},         {"W m-2 sr-1 (cm-1)-1", 1.0, true},
        {"mW m-2 sr-1 um-1", 1e-3, false},       {"mW m-2 sr-1 (cm-1)-1", 1e-3, true},
        {"uW m-2 sr-1 um-1", 1e-6, false},       {"uW m-2 sr-1 (cm-1)-1", 1e-6, true},
        {"W cm-2 sr-1 um-1", 1e4, false},        {"W cm-2 sr-1 (cm-1)-1", 1e4, true},
        {"mW cm-2 sr-1 um-1", 10.0, false},      {"mW cm-2 sr-1 (cm-1)-1", 10.0, true},
        {"uW cm-2 sr-1 um-1", 1e-2, false},      {"uW cm-2 sr-1 (cm-1)-1", 1e-2, true},
        {"W m-2 sr-1 nm-1", 1e3, false},         {"W cm-2 sr-1 nm-1", 1e7, false},
        {"mW cm-2 sr-1 angstrom-1", 1e5, false}, {"uW cm-2 sr-1 angstrom-1", 1e2, false},
        {"W cm-2 sr-1 angstrom-1", 1e8, false}};
    ASSERT_EQ(std::size(rows), SpectralRadianceUnit::known().size());
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        const auto unit = SpectralRadianceUnit::parse(rows[i].text);
        EXPECT_EQ(unit.toW_m2, rows[i].toW_m2) << rows[i].text;
        EXPECT_EQ(unit.perWavenumber, rows[i].perWavenumber) << rows[i].text;
        EXPECT_EQ(unit.text(), rows[i].text);
        EXPECT_THAT(SpectralRadianceUnit::known(), testing::Contains(rows[i].text));
    }
}

TEST(SpectralRadianceUnit, IsKnownInOtherSpellings) {
    const std::pair<const char*, const char*> rows[] = {
        {"W/(cm2 sr cm-1)", "W cm-2 sr-1 (cm-1)-1"},
        {"W/cm^2/sr/um", "W cm-2 sr-1 um-1"},
        {"W m^-2 sr^-1 um^-1", "W m-2 sr-1 um-1"},
        {"\u00b5W\u00b7cm\u207b\u00b2\u00b7sr\u207b\u00b9\u00b7\u00b5m\u207b\u00b9",
         "uW cm-2 sr-1 um-1"},
        {"\u03bcW cm-2 sr-1 / cm-1", "uW cm-2 sr-1 (cm-1)-1"},
        {"W cm-2 sr-1 per cm-1", "W cm-2 sr-1 (cm-1)-1"},
        {"mW m-2 sr-1 cm", "mW m-2 sr-1 (cm-1)-1"},
        {"mW/(m2 sr cm-1)", "mW m-2 sr-1 (cm-1)-1"},
        {"mW/(m\u00b2 sr cm\u207b\u00b9)", "mW m-2 sr-1 (cm-1)-1"},
        {"mW/m2/sr/cm-1", "mW m-2 sr-1 (cm-1)-1"},
        {"W/m2/sr/(1/cm)", "W m-2 sr-1 (cm-1)-1"},
        {"W/m2 sr um", "W m-2 sr-1 um-1"},
        {"mW/cm2/sr/nm", "W cm-2 sr-1 um-1"},
        {"mW m-2 sr-1 nm-1", "W m-2 sr-1 um-1"},
        {"uW cm-2 sr-1 nm-1", "mW cm-2 sr-1 um-1"},
        {"uW cm-2 sr-1 \u00c5-1", "uW cm-2 sr-1 angstrom-1"},
        {"mW m-2 sr-1 \u00c5ngstr\u00f6m-1", "mW cm-2 sr-1 um-1"},
        {"W/m2/sr/\u212b", "W cm-2 sr-1 um-1"},
        {"W/(m^2 sr micron)", "W m-2 sr-1 um-1"},
        {" W  m-2  sr-1  um-1 ", "W m-2 sr-1 um-1"}};
    for (const auto& [spelling, canonical] : rows) {
        EXPECT_EQ(SpectralRadianceUnit::parse(spelling).text(), canonical) << spelling;
    }
}

TEST(SpectralRadianceUnit, IsRefusedWithTheListOfWhatIsKnown) {
    for (const char* const text : {"", "W", "W cm-2 sr-1", "W cm-2 um-1", "W m-2 sr-1 um",
                                   "MW m-2 sr-1 um-1", "w m-2 sr-1 um-1", "K", "W m-2 sr-1 cm-1",
                                   "W m-3 sr-1", "W/(m2 sr um", "W m-2 sr-1 um-1 um-1"}) {
        const auto diagnostics = refusalOf([&] { SpectralRadianceUnit::parse(text); });
        ASSERT_EQ(diagnostics.size(), 1U) << text;
        EXPECT_EQ(diagnostics[0].value, "'" + std::string(text) + "'");
        EXPECT_THAT(diagnostics[0].expected, testing::HasSubstr("uW cm-2 sr-1 (cm-1)-1"));
    }
}

TEST(SpectralRadianceUnit, OfAnotherFactorHasNoName) {
    EXPECT_THROW((SpectralRadianceUnit{2.0, false}.text()), LogicError);
}

} // namespace
} // namespace irsg
