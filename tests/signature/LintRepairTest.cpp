#include <functional>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/LintUnits.h"

#include "Support.h"

namespace irsg {
namespace {

using testing::HasSubstr;

std::string listOf(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        text += finding.place + ": " + finding.value + ": " + finding.reason + "; " +
                finding.remedy + "\n";
    }
    return text;
}

using Spoil = std::function<void(SignatureDatabase&)>;

/// Something that is wrong, and what the database is once the repair has been applied.
struct Row {
    const char* name;
    Spoil spoil;
    const char* place;
    const char* repair;
    Spoil repaired; ///< done to the good database; what else the repair writes is compared apart
};
void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
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
Material& glass(SignatureDatabase& d) {
    return d.materials[3];
}

Spectrum withAxis(const Spectrum& spectrum, const std::function<double(double)>& f,
                  Spectrum::Outside outside) {
    std::vector<double> axis = spectrum.wavelengths_um();
    std::vector<double> values = spectrum.values();
    for (double& position : axis) {
        position = f(position);
    }
    if (axis.back() < axis.front()) {
        std::ranges::reverse(axis);
        std::ranges::reverse(values);
    }
    return {axis, values, outside};
}

/// The node values of the plume in another unit, its axis alone read otherwise.
void misreadAxis(SignatureDatabase& d, const std::function<double(double)>& f) {
    for (SpectrumComponent& component : plume(d).components) {
        // The importer took cell (0,0) for um and made densities per um of those per cm-1.
        std::vector<double> axis = component.radiance.wavelengths_um();
        std::vector<double> values = component.radiance.values();
        for (std::size_t i = 0; i < axis.size(); ++i) {
            const double right_um = axis[i];
            axis[i] = f(right_um);
            values[i] *= right_um * right_um / (axis[i] * axis[i]);
        }
        if (axis.back() < axis.front()) {
            std::ranges::reverse(axis);
            std::ranges::reverse(values);
        }
        component.radiance = Spectrum(axis, values, Spectrum::Outside::zero);
    }
}

void nothing(SignatureDatabase&) {}

const Row rows[] = {
    {"EmissivityInPercent", [](auto& d) { d.materials[0].emissivity = Spectrum::constant(90.0); },
     "materials.0.emissivity", "percent", nothing},
    {"SpectralEmissivityInPercent",
     [](auto& d) {
         glass(d).emissivity = glass(d).emissivity.mapped([](double v) { return 100.0 * v; });
     },
     "materials.3.emissivity at 5 um", "percent", nothing},
    {"NoiseAboveOne", [](auto& d) { d.materials[0].emissivity = Spectrum::constant(1.004); },
     "materials.0.emissivity", "Cut off",
     [](auto& d) { d.materials[0].emissivity = Spectrum::constant(1.0); }},
    {"SumAboveOne", [](auto& d) { d.materials[0].transmissivity = Spectrum::constant(0.3); },
     "materials.0", "lower the transmissivity",
     [](auto& d) { d.materials[0].transmissivity = Spectrum::constant(1.0 - 0.9); }},
    {"SurfaceThatEndsAtZero",
     [](auto& d) {
         glass(d).emissivity = withAxis(
             glass(d).emissivity, [](double x) { return x; }, Spectrum::Outside::zero);
     },
     "materials.3.emissivity", "hold the end values", nothing},
    {"MaterialInMetres",
     [](auto& d) {
         glass(d).emissivity = withAxis(
             glass(d).emissivity, [](double x) { return x * 1e-6; }, Spectrum::Outside::hold);
     },
     "materials.3.emissivity", "m taken for um", nothing},
    {"CelsiusForKelvin", [](auto& d) { terms(d).base_K = 300.0 - 273.15; }, "temperatures.-7",
     "Celsius", nothing},
    {"CelsiusBelowZero", [](auto& d) { terms(d).base_K = 260.0 - 273.15; }, "temperatures.-7",
     "Celsius", [](auto& d) { terms(d).base_K = 260.0; }},
    {"RecoveryInPercent", [](auto& d) { terms(d).recoveryFactor = 89.0; },
     "temperatures.-7.terms.recoveryFactor", "percent",
     [](auto& d) { terms(d).recoveryFactor = 0.89; }},
    {"AltitudeInKilometres",
     [](auto& d) {
         d.temperatures[0].terms.altitude = LookupTable({0, 11}, {0, -1});
     },
     "temperatures.0.terms.altitude_m", "km taken for m", nothing},
    {"MachInMetresPerSecond",
     [](auto& d) {
         terms(d).mach = LookupTable({0, 340.3}, {0, 3});
     },
     "temperatures.-7.terms.mach", "m/s taken for Mach",
     [](auto& d) {
         terms(d).mach = LookupTable({0, 1}, {0, 3});
     }},
    {"LoopOverPower",
     [](auto& d) {
         d.temperatures[0].terms.power = LookupTable({0, 1}, {0, 40}, true);
     },
     "temperatures.0.terms.power", "switch the loop mode off", nothing},
    {"LoopThatJumps",
     [](auto& d) {
         d.temperatures[0].terms.time = LookupTable({0, 10}, {0, 1.0 / 7.0}, true);
     },
     "temperatures.0.terms.time_s", "add a last node", nothing},
    {"AngleInRadians",
     [](auto& d) {
         factors(d)[0].angle = LookupTable({0, pi / 2, pi}, {1, 0.5, 0.25});
     },
     "temperatures.2147483647.factors[0].angle_deg", "radians", nothing},
    {"AngleOfAFullTurn",
     [](auto& d) {
         factors(d)[0].angle = LookupTable({0, 90, 180, 270, 360}, {1, 0.5, 0.25, 0.5, 1});
     },
     "temperatures.2147483647.factors[0].angle_deg", "keep the half", nothing},
    {"TimeFactorNegative",
     [](auto& d) {
         factors(d)[0].time = LookupTable({0, 1}, {1, -0.1});
     },
     "temperatures.2147483647.factors[0].time_s", "set what is negative to 0",
     [](auto& d) {
         factors(d)[0].time = LookupTable({0, 1}, {1, 0});
     }},
    {"ComponentInAnotherCase", [](auto& d) { factors(d)[0].component = "h2o"; },
     "temperatures.2147483647.factors[0].component", "take 'H2O'", nothing},
    {"SpectrumInAnotherCase",
     [](auto& d) { d.temperatures[2147483647].userSpectrum = "Plume_Core"; },
     "temperatures.2147483647.userSpectrum", "take 'plume core'", nothing},
    {"SpectrumUnderAnotherName", [](auto& d) { plume(d).name = "core"; }, "spectra.plume core",
     "name it 'plume core'", nothing},
    {"SpectrumOverWavenumbersCalledUm",
     [](auto& d) { misreadAxis(d, [](double x) { return 1e4 / x; }); }, "spectra.plume core",
     "cm-1", nothing},
    {"SpectrumOverNanometresCalledUm",
     [](auto& d) { misreadAxis(d, [](double x) { return 1e3 * x; }); }, "spectra.plume core",
     "nm taken for um", nothing},
    {"NoiseBelowZero",
     [](auto& d) {
         Spectrum& curve = plume(d).components[0].radiance;
         auto values = curve.values();
         values[3] = -0.5;
         curve = Spectrum(curve.wavelengths_um(), values, Spectrum::Outside::zero);
     },
     "spectra.plume core.CO2(T4)", "Set what is negative to 0",
     [](auto& d) {
         Spectrum& curve = plume(d).components[0].radiance;
         auto values = curve.values();
         values[3] = 0.0;
         curve = Spectrum(curve.wavelengths_um(), values, Spectrum::Outside::zero);
     }},
};

class Repairs : public testing::TestWithParam<Row> {};

/// Equal but for rounding: repairs multiply back what was divided.
void expectAlike(const Spectrum& a, const Spectrum& b) {
    ASSERT_EQ(a.size(), b.size());
    ASSERT_EQ(a.isConstant(), b.isConstant());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a.values()[i], b.values()[i], 1e-12 * std::abs(b.values()[i]) + 1e-15);
        if (!a.isConstant()) {
            EXPECT_NEAR(a.wavelengths_um()[i], b.wavelengths_um()[i],
                        1e-12 * b.wavelengths_um()[i]);
        }
    }
}

void expectAlike(const LookupTable& a, const LookupTable& b) {
    ASSERT_EQ(a.x().size(), b.x().size());
    EXPECT_EQ(a.loop(), b.loop());
    for (std::size_t i = 0; i < a.x().size(); ++i) {
        EXPECT_NEAR(a.x()[i], b.x()[i], 1e-9);
        EXPECT_NEAR(a.y()[i], b.y()[i], 1e-9);
    }
}

void expectAlike(const SignatureDatabase& a, const SignatureDatabase& b) {
    for (const auto& [index, material] : b.materials) {
        expectAlike(a.materials.at(index).emissivity, material.emissivity);
        expectAlike(a.materials.at(index).transmissivity, material.transmissivity);
    }
    for (const auto& [index, entry] : b.temperatures) {
        const TemperatureEntry& found = a.temperatures.at(index);
        EXPECT_NEAR(found.terms.base_K, entry.terms.base_K, 1e-9);
        EXPECT_NEAR(found.terms.recoveryFactor, entry.terms.recoveryFactor, 1e-12);
        EXPECT_EQ(found.userSpectrum, entry.userSpectrum);
        expectAlike(found.terms.power, entry.terms.power);
        expectAlike(found.terms.altitude, entry.terms.altitude);
        expectAlike(found.terms.mach, entry.terms.mach);
        ASSERT_EQ(found.factors.size(), entry.factors.size());
        for (std::size_t i = 0; i < entry.factors.size(); ++i) {
            EXPECT_EQ(found.factors[i].component, entry.factors[i].component);
            expectAlike(found.factors[i].time, entry.factors[i].time);
            expectAlike(found.factors[i].angle, entry.factors[i].angle);
        }
    }
    for (const auto& [name, spectrum] : b.spectra) {
        EXPECT_EQ(a.spectra.at(name).name, spectrum.name);
        for (std::size_t i = 0; i < spectrum.components.size(); ++i) {
            expectAlike(a.spectra.at(name).components[i].radiance, spectrum.components[i].radiance);
        }
    }
}

TEST_P(Repairs, RepairWhatTheyAreAbout) {
    const LintScope scope{.bands = {{4.0, 5.0}}};
    SignatureDatabase database = completeDatabase();
    GetParam().spoil(database);
    const SignatureDatabase spoilt = database;
    const auto findings = lint(database, scope);
    ASSERT_GE(findings.size(), 1U);
    EXPECT_EQ(findings[0].place, GetParam().place) << listOf(findings);
    EXPECT_THAT(findings[0].remedy, HasSubstr(GetParam().repair)) << listOf(findings);
    ASSERT_TRUE(findings[0].repair) << listOf(findings);
    EXPECT_TRUE(findings[0].place.starts_with(findings[0].entry));

    const auto repaired = repairAll(database, scope);
    EXPECT_GE(repaired.size(), 1U);
    EXPECT_EQ(listOf(lint(database, scope)), "");
    if (std::string(GetParam().name) != "LoopThatJumps") {
        SignatureDatabase expected = completeDatabase();
        GetParam().repaired(expected);
        expectAlike(database, expected);
    }

    // A repair whose entry is gone changes nothing.
    SignatureDatabase empty;
    findings[0].repair(empty);
    EXPECT_TRUE(empty == SignatureDatabase{});
    EXPECT_FALSE(database == spoilt);
}

INSTANTIATE_TEST_SUITE_P(Lint, Repairs, testing::ValuesIn(rows),
                         [](const auto& row) { return row.param.name; });

TEST(LintRepair, LeavesChoicesAndDeletionsToAPerson) {
    SignatureDatabase database = completeDatabase();
    database.materials[0].emissivity = Spectrum::constant(1.3);
    factors(database).push_back(factors(database)[0]);
    const SignatureDatabase before = database;
    EXPECT_TRUE(repairAll(database).empty());
    EXPECT_TRUE(database == before);
    const auto findings = lint(database);
    ASSERT_EQ(findings.size(), 2U) << listOf(findings);
    EXPECT_FALSE(findings[0].repair);
    EXPECT_TRUE(findings[1].removes);
    findings[1].repair(database);
    EXPECT_EQ(lint(database).size(), 1U);
}

TEST(LintRepair, TellsNanometresFromWavenumbersByTheBandAndElseNamesBoth) {
    // 2500 to 3300: nm of the near infrared, or cm-1 of 3 to 4 um.
    SignatureDatabase database = completeDatabase();
    database.materials[0].emissivity = Spectrum({2500, 3300}, {0.9, 0.8});
    const auto open = lint(database);
    ASSERT_EQ(open.size(), 1U) << listOf(open);
    EXPECT_THAT(open[0].remedy, HasSubstr("cm-1 or nm"));
    EXPECT_FALSE(open[0].repair);

    SignatureDatabase asWavenumbers = database;
    repairAll(asWavenumbers, {.bands = {{3.4, 4.1}}});
    EXPECT_NEAR(asWavenumbers.materials[0].emissivity.wavelengths_um().back(), 4.0, 1e-12);
    EXPECT_NEAR(asWavenumbers.materials[0].emissivity.values().back(), 0.9, 1e-12);
    SignatureDatabase asNanometres = database;
    repairAll(asNanometres, {.bands = {{2.0, 2.8}}});
    EXPECT_NEAR(asNanometres.materials[0].emissivity.wavelengths_um().back(), 3.3, 1e-12);
}

/// A grey body's curve with three digits, as a report prints it.
UserSpectrum greyBody(double temperature_K, double emissivity,
                      const std::function<double(double)>& factor) {
    std::vector<double> axis_um;
    std::vector<double> values;
    for (int i = 0; i <= 20; ++i) {
        axis_um.push_back(3.0 + 0.1 * i);
        char text[32];
        std::snprintf(text, sizeof text, "%.2e",
                      emissivity * planckRadiance_W_m2_sr_um(axis_um.back(), temperature_K) *
                          factor(axis_um.back()));
        values.push_back(std::stod(text));
    }
    return {"bb", 0.0, "", "", {{"BB(T1)", {axis_um, values, Spectrum::Outside::zero}}}};
}

TEST(LintRepair, FitsGreyBodies) {
    for (const double temperature_K : {250.0, 600.0, 3000.0}) {
        std::vector<double> axis_um;
        std::vector<double> values;
        for (int i = 0; i < 30; ++i) {
            axis_um.push_back(2.0 + 0.4 * i);
            values.push_back(0.3 * planckRadiance_W_m2_sr_um(axis_um.back(), temperature_K));
        }
        const auto body = fitGreyBody(axis_um, values);
        ASSERT_TRUE(body);
        EXPECT_NEAR(body->temperature_K, temperature_K, 1e-5 * temperature_K);
        EXPECT_NEAR(body->emissivity, 0.3, 1e-5);
        EXPECT_LT(body->misfit, 1e-6);
    }
    EXPECT_FALSE(fitGreyBody({1, 2, 3, 4}, {1, 1, 1, 1}));
    EXPECT_FALSE(fitGreyBody({1, 2, 3, 4, 5}, {1, 1, 0, 1, 1}));
}

TEST(LintRepair, KnowsADensityPerWavenumberByTheShapeOfAGreyBody) {
    for (const double temperature_K : {450.0, 600.0, 1200.0}) {
        SignatureDatabase database;
        database.spectra["bb"] = greyBody(temperature_K, 0.8, [](double) { return 1.0; });
        EXPECT_EQ(listOf(lint(database)), "") << temperature_K;

        // Per cm-1 and never converted; and converted though it was per um already.
        for (const bool forgotten : {true, false}) {
            database.spectra["bb"] = greyBody(temperature_K, 0.8, [&](double x) {
                return forgotten ? x * x / 1e4 : 1e4 / (x * x);
            });
            const auto findings = lint(database);
            ASSERT_EQ(findings.size(), 1U) << temperature_K << forgotten;
            EXPECT_THAT(findings[0].remedy, HasSubstr(forgotten ? "per cm-1 read as one per um"
                                                                : "per um read as one per cm-1"));
            ASSERT_TRUE(findings[0].repair);
        }
    }
}

TEST(LintRepair, MultipliesTheUnitThatIsSuspectedAndSaysSoInTheNotes) {
    for (const double factor : {1e-4, 1e4}) {
        SignatureDatabase database;
        database.spectra["bb"] = greyBody(600.0, 1.0, [&](double) { return factor; });
        const auto repaired = repairAll(database);
        ASSERT_EQ(repaired.size(), 1U);
        EXPECT_EQ(listOf(lint(database)), "");
        EXPECT_NEAR(database.spectra["bb"].components[0].radiance.at(4.0),
                    planckRadiance_W_m2_sr_um(4.0, 600.0),
                    0.01 * planckRadiance_W_m2_sr_um(4.0, 600.0));
        EXPECT_THAT(database.spectra["bb"].notes, HasSubstr("repaired by lint"));
    }
}

} // namespace
} // namespace irsg
