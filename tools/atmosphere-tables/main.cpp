// atmosphere-tables KIND... --data FOLDER --out FOLDER computes the tables of resources/atmosphere
// from public line lists and the numbers of LOWTRAN 7, and prints the recipe of each.

#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/Command.h"

int main(int argc, char** argv) {
    using namespace smat::tables;
    const std::vector<std::pair<std::string, void (*)(const Folders&)>> kinds = {
        {"profiles", makeProfiles},   {"particles", makeParticles},
        {"solar", makeSolarSpectrum}, {"continuum", makeContinuum},
        {"gases", makeGases},         {"truth", makeTruth},
        {"study", makeStudy},         {"plumes", makePlumes},
        {"hotgas", makeHotGas},       {"hotgas-samples", makeHotGasSamples}};
    const std::vector<std::string> onlyIfNamed = {"truth", "study", "plumes", "hotgas",
                                                  "hotgas-samples"};

    CLI::App app{"Computes the tables of the atmosphere from public data."};
    Folders folders;
    std::vector<std::string> wanted;
    app.add_option("kinds", wanted,
                   "profiles, particles, solar, continuum, gases, truth, study, plumes, hotgas, "
                   "hotgas-samples; none: "
                   "all but the last five");
    app.add_option("--data", folders.data,
                   "folder with lines/, lowtran/, continuum/, profiles/, solar/")
        ->required();
    app.add_option("--out", folders.out, "output folder; for plumes, the folder samples")
        ->required();
    app.add_option("--renew", folders.renew_per_cm,
                   "for gases, FROM TO in cm-1, may be repeated: computes the pieces of 60 cm-1 "
                   "that touch this range and keeps the others of the table in the folder");
    app.add_option("--measure", folders.measure_per_cm,
                   "for gases, FROM TO in cm-1, may be repeated: computes the errors of the pieces "
                   "that touch this range, which the header states, and keeps the pieces");
    CLI11_PARSE(app, argc, argv);

    try {
        for (const std::string& name : wanted)
            if (std::ranges::none_of(kinds, [&](const auto& kind) { return kind.first == name; }))
                throw irsg::InputError(
                    irsg::Diagnostic{"command line", "", name,
                                     "profiles, particles, solar, continuum, "
                                     "gases, truth, study, plumes, hotgas or hotgas-samples"});
        for (const auto& [name, make] : kinds)
            if ((wanted.empty() && std::ranges::find(onlyIfNamed, name) == onlyIfNamed.end()) ||
                std::ranges::find(wanted, name) != wanted.end())
                make(folders);
    } catch (const irsg::InputError& error) {
        std::cerr << error.what() << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 3;
    }
    return 0;
}
