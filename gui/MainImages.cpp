#include <algorithm>

#include <QFileInfo>
#include <QTabWidget>

#include "gui/MainWindow.h"
#include "gui/Sentences.h"
#include "gui/Theme.h"
#include "gui/analysis/ResultsDock.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImageView.h"
#include "gui/plot/ResultPlot.h"
#include "gui/project/ProjectFiles.h"
#include "irsg/image/ImageFile.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/Conditions.h"

namespace smat::gui {
namespace {

/// The band that an image names, where it is a range of wavelengths.
std::optional<irsg::Band> bandOf(const irsg::RadianceImage& image) {
    const auto low = image.attributes.find("band.min_um"),
               high = image.attributes.find("band.max_um"),
               name = image.attributes.find("band.name");
    if (low == image.attributes.end() || high == image.attributes.end() ||
        name == image.attributes.end())
        return std::nullopt;
    try {
        const irsg::Band band = irsg::Band::fromText(low->second + "-" + high->second);
        // A sampled response has a name of its own and is not told by its ends.
        return band.name() == name->second ? std::optional(band) : std::nullopt;
    } catch (const irsg::InputError&) {
        return std::nullopt;
    }
}

} // namespace

bool MainWindow::areImages(const QStringList& files) {
    if (files.isEmpty() || files.size() > 2)
        return false;
    return std::ranges::all_of(files, [&](const QString& file) {
        const QString suffix = QFileInfo(file).suffix().toLower();
        if (suffix == "exr")
            return true;
        const bool mayBeMatrix =
            suffix == "txt" || suffix == "dat" || (suffix == "csv" && files.size() == 2);
        return mayBeMatrix && irsg::holdsImage(file.toStdString());
    });
}

void MainWindow::openFiles(const QStringList& files) {
    if (areImages(files)) {
        openImages(files);
        return;
    }
    const std::size_t before = workbench_.results().size();
    for (const QString& file : files)
        openOther(file.toStdString());
    overlayResultsFrom(before);
}

bool MainWindow::begin(const std::filesystem::path& file) {
    const QString suffix = QString::fromStdString(file.extension().string()).mid(1).toLower();
    const bool needsNoProject =
        std::any_of(openers_.begin(), openers_.end(),
                    [&](const auto& opener) { return opener.first.contains(suffix); });
    if (!needsNoProject)
        return files_->begin(file);
    // An image or a result stands beside whatever project there is.
    files_->begin({});
    openFiles({QString::fromStdString(file.string())});
    return true;
}

void MainWindow::openOther(const std::filesystem::path& file) {
    const QString suffix = QString::fromStdString(file.extension().string()).mid(1).toLower();
    bool known = false;
    for (const auto& [suffixes, opener] : openers_) {
        known = known || suffixes.contains(suffix);
        if (suffixes.contains(suffix) && opener(file))
            return;
    }
    if (!known)
        open(file);
}

void MainWindow::overlayResultsFrom(std::size_t first) {
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
        emit results_->showRequested(plots);
}

void MainWindow::chooseFile() {
    const QString models = ProjectFiles::modelPatterns(), images = readableImagePatterns();
    const QString file = dialogs_.openFile(
        this, tr("Open a project, a model, a result or an image"),
        {tr("All that can be opened (%1)").arg("*.smat " + models + " *.json " + images),
         tr("Projects (*.smat)"), tr("Models (%1)").arg(models), tr("Results (*.csv *.json *.exr)"),
         tr("Images (%1)").arg(images), tr("All files (*)")});
    if (!file.isEmpty())
        openFiles({file});
}

ComparisonWindow* MainWindow::compareResults(int a, int b) {
    const ResultEntry* const first = workbench_.result(a);
    const ResultEntry* const second = workbench_.result(b);
    if (first == nullptr || second == nullptr || !first->isImage() || !second->isImage())
        return nullptr;
    auto* page = compareImages();
    const auto sideOf = [](const ResultEntry& entry) {
        return ComparisonSide{entry.image(), entry.title,
                              QString::fromStdString(entry.file.string())};
    };
    page->setSides(sideOf(*first), sideOf(*second));
    return page;
}

ComparisonWindow* MainWindow::compareImages(const QStringList& files) {
    auto* page = new ComparisonWindow(nullptr, dialogs_);
    addPage(page, icon("compare"), tr("Compare images"));
    connect(page, &ComparisonWindow::titleChanged, this, [this, page](const QString& title) {
        tabs_->setTabText(tabs_->indexOf(page), title);
        refreshActions();
    });
    connect(page, &ComparisonWindow::nothingRead, page, &QObject::deleteLater);
    if (!files.isEmpty())
        page->openFiles(files);
    return page;
}

void MainWindow::openImages(const QStringList& files) {
    if (files.size() == 2) {
        compareImages(files);
        return;
    }
    using Image = std::shared_ptr<const irsg::RadianceImage>;
    imageTask_.run<Image>(
        [file = files.front()] {
            return std::make_shared<const irsg::RadianceImage>(
                irsg::readImageFile(file.toStdString()));
        },
        [this, file = files.front()](const Image& image) {
            auto* view = new ImageView(nullptr, dialogs_);
            view->setAutoFillBackground(true);
            view->setBackgroundRole(QPalette::Window);
            view->setTitle(QFileInfo(file).completeBaseName());
            view->setImage(image, bandOf(*image));
            view->setConditions(QString::fromStdString(lineOf(conditionsOf(*image))));
            addPage(view, icon("image"), QFileInfo(file).fileName());
        },
        [this](const std::exception_ptr& thrown) {
            dialogs_.tell(this, tr("This image cannot be read"), sentencesOf(thrown));
        });
}

} // namespace smat::gui
