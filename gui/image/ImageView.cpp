#include "gui/image/ImageView.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/Theme.h"
#include "gui/image/ColorBar.h"
#include "gui/image/ImageCanvas.h"
#include "gui/plot/PlotData.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Quantity.h"

namespace smat::gui {
namespace {

QIcon swatch(const irsg::ColorMap& map) {
    QPixmap pixmap(56, 14);
    QPainter painter(&pixmap);
    for (int x = 0; x < pixmap.width(); ++x) {
        const irsg::Rgb color = map.at((x + 0.5) / pixmap.width());
        painter.fillRect(x, 0, 1, pixmap.height(), QColor(color.red, color.green, color.blue));
    }
    return pixmap;
}

QToolButton* textButton(const QString& text, const QString& name, const QString& tip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setObjectName(name);
    button->setToolTip(tip);
    return button;
}

} // namespace

QString planeTitle(const irsg::ImageChannel& channel) {
    if (channel.name == "L")
        return QStringLiteral("Radiance");
    if (channel.name == irsg::apparentTemperatureChannel || channel.name == "T")
        return QStringLiteral("Apparent temperature");
    if (channel.name == "E")
        return QStringLiteral("Irradiance");
    QString words = QString::fromStdString(channel.name).replace('_', ' ');
    if (!words.isEmpty())
        words[0] = words[0].toUpper();
    return words;
}

QString readableUnit(const std::string& unit) {
    for (int i = 0; i <= static_cast<int>(irsg::Quantity::dimensionless); ++i) {
        const auto& info = irsg::info(static_cast<irsg::Quantity>(i));
        if (info.unit == unit)
            return QString::fromUtf8(info.prettyUnit.data(),
                                     static_cast<qsizetype>(info.prettyUnit.size()));
    }
    return QString::fromStdString(unit);
}

ImageView::ImageView(QWidget* parent) : QWidget(parent) {
    setObjectName("imageView");
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    canvas_ = new ImageCanvas(this);
    colorBar_ = new ColorBar(this);
    plane_ = new QComboBox(this);
    plane_->setObjectName("plane");
    plane_->setToolTip(tr("What is shown"));
    plane_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    colors_ = new QComboBox(this);
    colors_->setObjectName("colorMap");
    colors_->setToolTip(tr("Colours of the view; the data stay as they are"));
    colors_->setIconSize(QSize(56, 14));
    for (const auto& name : irsg::ColorMap::names()) {
        const auto& map = irsg::ColorMap::named(name);
        if (!map.isDiverging())
            colors_->addItem(swatch(map), QString::fromStdString(name));
    }
    auto* fit = textButton(tr("Fit"), "fit", tr("Show the whole image (double click)"));
    auto* actual =
        textButton(tr("1:1"), "actualSize", tr("One pixel of the image is one of the screen"));
    readout_ = new QLabel(this);
    readout_->setObjectName("pixelReadout");
    statistics_ = new QLabel(this);
    statistics_->setObjectName("statistics");
    statistics_->setForegroundRole(QPalette::PlaceholderText);
    for (QLabel* label : {readout_, statistics_}) {
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        label->setMinimumWidth(0);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }

    auto* bar = new QHBoxLayout;
    bar->addWidget(plane_);
    bar->addWidget(colors_);
    bar->addStretch(1);
    bar->addWidget(fit);
    bar->addWidget(actual);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addWidget(canvas_, 1);
    middle->addWidget(colorBar_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 8);
    column->setSpacing(8);
    column->addLayout(bar);
    column->addLayout(middle, 1);
    column->addWidget(readout_);
    column->addWidget(statistics_);

    connect(plane_, &QComboBox::activated, this, &ImageView::showPlane);
    connect(colors_, &QComboBox::textActivated, this,
            [this](const QString& name) { setColorMap(name.toStdString()); });
    connect(fit, &QToolButton::clicked, canvas_, &ImageCanvas::fit);
    connect(actual, &QToolButton::clicked, canvas_,
            [this] { canvas_->setZoom(1.0 / canvas_->devicePixelRatioF()); });
    connect(canvas_, &ImageCanvas::hovered, this, [this](std::optional<QPoint> pixel) {
        readout_->setText(pixel ? readoutAt(pixel->x(), pixel->y())
                                : tr("Move the mouse over the image to read its pixels"));
    });
    connect(canvas_, &ImageCanvas::selectionChanged, this,
            [this] { statistics_->setText(statistics()); });
    connect(colorBar_, &ColorBar::limitsEdited, canvas_,
            [this](const irsg::DisplayLimits& limits) { canvas_->setColors(*map_, limits); });
    connect(colorBar_, &ColorBar::modeChosen, this, &ImageView::updateColors);
}

const irsg::ImageChannel& ImageView::plane() const {
    const auto index = static_cast<std::size_t>(std::max(plane_->currentIndex(), 0));
    return image_.channels.at(index);
}

void ImageView::setImage(irsg::RadianceImage image, const std::optional<irsg::Band>& band) {
    if (image.empty())
        throw irsg::LogicError("an image view needs an image");
    image_ = std::move(image);
    if (band && image_.primary().name == "L")
        irsg::addApparentTemperature(image_, *band);
    plane_->clear();
    for (const auto& channel : image_.channels)
        plane_->addItem(planeTitle(channel));
    readout_->setText(tr("Move the mouse over the image to read its pixels"));
    showPlane();
}

void ImageView::showPlane() {
    const auto& shown = plane();
    canvas_->setPlane(image_.width(), image_.height(), shown.values);
    const QString unit = readableUnit(shown.unit);
    colorBar_->setTitle(planeTitle(shown) + (unit.isEmpty() ? "" : " (" + unit + ")"));
    updateColors();
    statistics_->setText(statistics());
}

void ImageView::updateColors() {
    irsg::DisplayLimits limits = colorBar_->limits();
    if (colorBar_->mode() == LimitMode::full)
        limits = irsg::percentileLimits(plane().values);
    else if (colorBar_->mode() == LimitMode::target)
        limits = irsg::objectLimits(plane().values);
    colorBar_->setColors(*map_, limits);
    canvas_->setColors(*map_, limits);
}

void ImageView::setColorMap(const std::string& name) {
    map_ = &irsg::ColorMap::named(name);
    colors_->setCurrentText(QString::fromStdString(name));
    updateColors();
}

QString ImageView::readoutAt(int x, int y) const {
    QString text = QStringLiteral("x %1   y %2").arg(x).arg(y);
    for (const auto& channel : image_.channels) {
        const double value = static_cast<double>(channel.values.at(image_.offset(x, y)));
        text += QStringLiteral("     %1 %2 %3")
                    .arg(planeTitle(channel), readableNumber(value), readableUnit(channel.unit))
                    .trimmed()
                    .prepend("     ");
    }
    return text;
}

QString ImageView::statistics() const {
    const auto selection = canvas_->selection();
    const auto figures = irsg::imageStatistics(image_, plane(), selection);
    QString text = selection ? tr("Rectangle %1 × %2 at (%3, %4)")
                                   .arg(selection->width)
                                   .arg(selection->height)
                                   .arg(selection->x)
                                   .arg(selection->y)
                             : tr("Image %1 × %2").arg(image_.width()).arg(image_.height());
    text += tr("     min %1   max %2   mean %3   median %4   σ %5   sum %6")
                .arg(readableNumber(figures.minimum), readableNumber(figures.maximum),
                     readableNumber(figures.mean), readableNumber(figures.median),
                     readableNumber(figures.standardDeviation), readableNumber(figures.sum));
    const auto missing = image_.pixelCount() - figures.finite;
    if (!selection && missing > 0)
        text += tr("     %1 pixels without a value").arg(missing);
    return text;
}

} // namespace smat::gui
