#include "irsg/signature/CopyEntries.h"

#include "irsg/signature/Lint.h"

#include "Support.h"

namespace irsg {
namespace {

using OnConflict = CopyRequest::OnConflict;

CopyResult copied(SignatureDatabase& to, const CopyRequest& request) {
    return copyEntries(completeDatabase(), to, request, "from.sigdb", "to.sigdb");
}

TEST(CopyEntries, BringsTheSpectraThatTemperaturesName) {
    SignatureDatabase to;
    const CopyResult result =
        copied(to, {.temperatures = {2147483647, -7}, .materials = {3}, .spectra = {}});
    EXPECT_EQ(to.temperatures.size(), 2U);
    EXPECT_TRUE(to.materials.at(3) == completeDatabase().materials.at(3));
    EXPECT_TRUE(to.spectra.at("plume core") == completeDatabase().spectra.at("plume core"));
    EXPECT_EQ(result.spectra.at("plume core"), "plume core");
    EXPECT_TRUE(lint(to).empty());
}

TEST(CopyEntries, RefusesWhatIsTakenAndWhatIsNotThereAllAtOnce) {
    SignatureDatabase to;
    to.materials[3].name = "something else";
    to.spectra["plume core"].name = "plume core";
    const SignatureDatabase before = to;
    const auto diagnostics = refusalOf([&] {
        copied(to, {.temperatures = {2147483647, 5}, .materials = {3, 4}, .spectra = {"absent"}});
    });
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) {
        all += diagnostic.file + " " + diagnostic.position + "\n";
    }
    EXPECT_EQ(all, "from.sigdb spectra.absent\nto.sigdb spectra.plume core\n"
                   "from.sigdb temperatures.5\nto.sigdb materials.3\nfrom.sigdb materials.4\n");
    EXPECT_TRUE(to == before);
}

TEST(CopyEntries, RenumbersWhatIsTaken) {
    SignatureDatabase to;
    to.materials[3].name = "something else";
    to.materials[4].name = "and another";
    to.temperatures[-7].name = "taken";
    to.temperatures[-7].terms.base_K = 300.0;
    to.spectra["plume core"] = completeDatabase().spectra.at("plume core");
    to.spectra["plume core"].notes = "another one";
    const CopyResult result = copied(to, {.temperatures = {2147483647, -7},
                                          .materials = {3},
                                          .spectra = {},
                                          .onConflict = OnConflict::renumber});
    EXPECT_EQ(result.materials.at(3), 5);
    EXPECT_EQ(result.temperatures.at(-7), -6);
    EXPECT_EQ(result.spectra.at("plume core"), "plume core 2");
    EXPECT_EQ(to.temperatures.at(2147483647).userSpectrum, "plume core 2");
    EXPECT_EQ(to.spectra.at("plume core 2").name, "plume core 2");
    EXPECT_EQ(to.spectra.at("plume core").notes, "another one");
    EXPECT_TRUE(lint(to).empty());
}

TEST(CopyEntries, LeavesWhatIsEqualAlreadyWhereItIs) {
    SignatureDatabase to = completeDatabase();
    const CopyResult result = copied(to, {.temperatures = {2147483647},
                                          .materials = {3},
                                          .spectra = {"plume core"},
                                          .onConflict = OnConflict::renumber});
    EXPECT_TRUE(to == completeDatabase());
    EXPECT_EQ(result.materials.at(3), 3);
    copied(to,
           {.temperatures = {0}, .materials = {}, .spectra = {}, .onConflict = OnConflict::refuse});
    EXPECT_TRUE(to == completeDatabase());
}

TEST(CopyEntries, ReplacesWhereItIsAskedTo) {
    SignatureDatabase to;
    to.materials[3].name = "something else";
    copied(
        to,
        {.temperatures = {}, .materials = {3}, .spectra = {}, .onConflict = OnConflict::replace});
    EXPECT_EQ(to.materials.at(3).name, "glass");
}

} // namespace
} // namespace irsg
