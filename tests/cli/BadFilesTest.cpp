#include "tests/cli/BadInput.h"

namespace smat::test {
namespace {

const Words imageInAtmosphere = imageWith({"--atmosphere", "a.csv"});
const Words imageWithResponse = imageWith({"--response", "a.csv"});
const std::string smartHead = "<data>\n<fileType>Parameters</fileType>\n"
                              "<type>/AtmosphereSmart/Root/Atmosphere/AtmosphereSmart</type>\n";

INSTANTIATE_TEST_SUITE_P(
    Csv, BadInput,
    testing::Values(BadRow{"AtmosphereMissing", project(good()), imageInAtmosphere, {"a.csv"}},
                    BadRow{"AtmosphereOfUnknownForm",
                           file("a.txt", "x"),
                           imageWith({"--atmosphere", "a.txt"}),
                           {"a.txt", "no atmosphere", ".csv"}},
                    BadRow{"AtmosphereEmpty", file("a.csv", ""), imageInAtmosphere, {"a.csv"}},
                    BadRow{"AtmosphereParameterOutOfRange",
                           file("a.xml",
                                smartHead +
                                    "<parameter name=\"AirMass\"><double>0</double></parameter>\n"
                                    "</data>\n"),
                           imageWith({"--atmosphere", "a.xml"}),
                           {"a.xml", "line 4", "AirMass", "found 0", "1 to 10"}},
                    BadRow{"AtmosphereXmlCutShort",
                           file("a.xml", smartHead),
                           imageWith({"--atmosphere", "a.xml"}),
                           {"a.xml", "well-formed"}},
                    BadRow{"NegativeExtinction",
                           file("a.csv", atmosphereHead + "2,0.1\n6,-0.1\n"),
                           imageInAtmosphere,
                           {"a.csv", "line 3", "-0.1"}},
                    BadRow{"WordForANumber",
                           file("a.csv", atmosphereHead + "2,0.1\n6,thick\n"),
                           imageInAtmosphere,
                           {"a.csv", "line 3", "thick"}},
                    BadRow{"AxisToAndFro",
                           file("a.csv", atmosphereHead + "6,0.1\n2,0.1\n4,0.1\n"),
                           imageInAtmosphere,
                           {"a.csv"}},
                    BadRow{"NotANumber",
                           file("a.csv", atmosphereHead + "2,nan\n6,0.1\n"),
                           imageInAtmosphere,
                           {"a.csv", "line 2", "nan"}},
                    BadRow{"UnknownColumn",
                           file("a.csv", "wavelength [um],fog\n2,1\n6,1\n"),
                           imageInAtmosphere,
                           {"a.csv", "fog"}},
                    BadRow{"BandOutsideTheAir",
                           file("a.csv", atmosphereHead + "3.5,0.1\n6,0.1\n"),
                           imageInAtmosphere,
                           {"3"}},
                    BadRow{"ResponseMissing", project(good()), imageWithResponse, {"a.csv"}},
                    BadRow{"NegativeResponse",
                           file("a.csv", "wavelength [um],response\n3,1\n4,-1\n5,1\n"),
                           imageWithResponse,
                           {"a.csv", "-1"}},
                    BadRow{"ResponseWithoutArea",
                           file("a.csv", "wavelength [um],response\n3,0\n5,0\n"),
                           imageWithResponse,
                           {"a.csv"}},
                    BadRow{"ResponseOfOneColumn",
                           file("a.csv", "wavelength [um]\n3\n5\n"),
                           imageWithResponse,
                           {"a.csv"}},
                    BadRow{"DoubledWavelength",
                           file("a.csv", "wavelength [um],response\n3,1\n3,1\n5,1\n"),
                           imageWithResponse,
                           {"a.csv"}}),
    nameOf);

INSTANTIATE_TEST_SUITE_P(
    Models, BadInput,
    testing::Values(
        BadRow{"Missing", nothing, {"model", "info", "a.flt"}, {"a.flt"}},
        BadRow{"Empty", file("a.flt", ""), {"model", "info", "a.flt"}, {"a.flt"}},
        BadRow{"Text",
               file("a.flt", "this is no OpenFlight file, but a line of text\n"),
               {"model", "info", "a.flt"},
               {"a.flt", "byte 0"}},
        BadRow{"CutOff",
               cut("ship/ship.flt", 4001, "a.flt"),
               {"model", "info", "a.flt"},
               {"a.flt", "byte"}},
        BadRow{"HeaderAlone",
               cut("ship/ship.flt", 324, "a.flt"),
               {"model", "info", "a.flt"},
               {"a.flt"}},
        BadRow{"RecordOfLengthZero",
               patched("ship/ship.flt", 2, std::string("\0\0", 2), "a.flt"),
               {"model", "info", "a.flt"},
               {"a.flt", "byte"}},
        BadRow{
            "UnknownForm", file("a.xyz123", "hello"), {"model", "info", "a.xyz123"}, {"a.xyz123"}},
        BadRow{"Script",
               file("a.lua", "os.execute('touch o.csv')\n"),
               {"model", "info", "a.lua"},
               {"a.lua", "a file of type \".lua\"", "a model of type .flt, .osgt"}},
        BadRow{"ScriptOfAProject",
               [](const Folder& folder) {
                   write(folder / "a.lua", "os.execute('touch o.csv')\n");
                   write(folder / "p.smat",
                         R"({"version": 1, "models": [{"file": "a.lua", "database": ")" +
                             sample("sphere/sphere.sigdb").string() + R"("}]})");
               },
               imageWith(),
               {"a.lua", "a file of type \".lua\""}},
        BadRow{"ScriptForATerrain",
               file("a.lua", "os.execute('touch o.csv')\n"),
               imageWith({"--set", "environment.terrain=a.lua"}),
               {"a.lua", "a file of type \".lua\""}},
        BadRow{"ArchiveForAModel",
               file("a.tgz", "x"),
               {"model", "info", "a.tgz"},
               {"a.tgz", "a file of type \".tgz\""}},
        BadRow{"BrokenOsgt",
               file("a.osgt", "#Ascii Scene\n#Version 161\nosg::Group {"),
               {"model", "info", "a.osgt"},
               {"a.osgt"}},
        BadRow{"Folder", nothing, {"model", "info", "."}, {"."}},
        BadRow{"ConvertMissing", nothing, {"convert", "a.flt", "b.osgt"}, {"a.flt"}},
        BadRow{"ConvertToAFormThatLosesCodes",
               nothing,
               {"convert", sample("ship/ship.flt"), "b.obj"},
               {"b.obj"}},
        BadRow{"ConvertIntoNoFolder",
               nothing,
               {"convert", sample("ship/ship.flt"), "none/b.osgt"},
               {"none: found no such folder"}}),
    nameOf);

} // namespace
} // namespace smat::test
