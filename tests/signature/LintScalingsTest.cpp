#include "irsg/signature/LintScalings.h"

#include "Support.h"

namespace irsg {
namespace {

using testing::HasSubstr;

const std::string temperatureScales = "ship(temperaturesScalings).xml";
const std::string emissivityScales = "ship(emissivitiesScalings).xml";

/// A skin at 300 K that is painted, glass, and a plume, with a scaling file of each kind.
class LintScalings : public testing::Test {
  protected:
    LintScalings() {
        database.temperatures[1] = {"skin", {}, {300.0, 0, 0, 0, {}, {}, {}, {}}, "", {}, ""};
        database.spectra["plume core"] = completeDatabase().spectra.at("plume core");
        database.temperatures[4] = {"plume", EmissionMode::userSpectrum, {}, "plume core", {}, ""};
        database.materials[1] = {"paint", Spectrum::constant(0.8), Spectrum(), 0.0, ""};
        database.materials[2] = {"glass",
                                 {{3.0, 4.0, 5.0}, {0.2, 0.5, 0.3}},
                                 {{3.0, 4.0, 5.0}, {0.7, 0.1, 0.6}},
                                 0.0,
                                 ""};
        use.name = "ship.flt";
        use.temperatureFaces = {{1, 10}, {4, 2}};
        use.materialFaces = {{1, 8}, {2, 4}};
        scalings = ScalingUse{temperatureScales, emissivityScales, {}, {}};
    }
    void heat(int index, double min, double max,
              DistributionKind kind = DistributionKind::uniform) {
        scalings.scalings.temperatures[index] = {Distribution(kind, min, max), ""};
    }
    void paint(int index, double min, double max) {
        scalings.scalings.emissivities[index] = {Distribution(DistributionKind::uniform, min, max),
                                                 ""};
    }
    std::vector<Finding> findings() const { return lintScalings(database, use, scalings); }
    /// The one finding there is; its scaling file is the place.
    Finding only(const std::string& place) const {
        const auto all = findings();
        EXPECT_EQ(all.size(), 1U);
        if (all.empty()) {
            return {};
        }
        EXPECT_EQ(all.front().place, place);
        EXPECT_FALSE(all.front().value.empty());
        EXPECT_FALSE(all.front().remedy.empty());
        return all.front();
    }

    SignatureDatabase database;
    ModelUse use;
    ScalingUse scalings;
};

TEST_F(LintScalings, HaveNothingAgainstScalesThatSuitTheDatabase) {
    heat(1, 0.95, 1.05, DistributionKind::normal);
    paint(1, 0.9, 1.25); // 0.8 times 1.25 is 1
    paint(2, 0.5, 1.33); // 0.3 of the 0.4 that transmissivity leaves at 5 um
    EXPECT_TRUE(findings().empty());
    heat(4, 1.0, 1.0); // what a save writes for every entry
    paint(77, 1.0, 1.0);
    EXPECT_TRUE(findings().empty());
}

TEST_F(LintScalings, NameAnEmissivityThatLeavesOne) {
    paint(1, 0.9, 1.3);
    Finding found = only(emissivityScales + " 1");
    EXPECT_EQ(found.entry, "materials.1");
    EXPECT_EQ(found.value, "emissivity 0.8, times 1.3: 1.04");
    EXPECT_THAT(found.reason, HasSubstr("at most 1"));
    EXPECT_EQ(found.remedy, "max of at most 1.25");
    EXPECT_FALSE(found.isError());

    scalings.scalings.emissivities.clear();
    paint(2, 0.5, 1.5);
    found = only(emissivityScales + " 2");
    EXPECT_THAT(found.value, HasSubstr("0.3 at 5 um, times 1.5: 0.45"));
    EXPECT_THAT(found.reason, HasSubstr("at most 0.4, one less transmissivity"));
    EXPECT_THAT(found.remedy, HasSubstr("1.3333"));

    // Nodes of the transmissivity alone count, too.
    scalings.scalings.emissivities.clear();
    database.materials[2].emissivity = Spectrum::constant(0.25);
    paint(2, 0.5, 1.25);
    found = only(emissivityScales + " 2");
    EXPECT_THAT(found.value, HasSubstr("0.25 at 3 um, times 1.25: 0.3125"));
    database.materials[2].emissivity = Spectrum{{3.0, 4.0, 5.0}, {0.2, 0.5, 0.3}};
    scalings.scalings.emissivities.clear();
    paint(2, 0.5, 1.5);

    use.temperaturesOfMaterial[2] = {4};
    EXPECT_TRUE(findings().empty()) << "a user-defined spectrum is multiplied as it is";
    use.temperaturesOfMaterial[2] = {1, 4};
    EXPECT_EQ(findings().size(), 1U);

    scalings.scalings.emissivities.clear();
    paint(1, 90.0, 110.0);
    EXPECT_EQ(only(emissivityScales + " 1").remedy, "divide min and max by 100");
}

TEST_F(LintScalings, NameATemperatureThatNoSurfaceHas) {
    heat(1, 0.1, 1.1);
    Finding found = only(temperatureScales + " 1");
    EXPECT_EQ(found.value, "300 K at rest, times 0.1: 30 K");
    EXPECT_THAT(found.reason, HasSubstr("100 to 4000 K"));
    EXPECT_THAT(found.remedy, HasSubstr("min of at least 0.333"));
    heat(1, 0.9, 14.0);
    EXPECT_THAT(only(temperatureScales + " 1").value, HasSubstr("4200 K"));
    heat(1, 95.0, 105.0);
    EXPECT_EQ(only(temperatureScales + " 1").remedy, "divide min and max by 100");
    heat(1, 20.0, 20.0);
    EXPECT_THAT(only(temperatureScales + " 1").value, HasSubstr("6000 K")) << "fixed, but not at 1";
    // What the terms alone make impossible is theirs, and told once.
    database.temperatures[1].terms.base_K = 30.0;
    heat(1, 0.9, 1.1);
    EXPECT_TRUE(findings().empty());
}

TEST_F(LintScalings, NameScalesThatHaveNoEffect) {
    heat(9, 0.9, 1.1);
    EXPECT_THAT(only(temperatureScales + " 9").reason, HasSubstr("that the database has"));
    scalings.scalings.temperatures.clear();
    heat(4, 0.9, 1.1);
    EXPECT_THAT(only(temperatureScales + " 4").reason, HasSubstr("user-defined spectrum"));
    scalings.scalings.temperatures.clear();
    database.materials[5] = database.materials[1];
    use.materialFaces[5] = 1;
    paint(5, 0.9, 1.1);
    EXPECT_TRUE(findings().empty());
    use.materialFaces.erase(5);
    use.fallbackMaterial = 5;
    EXPECT_TRUE(findings().empty()) << "the fallback stands in";
    use.fallbackMaterial.reset();
    EXPECT_THAT(only(emissivityScales + " 5").reason, HasSubstr("on faces of ship.flt"));
}

TEST_F(LintScalings, NameDistributionsThatDoNotFillTheirEnds) {
    // Exponential of mean 0.0001: nine draws in ten lie within 0.3 % of the width.
    scalings.scalings.temperatures[1] = {
        Distribution(DistributionKind::exponential, 0.9, 1.1, {0.9, 0.0001}), ""};
    const Finding found = only(temperatureScales + " 1");
    EXPECT_THAT(found.value, HasSubstr("nine draws in ten from 0.9"));
    EXPECT_THAT(found.reason, HasSubstr("exponential does not reach all of it"));
    for (const DistributionInfo& info : distributionTable()) {
        heat(1, info.kind == DistributionKind::poisson ? 0.1 : 0.9,
             info.kind == DistributionKind::poisson ? 4.0 : 1.1, info.kind);
        if (info.kind == DistributionKind::poisson) {
            database.temperatures[1].terms.base_K = 1000.0;
        }
        for (const Finding& one : findings()) {
            ADD_FAILURE() << info.name << ": " << one.value << " " << one.reason;
        }
    }
}

TEST_F(LintScalings, NameEveryDiagnosticOfAFileThatCannotBeRead) {
    const TemporaryFolder folder;
    const auto file = [&](const std::string& parameters) {
        writeBytes(folder / temperatureScales,
                   "<?xml version=\"1.0\"?>\n<data>\n<fileType>Parameters</fileType>\n" +
                       parameters + "</data>\n");
        return scalingUseOf(folder / "ship.flt");
    };
    const auto scale = [](const char* numbers) {
        return std::string("<parameter name=\"1\"><vector3>") + numbers +
               "</vector3></parameter>\n";
    };
    struct Case {
        const char* numbers;
        const char* value;
    };
    for (const auto& [numbers, value] :
         {Case{"<double>1.1</double><double>0.9</double><double>0</double>", "min 1.1"},
          Case{"<double>-1</double><double>1</double><double>0</double>", "min -1"},
          Case{"<double>0.9</double><double>1.1</double><double>17</double>", "distribution 17"},
          Case{"<double>0.9</double><double>1.1</double><double>1.5</double>", "distribution 1.5"},
          Case{"<double>1.2</double><double>1.8</double><double>14</double>", "whole number"},
          Case{"<double>1e200</double><double>1e201</double><double>0</double>", "1e+200"}}) {
        scalings = file(scale(numbers));
        const auto all = findings();
        ASSERT_FALSE(all.empty()) << numbers;
        EXPECT_TRUE(all.front().isError()) << numbers;
        EXPECT_THAT(all.front().place, HasSubstr(temperatureScales + ", line")) << numbers;
        EXPECT_THAT(all.front().value + all.front().reason, HasSubstr(value)) << numbers;
        EXPECT_FALSE(all.front().remedy.empty());
    }
    // Shape parameters that the distribution does not have, in number or value.
    for (const char* numbers :
         {"0.9 1.1 1 1 -0.1", "0.9 1.1 1 1", "0.9 1.1 12 0.9 0.2 -1 2", "0.9 1.1 7 1 0.1 3 0"}) {
        std::string vector = "<parameter name=\"1\"><vector>";
        std::istringstream stream(numbers);
        for (std::string number; stream >> number;) {
            vector += "<double>" + number + "</double>";
        }
        scalings = file(vector + "</vector></parameter>\n");
        ASSERT_EQ(findings().size(), 1U) << numbers;
        EXPECT_TRUE(findings().front().isError()) << numbers;
    }
    writeBytes(folder / temperatureScales, "<data>");
    scalings = scalingUseOf(folder / "ship.flt");
    EXPECT_TRUE(findings().front().isError());
}

TEST_F(LintScalings, AreReadBesideTheModelWhereTheyAre) {
    const TemporaryFolder folder;
    ScalingUse none = scalingUseOf(folder / "ship.flt");
    EXPECT_TRUE(none.scalings.empty());
    EXPECT_TRUE(none.diagnostics.empty());
    createScalingFiles(folder / "ship.flt", database);
    const ScalingUse made = scalingUseOf(folder / "ship.flt");
    EXPECT_EQ(made.temperatureFile, temperatureScales);
    EXPECT_EQ(made.scalings.emissivities.size(), 2U);
    scalings = made;
    EXPECT_TRUE(findings().empty());
}

TEST(LintScalingsOfSamples, CanBeRead) {
    const std::filesystem::path samples = std::filesystem::path(SMAT_SOURCE_DIR) / "samples";
    int files = 0;
    for (const auto& folder : std::filesystem::directory_iterator(samples)) {
        const auto model = folder.path() / (folder.path().filename().string() + ".flt");
        const ScalingUse scalings = scalingUseOf(model);
        EXPECT_TRUE(scalings.diagnostics.empty()) << model;
        files += hasScalingFiles(model);
    }
    EXPECT_GT(files, 0);
}

} // namespace
} // namespace irsg
