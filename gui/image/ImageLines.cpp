#include "gui/image/ImageLines.h"

#include <algorithm>
#include <cmath>

#include <QImage>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>
#include <QToolButton>

#include "gui/image/HotSpotsPanel.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ProfilePanel.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/NumberText.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/widgets/Widgets.h"
#include "irsg/image/IsoLines.h"

namespace smat::gui {
namespace {

constexpr std::size_t mostLevels = 50;

std::vector<IsoLine> linesOf(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                             const std::vector<double>& levels) {
    std::vector<IsoLine> lines;
    for (const double level : levels) {
        IsoLine line{QString::number(level, 'g', 6), {}};
        for (const irsg::IsoSegment& part :
             irsg::isoLines(plane.values, image.width(), image.height(), level))
            line.parts.emplace_back(part.fromX, part.fromY, part.toX, part.toY);
        lines.push_back(std::move(line));
    }
    return lines;
}

/// Round levels at some equal steps of colour.
std::vector<double> automaticLevels(const irsg::DisplayLimits& limits) {
    if (limits.scale == irsg::ColorScale::linear)
        return irsg::roundLevels(limits.low, limits.high);
    constexpr int count = 6;
    std::vector<double> levels;
    for (int k = 1; k <= count; ++k) {
        const double step = 1.0 / (count + 1), at = k * step;
        const double apart = limits.value(at + 0.5 * step) - limits.value(at - 0.5 * step);
        if (!(apart > 0.0))
            continue;
        const double unit = std::pow(10.0, std::floor(std::log10(apart)));
        const double level = std::round(limits.value(at) / unit) * unit;
        if (levels.empty() || level > levels.back())
            levels.push_back(level);
    }
    return levels;
}

/// The numbers of a text, apart by semicolons or blanks; none where one of them is no number.
std::optional<std::vector<double>> numbersOf(const QString& text) {
    static const QRegularExpression separators(R"([;\s]+)");
    std::vector<double> numbers;
    for (const QString& word : text.split(separators, Qt::SkipEmptyParts)) {
        const auto number = numberOf(word);
        if (!number || numbers.size() >= mostLevels)
            return std::nullopt;
        numbers.push_back(*number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

} // namespace

ImageLines::ImageLines(ImageCanvas& canvas, ProfilePanel& profile, HotSpotsPanel& spots,
                       QObject* parent)
    : QObject(parent), canvas_(canvas), panel_(profile), spotsPanel_(spots) {
    profiles_ = textButton(tr("Profile"), "showProfile",
                           tr("Values along a line that is dragged, or along the row and the "
                              "column of a pixel that is clicked (P)"));
    profiles_->setCheckable(true);
    isoLines_ = textButton(tr("Isotherms"), "showIsoLines",
                           tr("Lines of equal value in the plane that is shown (I)"));
    isoLines_->setCheckable(true);
    levels_ = new QLineEdit;
    levels_->setObjectName("isoLevels");
    levels_->setPlaceholderText(tr("automatic"));
    levels_->setAccessibleName(tr("Levels"));
    levels_->setToolTip(tr("Levels of the lines in the unit of the plane, separated by semicolons "
                           "or spaces; empty for automatic ones"));
    levels_->setMaximumWidth(150);
    levels_->hide();

    spots_ = textButton(tr("Hot spots"), "showHotSpots",
                        tr("The largest values of the plane that is shown, as a list with their "
                           "places and what the other planes have there (G)"));
    spots_->setCheckable(true);
    connect(spots_, &QToolButton::toggled, this, [this](bool on) {
        spotsPanel_.setVisible(on);
        refreshSpots();
    });
    connect(&spotsPanel_, &HotSpotsPanel::chosen, this, [this](const QPoint& pixel) {
        canvas_.centreOn(pixel, canvas_.zoom());
        canvas_.setCursorPixel(pixel);
        emit canvas_.hovered(pixel);
    });

    connect(profiles_, &QToolButton::toggled, this, &ImageLines::followProfile);
    connect(isoLines_, &QToolButton::toggled, this, [this](bool on) {
        levels_->setVisible(on);
        refreshIsoLines();
    });
    connect(levels_, &QLineEdit::textChanged, this, &ImageLines::refreshIsoLines);
    connect(&canvas_, &ImageCanvas::lineChanged, this, &ImageLines::showProfile);
}

void ImageLines::show(std::shared_ptr<const irsg::RadianceImage> image,
                      const irsg::ImageChannel& plane, const QString& title) {
    image_ = std::move(image);
    plane_ = &plane;
    title_ = title;
    showProfile();
    refreshIsoLines();
    refreshSpots();
}

void ImageLines::refreshSpots() {
    spotsTask_.cancel();
    if (!spots_->isChecked() || plane_ == nullptr) {
        canvas_.setSpots({});
        spotsPanel_.clear();
        return;
    }
    const auto take = [this](const std::vector<irsg::HotSpot>& spots) {
        std::vector<QPoint> places;
        for (const irsg::HotSpot& spot : spots)
            places.emplace_back(spot.x, spot.y);
        canvas_.setSpots(std::move(places));
        spotsPanel_.show(*image_, *plane_, spots);
    };
    const auto work = [image = image_, plane = plane_] {
        return irsg::hottestSpots(*image, *plane);
    };
    if (image_->pixelCount() <= quickPixels)
        take(work());
    else
        spotsTask_.run<std::vector<irsg::HotSpot>>(work, take);
}

void ImageLines::setLimits(const irsg::DisplayLimits& limits) {
    if (limits_ == limits)
        return;
    limits_ = limits;
    if (levels_->text().trimmed().isEmpty())
        refreshIsoLines();
}

void ImageLines::followProfile() {
    const bool on = profiles_->isChecked();
    panel_.setVisible(on);
    canvas_.setLineMode(on);
    showProfile();
}

void ImageLines::showProfile() {
    if (!profiles_->isChecked() || plane_ == nullptr)
        return;
    const auto line = canvas_.line();
    if (!line)
        panel_.showHint();
    else if (line->p1() == line->p2())
        panel_.showPoint(*image_, *plane_, title_, line->p1());
    else
        panel_.showLine(*image_, *plane_, title_, *line);
}

std::vector<double> ImageLines::levels() const {
    const auto typed = numbersOf(levels_->text());
    if (!typed)
        return {};
    return typed->empty() ? automaticLevels(limits_) : *typed;
}

void ImageLines::refreshIsoLines() {
    const bool isRefused = !numbersOf(levels_->text());
    levels_->setStyleSheet(
        isRefused
            ? QStringLiteral("background: %1").arg(colors::wrongField(levels_->palette()).name())
            : QString());
    if (!isoLines_->isChecked() || plane_ == nullptr) {
        task_.cancel();
        canvas_.setIsoLines({});
        return;
    }
    const auto work = [image = image_, plane = plane_, at = levels()] {
        return linesOf(*image, *plane, at);
    };
    if (image_->pixelCount() <= quickPixels) {
        task_.cancel();
        canvas_.setIsoLines(work());
        return;
    }
    task_.run<std::vector<IsoLine>>(
        work, [this](const std::vector<IsoLine>& lines) { canvas_.setIsoLines(lines); });
}

void ImageLines::drawOn(QImage& picture) const {
    if (canvas_.isoLines().empty() || image_ == nullptr || image_->width() == 0)
        return;
    const double scale = static_cast<double>(picture.width()) / image_->width();
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    drawIsoLines(painter, canvas_.isoLines(),
                 [scale](const QPointF& point) { return point * scale; });
}

} // namespace smat::gui

#include "moc_ImageLines.cpp"
