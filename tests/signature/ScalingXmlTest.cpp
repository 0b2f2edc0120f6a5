#include "irsg/signature/ScalingXml.h"

#include "irsg/core/Errors.h"
#include "tests/signature/Support.h"
#include "tests/support/SharedMaterial.h"

namespace irsg {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::string fileOf(const std::string& parameters) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<data>\n<fileType>Parameters</fileType>\n" +
           parameters + "</data>\n";
}

std::string scale(const std::string& index, const std::string& numbers,
                  const std::string& element = "vector3") {
    std::string text = "<parameter name=\"" + index + "\"><" + element + ">";
    std::istringstream stream(numbers);
    for (std::string number; stream >> number;) {
        text += "<double>" + number + "</double>";
    }
    return text + "</" + element + "><documentation>d" + index + "</documentation></parameter>\n";
}

ScalingTable read(const std::string& parameters, ScalingKind kind = ScalingKind::temperature) {
    const TemporaryFolder folder;
    return readScalingFile(writeBytes(folder / "scales.xml", fileOf(parameters)), kind);
}

SignatureDatabase small() {
    SignatureDatabase database;
    database.temperatures[1].name = "skin";
    database.temperatures[4].name = "plume <core> & \"mist\"";
    database.temperatures[4].mode = EmissionMode::userSpectrum;
    database.materials[3].name = "paint";
    return database;
}

} // namespace

TEST(ScalingXml, ReadsTheFilesThatBelongToTheReport) {
    const std::filesystem::path folder = smat::test::sharedMaterial("data/karma");
    if (folder.empty()) {
        GTEST_SKIP() << "the sample files of the report are not on this machine";
    }
    const Scalings scalings = loadScalings(folder / "turboprop4.flt");
    ASSERT_THAT(scalings.temperatures, ElementsAre(Pair(1, testing::_), Pair(5, testing::_)));
    EXPECT_EQ(scalings.temperatures.at(1).distribution,
              Distribution(DistributionKind::normal, 0.99, 1.01));
    EXPECT_EQ(scalings.temperatures.at(5).distribution,
              Distribution(DistributionKind::logNormal, 0.95, 1.08));
    EXPECT_EQ(scalings.temperatures.at(5).documentation, "exhaust: log-normal");
    ASSERT_THAT(scalings.emissivities, ElementsAre(Pair(1, testing::_), Pair(3, testing::_)));
    EXPECT_TRUE(scalings.emissivities.at(3).distribution.isFixed());
}

TEST(ScalingXml, NamesTheFilesAfterTheModel) {
    EXPECT_EQ(scalingFile("a/ship.v2.flt", ScalingKind::temperature),
              "a/ship.v2(temperaturesScalings).xml");
    EXPECT_EQ(scalingFile("ship.osgb", ScalingKind::emissivity), "ship(emissivitiesScalings).xml");
}

TEST(ScalingXml, WritesBothFilesOnceAndNeverTouchesOneThatIsThere) {
    const TemporaryFolder folder;
    const std::filesystem::path model = folder / "ship.flt";
    EXPECT_FALSE(hasScalingFiles(model));
    const std::string mine = fileOf(scale("1", "0.9 1.1 0"));
    const std::filesystem::path kept =
        writeBytes(scalingFile(model, ScalingKind::temperature), mine);
    EXPECT_THAT(createScalingFiles(model, small()),
                ElementsAre(scalingFile(model, ScalingKind::emissivity)));
    EXPECT_EQ(readBytes(kept), mine);
    EXPECT_TRUE(hasScalingFiles(model));
    EXPECT_TRUE(createScalingFiles(model, small()).empty());

    // With every entry at 1, which scales nothing, and its name behind it.
    std::filesystem::remove(kept);
    createScalingFiles(model, small());
    const Scalings scalings = loadScalings(model);
    ASSERT_THAT(scalings.temperatures, ElementsAre(Pair(1, testing::_), Pair(4, testing::_)));
    ASSERT_THAT(scalings.emissivities, ElementsAre(Pair(3, testing::_)));
    EXPECT_EQ(scalings.temperatures.at(1).distribution, Distribution());
    EXPECT_EQ(scalings.temperatures.at(1).documentation, "skin");
    EXPECT_THAT(scalings.temperatures.at(4).documentation,
                HasSubstr("plume <core> & \"mist\": a user-defined spectrum"));
    EXPECT_THAT(readBytes(kept), HasSubstr("<vector3>"));
}

TEST(ScalingXml, SaysWhereAFileCannotBeWritten) {
    const TemporaryFolder folder;
    const auto diagnostics =
        refusalOf([&] { createScalingFiles(folder / "no" / "such" / "ship.flt", small()); });
    EXPECT_EQ(diagnostics.front().value, "a folder that does not exist");
}

TEST(ScalingXml, BringsParametersOfOnesOwnThroughTheFile) {
    ScalingTable table;
    table[1] = {Distribution(DistributionKind::normal, 0.8, 1.3, {1.0, 0.02}), "measured"};
    table[7] = {Distribution(DistributionKind::beta, 0.8, 1.3), ""};
    table[9] = {Distribution(DistributionKind::stable, 0.8, 1.3, {1.0, 0.02, 1.7, -0.5}), ""};
    const TemporaryFolder folder;
    EXPECT_EQ(
        readScalingFile(writeBytes(folder / "s.xml", scalingXml(table)), ScalingKind::temperature),
        table);
}

TEST(ScalingXml, RefusesWhatNoScaleCanBeWithItsLine) {
    const struct {
        const char* name;
        std::string parameters;
        ScalingKind kind;
        const char* says;
    } rows[] = {
        {"a name", scale("skin", "1 1 0"), ScalingKind::temperature, "the name 'skin'"},
        {"a negative index", scale("-3", "1 1 0"), ScalingKind::temperature, "the name '-3'"},
        {"a temperature of 0", scale("1", "0 1 0"), ScalingKind::temperature, "above 0"},
        {"a negative emissivity", scale("1", "-0.1 1 0"), ScalingKind::emissivity, "at least 0"},
        {"distribution 17", scale("1", "0.9 1 17"), ScalingKind::emissivity, "distribution 17"},
        {"distribution 1.5", scale("1", "0.9 1 1.5"), ScalingKind::emissivity, "distribution 1.5"},
        {"reversed ends", scale("1", "1.1 0.9 0"), ScalingKind::emissivity, "min 1.1"},
        {"Poisson without a number", scale("1", "0.2 0.9 14"), ScalingKind::emissivity,
         "no whole number"},
        {"the same index twice", scale("1", "1 1 0") + scale("01", "1 1 0"),
         ScalingKind::emissivity, "index 1 again"},
        {"a single number", "<parameter name=\"2\"><double>1</double></parameter>",
         ScalingKind::emissivity, "a vector3 of min, max and distribution"},
        {"a short vector", scale("2", "1 1", "vector"), ScalingKind::emissivity,
         "a vector3 of min, max and distribution"},
        {"too many parameters", scale("2", "1 1.2 1 1 1 1", "vector"), ScalingKind::emissivity,
         "expected 2"},
    };
    for (const auto& row : rows) {
        const auto diagnostics = refusalOf([&] { read(row.parameters, row.kind); });
        ASSERT_FALSE(diagnostics.empty()) << row.name;
        EXPECT_THAT(diagnostics.front().message(), HasSubstr(row.says)) << row.name;
        EXPECT_THAT(diagnostics.front().position, HasSubstr("line ")) << row.name;
    }
    EXPECT_EQ(refusalOf([&] {
                  read(scale("a", "1 1 0") + scale("1", "2 1 0") + scale("2", "1 1 99"));
              }).size(),
              3u);
}

TEST(ScalingXml, DrawsEveryIndexFromASequenceOfItsOwn) {
    ScalingTable table = read(scale("1", "0.9 1.1 0") + scale("5", "0.9 1.1 0"));
    const auto first = sampledScales(table, ScalingKind::temperature, 3, 0, 0);
    EXPECT_EQ(sampledScales(table, ScalingKind::temperature, 3, 0, 0), first);
    EXPECT_NE(first.at(1), first.at(5));
    EXPECT_NE(sampledScales(table, ScalingKind::temperature, 4, 0, 0).at(1), first.at(1));
    EXPECT_NE(sampledScales(table, ScalingKind::temperature, 3, 1, 0).at(1), first.at(1));
    EXPECT_NE(sampledScales(table, ScalingKind::temperature, 3, 0, 1).at(1), first.at(1));
    EXPECT_NE(sampledScales(table, ScalingKind::emissivity, 3, 0, 0).at(1), first.at(1));

    table[2] = {Distribution(DistributionKind::normal, 0.5, 1.5), ""};
    const auto more = sampledScales(table, ScalingKind::temperature, 3, 0, 0);
    EXPECT_EQ(more.at(1), first.at(1));
    EXPECT_EQ(more.at(5), first.at(5));
}

} // namespace irsg
