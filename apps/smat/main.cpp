#include <algorithm>
#include <array>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QApplication>

#include "apps/UnknownArguments.h"
#include "apps/smat/PlotCommand.h"
#include "gui/MainWindow.h"
#include "gui/Shutdown.h"
#include "gui/settings/Preferences.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WheelGuard.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FreedMemory.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/core/Wording.h"
#include "smatcore/data/Provenance.h"
#include "smatcore/data/RenderDoor.h"
#include "smatcore/support/NearestNames.h"

namespace {

constexpr int inputRefused = 2;
constexpr int ourFault = 3;

/// Qt takes the locale of the desktop, in which a decimal point may be a comma. What Qt shows
/// follows QLocale; all other numbers have points.
void keepDecimalPoints() {
    std::setlocale(LC_NUMERIC, "C");
}

int runPlot(const smat::PlotRequest& request, int argc, char** argv) {
    // Plots are painted, not drawn by OpenGL: they need no display at all.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    keepDecimalPoints();
    smat::gui::applyTheme(application, smat::gui::ThemeMode::light);
    smat::plot(request);
    return EXIT_SUCCESS;
}

bool isSet(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

/// A fault in what an event sets off is told, and the window goes on.
class Application : public QApplication {
  public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override {
        try {
            return QApplication::notify(receiver, event);
        } catch (const std::exception& error) {
            std::cerr << "smat: internal error: " << error.what() << '\n';
            if (window != nullptr)
                window->tellInternalError(error.what());
            return false;
        }
    }
    smat::gui::MainWindow* window = nullptr;
};

int runMainWindow(Application& application, smat::gui::Workbench& workbench,
                  const std::string& file) {
    smat::gui::MainWindow window(workbench);
    application.window = &window;
    window.show();
    window.begin(file);
    const int code = QApplication::exec();
    application.window = nullptr;
    return code;
}

int runWindow(const std::string& file, std::optional<smat::gui::ThemeMode> theme, int argc,
              char** argv) {
    if (!isSet("DISPLAY") && !isSet("WAYLAND_DISPLAY") && !isSet("QT_QPA_PLATFORM"))
        throw irsg::InputError({"smat", "", "no display",
                                "a desktop (DISPLAY or WAYLAND_DISPLAY); "
                                "without one, smat plot and smat-batch do the work"});
    Application application(argc, argv);
    keepDecimalPoints();
    QApplication::setApplicationName("smat");
    smat::gui::applyTheme(application, theme.value_or(smat::gui::Preferences::load().theme));
    application.installEventFilter(new smat::gui::WheelGuard(&application));
    smat::gui::Workbench workbench;
    const int code = runMainWindow(application, workbench, file);
    smat::gui::shutDown(workbench, code);
    return code;
}

/// No value for no word. Throws InputError for one that is none.
std::optional<smat::gui::ThemeMode> themeOf(const std::string& word) {
    using smat::gui::ThemeMode;
    const std::vector<std::string> words = {"system", "light", "dark"};
    const auto found = std::ranges::find(words, word);
    if (word.empty())
        return std::nullopt;
    if (found == words.end()) {
        throw irsg::InputError(
            {"--theme", "", word, irsg::alternatives(words) + smat::didYouMean(word, words)});
    }
    return std::array{ThemeMode::system, ThemeMode::light, ThemeMode::dark}.at(
        static_cast<std::size_t>(found - words.begin()));
}

/// Version with the GL renderer, where this machine has one.
std::string versionText() {
    std::string renderer;
    try {
        renderer = smat::openRenderDoor().description(irsg::Scene());
    } catch (const irsg::InputError& error) {
        renderer = error.diagnostics().front().message();
    }
    return irsg::programWithVersion() + "\nrenderer: " + renderer + "\nQt " + qVersion();
}

} // namespace

int main(int argc, char** argv) {
    // A file that grows beyond what is allowed is refused in words.
    std::signal(SIGXFSZ, SIG_IGN);
    irsg::keepFreedMemory();
    CLI::App cli{"SMAT, the infrared signature modelling workbench", "smat"};
    cli.set_version_flag("--version", versionText);
    std::string file;
    cli.add_option("file", file, "A .smat project, or a model, to open in the workbench");
    std::string theme;
    cli.add_option(
        "--theme", theme,
        "Colours of the window: system, light or dark; those of the preferences without");

    smat::PlotRequest request;
    auto* plot = cli.add_subcommand("plot", "Draws results into a file, without a display");
    plot->add_option("results", request.results, "Results (CSV or JSON) to overlay")->required();
    plot->add_option("-o,--out", request.output, "File to write: .svg, .pdf, .png or .csv")
        ->required();
    plot->add_option("--quantity", request.quantity,
                     "Column to draw, contrast_intensity where there is one");
    plot->add_flag("--log-x", request.logX, "Logarithmic abscissa");
    plot->add_flag("--log-y", request.logY, "Logarithmic ordinate");
    plot->add_flag("--db", request.decibel,
                   "Decibel radius of a polar plot, decibels of a signature table");
    plot->add_option("--at", request.at,
                     "Of a signature table the range or state that is drawn, such as range=3000; "
                     "may be given more than once")
        ->expected(1)
        ->take_all();

    try {
        cli.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return cli.exit(help);
    } catch (const CLI::ParseError& error) {
        std::cerr << "smat: "
                  << smat::unknownArgument(cli, {argv + 1, argv + argc})
                         .value_or(std::string(error.what()) + " (smat --help lists the options)")
                  << '\n';
        return inputRefused;
    }
    try {
        return plot->parsed() ? runPlot(request, argc, argv)
                              : runWindow(file, themeOf(theme), argc, argv);
    } catch (const irsg::InputError& error) {
        for (const auto& diagnostic : error.diagnostics())
            std::cerr << "smat: " << diagnostic.message() << '\n';
        return inputRefused;
    } catch (const std::exception& error) {
        std::cerr << "smat: internal error: " << error.what() << '\n';
        return ourFault;
    }
}
