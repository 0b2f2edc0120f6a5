// atmosphere-accuracy [SECTION...] --shared FOLDER [--out FOLDER] compares the computed atmosphere
// with other programs, with line by line and with itself, and times it. Tables go to the standard
// output as Markdown, curves to the folder as CSV.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "benchmarks/Sections.h"
#include "benchmarks/atmosphere/Table.h"

int main(int argc, char** argv) {
    using namespace irsg::accuracy;
    const irsg::bench::Sections<Output> sections = {{"modtran", modtranTables},
                                                    {"lowtran", lowtranTables},
                                                    {"line-by-line", lineByLineTables},
                                                    {"wideband", widebandTables},
                                                    {"sun", sunTables},
                                                    {"speed", speedTables}};

    CLI::App app{"Measures how accurate and how fast the computed atmosphere is."};
    Output output{"../shared", {}, "tests/data/atmosphere/line-by-line.csv.gz"};
    std::vector<std::string> wanted;
    app.add_option("sections", wanted,
                   "modtran, lowtran, line-by-line, wideband, sun, speed; none: all")
        ->check(CLI::IsMember(irsg::bench::namesOf(sections)));
    app.add_option("--shared", output.shared, "folder that holds data/atmosphere (../shared)");
    app.add_option("--out", output.folder, "folder for curves as CSV")
        ->check(CLI::ExistingDirectory);
    app.add_option("--truth", output.truth,
                   "results computed line by line, as atmosphere-tables truth writes them");
    CLI11_PARSE(app, argc, argv);
    return irsg::bench::run(sections, wanted, output);
}
