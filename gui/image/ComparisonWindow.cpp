#include "gui/image/ComparisonWindow.h"

#include <algorithm>
#include <array>

#include <QClipboard>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QVBoxLayout>

#include "gui/image/ComparisonBar.h"
#include "gui/image/ComparisonCommand.h"
#include "gui/image/ComparisonFiles.h"
#include "gui/image/ComparisonKeys.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonReport.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/PaperPicture.h"
#include "gui/image/ShownImage.h"
#include "gui/image/ThresholdForm.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/support/ShellText.h"

namespace smat::gui {
namespace {

QString quoted(const QString& word) {
    return QString::fromStdString(shellQuoted(word.toStdString()));
}

} // namespace

ComparisonWindow::ComparisonWindow(QWidget* parent, Dialogs dialogs)
    : ComparisonWindow({}, {}, parent, std::move(dialogs)) {}

ComparisonWindow::ComparisonWindow(ComparisonSide a, ComparisonSide b, QWidget* parent,
                                   Dialogs dialogs)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    build();
    setSides(std::move(a), std::move(b));
}

ComparisonWindow::~ComparisonWindow() {
    delete keys_; // nothing that happens to images that go is for it
}

void ComparisonWindow::build() {
    setObjectName("comparisonWindow");
    setAcceptDrops(true);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window); // so that its fields stand out in the dark, too
    pair_ = new ComparedPair(this);
    panes_ = new ComparisonPanes(this);
    report_ = new ComparisonReport(this);
    panes_->setCompanion(report_);
    bar_ = new ComparisonBar(panes_->wipeControl(), this);
    readout_ = new QLabel(this);
    readout_->setObjectName("comparisonReadout");
    readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 8);
    column->setSpacing(6);
    column->addWidget(bar_);
    column->addWidget(panes_, 1);
    column->addWidget(readout_);
    files_ = new ComparisonFiles(*pair_, dialogs_, this);
    keys_ = new ComparisonKeys(this, *bar_, *panes_, *report_);
    connectBar();
    connectParts();
}

void ComparisonWindow::connectBar() {
    connect(bar_, &ComparisonBar::openWanted, files_, &ComparisonFiles::ask);
    connect(bar_, &ComparisonBar::swapWanted, this, &ComparisonWindow::swapSides);
    connect(bar_, &ComparisonBar::planeChosen, this, &ComparisonWindow::showPlanes);
    connect(bar_, &ComparisonBar::colorsChosen, panes_, &ComparisonPanes::setColorMap);
    connect(bar_, &ComparisonBar::modeChosen, this, &ComparisonWindow::setDifferenceMode);
    connect(bar_, &ComparisonBar::marksToggled, this, &ComparisonWindow::showMarks);
    connect(bar_, &ComparisonBar::worstWanted, this, &ComparisonWindow::goToWorstPixel);
    connect(bar_, &ComparisonBar::numbersWanted, numbers(), &FiguresTable::copy);
    connect(bar_, &ComparisonBar::pictureWanted, this, &ComparisonWindow::copyPicture);
    connect(bar_, &ComparisonBar::commandWanted, report_->command(), &ComparisonCommand::copy);
    connect(bar_, &ComparisonBar::exportWanted, this, &ComparisonWindow::askAndExport);
    connect(bar_, &ComparisonBar::fitWanted, panes_, &ComparisonPanes::fit);
    connect(bar_, &ComparisonBar::actualSizeWanted, panes_, &ComparisonPanes::showActualSize);
}

void ComparisonWindow::connectParts() {
    connect(files_, &ComparisonFiles::begun, this, [this](const QStringList& files) {
        readout_->setText(tr("Reading %1 …").arg(files.join(tr(" and "))));
    });
    connect(files_, &ComparisonFiles::read, this, &ComparisonWindow::setSides);
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this, [this] {
        if (pair_->hasAny())
            showPlanes();
        report_->show(*pair_);
        showReadout(pixel_);
    });
    connect(files_, &ComparisonFiles::ended, this, [this] { showReadout(pixel_); });
    connect(files_, &ComparisonFiles::nothingRead, this, &ComparisonWindow::nothingRead);
    connect(pair_, &ComparedPair::differenceFound, this, &ComparisonWindow::showDifference);
    connect(pair_, &ComparedPair::compared, this, &ComparisonWindow::showFigures);
    connect(pair_, &ComparedPair::marksFound, this, &ComparisonWindow::showMarks);
    connect(thresholds(), &ThresholdForm::changed, this, [this] {
        pair_->setThresholds(thresholds()->fail(), thresholds()->warn());
        pair_->compare(panes_->selection());
    });
    connect(panes_, &ComparisonPanes::hovered, this, &ComparisonWindow::showReadout);
    connect(panes_, &ComparisonPanes::selectionChanged, this, [this] {
        report_->inspector()->setRectangle(panes_->selection());
        pair_->compareRectangle(panes_->selection());
    });
    connect(panes_, &ComparisonPanes::differenceLimitsFound, report_->inspector(),
            &ImageInspector::setLimits);
}

ThresholdForm* ComparisonWindow::thresholds() const {
    return report_->thresholds();
}

FiguresTable* ComparisonWindow::numbers() const {
    return report_->numbers();
}

void ComparisonWindow::setSides(ComparisonSide a, ComparisonSide b) {
    pair_->setSides(std::move(a), std::move(b));
    bar_->offerPlanes(*pair_);
    showPlanes();
    const auto shortName = [](const ComparisonSide& side) {
        return side.image ? QFileInfo(side.name).fileName() : QStringLiteral("–");
    };
    emit titleChanged(shortName(side(0)) + " | " + shortName(side(1)));
}

void ComparisonWindow::swapSides() {
    setSides(side(1), side(0));
}

void ComparisonWindow::openFiles(const QStringList& files, std::optional<int> side) {
    files_->open(files, side);
}

bool ComparisonWindow::isBusy() const {
    return files_->isBusy() || pair_->isBusy() || panes_->isBusy() ||
           report_->inspector()->isBusy();
}

void ComparisonWindow::showPlanes() {
    pair_->setChannel(bar_->plane().toStdString());
    std::array<ComparedPlane, 2> planes;
    QString title;
    for (std::size_t i = 0; i < 2; ++i) {
        const irsg::ImageChannel* plane = pair_->plane(i);
        const ComparisonSide& side = pair_->side(i);
        planes[i].name = QFileInfo(side.name).fileName();
        if (plane == nullptr)
            continue;
        planes[i].width = side.image->width();
        planes[i].height = side.image->height();
        const irsg::ImageChannel shown = inShownUnits(*plane);
        planes[i].values = unitOfPlane(*plane) != nullptr
                               ? std::make_shared<const std::vector<float>>(shown.values)
                               : shareValues(side.image, *plane);
        if (title.isEmpty() || pair_->plane(0)->unit.empty())
            title = titleWithUnit(shown); // a plain matrix has no unit of its own
    }
    panes_->setPlanes(planes[0], planes[1], title);
    pair_->findDifference();
    pair_->compare(panes_->selection());
}

void ComparisonWindow::showDifference() {
    const ComparedPair::Image& difference = pair_->difference();
    if (!difference) {
        panes_->setDifference(nullptr, pair_->mode(), {});
        report_->inspector()->clear();
        return;
    }
    const QString unit = formattedUnit(difference->primary().unit);
    const QString title =
        differenceName(pair_->mode()) + (unit.isEmpty() ? QString() : " (" + unit + ")");
    panes_->setDifference(shareValues(difference, difference->primary()), pair_->mode(), title);
    report_->inspector()->show(difference, difference->primary(), title, unit);
    report_->inspector()->setRectangle(panes_->selection());
    showMarks();
    showReadout(pixel_);
    bar_->refresh(*pair_);
}

void ComparisonWindow::showFigures() {
    const QString command = commandLine();
    report_->command()->setVisible(pair_->hasBoth());
    report_->command()->setCommand(command);
    bar_->setHasCommand(!command.isEmpty());
    bar_->refresh(*pair_);
    report_->show(*pair_);
}

void ComparisonWindow::showMarks() {
    panes_->setMarks(bar_->isMarking() && pair_->difference() ? pair_->marks()
                                                              : std::vector<std::uint8_t>());
}

void ComparisonWindow::showReadout(std::optional<QPoint> pixel) {
    pixel_ = pixel;
    readout_->setText(pixel ? readoutAt(pixel->x(), pixel->y())
                            : tr("Move the mouse over an image, or press the arrows, to read its "
                                 "pixels. Hold Space to see B in the place of A."));
}

void ComparisonWindow::setDifferenceMode(irsg::DifferenceMode mode) {
    pair_->setMode(mode);
    bar_->setMode(mode);
    pair_->findDifference();
}

void ComparisonWindow::goToWorstPixel() {
    const auto& compared = pair_->part() ? pair_->part() : pair_->whole();
    if (compared && compared->largest.x >= 0)
        panes_->goTo({compared->largest.x, compared->largest.y});
}

QString ComparisonWindow::commandLine() const {
    if (side(0).file.isEmpty() || side(1).file.isEmpty())
        return {};
    QString text = "smat-batch compare " + quoted(side(0).file) + " " + quoted(side(1).file);
    if (!options().channel.empty())
        text += " --channel " + quoted(QString::fromStdString(options().channel));
    text += thresholds()->options();
    if (const auto part = panes_->selection())
        text += QStringLiteral(" --rectangle %1,%2,%3,%4")
                    .arg(part->x)
                    .arg(part->y)
                    .arg(part->width)
                    .arg(part->height);
    return text;
}

QStringList ComparisonWindow::exportFilters() const {
    if (!comparison())
        return {};
    return imageFilters();
}

void ComparisonWindow::exportTo(const std::filesystem::path& file) const {
    if (!comparison())
        throw irsg::InputError({file.string(), "", "no comparison", "two images of one size"});
    const irsg::RadianceImage image = pair_->exported();
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

void ComparisonWindow::copyPicture() const {
    if (const auto& difference = pair_->difference())
        QGuiApplication::clipboard()->setImage(pictureOfDifference(*difference));
}

QImage ComparisonWindow::pictureOfDifference(const irsg::RadianceImage& difference) const {
    // The conditions that both images have.
    std::vector<Condition> conditions = conditionsOf(*side(0).image);
    const std::vector<Condition> ofB = conditionsOf(*side(1).image);
    std::erase_if(conditions,
                  [&](const Condition& one) { return std::ranges::find(ofB, one) == ofB.end(); });
    const ColorBar& bar = *panes_->differenceBar();
    return onPaper({enlargedPlane(difference, difference.primary(), bar),
                    tr("%1 of two images").arg(differenceName(differenceMode())),
                    QString::fromStdString(lineOf(conditions)), &bar});
}

void ComparisonWindow::focusInEvent(QFocusEvent* event) {
    // No proxy: Tab would jump over all that stands before it.
    panes_->canvas(0)->setFocus(event->reason());
}

void ComparisonWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    const bool local =
        std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
    if (!urls.isEmpty() && urls.size() <= 2 && local)
        event->acceptProposedAction();
}

void ComparisonWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        files << url.toLocalFile();
    // One file takes the place of the image it is dropped on.
    const QWidget* under = childAt(event->position().toPoint());
    std::optional<int> side;
    for (const int i : {0, 1})
        if (under == panes_->canvas(i))
            side = i;
    event->acceptProposedAction();
    openFiles(files, side);
}

} // namespace smat::gui

#include "moc_ComparisonWindow.cpp"
