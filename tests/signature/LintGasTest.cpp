#include "irsg/signature/Lint.h"
#include "irsg/signature/SignatureFile.h"

#include "Support.h"

namespace irsg {
namespace {

using testing::HasSubstr;

SignatureDatabase plume() {
    SignatureDatabase database;
    database.temperatures[7].name = "plume";
    database.temperatures[7].terms.base_K = 700.0;
    Material& gas = database.materials[7];
    gas.name = "exhaust";
    gas.gasPressure_atm = 1.0;
    gas.gasCO2 = 0.033;
    gas.gasH2O = 0.034;
    gas.gasSoot_ppmv = 0.02;
    return database;
}

TEST(LintGas, FindsNothingInASoundOneWhichFilesKeep) {
    EXPECT_TRUE(lint(plume()).empty());
    EXPECT_TRUE(signatureFromJson(signatureToJson(plume())) == plume());
    EXPECT_THAT(signatureToJson(plume()), HasSubstr("\"version\": 7"));
    EXPECT_FALSE(plume().materials[7].isOpaque());
}

TEST(LintGas, NamesWhatIsWrongWithOne) {
    const auto wrong = [](auto change) {
        SignatureDatabase database = plume();
        change(database.materials[7]);
        return lint(database);
    };
    const auto full = wrong([](Material& gas) { gas.gasO2 = 0.95; });
    ASSERT_EQ(full.size(), 1U);
    EXPECT_TRUE(full[0].isError());
    EXPECT_THAT(full[0].value, HasSubstr("1.017"));
    const auto thin = wrong([](Material& gas) { gas.gasPressure_atm = 0.01; });
    ASSERT_EQ(thin.size(), 1U);
    EXPECT_TRUE(thin[0].isError());
    EXPECT_EQ(thin[0].place, "materials.7.gasPressure_atm");
    for (const auto& findings : {wrong([](Material& gas) { gas.gasPressure_atm = 11.0; }),
                                 wrong([](Material& gas) { gas.gasCO2 = -0.1; }),
                                 wrong([](Material& gas) { gas.gasSoot_ppmv = 2000.0; })}) {
        ASSERT_FALSE(findings.empty());
        EXPECT_TRUE(findings[0].isError());
    }
    const auto surface = wrong([](Material& gas) { gas.gasPressure_atm = 0.0; });
    ASSERT_EQ(surface.size(), 1U);
    EXPECT_FALSE(surface[0].isError());
    const auto nothing =
        wrong([](Material& gas) { gas.gasCO2 = gas.gasH2O = gas.gasSoot_ppmv = 0.0; });
    ASSERT_EQ(nothing.size(), 1U);
    EXPECT_FALSE(nothing[0].isError());
}

TEST(LintGas, NamesOneOfAMeasuredSpectrum) {
    SignatureDatabase database = plume();
    ModelUse use;
    use.name = "a.flt";
    use.temperatureFaces = {{7, 5}};
    use.materialFaces = {{7, 5}};
    use.temperaturesOfMaterial = {{7, {7}}};
    EXPECT_TRUE(lint(database, {.models = {use}}).empty());
    database.spectra["plume core"] = completeDatabase().spectra.at("plume core");
    database.temperatures[7].mode = EmissionMode::userSpectrum;
    database.temperatures[7].userSpectrum = "plume core";
    const auto findings = lint(database, {.models = {use}});
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_THAT(findings[0].value, HasSubstr("temperature index 7"));
}

} // namespace
} // namespace irsg
