#include "gui/FileOpening.h"

#include <algorithm>

#include <QWidget>

#include "gui/analysis/ResultsDock.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImagePages.h"
#include "gui/plot/ResultPlot.h"
#include "gui/project/ProjectFiles.h"
#include "gui/scenario/ScenarioPages.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/analysis/ResultFile.h"

namespace smat::gui {

FileOpening::FileOpening(QWidget* window, const Workbench& workbench, Dialogs& dialogs,
                         ProjectFiles& projects, ImagePages& images, ResultsDock& results,
                         ScenarioPages& scenarios)
    : QObject(window),
      window_(window),
      workbench_(workbench),
      dialogs_(dialogs),
      projects_(projects),
      images_(images),
      results_(results) {
    openWith({"json"},
             [&scenarios](const std::filesystem::path& file) { return scenarios.open(file); });
    QStringList ofResults;
    for (const std::string& extension : readableResultExtensions())
        ofResults << QString::fromStdString(extension).mid(1);
    openWith(ofResults,
             [this](const std::filesystem::path& file) { return results_.openResult(file); });
}

void FileOpening::openWith(const QStringList& suffixes, Opener opener) {
    openers_.emplace_back(suffixes, std::move(opener));
}

void FileOpening::open(const QStringList& files) {
    if (ImagePages::areImages(files)) {
        images_.open(files);
        return;
    }
    const std::size_t before = workbench_.results().size();
    for (const QString& file : files)
        openOther(file.toStdString());
    overlayResultsFrom(before);
}

bool FileOpening::begin(const std::filesystem::path& file) {
    const QString suffix = QString::fromStdString(file.extension().string()).mid(1).toLower();
    const bool needsNoProject =
        std::any_of(openers_.begin(), openers_.end(),
                    [&](const auto& opener) { return opener.first.contains(suffix); });
    if (!needsNoProject)
        return projects_.begin(file);
    // An image or a result stands beside whatever project there is.
    projects_.begin({});
    open({QString::fromStdString(file.string())});
    return true;
}

void FileOpening::openOther(const std::filesystem::path& file) {
    const QString suffix = QString::fromStdString(file.extension().string()).mid(1).toLower();
    bool known = false;
    for (const auto& [suffixes, opener] : openers_) {
        known = known || suffixes.contains(suffix);
        if (suffixes.contains(suffix) && opener(file))
            return;
    }
    if (!known)
        projects_.open(file);
}

void FileOpening::overlayResultsFrom(std::size_t first) {
    const auto& results = workbench_.results();
    QList<int> plots;
    const ResultTable* one = nullptr;
    for (std::size_t i = first; i < results.size(); ++i) {
        const ResultTable& table = results[i].data->table;
        if (results[i].isImage() || (one != nullptr && !goOnOnePlot(*one, table)))
            return; // nobody asked for a plot that there cannot be
        one = &table;
        plots << results[i].id;
    }
    if (plots.size() > 1)
        emit results_.showRequested(plots);
}

void FileOpening::choose() {
    const QString models = ProjectFiles::modelPatterns(), images = readableImagePatterns();
    const QString file = dialogs_.openFile(
        window_, tr("Open a project, a model, a scenario, an atmosphere, a result or an image"),
        {tr("All that can be opened (%1)").arg("*.smat " + models + " *.json *.xml " + images),
         tr("Projects (*.smat)"), tr("Models (%1)").arg(models), tr("Scenarios (*.json)"),
         tr("Air (*.xml)"), tr("Results (%1)").arg(readableResultPatterns()),
         tr("Images (%1)").arg(images), tr("All files (*)")});
    if (!file.isEmpty())
        open({file});
}

} // namespace smat::gui

#include "moc_FileOpening.cpp"
