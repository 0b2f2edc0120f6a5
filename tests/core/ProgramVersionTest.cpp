#include "irsg/core/ProgramVersion.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/simulate/ScenarioFile.h"
#include "tests/support/WithoutProgram.h"

namespace smat {
namespace {

using Json = nlohmann::json;

/// A file in JSON: a text without `program`, and what a reader and a writer make of a text.
struct Format {
    const char* name;
    std::string old;
    std::function<std::string(const std::string& text)> writtenAgain;
};

std::ostream& operator<<(std::ostream& out, const Format& format) {
    return out << format.name;
}

class FileInJson : public testing::TestWithParam<Format> {
  protected:
    static Json parsed(const std::string& text) { return Json::parse(text); }
    static std::string with(const std::string& text, const Json& program) {
        Json json = parsed(text);
        json["program"] = program;
        return json.dump();
    }
};

TEST_P(FileInJson, NamesTheVersionThatWroteItAndNothingElseIsNew) {
    const std::string written = GetParam().writtenAgain(GetParam().old);
    EXPECT_EQ(parsed(written).value("program", ""), irsg::programWithVersion());
    EXPECT_EQ(parsed(test::withoutProgram(written)), parsed(GetParam().old));
    EXPECT_EQ(GetParam().writtenAgain(written), written);
}

TEST_P(FileInJson, IsReadWhateverVersionItNames) {
    const std::string written = GetParam().writtenAgain(GetParam().old);
    for (const Json& program : {Json("smat 99.0.0"), Json(""), Json(7)}) {
        EXPECT_EQ(GetParam().writtenAgain(with(GetParam().old, program)), written) << program;
    }
}

INSTANTIATE_TEST_SUITE_P(
    ProgramVersion, FileInJson,
    testing::Values(
        Format{"Project", R"({"version": 1, "title": "a", "camera": {"range": 7.0}})",
               [](const std::string& text) {
                   const Project project = projectFromJson(text, "/a/a.smat");
                   EXPECT_THAT(unknownKeys(project), testing::IsEmpty());
                   return projectToJson(project, "/a/a.smat");
               }},
        Format{"Scenario", R"({"version": 1, "dt_s": 0.5, "end_s": 1.0,
                               "entities": [{"name": "a", "model": "a.flt", "database": "a.sigdb",
                                             "position_m": [0.0, 0.0, 0.0]}],
                               "sensors": [{"name": "s", "position_m": [0.0, -900.0, 0.0],
                                            "track": "a"}]})",
               [](const std::string& text) {
                   return scenarioToJson(scenarioFromJson(text, "/a/a.json"), "/a/a.json");
               }},
        Format{"Signature", R"({"format": "smat-signature", "version": 1, "title": "a",
                                "notes": "", "temperatures": {}, "materials": {}, "spectra": {}})",
               [](const std::string& text) {
                   return irsg::signatureToJson(irsg::signatureFromJson(text, "a.json"));
               }},
        Format{"ModelCodes", R"({"format": "smat-codes", "version": 1,
                                 "rules": [{"group": "a", "materialIndex": 1}]})",
               [](const std::string& text) {
                   return irsg::modelCodesToJson(irsg::modelCodesFromJson(text, "a.codes.json"));
               }},
        Format{"TabulatedAtmosphere",
               R"({"format": "irsg tabulated atmosphere", "version": 1, "name": "a",
                   "wavenumbers [cm-1]": [2050.0, 2051.0], "runs": [{"source": "s",
                   "kind": "transmittance", "path": "horizontal", "sensor_altitude [m]": 2000.0,
                   "target_altitude [m]": 2000.0, "range [m]": 2000.0, "elevation [rad]": 0.0,
                   "cards": {}, "warnings": [], "transmittance": [0.9, 0.8]}]})",
               [](const std::string& text) {
                   return irsg::TabulatedAtmosphere::fromText(text, "a.smatatm").toText();
               }}),
    testing::PrintToStringParamName());

} // namespace
} // namespace smat
