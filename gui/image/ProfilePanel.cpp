#include "gui/image/ProfilePanel.h"

#include <QVBoxLayout>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/image/ImageProfile.h"

namespace smat::gui {

ProfilePanel::ProfilePanel(Dialogs dialogs, QWidget* parent) : QWidget(parent) {
    setObjectName("profilePanel");
    plot_ = new PlotPanel(PlotKind::cartesian, std::move(dialogs), this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(plot_);
    setMinimumHeight(250);
    showHint();
}

void ProfilePanel::showHint() {
    PlotData data;
    data.title = tr("Drag a line, or click a pixel for its row and column");
    data.xTitle = tr("Pixels");
    plot_->cartesian()->setData(std::move(data));
    plot_->refresh();
}

void ProfilePanel::showLine(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                            const QString& title, const QLine& line) {
    const irsg::ImageProfile profile =
        irsg::profileAlong(image, plane, line.x1(), line.y1(), line.x2(), line.y2());
    PlotData data;
    data.title =
        tr("From (%1, %2) to (%3, %4)").arg(line.x1()).arg(line.y1()).arg(line.x2()).arg(line.y2());
    data.xTitle = tr("Distance along the line (px)");
    data.yTitle = title;
    data.curves = {{tr("line"), profile.distance_px, profile.values}};
    plot_->cartesian()->setData(std::move(data));
    plot_->refresh();
}

void ProfilePanel::showPoint(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                             const QString& title, const QPoint& pixel) {
    const auto curve = [&](const QString& name, const irsg::ImageProfile& profile) {
        return Curve{name, profile.distance_px, profile.values};
    };
    PlotData data;
    const auto value = static_cast<double>(plane.values[image.offset(pixel.x(), pixel.y())]);
    data.title = tr("Through (%1, %2): %3 %4")
                     .arg(pixel.x())
                     .arg(pixel.y())
                     .arg(formattedNumber(value), formattedUnit(plane.unit))
                     .trimmed();
    data.xTitle = tr("Column x or row y (px)");
    data.yTitle = title;
    data.curves = {
        curve(tr("row y %1, over x").arg(pixel.y()),
              irsg::profileAlong(image, plane, 0, pixel.y(), image.width() - 1, pixel.y())),
        curve(tr("column x %1, over y").arg(pixel.x()),
              irsg::profileAlong(image, plane, pixel.x(), 0, pixel.x(), image.height() - 1))};
    plot_->cartesian()->setData(std::move(data));
    plot_->refresh();
}

} // namespace smat::gui

#include "moc_ProfilePanel.cpp"
