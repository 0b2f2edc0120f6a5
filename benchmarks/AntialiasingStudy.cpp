// antialiasing-study [SECTION...] --out FOLDER measures what every antialiasing mode does to the
// contrast intensity of objects of 0.01 to 100 pixels, and how long a frame takes. Results go to
// the folder as CSV; scripts/antialiasing-report makes tables and figures of them.

#include <cstdlib>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "benchmarks/Sections.h"
#include "benchmarks/antialiasing/Study.h"

int main(int argc, char** argv) {
    using namespace irsg::study;
    const irsg::bench::Sections<Options> sections = {
        {"errors", measureErrors}, {"angles", measureAngles}, {"times", measureTimes},
        {"ranges", measureRanges}, {"parts", measureParts},   {"spots", measureSpots},
        {"noses", measureNoses},   {"polar", measurePolar},   {"profile", profile}};

    CLI::App app{"Measures how true and how fast every antialiasing mode is."};
    Options options;
    std::vector<std::string> wanted;
    app.add_option("sections", wanted,
                   "errors, angles, times, ranges, parts, spots, noses, polar, profile; none: all")
        ->check(CLI::IsMember(irsg::bench::namesOf(sections)));
    app.add_option("--out", options.folder, "folder for the results as CSV")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("--phases", options.phases, "pixel phases along either axis (16)")
        ->check(CLI::Range(1, 1000));
    app.add_option("--rounds", options.rounds, "frames that a median time is taken of (105)")
        ->check(CLI::Range(1, 10000));
    app.add_option("--body", options.bodies, "only this body; may be repeated");
    CLI11_PARSE(app, argc, argv);

    // One core draws. How two or more share a frame is chance, worth a fifth of its time; where
    // the variable is set that number of threads is taken.
    constexpr int keepWhatIsSet = 0;
    setenv("LP_NUM_THREADS", "0", keepWhatIsSet);
    return irsg::bench::run(sections, wanted, options);
}
