// smat-screenshots --out FOLDER --project FILE [--image FILE FILE] [--wanted NAME...]
// [--dark] [--without-gl | --first-steps | --spectra] keeps a picture of every window and dialog of
// the workbench. It needs a display; scripts/screenshots gives it one.

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QStandardPaths>

#include "gui/widgets/Theme.h"
#include "tools/screenshots/ScreenshotTaker.h"

int main(int argc, char** argv) {
    CLI::App cli{"Keeps a picture of every window and dialog of the workbench"};
    std::filesystem::path folder, project;
    std::vector<std::string> images, wanted;
    bool dark = false, withoutGl = false, firstSteps = false, spectra = false;
    cli.add_option("--out", folder, "Folder for the pictures")->required();
    cli.add_option("--project", project, "Project that is open in them")
        ->required()
        ->check(CLI::ExistingFile);
    cli.add_option("--image", images, "The two images that are compared")
        ->expected(2)
        ->check(CLI::ExistingFile);
    cli.add_option("--wanted", wanted, "Names of the pictures that are wanted (default: all)");
    cli.add_flag("--dark", dark, "In dark colours");
    cli.add_flag("--without-gl", withoutGl, "Only the main window, on a display without OpenGL");
    cli.add_flag("--first-steps", firstSteps, "Only those of the guide's first chapter");
    cli.add_flag("--spectra", spectra, "Only the tab of spectra of the editor of databases");
    CLI11_PARSE(cli, argc, argv);

    // Nothing of the user's own preferences shows in the pictures or is changed by them.
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(argc, argv);
    QApplication::setApplicationName("smat-screenshots");
    QApplication::setOrganizationName("smat-screenshots");
    smat::gui::applyTheme(application,
                          dark ? smat::gui::ThemeMode::dark : smat::gui::ThemeMode::light);
    QStringList names, pictures;
    for (const std::string& picture : wanted)
        pictures << QString::fromStdString(picture);
    for (const std::string& image : images)
        names << QString::fromStdString(image);
    smat::gui::ScreenshotTaker screenshotTaker(folder, project, names, pictures);
    const QStringList problems = withoutGl    ? screenshotTaker.takeWithoutGl()
                                 : firstSteps ? screenshotTaker.takeFirstSteps()
                                 : spectra    ? screenshotTaker.takeSpectra()
                                              : screenshotTaker.takeAll();
    for (const QString& problem : problems)
        std::cerr << "smat-screenshots: " << problem.toStdString() << '\n';
    return problems.isEmpty() ? 0 : 1;
}
