#include "irsg/signature/Lint.h"

#include "Support.h"

namespace irsg {
namespace {

using testing::HasSubstr;

std::string listOf(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings) {
        text += finding.place + ": " + finding.value + ": " + finding.reason + "\n";
    }
    return text;
}

ModelUse everything() {
    ModelUse use;
    use.name = "a.flt";
    use.temperatureFaces = {{0, 5}, {-7, 1}, {2147483647, 9}};
    use.materialFaces = {{0, 5}, {3, 10}};
    return use;
}

TEST(LintScope, FindsNothingWhereModelAndDatabaseSuitEachOther) {
    EXPECT_EQ(listOf(lint(completeDatabase(), {.models = {everything()}})), "");
}

TEST(LintScope, NamesCodesWithoutAnEntryAndAddsOne) {
    ModelUse use = everything();
    use.temperatureFaces[12] = 32;
    use.materialFaces[13] = 1;
    const LintScope scope{.models = {use}};
    SignatureDatabase database = completeDatabase();
    const auto findings = lint(database, scope);
    ASSERT_EQ(findings.size(), 2U) << listOf(findings);
    EXPECT_TRUE(findings[0].isError());
    EXPECT_EQ(findings[0].place, "temperatures.12");
    EXPECT_EQ(findings[0].entry, "temperatures.12");
    EXPECT_THAT(findings[0].reason, HasSubstr("32 faces of a.flt"));
    EXPECT_EQ(findings[1].place, "materials.13");

    EXPECT_EQ(repairAll(database, scope).size(), 2U);
    EXPECT_EQ(listOf(lint(database, scope)), "");
    EXPECT_EQ(database.temperatures[12].name, "temperature 12");
    EXPECT_TRUE(database.materials[13].isOpaque());
}

TEST(LintScope, TakesAFallbackForAnEntry) {
    ModelUse use = everything();
    use.temperatureFaces[12] = 32;
    use.fallbackTemperature = 0;
    EXPECT_EQ(listOf(lint(completeDatabase(), {.models = {use}})), "");
    use.fallbackTemperature = 99; // not there either
    EXPECT_EQ(lint(completeDatabase(), {.models = {use}}).size(), 1U);
}

TEST(LintScope, NamesEntriesAndSpectraThatNothingUsesAndDeletesOnlyWhenAsked) {
    ModelUse use = everything();
    use.temperatureFaces = {{-7, 1}};
    use.materialFaces = {{0, 5}};
    SignatureDatabase database = completeDatabase();
    database.spectra["spare"] = database.spectra["plume core"];
    database.spectra["spare"].name = "spare";
    const LintScope scope{.models = {use}};
    const auto findings = lint(database, scope);
    ASSERT_EQ(findings.size(), 3U) << listOf(findings);
    EXPECT_EQ(findings[0].place, "temperatures.2147483647");
    EXPECT_EQ(findings[1].place, "materials.3");
    EXPECT_EQ(findings[2].place, "spectra.spare");
    EXPECT_TRUE(repairAll(database, scope).empty());
    for (const Finding& finding : findings) {
        EXPECT_FALSE(finding.isError());
        EXPECT_TRUE(finding.removes);
        finding.repair(database);
    }
    EXPECT_FALSE(database.temperatures.contains(2147483647));
    EXPECT_FALSE(database.materials.contains(3));
    EXPECT_FALSE(database.spectra.contains("spare"));
    EXPECT_TRUE(database.temperatures.contains(0)) << "the code of a face without one";
}

TEST(LintScope, SharesADatabaseBetweenModels) {
    ModelUse first = everything();
    first.temperatureFaces = {{-7, 1}, {0, 1}};
    ModelUse second = everything();
    second.name = "b.flt";
    second.temperatureFaces = {{2147483647, 1}};
    EXPECT_EQ(listOf(lint(completeDatabase(), {.models = {first, second}})), "");
}

TEST(LintScope, NamesLevelsOfDetail) {
    ModelUse use = everything();
    use.levelsOfDetail = {"2 range LODs are overridden: the highest detail is drawn"};
    const auto findings = lint(completeDatabase(), {.models = {use}});
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].entry, "model");
    EXPECT_EQ(findings[0].place, "model a.flt");
    EXPECT_THAT(findings[0].value, HasSubstr("2 range LODs"));
}

SweptState at(double power, double mach = 0.5, double ambient_K = 288.15) {
    EntityState state;
    state.power = power;
    state.mach = mach;
    state.ambient_K = ambient_K;
    return {"climb", state};
}

TEST(LintScope, NamesTheStateInWhichATemperatureIsNone) {
    SignatureDatabase database = completeDatabase();
    database.temperatures[0].terms.power = LookupTable({0, 1, 2}, {0, 40, 5000});
    database.temperatures[-7].terms = {900.0, -3.0, 0.0, 0.0, {}, {}, {}, {}};
    // At rest 35.55 K: only a warning there.
    const LintScope scope{.states = {at(0.0), at(1.5), at(2.0, 0.5, 320.0)}};
    std::string hot;
    std::string cold;
    for (const Finding& finding : lint(database, scope)) {
        if (finding.value.find("(climb)") == std::string::npos) {
            continue;
        }
        (finding.entry == "temperatures.0" ? hot : cold) +=
            finding.value + " " + finding.reason + (finding.isError() ? " error\n" : "\n");
    }
    EXPECT_THAT(hot, HasSubstr("power 2, Mach 0.5"));
    EXPECT_THAT(hot, HasSubstr("air of 320 K (climb)"));
    EXPECT_THAT(hot, HasSubstr("at most 4000 K"));
    EXPECT_THAT(cold, HasSubstr("-60 K at time 0 s, power 2"));
    EXPECT_THAT(cold, HasSubstr("above 0 K error"));
}

TEST(LintScope, CountsTheStatesInWhichATableHoldsItsEnd) {
    const LintScope scope{.states = {at(0.5), at(1.5), at(2.5), at(0.5, 0.95)}};
    const auto findings = lint(completeDatabase(), scope);
    ASSERT_EQ(findings.size(), 2U) << listOf(findings);
    EXPECT_EQ(findings[0].place, "temperatures.0.terms.mach");
    EXPECT_THAT(findings[0].value, HasSubstr("held in 1 of 4 states"));
    EXPECT_EQ(findings[1].place, "temperatures.0.terms.power");
    EXPECT_EQ(findings[1].entry, "temperatures.0");
    EXPECT_THAT(findings[1].value,
                HasSubstr("held in 2 of 4 states, first at time 0 s, power 1.5"));
}

TEST(LintScope, FindsNothingInStatesThatAreLikely) {
    EXPECT_EQ(listOf(lint(completeDatabase(), {.states = {at(0.0), at(1.0), at(0.5)}})), "");
}

} // namespace
} // namespace irsg
