#include "tests/cli/BadInput.h"

namespace smat::test {
namespace {

const Words image = imageWith();

INSTANTIATE_TEST_SUITE_P(
    Databases, BadInput,
    testing::Values(
        BadRow{"Missing", nothing, {"db", "info", "a.sigdb"}, {"a.sigdb"}},
        BadRow{"Text",
               file("a.sigdb", "hello, this is no database at all\n"),
               {"db", "info", "a.sigdb"},
               {"a.sigdb"}},
        BadRow{"Empty", file("a.sigdb", ""), {"db", "info", "a.sigdb"}, {"a.sigdb"}},
        BadRow{"CutOff",
               cut("sphere/sphere.sigdb", 5000, "a.sigdb"),
               {"db", "info", "a.sigdb"},
               {"a.sigdb"}},
        BadRow{"ForeignSqlite",
               patched("sphere/sphere.sigdb", 68, "zzzz", "a.sigdb"),
               {"db", "info", "a.sigdb"},
               {"a.sigdb"}},
        BadRow{"NewerSchema",
               patched("sphere/sphere.sigdb", 60, std::string("\0\0\0\x63", 4), "a.sigdb"),
               {"db", "info", "a.sigdb"},
               {"a.sigdb", "99"}},
        BadRow{"ExistsAlready",
               file("a.sigdb", "something"),
               {"db", "create", "a.sigdb"},
               {"a.sigdb", "exists already"}},
        BadRow{"JsonCutOff",
               file("a.json", "{\"version\": 1,"),
               {"db", "import", "a.json", "o.sigdb"},
               {"a.json"}},
        BadRow{"JsonUnknownKey",
               file("a.json", R"({"version": 1, "colour": "red"})"),
               {"db", "import", "a.json", "o.sigdb"},
               {"a.json", "colour"}},
        BadRow{"CodeWithoutEntry",
               [](const Folder& folder) {
                   write(folder / "p.smat",
                         R"({"version": 1, "target": {"altitude": 100}, "models": [{"file": ")" +
                             sample("chessboard/chessboard.flt").string() + R"(", "database": ")" +
                             sample("sphere/sphere.sigdb").string() + R"("}]})");
               },
               image,
               {"32"}}),
    nameOf);

BadRow databaseRow(const char* name, const Words& arguments, const Words& named) {
    return {name,
            [](const Folder& folder) {
                std::filesystem::copy(sample("ship/ship.sigdb"), folder / "ship.sigdb");
                std::filesystem::copy(sample("sphere/sphere.sigdb"), folder / "to.sigdb");
                write(folder / "p.smat", good());
            },
            with({"db"}, arguments), named};
}

INSTANTIATE_TEST_SUITE_P(
    DatabaseCommands, BadInput,
    testing::Values(
        databaseRow("LintRepairWithoutOut", {"lint", "ship.sigdb", "--repair"}, {"--repair"}),
        databaseRow("LintOutWithoutRepair", {"lint", "ship.sigdb", "--out", "b.sigdb"}, {"--out"}),
        databaseRow("LintBand", {"lint", "ship.sigdb", "--band", "5-3"}, {"5-3"}),
        databaseRow("LintModelMissing", {"lint", "ship.sigdb", "--model", "a.flt"}, {"a.flt"}),
        databaseRow("LintProjectOfAnother", {"lint", "ship.sigdb", "--project", "p.smat"},
                    {"p.smat", "no model with the database ship.sigdb"}),
        databaseRow("CopyNothing", {"copy", "ship.sigdb", "to.sigdb"}, {"nothing to copy"}),
        databaseRow("CopyAWord", {"copy", "ship.sigdb", "to.sigdb", "--materials", "1,hull"},
                    {"--materials", "'hull'"}),
        databaseRow("CopyWhatIsNotThere",
                    {"copy", "ship.sigdb", "to.sigdb", "--materials", "77", "--spectra", "smoke"},
                    {"ship.sigdb", "materials.77", "spectra.smoke"}),
        databaseRow("CopyBothWays",
                    {"copy", "ship.sigdb", "to.sigdb", "--materials", "1", "--replace",
                     "--renumber"},
                    {"--renumber"}),
        databaseRow("CopyFromNothing", {"copy", "a.sigdb", "to.sigdb", "--materials", "1"},
                    {"a.sigdb"}),
        databaseRow("ExportSpectrumThatIsNotThere",
                    {"export", "ship.sigdb", "o.csv", "--spectrum", "smoke"}, {"spectra.smoke"}),
        databaseRow("ExportMaterialThatIsNotThere",
                    {"export", "ship.sigdb", "o.csv", "--material", "77"}, {"materials.77"}),
        databaseRow("ExportCsvToNowhere", {"export", "ship.sigdb", "--material", "5"}, {"OUT"}),
        databaseRow("ExportIntoNoFolder", {"export", "ship.sigdb", "none/o.json"},
                    {"none/o.json", "folder"})),
    nameOf);

/// Imports a CSV into a copy of the ship's database.
BadRow importRow(const char* name, const std::string& csv, const Words& more, const Words& named) {
    return {name,
            [csv](const Folder& folder) {
                write(folder / "a.csv", csv);
                std::filesystem::copy(sample("ship/ship.sigdb"), folder / "ship.sigdb");
            },
            with({"db", "import", "a.csv", "ship.sigdb"}, more), named};
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
        importRow("TwoDecimalSigns", "um;CO2\n3;1\n4,5;2.5\n", inWatts, {"a.csv", "line 3", "4,5"}),
        importRow("DecimalCommas", "um,CO2\n3,0,1,5\n4,0,2,5\n", inWatts,
                  {"a.csv", "line 2", "decimal points"}),
        importRow("NoNames", "3,1\n4,2\n5,2\n", inWatts, {"a.csv", "line 1", "row of names"}),
        importRow("FactorsForNobody", ",CO2\n0,1\n180,1\n", {"--as", "angle"}, {"--temperature"}),
        importRow("MaterialForNobody", "um,emissivity\n3,1\n5,1\n", {"--as", "material"},
                  {"--material"}),
        importRow("MaterialInPercent", "um,emissivity\n3,90\n5,95\n",
                  {"--as", "material", "--material", "1"}, {"a.csv", "line 2", "percent"}),
        importRow("EntryThatIsNotThere", ",CO2\n0,1\n180,1\n",
                  {"--as", "angle", "--temperature", "77"}, {"temperatures.77"})),
    nameOf);

} // namespace
} // namespace smat::test
