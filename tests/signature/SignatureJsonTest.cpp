#include <cstring>
#include <limits>

#include "irsg/signature/SignatureFile.h"

#include "Support.h"

namespace irsg {
namespace {

using testing::HasSubstr;

TEST(SignatureJson, BringsACompleteDatabaseBackUnchanged) {
    const SignatureDatabase database = completeDatabase();
    EXPECT_TRUE(signatureFromJson(signatureToJson(database)) == database);
}

TEST(SignatureJson, OfEqualDatabasesIsEqualText) {
    const std::string text = signatureToJson(completeDatabase());
    EXPECT_EQ(signatureToJson(completeDatabase()), text);
    EXPECT_EQ(signatureToJson(signatureFromJson(text)), text);
}

TEST(SignatureJson, OfAnEmptyDatabaseComesBack) {
    EXPECT_TRUE(signatureFromJson(signatureToJson(SignatureDatabase{})) == SignatureDatabase{});
}

TEST(SignatureJson, KeepsTheLastBitOfEveryNumber) {
    SignatureDatabase database;
    const double values[] = {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.123456789};
    int index = 0;
    for (const double value : values) {
        database.temperatures[index] = {"t", {}, {300.0, 0.0, 0.0, value, {}, {}, {}, {}},
                                        "",  {}, ""};
        ++index;
    }
    const SignatureDatabase again = signatureFromJson(signatureToJson(database));
    index = 0;
    for (const double value : values) {
        const double read = again.temperatures.at(index++).terms.ambientOffset_K;
        EXPECT_EQ(std::memcmp(&read, &value, sizeof value), 0) << value;
    }
}

TEST(SignatureJson, SortsIndicesByValueAndKeysByLetter) {
    SignatureDatabase database;
    for (const int index : {10, 9, -3, 0, 100}) {
        database.materials[index].name = "m" + std::to_string(index);
    }
    const std::string text = signatureToJson(database);
    std::size_t last = 0;
    for (const char* const key : {"\"-3\"", "\"0\"", "\"9\"", "\"10\"", "\"100\""}) {
        ASSERT_NE(text.find(key), std::string::npos) << key;
        EXPECT_GT(text.find(key), last) << key;
        last = text.find(key);
    }
    EXPECT_LT(text.find("\"emissivity\""), text.find("\"name\""));
    EXPECT_LT(text.find("\"format\""), text.find("\"materials\""));
    EXPECT_LT(text.find("\"materials\""), text.find("\"temperatures\""));
}

TEST(SignatureJson, WritesEachRowOfATableOnALineOfItsOwn) {
    EXPECT_THAT(signatureToJson(completeDatabase()),
                HasSubstr("        [4.5, 0.2],\n        [5, 0.9],\n"));
}

TEST(SignatureJson, WithAReflectivityThatClosesIsAcceptedAndNotKept) {
    const std::string text = R"({"format": "smat-signature", "version": 1, "temperatures": {},
        "materials": {"3": {"name": "m", "emissivity": [[3, 0.8], [5, 0.6]],
                            "transmissivity": 0.1, "reflectivity": [[3, 0.10005], [5, 0.3]]}}})";
    const Material material = signatureFromJson(text).materials.at(3);
    EXPECT_NEAR(material.reflectivityAt(3.0), 0.1, 1e-15);
    EXPECT_NEAR(material.reflectivityAt(4.0), 0.2, 1e-15);
    EXPECT_NEAR(material.reflectivityAt(9.0), 0.3, 1e-15);
}

TEST(SignatureJson, RefusesToWriteWhatIsPhysicallyWrong) {
    SignatureDatabase database = completeDatabase();
    database.materials[0].emissivity = Spectrum::constant(1.2);
    const auto diagnostics = refusalOf([&] { signatureToJson(database); });
    ASSERT_EQ(diagnostics.size(), 1U);
    EXPECT_EQ(diagnostics[0].position, "materials.0.emissivity");
}

TEST(SignatureJson, RefusesToWriteTextThatIsNotUtf8) {
    SignatureDatabase database = completeDatabase();
    database.materials[0].notes = "\xff latin";
    const auto diagnostics = refusalOf([&] { signatureToJson(database); });
    ASSERT_EQ(diagnostics.size(), 1U);
    EXPECT_THAT(diagnostics[0].expected, HasSubstr("UTF-8"));
}

struct BadJson {
    const char* name;
    std::string text;
    const char* position;
    const char* value;
    const char* expected;
};
void PrintTo(const BadJson& row, std::ostream* out) {
    *out << row.name;
}

/// A whole file around one material, one temperature, one spectrum.
std::string around(const std::string& temperatures, const std::string& materials,
                   const std::string& spectra = "") {
    return R"({"format": "smat-signature", "version": 1, "temperatures": {)" + temperatures +
           R"(}, "materials": {)" + materials + R"(}, "spectra": {)" + spectra + "}}";
}
std::string material(const std::string& rest) {
    return around("", R"("3": {"name": "m", )" + rest + "}");
}
std::string terms(const std::string& rest) {
    return around(R"("1": {"name": "t", "mode": "temperature", "terms": {"base_K": 300, )"
                  R"("ambientFactor": 0)" +
                      rest + "}}",
                  "");
}
const char* const goodSpectrum =
    R"("p": {"components": ["CO2"], "radiance_W_m2_sr_um": [[4, 10], [5, 10]]})";
std::string gas(const std::string& rest) {
    return around(R"("1": {"name": "g", "mode": "userSpectrum", )" + rest + "}", "", goodSpectrum);
}

class RefusedJson : public testing::TestWithParam<BadJson> {};

TEST_P(RefusedJson, NamesFilePlaceValueAndExpectation) {
    const BadJson& row = GetParam();
    const auto diagnostics = refusalOf([&] { signatureFromJson(row.text, "bad.json"); });
    bool found = false;
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) {
        EXPECT_EQ(diagnostic.file, "bad.json");
        EXPECT_FALSE(diagnostic.expected.empty()) << diagnostic.message();
        all += diagnostic.message() + "\n";
        const std::string& position = diagnostic.position;
        found |= position.substr(0, position.rfind(", line ")) == row.position &&
                 diagnostic.value.find(row.value) != std::string::npos &&
                 diagnostic.expected.find(row.expected) != std::string::npos;
    }
    EXPECT_TRUE(found) << all;
}

INSTANTIATE_TEST_SUITE_P(
    SignatureJson, RefusedJson,
    testing::Values(
        BadJson{"Empty", "", "line 1, column 1", "the end", "JSON"},
        BadJson{"CutOff", "{\n \"format\":", "line 2, column 11", "the end", "JSON"},
        BadJson{"PlainText", "hello", "line 1, column 1", "not JSON", "JSON"},
        BadJson{"ZeroByte", std::string("{}\n \0{", 6), "line 2, column 2", "a zero byte", "JSON"},
        BadJson{"TrailingComma", "{\"format\": \"smat-signature\",}", "line 1, column 29",
                "not JSON", "JSON"},
        BadJson{"NotUtf8", "{\"\xff\": 1}", "line 1, column 3", "not JSON", "UTF-8"},
        BadJson{"BareNan", material("\"emissivity\": NaN"), "line 1, column 111", "not JSON",
                "JSON"},
        BadJson{"NumberTooLarge", material("\"emissivity\": 1e999"), "line 1, column 111",
                "too large", "1.8e308"},
        BadJson{"List", "[]", "", "[]", "an object"},
        BadJson{"NoFormat", R"({"version": 1, "temperatures": {}, "materials": {}})", "format",
                "nothing", "smat-signature"},
        BadJson{"OtherFormat",
                R"({"format": "gltf", "version": 1, "temperatures": {}, "materials": {}})",
                "format", "\"gltf\"", "smat-signature"},
        BadJson{
            "NewerVersion",
            R"({"format": "smat-signature", "version": 8, "temperatures": {}, "materials": {}})",
            "version", "8", "1 to 7"},
        BadJson{"NoMaterials", R"({"format": "smat-signature", "version": 1, "temperatures": {}})",
                "materials", "nothing", "an object of entries by index"},
        BadJson{"UnknownTopKey",
                R"({"format": "smat-signature", "version": 1, "temperatures": {}, "materials": {},
                    "colour": 1})",
                "colour", "unknown", "spectra"},
        BadJson{"DuplicateKey", around("", R"("3": {"name": "a", "emissivity": 1},
                                             "3": {"name": "b", "emissivity": 1})"),
                "materials.3", "twice", "once"},
        BadJson{"IndexNotANumber", around("", R"("paint": {"name": "m", "emissivity": 1})"),
                "materials.paint", "\"paint\"", "whole number"},
        BadJson{"IndexTooLarge", around("", R"("2147483648": {"name": "m", "emissivity": 1})"),
                "materials.2147483648", "2147483648", "32 bits"},
        BadJson{"IndexWithZeros", around("", R"("03": {"name": "m", "emissivity": 1})"),
                "materials.03", "\"03\"", "whole number"},
        BadJson{"MaterialNotAnObject", around("", R"("3": 0.9)"), "materials.3", "0.9",
                "an object"},
        BadJson{"NoEmissivity", around("", R"("3": {"name": "m"})"), "materials.3.emissivity",
                "nothing", "a number, or rows"},
        BadJson{"NameNotText", around("", R"("3": {"name": 7, "emissivity": 1})"),
                "materials.3.name", "7", "text"},
        BadJson{"Misspelt", material(R"("emissivity": 1, "emisivity": 1)"), "materials.3.emisivity",
                "unknown", "emissivity"},
        BadJson{"EmissivityText", material(R"("emissivity": "0.9")"), "materials.3.emissivity",
                "\"0.9\"", "a number"},
        BadJson{"EmissivityAboveOne", material(R"("emissivity": 1.3)"), "materials.3.emissivity",
                "1.3", "0 to 1"},
        BadJson{"EmissivityNodeNegative", material(R"("emissivity": [[3, 0.5], [4, -0.1]])"),
                "materials.3.emissivity at 4 um", "-0.1", "0 to 1"},
        BadJson{"SumAboveOne", material(R"("emissivity": 0.7, "transmissivity": 0.4)"),
                "materials.3", "1.1", "at most 1"},
        BadJson{"ReflectivityOpen", material(R"("emissivity": 0.7, "reflectivity": 0.2)"),
                "materials.3.reflectivity at 1 um", "0.2", "0.3"},
        BadJson{"SpectrumRowShort", material(R"("emissivity": [[3, 0.5], [4]])"),
                "materials.3.emissivity[1]", "[4]", "2 numbers"},
        BadJson{"SpectrumRowText", material(R"("emissivity": [[3, "a"], [4, 1]])"),
                "materials.3.emissivity[0]", "[3,\"a\"]", "2 numbers"},
        BadJson{"SpectrumRowNull", material(R"("emissivity": [[3, null], [4, 1]])"),
                "materials.3.emissivity[0]", "null", "2 numbers"},
        BadJson{"SpectrumReversed", material(R"("emissivity": [[5, 0.5], [4, 0.5]])"),
                "materials.3.emissivity, node 2", "4", "5"},
        BadJson{"SpectrumOfOneNode", material(R"("emissivity": [[5, 0.5]])"),
                "materials.3.emissivity", "1 nodes", "two"},
        BadJson{"NegativeN", material(R"("emissivity": 1, "nAngleFactor": -1)"),
                "materials.3.nAngleFactor", "-1", "at least 0"},
        BadJson{"NoTerms", around(R"("1": {"name": "t", "mode": "temperature"})", ""),
                "temperatures.1.terms", "nothing", "an object"},
        BadJson{
            "NoBase",
            around(R"("1": {"name": "t", "mode": "temperature", "terms": {"ambientFactor": 1}})",
                   ""),
            "temperatures.1.terms.base_K", "nothing", "a number"},
        BadJson{"UnknownMode", around(R"("1": {"name": "t", "mode": "magic"})", ""),
                "temperatures.1.mode", "\"magic\"", "userSpectrum"},
        BadJson{"BelowAbsoluteZero",
                around(R"("1": {"name": "t", "mode": "temperature",
                                "terms": {"base_K": -5, "ambientFactor": 0}})",
                       ""),
                "temperatures.1", "-5 K at rest", "above 0 K"},
        BadJson{"TableDescending", terms(R"(, "power": {"nodes": [[1, 0], [0, 5]]})"),
                "temperatures.1.terms.power.nodes, node 2", "0 after 1", "ascending"},
        BadJson{"TableWithoutNodes", terms(R"(, "power": {"loop": false})"),
                "temperatures.1.terms.power.nodes", "nothing", "rows of 2 numbers"},
        BadJson{"TableEmpty", terms(R"(, "power": {"nodes": []})"),
                "temperatures.1.terms.power.nodes", "0 nodes", "at least one"},
        BadJson{"LoopNotAFlag", terms(R"(, "time_s": {"loop": 1, "nodes": [[0, 0], [1, 1]]})"),
                "temperatures.1.terms.time_s.loop", "1", "true or false"},
        BadJson{"LoopOverPower", terms(R"(, "power": {"loop": true, "nodes": [[0, 0], [1, 1]]})"),
                "temperatures.1.terms.power", "loop", "time alone"},
        BadJson{"UnknownTerm", terms(R"(, "machNumber": 1)"), "temperatures.1.terms.machNumber",
                "unknown", "mach"},
        BadJson{"UnknownSpectrum", gas(R"("userSpectrum": "q")"), "temperatures.1.userSpectrum",
                "'q'", "user-defined spectrum"},
        BadJson{"UnknownComponent",
                gas(R"("userSpectrum": "p", "factors": [{"component": "H2O"}])"),
                "temperatures.1.factors[0].component", "'H2O'", "'p'"},
        BadJson{"ComponentTwice", gas(R"("userSpectrum": "p",
                       "factors": [{"component": "CO2"}, {"component": "CO2"}])"),
                "temperatures.1.factors[1].component", "second", "one factor"},
        BadJson{"NegativeFactor",
                gas(R"("userSpectrum": "p", "factors": [{"component": "CO2", "constant": -1}])"),
                "temperatures.1.factors[0].constant", "-1", "at least 0"},
        BadJson{"AngleOutside", gas(R"("userSpectrum": "p",
                       "factors": [{"component": "CO2", "angle_deg": {"nodes": [[0, 1], [270, 1]]}}])"),
                "temperatures.1.factors[0].angle_deg", "270", "0 to 180"},
        BadJson{"FactorsNotAList", gas(R"("userSpectrum": "p", "factors": {})"),
                "temperatures.1.factors", "{}", "a list"},
        BadJson{"SpectrumWithoutComponents",
                around("", "", R"("p": {"components": [], "radiance_W_m2_sr_um": []})"),
                "spectra.p.components", "none", "at least one"},
        BadJson{"ComponentNameNumber",
                around("", "", R"("p": {"components": [1], "radiance_W_m2_sr_um": []})"),
                "spectra.p.components[0]", "1", "text"},
        BadJson{"RadianceRowShort", around("", "", R"("p": {"components": ["a", "b"],
                                        "radiance_W_m2_sr_um": [[4, 1, 1], [5, 1]]})"),
                "spectra.p.radiance_W_m2_sr_um[1]", "[5,1]", "3 numbers"},
        BadJson{"RadianceAxisReversed", around("", "", R"("p": {"components": ["a"],
                                        "radiance_W_m2_sr_um": [[5, 1], [4, 1]]})"),
                "spectra.p.radiance_W_m2_sr_um, node 2", "4", "5"},
        BadJson{"NegativeReferenceDistance",
                around("", "", R"("p": {"components": ["a"], "referenceDistance_m": -2,
                                        "radiance_W_m2_sr_um": [[4, 1], [5, 1]]})"),
                "spectra.p.referenceDistance_m", "-2", "at least 0 m"}),
    [](const auto& row) { return row.param.name; });

TEST(SignatureJson, NamesTheLineOfAValueAndOfWhatLacksOne) {
    const auto diagnostics = refusalOf([] {
        signatureFromJson(
            "{\"format\": \"smat-signature\", \"version\": 1,\n\"temperatures\": {},\n"
            "\"materials\": {\n\"1\": {\"name\": \"a\",\n\"emissivity\": [[5, 1],\n"
            "[4, 1]]},\n\"2\": {\"name\": \"b\"}}}",
            "bad.json");
    });
    ASSERT_EQ(diagnostics.size(), 2U);
    EXPECT_EQ(diagnostics[0].position, "materials.1.emissivity, node 2, line 5");
    EXPECT_EQ(diagnostics[1].position, "materials.2.emissivity, line 7");
}

TEST(SignatureJson, ReportsAllDiagnosticsAtOnce) {
    const auto diagnostics = refusalOf([] {
        signatureFromJson(R"({"format": "x", "version": 99, "temperatures": {"a": {}},
                              "materials": {"1": {"name": 5, "emissivity": "x", "k": 1}}})");
    });
    EXPECT_EQ(diagnostics.size(), 6U);
}

TEST(SignatureJson, SurvivesDeepNesting) {
    for (const std::string& text :
         {std::string(200000, '['), std::string(100000, '[') + std::string(100000, ']')}) {
        const auto diagnostics = refusalOf([&] { signatureFromJson(text, "deep.json"); });
        ASSERT_EQ(diagnostics.size(), 1U);
        EXPECT_THAT(diagnostics[0].value, HasSubstr("nested more than 16 deep"));
    }
}

} // namespace
} // namespace irsg
