#include <functional>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using Folder = std::filesystem::path;
using Words = std::vector<std::string>;

/// One bad input: what is written into the folder, how the program is called from there, and what
/// its complaint must name.
struct Row {
    const char* name;
    std::function<void(const Folder&)> prepare;
    Words arguments;
    Words named; ///< place, value and expectation: each must be in one line of standard error
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

void nothing(const Folder&) {}

/// A project that is right but for what `more` adds to or puts in place of its parts.
std::function<void(const Folder&)> project(const std::string& json) {
    return [json](const Folder& folder) { write(folder / "p.smat", json); };
}

std::string good(const std::string& more = "") {
    return R"({"version": 1, "models": [{"file": ")" + sample("sphere/sphere.flt").string() +
           R"(", "database": ")" + sample("sphere/sphere.sigdb").string() + R"("}])" +
           (more.empty() ? "" : ",\n" + more) + "}";
}

std::function<void(const Folder&)> file(const std::string& name, const std::string& content) {
    return [name, content](const Folder& folder) {
        write(folder / name, content);
        write(folder / "p.smat", good());
    };
}

/// The first bytes of a sample's file.
std::function<void(const Folder&)> cut(const std::string& from, std::size_t bytes,
                                       const std::string& name) {
    return [=](const Folder& folder) {
        write(folder / name, contentOf(sample(from)).substr(0, bytes));
        write(folder / "p.smat", good());
    };
}

/// A sample's file with some bytes written over.
std::function<void(const Folder&)> patched(const std::string& from, std::size_t at,
                                           const std::string& bytes, const std::string& name) {
    return [=](const Folder& folder) {
        write(folder / name, contentOf(sample(from)).replace(at, bytes.size(), bytes));
    };
}

const Words image = {"image", "p.smat", "--out", "o.exr"};

Words imageWith(const Words& more) {
    Words words = image;
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

Words polarWith(const Words& more) {
    Words words = {"polar", "p.smat", "--out", "o.csv"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

class BadInput : public testing::TestWithParam<Row> {};

TEST_P(BadInput, IsRefusedWithPlaceValueAndExpectation) {
    const TemporaryFolder folder;
    GetParam().prepare(folder.path());
    const Ran ran = smatBatch(GetParam().arguments, folder.path());
    EXPECT_EQ(ran.exitCode, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.err, testing::StartsWith("error: "));
    EXPECT_THAT(ran.err, testing::HasSubstr("expected"));
    for (const std::string& named : GetParam().named) {
        EXPECT_THAT(ran.err, testing::HasSubstr(named));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "o.exr"));
    EXPECT_FALSE(std::filesystem::exists(folder / "o.csv"));
}

std::string nameOf(const testing::TestParamInfo<Row>& row) {
    return row.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Projects, BadInput,
    testing::Values(
        Row{"Missing", nothing, image, {"p.smat", "no such file"}},
        Row{"Folder", nothing, {"image", ".smat", "--out", "o.exr"}, {".smat"}},
        Row{"NoJson", project("hello"), image, {"p.smat", "line 1", "JSON"}},
        Row{"CutOff", project(good().substr(0, 60)), image, {"p.smat", "line 1", "JSON"}},
        Row{"NewerVersion", project(R"({"version": 99})"), image, {"p.smat", "version", "99"}},
        Row{"NoVersion", project("{}"), image, {"p.smat", "version"}},
        Row{"NoModels", project(R"({"version": 1})"), image, {"p.smat", "models", "no model"}},
        Row{"KeyTwice",
            project(good("\"sensor\": {\"width\": 9, \"width\": 8}")),
            image,
            {"sensor.width, line 2", "twice"}},
        Row{"WidthOfNothing",
            project(good("\"sensor\": {\"width\": 0}")),
            image,
            {"sensor.width, line 2", "found 0", "from 1 to 16384"}},
        Row{"WidthInQuotes",
            project(good("\"sensor\": {\"width\": \"640\"}")),
            image,
            {"sensor.width, line 2", "\"640\""}},
        Row{"TwoOffences",
            project(good("\"sensor\": {\"fov\": 200,\n\"band\": \"5-3\"}")),
            image,
            {"sensor.fov, line 2", "200", "sensor.band, line 3", "5-3"}},
        Row{"PoseOfTheTarget",
            project(R"({"version": 1, "models": [{"file": "a.flt", "yaw_deg": 3}]})"),
            image,
            {"models.0.yaw_deg", "target.yaw"}},
        Row{"ModelMissing",
            project(R"({"version": 1, "models": [{"file": "a.flt", "database": "a.sigdb"}]})"),
            image,
            {"a.flt", "a.sigdb", "no such file"}},
        Row{"NoDatabase",
            project(R"({"version": 1, "models": [{"file": ")" +
                    sample("sphere/sphere.flt").string() + R"("}]})"),
            image,
            {"models.0.database", "nothing"}},
        Row{"UnknownKindOfAnalysis",
            project(good(R"("analyses": {"a": {"kind": "film"}})")),
            {"run", "p.smat", "--out", "o"},
            {"analyses.a.kind, line 2", "film", "polar"}},
        Row{"AnalysisOutsideItsFolder",
            project(good(R"("analyses": {"../a": {"kind": "image"}})")),
            {"run", "p.smat", "--out", "o"},
            {"analyses.../a"}},
        Row{"NoAnalyses", project(good()), {"run", "p.smat", "--out", "o"}, {"analyses", "none"}},
        Row{"NoSuchAnalysis",
            project(good(R"("analyses": {"a": {"kind": "image"}})")),
            {"run", "p.smat", "--analysis", "b", "--out", "o"},
            {"found b", "one of a"}},
        Row{"CameraBelowTheGround",
            project(good(R"("target": {"altitude": 10})")),
            imageWith({"--elevation=-45"}),
            {"altitude"}}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Options, BadInput,
    testing::Values(
        Row{"NoNumber",
            project(good()),
            imageWith({"--width", "wide"}),
            {"--width", "sensor.width", "wide", "whole number"}},
        Row{"OutOfRange", project(good()), imageWith({"--fov", "180"}), {"sensor.fov", "180"}},
        Row{"NegativeRange", project(good()), imageWith({"--range", "-5"}), {"camera.range", "-5"}},
        Row{"ReversedBand",
            project(good()),
            imageWith({"--band", "12-8"}),
            {"sensor.band", "12-8", "MIN-MAX"}},
        Row{"UnknownChoice",
            project(good()),
            imageWith({"--sun", "bright"}),
            {"render.sun", "bright", "off, approx or smart"}},
        Row{"ModeNobodyAnswers",
            project(good()),
            imageWith({"--mode", "ck"}),
            {"wideband-ck", "has no wideband mode"}},
        Row{"AntialiasingNotThere",
            project(good()),
            imageWith({"--antialiasing", "6"}),
            {"render.antialiasing", "found 6", "from 0 to 5"}},
        Row{"TwoBadOptions",
            project(good()),
            imageWith({"--height", "0", "--sun-azimuth", "400"}),
            {"sensor.height", "environment.sunAzimuth"}},
        Row{"SetWithoutEquals",
            project(good()),
            imageWith({"--set", "sensor.width"}),
            {"--set", "key=value"}},
        Row{"SetUnknownKey",
            project(good()),
            imageWith({"--set", "sensor.widht=3"}),
            {"sensor.widht"}},
        Row{"NoSuchOption", project(good()), imageWith({"--colour", "red"}), {"--colour"}},
        Row{"NoSuchCommand", nothing, {"film"}, {"film"}},
        Row{"NoCommand", nothing, {}, {"no command"}},
        Row{"NoOutput", project(good()), {"image", "p.smat"}, {"--out"}},
        Row{"OutputOfUnknownForm",
            project(good()),
            {"image", "p.smat", "--out", "o.tiff"},
            {"o.tiff", ".tiff", ".exr, .csv, .png, .json"}},
        Row{"PlotOfAnImage",
            project(good()),
            {"polar", "p.smat", "--out", "o.png"},
            {"o.png", ".csv, .json"}},
        Row{"OutputFolderMissing",
            project(good()),
            {"image", "p.smat", "--out", "none/o.exr"},
            {"none/o.exr"}},
        Row{"OutputFolderIsAFile",
            project(good(R"("analyses": {"a": {"kind": "image"}})")),
            {"run", "p.smat", "--out", "p.smat"},
            {"p.smat", "folder"}},
        Row{"ReversedRange",
            project(good()),
            {"range", "p.smat", "--from", "9", "--to", "5", "--out", "o.csv"},
            {"range.to", "found 5", "9 m"}},
        Row{"LogarithmFromZero",
            project(good()),
            {"range", "p.smat", "--from", "0", "--log", "--out", "o.csv"},
            {"range.from"}},
        Row{"EndlessTime",
            project(good()),
            {"time", "p.smat", "--to", "1e9", "--step", "0.001", "--out", "o.csv"},
            {"time.step"}},
        Row{"OffsetOfAnotherMode",
            project(good()),
            polarWith({"--type", "model-yaw", "--offset", "5"}),
            {"polar.offset", "found 5"}},
        Row{"DatabaseOfAProject",
            project(good()),
            imageWith({"--database", "a.sigdb"}),
            {"--database", "a.sigdb"}},
        Row{"ColoursUpsideDown",
            project(good()),
            {"image", "p.smat", "--display-minimum", "5", "--display-maximum", "1", "--out",
             "o.png"},
            {"display.maximum"}}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Databases, BadInput,
    testing::Values(
        Row{"Missing", nothing, {"db", "info", "a.sigdb"}, {"a.sigdb"}},
        Row{"Text",
            file("a.sigdb", "hello, this is no database at all\n"),
            {"db", "info", "a.sigdb"},
            {"a.sigdb"}},
        Row{"Empty", file("a.sigdb", ""), {"db", "info", "a.sigdb"}, {"a.sigdb"}},
        Row{"CutOff",
            cut("sphere/sphere.sigdb", 5000, "a.sigdb"),
            {"db", "info", "a.sigdb"},
            {"a.sigdb"}},
        Row{"ForeignSqlite",
            patched("sphere/sphere.sigdb", 68, "zzzz", "a.sigdb"),
            {"db", "info", "a.sigdb"},
            {"a.sigdb"}},
        Row{"NewerSchema",
            patched("sphere/sphere.sigdb", 60, std::string("\0\0\0\x63", 4), "a.sigdb"),
            {"db", "info", "a.sigdb"},
            {"a.sigdb", "99"}},
        Row{"ExistsAlready",
            file("a.sigdb", "something"),
            {"db", "create", "a.sigdb"},
            {"a.sigdb", "exists already"}},
        Row{"JsonCutOff",
            file("a.json", "{\"version\": 1,"),
            {"db", "import", "a.json", "o.sigdb"},
            {"a.json"}},
        Row{"JsonUnknownKey",
            file("a.json", R"({"version": 1, "colour": "red"})"),
            {"db", "import", "a.json", "o.sigdb"},
            {"a.json", "colour"}},
        Row{"CodeWithoutEntry",
            [](const Folder& folder) {
                write(folder / "p.smat",
                      R"({"version": 1, "target": {"altitude": 100}, "models": [{"file": ")" +
                          sample("chessboard/chessboard.flt").string() + R"(", "database": ")" +
                          sample("sphere/sphere.sigdb").string() + R"("}]})");
            },
            image,
            {"32"}}),
    nameOf);

const Words imageInAir = imageWith({"--atmosphere", "a.csv"});
const Words imageWithResponse = imageWith({"--response", "a.csv"});
const std::string smartHead = "<data>\n<fileType>Parameters</fileType>\n"
                              "<type>/AtmosphereSmart/Root/Atmosphere/AtmosphereSmart</type>\n";
const std::string airHead = "wavelength [um],extinction [km-1]\n";

INSTANTIATE_TEST_SUITE_P(
    Csv, BadInput,
    testing::Values(
        Row{"AtmosphereMissing", project(good()), imageInAir, {"a.csv"}},
        Row{"AtmosphereOfUnknownForm",
            file("a.txt", "x"),
            imageWith({"--atmosphere", "a.txt"}),
            {"a.txt", "no atmosphere", ".csv"}},
        Row{"AtmosphereEmpty", file("a.csv", ""), imageInAir, {"a.csv"}},
        Row{"AtmosphereParameterOutOfRange",
            file("a.xml", smartHead + "<parameter name=\"AirMass\"><double>0</double></parameter>\n"
                                      "</data>\n"),
            imageWith({"--atmosphere", "a.xml"}),
            {"a.xml", "line 4", "AirMass", "found 0", "1 to 10"}},
        Row{"AtmosphereXmlCutShort",
            file("a.xml", smartHead),
            imageWith({"--atmosphere", "a.xml"}),
            {"a.xml", "well-formed"}},
        Row{"NegativeExtinction",
            file("a.csv", airHead + "2,0.1\n6,-0.1\n"),
            imageInAir,
            {"a.csv", "line 3", "-0.1"}},
        Row{"WordForANumber",
            file("a.csv", airHead + "2,0.1\n6,thick\n"),
            imageInAir,
            {"a.csv", "line 3", "thick"}},
        Row{"ReversedAxis", file("a.csv", airHead + "6,0.1\n2,0.1\n"), imageInAir, {"a.csv"}},
        Row{"NotANumber",
            file("a.csv", airHead + "2,nan\n6,0.1\n"),
            imageInAir,
            {"a.csv", "line 2", "nan"}},
        Row{"UnknownColumn",
            file("a.csv", "wavelength [um],fog\n2,1\n6,1\n"),
            imageInAir,
            {"a.csv", "fog"}},
        Row{"BandOutsideTheAir", file("a.csv", airHead + "3.5,0.1\n6,0.1\n"), imageInAir, {"3"}},
        Row{"ResponseMissing", project(good()), imageWithResponse, {"a.csv"}},
        Row{"NegativeResponse",
            file("a.csv", "wavelength [um],response\n3,1\n4,-1\n5,1\n"),
            imageWithResponse,
            {"a.csv", "-1"}},
        Row{"ResponseWithoutArea",
            file("a.csv", "wavelength [um],response\n3,0\n5,0\n"),
            imageWithResponse,
            {"a.csv"}},
        Row{"ResponseOfOneColumn",
            file("a.csv", "wavelength [um]\n3\n5\n"),
            imageWithResponse,
            {"a.csv"}},
        Row{"DoubledWavelength",
            file("a.csv", "wavelength [um],response\n3,1\n3,1\n5,1\n"),
            imageWithResponse,
            {"a.csv"}}),
    nameOf);

/// Imports a CSV into a copy of the ship's database.
Row importRow(const char* name, const std::string& csv, const Words& more, const Words& named) {
    Words arguments = {"db", "import", "a.csv", "ship.sigdb"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return {name,
            [csv](const Folder& folder) {
                write(folder / "a.csv", csv);
                std::filesystem::copy(sample("ship/ship.sigdb"), folder / "ship.sigdb");
            },
            arguments, named};
}

const Words inWatts = {"--unit", "W m-2 sr-1 um-1"};
const Words asAngle = {"--as", "angle", "--temperature", "8"};

INSTANTIATE_TEST_SUITE_P(
    Imports, BadInput,
    testing::Values(
        importRow("SpectrumWithoutUnit", "um,CO2\n3,1\n4,2\n", {}, {"a.csv", "unit"}),
        importRow("UnknownUnit", "um,CO2\n3,1\n4,2\n", {"--unit", "candela"}, {"candela"}),
        importRow("UnknownAxis", "miles,CO2\n3,1\n4,2\n", inWatts, {"a.csv", "line 1", "miles"}),
        importRow("AxisThatTurns", "um,CO2\n3,1\n5,2\n4,1\n", inWatts, {"a.csv", "line 4"}),
        importRow("RaggedRow", "um,CO2,H2O\n3,1,1\n4,2\n", inWatts, {"a.csv", "line 3"}),
        importRow("WordInACell", "um,CO2\n3,1\n4,hot\n", inWatts, {"a.csv", "line 3", "hot"}),
        importRow("ComponentTwice", "um,CO2,CO2\n3,1,1\n4,2,2\n", inWatts, {"a.csv", "CO2"}),
        importRow("AngleBeyondTheTail", ",CO2\n0,1\n270,1\n", asAngle, {"a.csv", "270"}),
        importRow("UnknownComponent", ",neon\n0,1\n180,1\n", asAngle, {"a.csv", "neon"}),
        importRow("EntryWithoutSpectrum", ",CO2\n0,1\n180,1\n",
                  {"--as", "angle", "--temperature", "11"}, {"temperatures.11"}),
        importRow("EntryThatIsNotThere", ",CO2\n0,1\n180,1\n",
                  {"--as", "angle", "--temperature", "77"}, {"temperatures.77"})),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Models, BadInput,
    testing::Values(
        Row{"Missing", nothing, {"model", "info", "a.flt"}, {"a.flt"}},
        Row{"Empty", file("a.flt", ""), {"model", "info", "a.flt"}, {"a.flt"}},
        Row{"Text",
            file("a.flt", "this is no OpenFlight file, but a line of text\n"),
            {"model", "info", "a.flt"},
            {"a.flt", "byte 0"}},
        Row{"CutOff",
            cut("ship/ship.flt", 4001, "a.flt"),
            {"model", "info", "a.flt"},
            {"a.flt", "byte"}},
        Row{"HeaderAlone",
            cut("ship/ship.flt", 324, "a.flt"),
            {"model", "info", "a.flt"},
            {"a.flt"}},
        Row{"RecordOfLengthZero",
            patched("ship/ship.flt", 2, std::string("\0\0", 2), "a.flt"),
            {"model", "info", "a.flt"},
            {"a.flt", "byte"}},
        Row{"UnknownForm", file("a.xyz123", "hello"), {"model", "info", "a.xyz123"}, {"a.xyz123"}},
        Row{"BrokenOsgt",
            file("a.osgt", "#Ascii Scene\n#Version 161\nosg::Group {"),
            {"model", "info", "a.osgt"},
            {"a.osgt"}},
        Row{"Folder", nothing, {"model", "info", "."}, {"."}},
        Row{"ConvertMissing", nothing, {"convert", "a.flt", "b.osgt"}, {"a.flt"}},
        Row{"ConvertToAFormThatLosesCodes",
            nothing,
            {"convert", sample("ship/ship.flt"), "b.obj"},
            {"b.obj"}},
        Row{"ConvertIntoNoFolder",
            nothing,
            {"convert", sample("ship/ship.flt"), "none/b.osgt"},
            {"none: found no such folder"}}),
    nameOf);

/// A radiative output of a haze from 3.5 to 6 um.
Row radiativeRow(const char* name, const Words& more, const Words& named) {
    Words arguments = {"radiative", "a.csv", "--out", "o.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return {name, file("a.csv", airHead + "3.5,0.1\n6,0.1\n"), arguments, named};
}

Words slantWith(const Words& more) {
    Words words = {"--quantity", "transmittance", "--band", "4-5"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

INSTANTIATE_TEST_SUITE_P(
    RadiativeOutputs, BadInput,
    testing::Values(
        radiativeRow("NoQuantity", {"--range", "5"}, {"--quantity", "found nothing", "scattering"}),
        radiativeRow("UnknownQuantity", {"--quantity", "fog"}, {"--quantity", "fog", "all"}),
        radiativeRow("NoGeometry", slantWith({}), {"transmittance", "a sensor altitude"}),
        radiativeRow("NoRange", slantWith({"--sensor-altitude", "9", "--los-elevation", "5"}),
                     {"transmittance", "with a range"}),
        radiativeRow("SensorBelowGround",
                     slantWith({"--sensor-altitude", "-9", "--los-elevation", "5"}),
                     {"sensor altitude", "-9"}),
        radiativeRow("WordForANumber", slantWith({"--range", "far"}), {"--range", "far"}),
        radiativeRow("InfiniteRange", slantWith({"--range", "inf"}), {"--range", "inf"}),
        radiativeRow("Contradiction",
                     slantWith({"--sensor-altitude", "9", "--los-elevation", "5", "--altitude", "9",
                                "--range", "500"}),
                     {"elevation of the line of sight", "5 deg", "target altitude of 9 m"}),
        radiativeRow("IntoTheGround",
                     slantWith({"--sensor-altitude", "9", "--los-elevation=-30", "--range", "50"}),
                     {"range", "50 m", "at most 18"}),
        radiativeRow("SpaceWithARange",
                     slantWith({"--sensor-altitude", "9", "--los-elevation", "5", "--range", "50",
                                "--to-space"}),
                     {"range", "path to space"}),
        radiativeRow("BandOutsideTheAir",
                     {"--quantity", "transmittance", "--sensor-altitude", "9", "--los-elevation",
                      "5", "--range", "50"},
                     {"3-5 um", "3.5-6 um"}),
        radiativeRow("AllOfABandOutsideTheAir",
                     {"--quantity", "all", "--band", "8-12", "--altitude", "9"},
                     {"solar irradiance over 8-12 um", "3.5-6 um"}),
        radiativeRow("AllOfNowhere", {"--quantity", "all", "--band", "4-5"},
                     {"geometry", "a sensor altitude"}),
        radiativeRow("ReversedBand", {"--quantity", "sun", "--band", "5-3"}, {"5-3"}),
        radiativeRow("UnknownResolution", slantWith({"--resolution", "2"}),
                     {"--resolution", "found 2", "1, 5 or 15"}),
        radiativeRow("ResolutionOfAirWithoutBins",
                     slantWith({"--sensor-altitude", "9", "--los-elevation", "5", "--range", "50",
                                "--resolution", "5"}),
                     {"Beer-Lambert (a.csv): resolution: found 5", "AtmosphereSmart"}),
        radiativeRow("SunBeyondTheZenith", slantWith({"--sun-elevation", "91"}),
                     {"--sun-elevation", "91"}),
        Row{"SeveralAtOnce",
            nothing,
            {"radiative", "none", "--quantity", "fog", "--band", "x", "--sun-azimuth", "-1",
             "--out", "o.csv"},
            {"fog", "found 'x'", "--sun-azimuth"}},
        Row{"AtmosphereMissing",
            nothing,
            {"radiative", "b.csv", "--quantity", "sun", "--altitude", "0", "--out", "o.csv"},
            {"b.csv"}},
        Row{"AtmosphereThatIsNoFile",
            nothing,
            {"radiative", "b.txt", "--quantity", "sun", "--altitude", "0", "--out", "o.csv"},
            {"b.txt", "no such file"}},
        Row{"NoOutput", nothing, {"radiative", "none", "--quantity", "sun"}, {"--out"}},
        Row{"OutputOfUnknownForm",
            nothing,
            {"radiative", "none", "--quantity", "sun", "--out", "o.exr"},
            {"o.exr", ".csv, .json"}}),
    nameOf);

Row profileRow(const char* name, const Words& more, const Words& named) {
    Words arguments = {"temperature-profile", "a.csv", "--out", "o.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return {name, file("a.csv", airHead + "3.5,0.1\n6,0.1\n"), arguments, named};
}

INSTANTIATE_TEST_SUITE_P(
    TemperatureProfiles, BadInput,
    testing::Values(
        profileRow("Nothing", {}, {"--min", "--max", "--step"}),
        profileRow("Reversed", {"--min", "9", "--max", "5", "--step", "1"}, {"max", "5 m", "9 m"}),
        profileRow("BelowGround", {"--min", "-9", "--max", "5", "--step", "1"}, {"min", "-9 m"}),
        profileRow("NoStep", {"--min", "0", "--max", "5", "--step", "0"}, {"step", "0 m"}),
        profileRow("TooFine", {"--min", "0", "--max", "1e5", "--step", "1e-3"}, {"step", "0.001"}),
        profileRow("WordForANumber", {"--min", "low"}, {"--min", "low"}),
        Row{"OfVacuum",
            nothing,
            {"temperature-profile", "none", "--min", "0", "--max", "5", "--step", "1", "--out",
             "o.csv"},
            {"vacuum", "ambient temperature"}}),
    nameOf);

} // namespace
} // namespace smat::test
