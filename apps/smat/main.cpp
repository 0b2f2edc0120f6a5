#include <cstdlib>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <QApplication>

#include "apps/smat/PlotCommand.h"
#include "gui/Theme.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/data/Provenance.h"

namespace {

constexpr int inputRefused = 2;
constexpr int ourFault = 3;

int runPlot(const smat::PlotRequest& request, int argc, char** argv) {
    // Plots are painted, not drawn by OpenGL: they need no display at all.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    smat::gui::applyTheme(application, smat::gui::ThemeMode::light);
    smat::plot(request);
    return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App cli{"SMAT, the infrared signature modelling workbench"};
    cli.set_version_flag("--version", "smat " + smat::programVersion());
    cli.require_subcommand(1);

    smat::PlotRequest request;
    auto* plot = cli.add_subcommand("plot", "Draws results into a file, without a display");
    plot->add_option("results", request.results, "Results (CSV or JSON) to overlay")->required();
    plot->add_option("-o,--out", request.output, "File to write: .svg, .pdf, .png or .csv")
        ->required();
    plot->add_option("--quantity", request.quantity,
                     "Column to draw, contrast_intensity where there is one");
    plot->add_flag("--log-x", request.logX, "Logarithmic abscissa");
    plot->add_flag("--log-y", request.logY, "Logarithmic ordinate");
    plot->add_flag("--db", request.decibel, "Decibel radius of a polar plot");

    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return cli.exit(error) == 0 ? EXIT_SUCCESS : inputRefused;
    }
    try {
        return runPlot(request, argc, argv);
    } catch (const irsg::InputError& error) {
        for (const auto& offence : error.offences())
            std::cerr << "smat: " << offence.message() << '\n';
        return inputRefused;
    } catch (const std::exception& error) {
        std::cerr << "smat: internal error: " << error.what() << '\n';
        return ourFault;
    }
}
