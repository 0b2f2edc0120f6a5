#include "gui/image/ImageView.h"
#include "gui/image/PaperPicture.h"

#include <algorithm>
#include <cmath>

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>

#include "gui/image/ColorBar.h"
#include "gui/image/ColorPicture.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ImageLines.h"
#include "gui/image/IndexLegend.h"
#include "gui/image/ShownImage.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/ImageStatistics.h"

namespace smat::gui {
namespace {

QRectF rectangleOf(const irsg::SampledTile& window) {
    return QRectF(QPointF(window.left_px, window.top_px),
                  QPointF(window.right_px, window.bottom_px));
}

} // namespace

const irsg::ImageChannel& ImageView::plane() const {
    return image_->channels.at(static_cast<std::size_t>(plane_->currentData().toInt()));
}

const irsg::ImageChannel& ImageView::givenPlane() const {
    return given_->channels.at(static_cast<std::size_t>(plane_->currentData().toInt()));
}

void ImageView::takeUnits() {
    if (given_ == nullptr)
        return;
    const bool isLocked = colorBar_->mode() == LimitMode::locked;
    const ShownUnit* before =
        plane().unit == givenPlane().unit ? nullptr : shownUnitOf(givenPlane().unit, shownIn_);
    irsg::DisplayLimits limits = colorBar_->limits();
    if (before != nullptr) {
        limits.low = before->back(limits.low);
        limits.high = before->back(limits.high);
    }
    fillPlanes();
    showPlane();
    if (isLocked)
        setLimits(limits.low, limits.high);
}

bool ImageView::showsColors() const {
    return image_ != nullptr && isColorPicture(*image_) && plane_->currentIndex() == 0;
}

bool ImageView::showsIndices() const {
    return image_ != nullptr && !showsColors() && isIndexPlane(plane());
}

void ImageView::tellPixel(const std::optional<QPoint>& pixel) {
    readout_->setText(pixel ? readoutAt(pixel->x(), pixel->y())
                            : tr("Move the mouse over the image, or press the arrows, to read its "
                                 "pixels"));
    markIndex(pixel);
}

void ImageView::readPixel(const std::optional<QPoint>& pixel) {
    canvas_->setCursorPixel(pixel);
    tellPixel(pixel);
}

void ImageView::markIndex(const std::optional<QPoint>& pixel) {
    if (!showsIndices())
        return;
    const float value =
        pixel ? plane().values[image_->offset(pixel->x(), pixel->y())] : std::nanf("");
    legend_->mark(std::isfinite(value) ? std::optional(static_cast<int>(std::lround(value)))
                                       : std::nullopt);
}

void ImageView::setImage(irsg::RadianceImage image, const std::optional<irsg::Band>& band) {
    setImage(std::make_shared<const irsg::RadianceImage>(std::move(image)), band);
}

void ImageView::setImage(std::shared_ptr<const irsg::RadianceImage> image,
                         const std::optional<irsg::Band>& band) {
    if (image == nullptr || image->empty())
        throw irsg::LogicError("an image view needs an image");
    temperatureTask_.cancel();
    canvas_->forgetPicture();
    const auto withTemperature = [base = image, band] {
        auto with = std::make_shared<irsg::RadianceImage>(*base);
        irsg::addApparentTemperature(*with, *band);
        return std::shared_ptr<const irsg::RadianceImage>(std::move(with));
    };
    const bool hasTemperature = band && image->primary().name == "L";
    const bool quick = image->pixelCount() <= quickPixels;
    plane_->setCurrentIndex(0);
    adopt(hasTemperature && quick ? withTemperature() : std::move(image));
    readout_->setText(tr("Move the mouse over the image, or press the arrows, to read its pixels"));
    showPlane();
    if (hasTemperature && !quick)
        temperatureTask_.run<std::shared_ptr<const irsg::RadianceImage>>(
            withTemperature,
            [this](std::shared_ptr<const irsg::RadianceImage> with) { adopt(std::move(with)); });
}

void ImageView::setFrame(std::shared_ptr<const irsg::RadianceImage> image) {
    if (image_ == nullptr || image == nullptr || image->empty() ||
        image->width() != image_->width() || image->height() != image_->height()) {
        setImage(std::move(image));
        return;
    }
    temperatureTask_.cancel();
    adopt(std::move(image));
    showPlane();
    if (const auto pixel = canvas_->cursorPixel())
        readout_->setText(readoutAt(pixel->x(), pixel->y()));
}

void ImageView::adopt(std::shared_ptr<const irsg::RadianceImage> image) {
    given_ = isColorPicture(*image) ? withLuminance(*image) : std::move(image);
    fillPlanes();
}

void ImageView::fillPlanes() {
    const int shown = plane_->currentIndex();
    image_ = inShownUnits(given_);
    shownIn_ = DisplayUnits::current();
    plane_->clear();
    const int planes = static_cast<int>(image_->channels.size());
    if (isColorPicture(*image_))
        plane_->addItem(tr("Colour"), planes - 1); // read and measured by its luminance
    for (int i = 0; i < planes; ++i)
        plane_->addItem(planeTitle(image_->channels[static_cast<std::size_t>(i)]), i);
    plane_->setCurrentIndex(std::clamp(shown, 0, plane_->count() - 1));
    windows_ = irsg::tilesOf(*image_);
    tilesShown_->setEnabled(!windows_.empty());
    outlineTiles();
}

void ImageView::outlineTiles() {
    std::vector<QRectF> outlines;
    if (tilesShown_->isChecked())
        for (const irsg::SampledTile& window : windows_)
            outlines.push_back(rectangleOf(window));
    canvas_->setOutlines(std::move(outlines));
}

QString ImageView::windowWords(int x, int y) const {
    const auto finest =
        std::ranges::find_if(windows_.rbegin(), windows_.rend(), [&](const auto& w) {
            return rectangleOf(w).intersects(QRectF(x, y, 1.0, 1.0));
        });
    if (finest == windows_.rend())
        return {};
    const QString objects = QString::fromStdString(finest->objects);
    if (finest->across == 0.0)
        return tr("Point: %1").arg(objects);
    return tr("Tile: %1 × %2 samples per pixel, %3")
        .arg(formattedNumber(finest->across), formattedNumber(finest->down), objects);
}

void ImageView::setShownPlane(int index) {
    if (index < 0 || index >= plane_->count())
        return;
    plane_->setCurrentIndex(index);
    showPlane();
}

void ImageView::showPlane() {
    const auto& shown = plane();
    std::optional<LightPlanes> light;
    if (showsColors()) {
        light = lightOf(image_);
    } else if (showsIndices()) {
        std::vector<SeenIndex> seen = seenIndices(*image_, shown);
        light = lightOf(shown, seen);
        legend_->setIndices(planeTitle(shown), std::move(seen));
        markIndex(canvas_->cursorPixel());
    }
    canvas_->setPlane(image_->width(), image_->height(), shareValues(image_, shown), light);
    colors_->setEnabled(!light);
    colorBar_->setVisible(!showsIndices());
    legend_->setVisible(showsIndices());
    colorBar_->setTitle(titleWithUnit(shown));
    inspector_->show(image_, shown, titleWithUnit(shown), formattedUnit(shown.unit));
    lines_->show(image_, shown, titleWithUnit(shown));
    updateColors();
    updateStatistics();
}

void ImageView::updateColors() {
    if (showsIndices()) {
        // Their colours have no limits; the histogram has those of its values.
        limitsTask_.cancel();
        const irsg::DisplayLimits all = irsg::percentileLimits(plane().values);
        canvas_->setColors(*map_, {0.0, 1.0});
        inspector_->setLimits(all);
        lines_->setLimits(all);
        return;
    }
    if (colorBar_->mode() == LimitMode::locked) {
        recolor();
        return;
    }
    findLimits(std::nullopt);
}

void ImageView::recolor() {
    if (showsIndices())
        return;
    // The limits are known and shown at once, what lies outside of them is counted.
    useLimits({colorBar_->limits(), {}});
    findLimits(colorBar_->limits());
}

void ImageView::findLimits(const std::optional<irsg::DisplayLimits>& known) {
    const auto work = [values = shareValues(image_, plane()), known, rule = colorBar_->rule(),
                       inColors = showsColors()] {
        return inColors ? findLightLimits(rule, values, known)
                        : smat::gui::findLimits(rule, {values}, known);
    };
    limitsTask_.cancel();
    if (image_->pixelCount() <= quickPixels) {
        useLimits(work());
        return;
    }
    if (!known)
        canvas_->awaitColors();
    limitsTask_.run<FoundLimits>(work, [this, known](const FoundLimits& found) {
        if (known == found.limits)
            colorBar_->setOutOfRange(found.outside);
        else
            useLimits(found);
    });
}

void ImageView::useLimits(const FoundLimits& found) {
    colorBar_->setColors(*map_, found.limits);
    colorBar_->setOutOfRange(found.outside);
    canvas_->setColors(*map_, found.limits);
    inspector_->setLimits(found.limits);
    lines_->setLimits(found.limits);
}

void ImageView::setLimits(std::optional<double> low, std::optional<double> high) {
    irsg::DisplayLimits limits = colorBar_->limits();
    const ShownUnit* unit = image_ != nullptr && plane().unit != givenPlane().unit
                                ? shownUnitOf(givenPlane().unit, shownIn_)
                                : nullptr;
    const auto shown = [unit](double value) {
        return unit == nullptr ? value : unit->shown(value);
    };
    if (low)
        limits.low = shown(*low);
    if (high)
        limits.high = shown(*high);
    if ((low || high) && limits.low < limits.high)
        colorBar_->edit(limits);
}

void ImageView::setColorMap(const std::string& name) {
    map_ = &irsg::ColorMap::named(name);
    colors_->setCurrentText(QString::fromStdString(name));
    if (image_ == nullptr || showsIndices())
        return;
    colorBar_->setColors(*map_, colorBar_->limits());
    canvas_->setColors(*map_, colorBar_->limits());
}

void ImageView::setColorScale(irsg::ColorScale scale, bool marksOutside) {
    colorBar_->setScale(scale);
    colorBar_->setMarksOutside(marksOutside);
    if (image_ != nullptr)
        updateColors();
}

void ImageView::setConditions(const QString& conditions) {
    conditions_->setText(conditions);
    conditions_->setToolTip(conditions);
    conditions_->setVisible(!conditions.isEmpty());
}

QString ImageView::readoutAt(int x, int y) const {
    QString text = QStringLiteral("x %1   y %2").arg(x).arg(y);
    for (const auto& channel : image_->channels) {
        text += QStringLiteral("     %1 %2 %3")
                    .arg(planeTitle(channel), valueWords(*image_, channel, image_->offset(x, y)),
                         formattedUnit(channel.unit))
                    .trimmed()
                    .prepend("     ");
    }
    if (tilesShown_->isChecked())
        text += "     " + windowWords(x, y);
    return text;
}

QString ImageView::statistics() const {
    return statisticsText(canvas_->selection(), figuresOf(*image_, plane(), canvas_->selection()));
}

QString ImageView::statisticsText(const std::optional<irsg::PixelRectangle>& selection,
                                  const PlaneFigures& figures) const {
    const auto& s = figures.statistics;
    QString text = selection ? tr("Rectangle %1 × %2 at (%3, %4)")
                                   .arg(selection->width)
                                   .arg(selection->height)
                                   .arg(selection->x)
                                   .arg(selection->y)
                             : tr("Image %1 × %2").arg(image_->width()).arg(image_->height());
    text += tr("     min %1   max %2   mean %3   median %4   σ %5   sum %6")
                .arg(sentenceNumber(s.minimum), sentenceNumber(s.maximum), sentenceNumber(s.mean),
                     sentenceNumber(s.median), sentenceNumber(s.standardDeviation),
                     sentenceNumber(s.sum));
    if (figures.contrastIntensity_W_sr)
        text += tr("     contrast intensity %1")
                    .arg(valueWithUnit(*figures.contrastIntensity_W_sr, "W sr-1",
                                       [](double value) { return sentenceNumber(value); }));
    const auto missing = s.nan + s.positiveInfinite + s.negativeInfinite;
    if (missing > 0)
        text += tr("     %1 pixels without a value").arg(missing);
    return text;
}

void ImageView::updateStatistics() {
    const auto selection = canvas_->selection();
    const auto pixels = selection ? static_cast<std::size_t>(selection->width) *
                                        static_cast<std::size_t>(selection->height)
                                  : image_->pixelCount();
    inspector_->setRectangle(selection);
    if (pixels <= quickPixels) {
        figuresTask_.cancel();
        statistics_->setText(statistics());
        return;
    }
    figuresTask_.run<PlaneFigures>([image = image_, shown = &plane(),
                                    selection] { return figuresOf(*image, *shown, selection); },
                                   [this, selection](const PlaneFigures& figures) {
                                       statistics_->setText(statisticsText(selection, figures));
                                   });
}

bool ImageView::isBusy() const {
    return figuresTask_.isBusy() || temperatureTask_.isBusy() || limitsTask_.isBusy() ||
           canvas_->isBusy() || lines_->isBusy() || inspector_->isBusy() || pixels_->isBusy();
}

QStringList ImageView::exportFilters() const {
    if (image_ == nullptr)
        return {};
    return imageFilters();
}

QImage ImageView::picture(bool withColorBar) const {
    if (showsColors())
        return canvas_->picture();
    if (showsIndices() && !withColorBar)
        return canvas_->picture();
    if (showsIndices())
        return onPaper(
            {enlarged(canvas_->picture()), title_, conditions_->text(), nullptr, legend_});
    if (withColorBar) {
        QImage enlarged = enlargedPlane(*image_, plane(), *colorBar_);
        lines_->drawOn(enlarged);
        return onPaper({enlarged, title_, conditions_->text(), colorBar_});
    }
    irsg::PngViewOptions options;
    options.colorMap = map_->name();
    options.limits = colorBar_->limits();
    options.colorBar = false;
    return pictureOf(*image_, plane(), options);
}

void ImageView::exportTo(const std::filesystem::path& file) const {
    write(file, true);
}

void ImageView::write(const std::filesystem::path& file, bool withColorBar) const {
    if (irsg::requiredImageFormat(file).keeps == irsg::ImageFormat::Keeps::picture)
        writePicture(picture(withColorBar), file);
    else
        exportImage(*given_, shownChannel(), {}, file);
}

void ImageView::askAndExport(const QString& filter, bool withColorBar) {
    const QString suffix = filter.section("*", -1).chopped(1);
    const QString name = title_.isEmpty() ? tr("image") : title_;
    const QString file = dialogs_.saveFile(this, tr("Export the image"), {filter}, name + suffix);
    if (file.isEmpty())
        return;
    try {
        write(file.toStdString(), withColorBar);
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("The image cannot be written"), sentencesOf(error));
    }
}

void ImageView::copyPicture(bool withColorBar) const {
    QGuiApplication::clipboard()->setImage(picture(withColorBar));
}

void ImageView::copyValues() const {
    QGuiApplication::clipboard()->setText(valuesText(*given_, givenPlane(), canvas_->selection()));
}

void ImageView::setExplainer(PixelPanel::Maker maker) {
    pixels_->setMaker(std::move(maker));
    explains_->setVisible(pixels_->canExplain());
    if (!pixels_->canExplain())
        explains_->setChecked(false);
}

void ImageView::explainAt(const QPoint& pixel) {
    if (!explains_->isChecked())
        return;
    // Planes of other quantities have no terms of their own.
    const irsg::ImageChannel* radiance = image_->find("L");
    std::optional<double> inImage;
    if (radiance != nullptr)
        inImage = static_cast<double>(radiance->values[image_->offset(pixel.x(), pixel.y())]);
    pixels_->ask(pixel, inImage);
}

void ImageView::keyPressEvent(QKeyEvent* event) {
    const bool back = event->modifiers().testFlag(Qt::ShiftModifier);
    const int key = event->key();
    if (image_ == nullptr) {
        QWidget::keyPressEvent(event);
    } else if (event->matches(QKeySequence::Copy)) {
        copyPicture(true);
    } else if (key == Qt::Key_C && back && event->modifiers().testFlag(Qt::ControlModifier)) {
        copyValues();
    } else if (event->modifiers().testFlag(Qt::ControlModifier)) {
        QWidget::keyPressEvent(event);
    } else if (key == Qt::Key_E) {
        colorBar_->changeExposure(back ? -ColorBar::exposureStep : ColorBar::exposureStep);
    } else if (key == Qt::Key_O) {
        colorBar_->changeOffset(back ? ColorBar::offsetStep : -ColorBar::offsetStep);
    } else if (key == Qt::Key_N || key == Qt::Key_L) {
        colorBar_->setMode(key == Qt::Key_N ? LimitMode::target : LimitMode::locked);
        updateColors();
    } else if (key == Qt::Key_M) {
        const int step = back ? colors_->count() - 1 : 1;
        setColorMap(
            colors_->itemText((colors_->currentIndex() + step) % colors_->count()).toStdString());
    } else if (key == Qt::Key_H) {
        histogram_->toggle();
    } else if (key == Qt::Key_P) {
        lines_->profileButton()->click();
    } else if (key == Qt::Key_G) {
        lines_->spotsButton()->click();
    } else if (key == Qt::Key_I) {
        lines_->isoButton()->click();
    } else if (key == Qt::Key_W) {
        tilesShown_->click();
    } else if (key == Qt::Key_X && pixels_->canExplain()) {
        explains_->click();
    } else if ((key == Qt::Key_Return || key == Qt::Key_Enter) && explains_->isChecked() &&
               canvas_->cursorPixel()) {
        explainAt(*canvas_->cursorPixel());
    } else if (key >= Qt::Key_1 && key <= Qt::Key_9) {
        setShownPlane(key - Qt::Key_1);
    } else {
        QWidget::keyPressEvent(event);
    }
}

QList<std::pair<QString, QString>> imageKeys() {
    return {
        {ImageView::tr("Wheel, + and −"), ImageView::tr("Zoom; values appear on the pixels")},
        {ImageView::tr("Right drag, Ctrl+arrows"), ImageView::tr("Move the image")},
        {ImageView::tr("F, A"), ImageView::tr("Fit the window; actual size")},
        {ImageView::tr("Arrows"), ImageView::tr("Read pixels one by one")},
        {ImageView::tr("Drag, Shift+arrows"), ImageView::tr("Rectangle with its statistics")},
        {ImageView::tr("Esc"), ImageView::tr("No rectangle")},
        {ImageView::tr("1 … 9"), ImageView::tr("Plane of the image")},
        {ImageView::tr("M, Shift+M"), ImageView::tr("Next, previous colour map")},
        {ImageView::tr("E, O (Shift: back)"), ImageView::tr("Exposure, offset of the colours")},
        {ImageView::tr("N, L"), ImageView::tr("Limits of the colours automatic, locked")},
        {ImageView::tr("H"), ImageView::tr("Histogram and statistics")},
        {ImageView::tr("P"), ImageView::tr("Profile: drag a line, or click a pixel")},
        {ImageView::tr("I"), ImageView::tr("Isotherms: lines of equal value")},
        {ImageView::tr("G"), ImageView::tr("Hot spots: a list of the largest values")},
        {ImageView::tr("W"),
         ImageView::tr("Antialiasing tiles: objects and hot spots that are sampled separately")},
        {ImageView::tr("X"), ImageView::tr("What a pixel is made of: click it, or Return")},
        {ImageView::tr("Ctrl+C, Ctrl+Shift+C"), ImageView::tr("Copy picture, copy values")}};
}

} // namespace smat::gui

#include "moc_ImageView.cpp"
