#include "gui/image/ComparisonWindow.h"

#include <algorithm>

#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QPointer>

#include "gui/Readable.h"
#include "gui/Sentences.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ThresholdForm.h"
#include "irsg/image/ComparisonFigures.h"
#include "irsg/image/ImageFile.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/support/ShellText.h"

namespace smat::gui {
namespace {

QString quoted(const QString& word) {
    return QString::fromStdString(shellQuoted(word.toStdString()));
}

/// The first thing that is wrong with a file, and how much more there is.
QString sentenceOf(const irsg::InputError& error) {
    const QStringList all = sentencesOf(error);
    return all.size() == 1
               ? all.front()
               : ComparisonWindow::tr("%1 (and %2 more)").arg(all.front()).arg(all.size() - 1);
}

} // namespace

ComparisonWindow::Reading ComparisonWindow::readingOf(const QStringList& files) {
    Reading reading;
    for (const QString& file : files) {
        try {
            reading.sides.push_back(
                ComparisonSide::of(irsg::readImageFile(file.toStdString()), file));
        } catch (const irsg::InputError& error) {
            reading.sides.emplace_back();
            reading.wrong << sentenceOf(error);
        }
    }
    return reading;
}

ComparisonWindow::ComparisonWindow(QWidget* parent, Dialogs dialogs)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    build();
    onSidesChanged();
}

ComparisonWindow::ComparisonWindow(ComparisonSide a, ComparisonSide b, QWidget* parent,
                                   Dialogs dialogs)
    : QWidget(parent), dialogs_(std::move(dialogs)), sides_{std::move(a), std::move(b)} {
    build();
    onSidesChanged();
}

ComparisonWindow::~ComparisonWindow() = default;

void ComparisonWindow::setSides(ComparisonSide a, ComparisonSide b) {
    sides_ = {std::move(a), std::move(b)};
    onSidesChanged();
}

void ComparisonWindow::swapSides() {
    std::swap(sides_[0], sides_[1]);
    onSidesChanged();
}

void ComparisonWindow::openFiles(const QStringList& files, std::optional<int> side) {
    if (files.isEmpty() || files.size() > 2) {
        dialogs_.tell(this, tr("These files cannot be compared"),
                      {tr("Two images are compared, or one takes the place of A or B; these are %1 "
                          "files.")
                           .arg(files.size())});
        return;
    }
    const int first = files.size() == 2 ? 0 : side.value_or(sides_[0].image && !sides_[1].image);
    readout_->setText(tr("Reading %1 …").arg(files.join(tr(" and "))));
    readTask_.run<Reading>([files] { return readingOf(files); },
                           [this, first](Reading reading) { take(std::move(reading), first); });
}

void ComparisonWindow::take(Reading reading, int first) {
    const bool isEmpty = !sides_[0].image && !sides_[1].image;
    if (reading.wrong.isEmpty() || isEmpty) {
        for (std::size_t i = 0; i < reading.sides.size(); ++i)
            if (reading.sides[i].image)
                sides_[static_cast<std::size_t>(first) + i] = std::move(reading.sides[i]);
        onSidesChanged();
    }
    showReadout(pixel_);
    if (reading.wrong.isEmpty())
        return;
    const QPointer<ComparisonWindow> stillThere(this); // a message box lets other things happen
    dialogs_.tell(this,
                  reading.wrong.size() > 1 ? tr("These images cannot be read")
                                           : tr("This image cannot be read"),
                  reading.wrong);
    if (stillThere && !sides_[0].image && !sides_[1].image)
        emit nothingRead();
}

bool ComparisonWindow::isBusy() const {
    return readTask_.isBusy() || compareTask_.isBusy() || partTask_.isBusy() ||
           differenceTask_.isBusy() || panes_->isBusy() || inspector_->isBusy();
}

void ComparisonWindow::onSidesChanged() {
    options_.nameA = sides_[0].name.toStdString();
    options_.nameB = sides_[1].name.toStdString();
    difference_.reset(); // of other images: not shown until the new one is there
    fillPlanes();
    showPlanes();
    const auto shortName = [](const ComparisonSide& side) {
        return side.image ? QFileInfo(side.name).fileName() : QStringLiteral("–");
    };
    emit titleChanged(shortName(sides_[0]) + " | " + shortName(sides_[1]));
}

void ComparisonWindow::fillPlanes() {
    // The usual plane of both under the name of A's, then every other name that both have.
    const QString before = planeChoice();
    plane_->clear();
    const auto& a = sides_[0].image;
    const auto& b = sides_[1].image;
    if (!a || !b)
        return;
    std::string usual;
    try {
        usual = irsg::chosenPlane(*a, "", "A").name;
        const std::string other = irsg::chosenPlane(*b, "", "B").name;
        plane_->addItem(planeTitle(*a->find(usual)) +
                            (usual == other ? QString() : " | " + planeTitle(*b->find(other))),
                        QString());
        usual = usual == other ? usual : std::string();
    } catch (const irsg::InputError&) {
        usual.clear(); // there is no usual one: a name has to be chosen
    }
    for (const auto& channel : a->channels)
        if (b->find(channel.name) != nullptr && channel.name != usual)
            plane_->addItem(planeTitle(channel), QString::fromStdString(channel.name));
    plane_->setCurrentIndex(std::max(plane_->findData(before), 0));
}

QString ComparisonWindow::planeChoice() const {
    return plane_->currentData().toString();
}

const irsg::ImageChannel* ComparisonWindow::planeOf(std::size_t index) const {
    const auto& image = sides_[index].image;
    if (!image)
        return nullptr;
    try {
        return &irsg::chosenPlane(*image, options_.channel, sides_[index].name.toStdString());
    } catch (const irsg::InputError&) {
        return &image->primary(); // to look at; the comparison says what is wrong
    }
}

void ComparisonWindow::showPlanes() {
    options_.channel = planeChoice().toStdString();
    std::array<ComparedPlane, 2> planes;
    QString title;
    for (std::size_t i = 0; i < 2; ++i) {
        const irsg::ImageChannel* plane = planeOf(i);
        planes[i].name = QFileInfo(sides_[i].name).fileName();
        if (plane == nullptr)
            continue;
        planes[i].width = sides_[i].image->width();
        planes[i].height = sides_[i].image->height();
        planes[i].values = shareValues(sides_[i].image, *plane);
        if (title.isEmpty() || planeOf(0)->unit.empty())
            title = titleWithUnit(*plane); // a plain matrix has no unit of its own
    }
    panes_->setPlanes(planes[0], planes[1], title);
    showDifference();
    compare();
}

void ComparisonWindow::showDifference() {
    const irsg::ImageChannel* a = planeOf(0);
    const irsg::ImageChannel* b = planeOf(1);
    differenceTask_.cancel();
    const bool sameSize = a != nullptr && b != nullptr &&
                          sides_[0].image->width() == sides_[1].image->width() &&
                          sides_[0].image->height() == sides_[1].image->height();
    const bool keeps = sameSize && difference_ != nullptr &&
                       difference_->width() == sides_[0].image->width() &&
                       difference_->height() == sides_[0].image->height();
    if (!keeps) {
        difference_.reset();
        panes_->setDifference(nullptr, mode_, {});
        inspector_->clear();
    }
    if (!sameSize)
        return;
    using Image = std::shared_ptr<const irsg::RadianceImage>;
    const auto work = [imageA = sides_[0].image, imageB = sides_[1].image, a, b, mode = mode_] {
        irsg::ImageChannel plane = irsg::differencePlane(*a, *b, mode);
        auto image = std::make_shared<irsg::RadianceImage>(imageA->width(), imageA->height(),
                                                           plane.name, plane.unit);
        image->primary().values = std::move(plane.values);
        return Image(std::move(image));
    };
    if (sides_[0].image->pixelCount() <= quickPixels)
        useDifference(work());
    else
        differenceTask_.run<Image>(work, [this](const Image& image) { useDifference(image); });
}

void ComparisonWindow::useDifference(std::shared_ptr<const irsg::RadianceImage> difference) {
    difference_ = std::move(difference);
    const QString unit = readableUnit(difference_->primary().unit);
    const QString title = differenceName(mode_) + (unit.isEmpty() ? QString() : " (" + unit + ")");
    panes_->setDifference(shareValues(difference_, difference_->primary()), mode_, title);
    inspector_->show(difference_, difference_->primary(), title, unit);
    inspector_->setRectangle(panes_->selection());
    showMarks();
    showReadout(pixel_);
    showVerdict();
}

void ComparisonWindow::setDifferenceMode(irsg::DifferenceMode mode) {
    mode_ = mode;
    modeBox_->setCurrentIndex(static_cast<int>(mode));
    showDifference();
}

ComparisonWindow::Answer ComparisonWindow::work(const irsg::RadianceImage& a,
                                                const irsg::RadianceImage& b,
                                                const irsg::ComparisonOptions& options,
                                                const std::optional<irsg::PixelRectangle>& part) {
    Answer answer;
    answer.whole = irsg::compareImages(a, b, options);
    if (part) {
        irsg::ComparisonOptions ofPart = options;
        ofPart.rectangle = part;
        answer.part = irsg::compareImages(a, b, ofPart);
    }
    const auto& planeA = irsg::chosenPlane(a, options.channel, options.nameA).values;
    const auto& planeB = irsg::chosenPlane(b, options.channel, options.nameB).values;
    answer.marks.resize(planeA.size());
    std::ranges::transform(planeA, planeB, answer.marks.begin(), [&options](float x, float y) {
        const auto verdict =
            irsg::pixelVerdict(static_cast<double>(x), static_cast<double>(y), options);
        return static_cast<std::uint8_t>(
            verdict >= irsg::PixelVerdict::overFail   ? ColoredPlane::failed
            : verdict == irsg::PixelVerdict::overWarn ? ColoredPlane::warned
                                                      : ColoredPlane::unmarked);
    });
    return answer;
}

void ComparisonWindow::compareRectangle() {
    if (!whole_) {
        compare();
        return;
    }
    const auto rectangle = panes_->selection();
    partTask_.cancel();
    if (!rectangle) {
        use(whole_, std::nullopt);
        return;
    }
    irsg::ComparisonOptions options = options_;
    options.rectangle = rectangle;
    const auto work = [a = sides_[0].image, b = sides_[1].image, options] {
        return irsg::compareImages(*a, *b, options);
    };
    const auto pixels =
        static_cast<std::size_t>(rectangle->width) * static_cast<std::size_t>(rectangle->height);
    if (pixels <= quickPixels)
        use(whole_, work());
    else
        partTask_.run<irsg::Comparison>(
            work, [this](const irsg::Comparison& part) { use(whole_, part); });
}

void ComparisonWindow::compare() {
    compareTask_.cancel();
    partTask_.cancel();
    const auto a = sides_[0].image, b = sides_[1].image;
    whole_.reset();
    part_.reset();
    marks_.clear();
    refusal_.clear();
    if (!a || !b) {
        showVerdict();
        return;
    }
    const auto refuse = [this](const std::exception_ptr& thrown) {
        refusal_ = sentencesOf(thrown).join('\n');
        showVerdict();
    };
    if (a->pixelCount() <= quickPixels) {
        try {
            take(work(*a, *b, options_, panes_->selection()));
        } catch (const irsg::InputError&) {
            refuse(std::current_exception());
        }
        return;
    }
    compareTask_.run<Answer>([a, b, options = options_,
                              part = panes_->selection()] { return work(*a, *b, options, part); },
                             [this](Answer answer) { take(std::move(answer)); }, refuse);
    showVerdict();
}

void ComparisonWindow::goToWorstPixel() {
    const auto& compared = part_ ? part_ : whole_;
    if (compared && compared->largest.x >= 0)
        panes_->goTo({compared->largest.x, compared->largest.y});
}

QString ComparisonWindow::commandLine() const {
    if (sides_[0].file.isEmpty() || sides_[1].file.isEmpty())
        return {};
    QString text = "smat-batch compare " + quoted(sides_[0].file) + " " + quoted(sides_[1].file);
    if (!options_.channel.empty())
        text += " --channel " + quoted(QString::fromStdString(options_.channel));
    text += thresholds_->options();
    if (const auto part = panes_->selection())
        text += QStringLiteral(" --rectangle %1,%2,%3,%4")
                    .arg(part->x)
                    .arg(part->y)
                    .arg(part->width)
                    .arg(part->height);
    return text;
}

QStringList ComparisonWindow::exportFilters() const {
    if (!whole_)
        return {};
    return imageFilters();
}

void ComparisonWindow::exportTo(const std::filesystem::path& file) const {
    if (!whole_)
        throw irsg::InputError({file.string(), "", "no comparison", "two images of one size"});
    const irsg::RadianceImage image =
        irsg::differenceImage(*sides_[0].image, *sides_[1].image, *whole_, options_, mode_);
    if (irsg::requiredImageFormat(file).keeps == irsg::ImageFormat::Keeps::picture)
        writePicture(pictureOfDifference(image), file);
    else
        exportImage(image, image.primary().name, {}, file);
}

void ComparisonWindow::askAndExport(const QString& filter) {
    const QString suffix = filter.section("*", -1).chopped(1);
    const QString file =
        dialogs_.saveFile(this, tr("Export the difference"), {filter}, tr("difference") + suffix);
    if (file.isEmpty())
        return;
    try {
        exportTo(file.toStdString());
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("The difference cannot be written"), sentencesOf(error));
    }
}

void ComparisonWindow::askForFile(int side) {
    const QString file =
        dialogs_.openFile(this, side == 0 ? tr("Open image A") : tr("Open image B"),
                          {tr("Images (%1)").arg(readableImagePatterns()), tr("All files (*)")});
    if (!file.isEmpty())
        openFiles({file}, side);
}

} // namespace smat::gui
