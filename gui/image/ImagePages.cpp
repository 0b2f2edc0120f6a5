#include "gui/image/ImagePages.h"

#include <algorithm>

#include <QFileInfo>

#include "gui/image/ChosenImage.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageView.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/image/ImageFile.h"
#include "irsg/image/ImageFormat.h"
#include "smatcore/analysis/AnalysisOfResult.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/analysis/PixelExplainer.h"

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

ImagePages::ImagePages(const Workbench& workbench, Dialogs& dialogs, PageTabs& tabs)
    : QObject(&tabs), workbench_(workbench), dialogs_(dialogs), tabs_(tabs) {}

bool ImagePages::areImages(const QStringList& files) {
    if (files.isEmpty() || files.size() > 2)
        return false;
    return std::ranges::all_of(files, [&](const QString& name) {
        const std::filesystem::path file = name.toStdString();
        const irsg::ImageFormat* format = irsg::readableImageFormatOf(file);
        if (format == nullptr || !format->isText)
            return format != nullptr;
        const bool isOfOurs = std::ranges::count(format->extensionList(),
                                                 irsg::lowerCase(file.extension().string())) > 0;
        return (files.size() == 2 || !isOfOurs) && irsg::holdsImage(file);
    });
}

std::vector<Project> ImagePages::openProjects() const {
    return workbench_.hasProject() ? std::vector<Project>{workbench_.project()}
                                   : std::vector<Project>{};
}

ComparisonWindow* ImagePages::compareResults(int a, int b) {
    const ResultEntry* const first = workbench_.result(a);
    const ResultEntry* const second = workbench_.result(b);
    if (first == nullptr || second == nullptr || !first->isImage() || !second->isImage())
        return nullptr;
    auto* page = compare();
    const auto sideOf = [](const ResultEntry& entry) {
        return ComparisonSide{entry.image(), entry.title,
                              QString::fromStdString(entry.file.string())};
    };
    page->setSides(sideOf(*first), sideOf(*second));
    return page;
}

ComparisonWindow* ImagePages::compare(const QStringList& files) {
    auto* page = new ComparisonWindow(nullptr, dialogs_);
    tabs_.addPage(page, icon("compare"), tr("Compare images"));
    connect(page, &ComparisonWindow::titleChanged, &tabs_,
            [this, page](const QString& title) { tabs_.retitle(page, title); });
    connect(page, &ComparisonWindow::nothingRead, page, &QObject::deleteLater);
    if (!files.isEmpty())
        page->openFiles(files);
    return page;
}

void ImagePages::open(const QStringList& files) {
    if (files.size() == 2) {
        compare(files);
        return;
    }
    using Image = std::shared_ptr<const irsg::RadianceImage>;
    task_.run<Image>(
        [file = files.front(), what = chosenImage(dialogs_, tabs_.window(), files.front())] {
            return std::make_shared<const irsg::RadianceImage>(
                irsg::readImageFile(file.toStdString(), what));
        },
        [this, file = files.front()](const Image& image) {
            auto* view = new ImageView(nullptr, dialogs_);
            view->setAutoFillBackground(true);
            view->setBackgroundRole(QPalette::Window);
            view->setTitle(QFileInfo(file).completeBaseName());
            view->setImage(image, bandOf(*image));
            // Why not, where the file does not say enough, is told when somebody asks.
            view->setExplainer([this, image, file]() -> PixelPanel::Work {
                return [image, path = std::filesystem::path(file.toStdString()),
                        open = openProjects(), models = workbench_.models()] {
                    return std::make_shared<PixelExplainer>(analysisOfImage(*image, path, open),
                                                            ModelStore::loader(models));
                };
            });
            view->setConditions(QString::fromStdString(lineOf(conditionsOf(*image))));
            tabs_.addPage(view, icon("image"), QFileInfo(file).fileName());
        },
        [this](const std::exception_ptr& thrown) {
            dialogs_.tell(tabs_.window(), tr("This image cannot be read"), sentencesOf(thrown));
        });
}

} // namespace smat::gui

#include "moc_ImagePages.cpp"
