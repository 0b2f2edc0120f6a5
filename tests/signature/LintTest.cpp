#include <functional>
#include <limits>

#include "irsg/radiometry/Planck.h"
#include "irsg/signature/Lint.h"

#include "Support.h"

namespace irsg {
namespace {

using Severity = Finding::Severity;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string listOf(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        text += finding.place + ": " + finding.value + ": " + finding.reason + "\n";
    }
    return text;
}

UserSpectrum blackbody(double temperature_K, double scale = 1.0) {
    std::vector<double> axis_um;
    std::vector<double> radiance;
    for (double wavelength_um = 3.0; wavelength_um < 5.01; wavelength_um += 0.1) {
        axis_um.push_back(wavelength_um);
        radiance.push_back(scale * planckRadiance_W_m2_sr_um(wavelength_um, temperature_K));
    }
    return {"bb", 0.0, "", "", {{"BB", {axis_um, radiance, Spectrum::Outside::zero}}}};
}

TEST(Lint, FindsNothingInAGoodDatabase) {
    EXPECT_EQ(listOf(lint(completeDatabase())), "");
    EXPECT_EQ(listOf(lint(completeDatabase(), {4.0, 5.0})), "");
    EXPECT_EQ(listOf(lint(SignatureDatabase{})), "");
}

TEST(Lint, AcceptsTheLimitsOfWhatIsRight) {
    SignatureDatabase database;
    database.materials[1] = {"mirror", Spectrum::constant(0.0), Spectrum(), 0.0, ""};
    database.materials[2] = {"black", Spectrum::constant(1.0), Spectrum(), 50.0, ""};
    database.materials[3] = {"window", Spectrum::constant(0.0), Spectrum::constant(1.0), 0.0, ""};
    database.materials[4] = {"sum", Spectrum::constant(0.7), Spectrum::constant(0.3), 0.0, ""};
    database.materials[5] = {"tenths", {{1.0, 2.0}, {0.1, 0.9}}, {{1.0, 2.0}, {0.9, 0.1}}, 0.0, ""};
    for (const double temperature_K : {201.0, 300.0, 900.0, 3999.0}) {
        UserSpectrum spectrum = blackbody(temperature_K);
        spectrum.name = numberText(temperature_K);
        database.spectra[spectrum.name] = spectrum;
    }
    EXPECT_EQ(listOf(lint(database)), "");
}

struct Row {
    const char* name;
    std::function<void(SignatureDatabase&)> spoil;
    Severity severity;
    const char* place;
    const char* value;
    const char* reason;
};
void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

class Finds : public testing::TestWithParam<Row> {};

TEST_P(Finds, OneThingAndNothingElse) {
    SignatureDatabase database = completeDatabase();
    GetParam().spoil(database);
    const auto findings = lint(database);
    ASSERT_EQ(findings.size(), 1U) << listOf(findings);
    EXPECT_EQ(findings[0].severity, GetParam().severity);
    EXPECT_EQ(findings[0].place, GetParam().place);
    EXPECT_THAT(findings[0].value, testing::HasSubstr(GetParam().value));
    EXPECT_THAT(findings[0].reason + " " + findings[0].remedy,
                testing::HasSubstr(GetParam().reason));
}

TemperatureTerms& terms(SignatureDatabase& d) {
    return d.temperatures[-7].terms;
}
ComponentFactors& factors(SignatureDatabase& d) {
    return d.temperatures[2147483647].factors;
}
UserSpectrum& plume(SignatureDatabase& d) {
    return d.spectra["plume core"];
}
void scale(SignatureDatabase& d, double factor) {
    for (SpectrumComponent& component : plume(d).components) {
        if (component.name == "CO2(T4)") {
            component.radiance = component.radiance.mapped([&](double v) { return v * factor; });
        }
    }
}

constexpr Severity error = Severity::error;
constexpr Severity warning = Severity::warning;

const Row rows[] = {
    {"TitleInLatin1", [](auto& d) { d.title = "\xe9t\xe9"; }, error, "title", "not UTF-8", "UTF-8"},
    {"NotesInLatin1", [](auto& d) { d.materials[3].notes = "\xe9"; }, error, "materials.3.notes",
     "not UTF-8", "UTF-8"},
    {"EmissivityAboveOne", [](auto& d) { d.materials[0].emissivity = Spectrum::constant(1.01); },
     error, "materials.0.emissivity", "1.01", "0 to 1"},
    {"EmissivityNegativeAtANode",
     [](auto& d) {
         d.materials[0].emissivity = Spectrum({3, 4, 5}, {0.5, -0.2, -0.1});
     },
     error, "materials.0.emissivity at 4 um", "-0.2", "0 to 1"},
    {"TransmissivityAboveOne",
     [](auto& d) {
         d.materials[0].emissivity = Spectrum::constant(0.0);
         d.materials[0].transmissivity = Spectrum::constant(1.5);
     },
     error, "materials.0.transmissivity", "1.5", "0 to 1"},
    {"SumAboveOneBetweenTheNodesOfOne",
     [](auto& d) {
         d.materials[3].transmissivity = Spectrum({2, 4.9, 5}, {0.5, 0.5, 0.0});
     },
     error, "materials.3 at 4.9 um", "1.26", "at most 1"},
    {"SumAboveOneGrey", [](auto& d) { d.materials[0].transmissivity = Spectrum::constant(0.2); },
     error, "materials.0", "1.1", "at most 1"},
    {"SurfaceThatEndsAtZero",
     [](auto& d) {
         d.materials[0].emissivity = Spectrum({3, 5}, {0.5, 0.5}, Spectrum::Outside::zero);
     },
     error, "materials.0.emissivity", "zero outside", "holds"},
    {"NegativeN", [](auto& d) { d.materials[0].nAngleFactor = -0.25; }, error,
     "materials.0.nAngleFactor", "-0.25", "at least 0"},
    {"NNotANumber", [](auto& d) { d.materials[0].nAngleFactor = nan; }, error,
     "materials.0.nAngleFactor", "nan", "at least 0"},
    {"BaseNotANumber", [](auto& d) { terms(d).base_K = nan; }, error,
     "temperatures.-7.terms.base_K", "nan", "finite"},
    {"BelowAbsoluteZero", [](auto& d) { terms(d).base_K = -20.0; }, error, "temperatures.-7",
     "-20 K at rest", "above 0 K"},
    {"CelsiusForKelvin", [](auto& d) { terms(d).base_K = 27.0; }, warning, "temperatures.-7",
     "27 K at rest", "Celsius"},
    {"HotterThanAnyMetal", [](auto& d) { terms(d).base_K = 9000.0; }, warning, "temperatures.-7",
     "9000 K at rest", "4000"},
    {"TooHotAtFullPower",
     [](auto& d) {
         terms(d).power = LookupTable({0, 1}, {0, 5000});
     },
     warning, "temperatures.-7", "5300 K where the tables are highest", "at most 4000"},
    {"TooColdAtAltitude",
     [](auto& d) {
         terms(d).altitude = LookupTable({0, 11000}, {0, -250});
     },
     warning, "temperatures.-7", "50 K where the tables are lowest", "at least 100"},
    {"LoopOverPower",
     [](auto& d) {
         terms(d).power = LookupTable({0, 1}, {0, 5}, true);
     },
     error, "temperatures.-7.terms.power", "loop", "time alone"},
    {"LoopOverAltitude",
     [](auto& d) {
         terms(d).altitude = LookupTable({0, 1000}, {0, 5}, true);
     },
     error, "temperatures.-7.terms.altitude_m", "loop", "time alone"},
    {"LoopOverMach",
     [](auto& d) {
         terms(d).mach = LookupTable({0, 1}, {0, 5}, true);
     },
     error, "temperatures.-7.terms.mach", "loop", "time alone"},
    {"UnknownSpectrum", [](auto& d) { d.temperatures[2147483647].userSpectrum = "plume"; }, error,
     "temperatures.2147483647.userSpectrum", "'plume'", "user-defined spectrum"},
    {"UnknownComponent", [](auto& d) { factors(d)[0].component = "h2o"; }, error,
     "temperatures.2147483647.factors[0].component", "'h2o'", "'plume core'"},
    {"ComponentTwice", [](auto& d) { factors(d)[0].component = "CO2(T4)"; }, error,
     "temperatures.2147483647.factors[1].component", "second time", "one factor"},
    {"FactorNegative", [](auto& d) { factors(d)[0].constant = -0.1; }, error,
     "temperatures.2147483647.factors[0].constant", "-0.1", "at least 0"},
    {"FactorNotANumber", [](auto& d) { factors(d)[0].constant = nan; }, error,
     "temperatures.2147483647.factors[0].constant", "nan", "at least 0"},
    {"TimeFactorNegative",
     [](auto& d) {
         factors(d)[0].time = LookupTable({0, 1}, {1, -1});
     },
     error, "temperatures.2147483647.factors[0].time_s", "-1", "at least 0"},
    {"AngleBeyondHalfATurn",
     [](auto& d) {
         factors(d)[0].angle = LookupTable({0, 181}, {1, 1});
     },
     error, "temperatures.2147483647.factors[0].angle_deg", "0 to 181", "0 to 180"},
    {"AngleNegative",
     [](auto& d) {
         factors(d)[0].angle = LookupTable({-1, 180}, {1, 1});
     },
     error, "temperatures.2147483647.factors[0].angle_deg", "-1 to 180", "0 to 180"},
    {"LoopOverAngle",
     [](auto& d) {
         factors(d)[0].angle = LookupTable({0, 180}, {1, 1}, true);
     },
     error, "temperatures.2147483647.factors[0].angle_deg", "loop", "time alone"},
    {"SpectrumUnderAnotherName", [](auto& d) { plume(d).name = "core"; }, error,
     "spectra.plume core", "'core'", "filed under"},
    {"ReferenceDistanceNegative", [](auto& d) { plume(d).referenceDistance_m = -1.0; }, error,
     "spectra.plume core.referenceDistance_m", "-1", "at least 0 m"},
    {"ComponentWithoutName",
     [](auto& d) {
         factors(d).erase(factors(d).begin());
         plume(d).components[1].name = "";
     },
     error, "spectra.plume core.components", "''", "not empty"},
    {"ComponentOnAnAxisOfItsOwn",
     [](auto& d) {
         plume(d).components[1].radiance = Spectrum({3, 4}, {1, 1}, Spectrum::Outside::zero);
     },
     error, "spectra.plume core.H2O", "axis of its own", "share"},
    {"ComponentWithoutEnd",
     [](auto& d) { plume(d).components[1].radiance = Spectrum::constant(1.0); }, error,
     "spectra.plume core.H2O", "without end", "nodes"},
    {"RadianceTenThousandTimesTooSmall", [](auto& d) { scale(d, 1e-7); }, warning,
     "spectra.plume core.CO2(T4)", "K", "1e4 too small"},
    {"RadianceTenThousandTimesTooLarge", [](auto& d) { scale(d, 1e4); }, warning,
     "spectra.plume core.CO2(T4)", "K", "1e4 too large"},
    {"RadianceAbsurd", [](auto& d) { scale(d, 1e12); }, warning, "spectra.plume core.CO2(T4)", "K",
     "200 to 4000 K"},
    {"RadianceNegative",
     [](auto& d) {
         Spectrum& curve = plume(d).components[0].radiance;
         auto values = curve.values();
         values[3] = -0.5;
         curve = Spectrum(curve.wavelengths_um(), values, Spectrum::Outside::zero);
     },
     warning, "spectra.plume core.CO2(T4)", "-0.5", "at least 0"},
};

INSTANTIATE_TEST_SUITE_P(Lint, Finds, testing::ValuesIn(rows),
                         [](const auto& row) { return row.param.name; });

TEST(Lint, NamesTheSpectraThatDoNotCoverTheBand) {
    const auto findings = lint(completeDatabase(), {3.0, 5.2});
    ASSERT_EQ(findings.size(), 2U) << listOf(findings);
    EXPECT_EQ(findings[0].place, "materials.3.transmissivity");
    EXPECT_EQ(findings[0].value, "2 to 5 um");
    EXPECT_EQ(findings[1].place, "spectra.plume core");
    for (const Finding& finding : findings) {
        EXPECT_EQ(finding.severity, Severity::warning);
        EXPECT_THAT(finding.reason, testing::HasSubstr("3 to 5.2 um"));
    }
}

TEST(Lint, SuspectsTheUnitOfTheReportsTableOnlyWhenItIsTakenForWattsPerSquareMetre) {
    // 7.76e-5 per cm-1 at 1900 cm-1 is a black body of 586 K in W cm-2 and of 197 K in W m-2.
    for (const bool right : {true, false}) {
        UserSpectrum spectrum{"s", 0.0, "", "", {}};
        const double radiance = 7.76e-5 * 361.0 * (right ? 1e4 : 1.0);
        spectrum.components.push_back(
            {"BB(T1)", {{5.26, 5.27}, {radiance, radiance}, Spectrum::Outside::zero}});
        SignatureDatabase database;
        database.spectra["s"] = spectrum;
        EXPECT_EQ(lint(database).size(), right ? 0U : 1U) << listOf(lint(database));
    }
}

} // namespace
} // namespace irsg
