#include <QFileInfo>
#include <QTabWidget>

#include "gui/MainWindow.h"
#include "gui/Sentences.h"
#include "gui/Theme.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageView.h"
#include "irsg/image/ImageFile.h"
#include "irsg/radiometry/Errors.h"

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
    for (const QString& file : files) {
        const QString suffix = QFileInfo(file).suffix().toLower();
        // A table of a result may be .csv as well; two of them at once are images.
        if (suffix != "exr" && !(files.size() == 2 && (suffix == "csv" || suffix == "txt")))
            return false;
    }
    return true;
}

ComparisonWindow* MainWindow::compareResults(int a, int b) {
    const ResultEntry* const first = workbench_.result(a);
    const ResultEntry* const second = workbench_.result(b);
    if (first == nullptr || second == nullptr || !first->isImage() || !second->isImage())
        return nullptr;
    auto* page = compareImages();
    page->setSides({first->image(), first->title}, {second->image(), second->title});
    return page;
}

ComparisonWindow* MainWindow::compareImages(const QStringList& files) {
    auto* page = new ComparisonWindow(nullptr, dialogs_);
    addPage(page, icon("compare"), tr("Compare images"));
    connect(page, &ComparisonWindow::titleChanged, this, [this, page](const QString& title) {
        tabs_->setTabText(tabs_->indexOf(page), title);
        refreshActions();
    });
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
            addPage(view, icon("image"), QFileInfo(file).fileName());
        },
        [this](const std::exception_ptr& thrown) {
            dialogs_.tell(this, tr("This image cannot be read"), sentencesOf(thrown));
        });
}

} // namespace smat::gui
