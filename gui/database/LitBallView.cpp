#include "gui/database/LitBallView.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QFontMetricsF>
#include <QPainter>

#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/LitBall.h"

namespace smat::gui {

namespace {

constexpr int size_px = 96;
/// Glints are many times as bright as what is around them.
constexpr double brightest = 10.0;
constexpr double captionHeight = 20.0;

} // namespace

LitBallView::LitBallView(QWidget* parent) : QWidget(parent) {
    setMinimumSize(110, 130);
    setObjectName("litBall");
}

void LitBallView::show(const irsg::Material& material, const irsg::SpectralRange& band) {
    picture_ = QImage();
    caption_.clear();
    update();
    irsg::LitBall ball;
    try {
        ball = irsg::litBall(material, band, size_px);
    } catch (const irsg::InputError&) {
        caption_ = tr("no ball yet");
        setToolTip(tr("Data are missing for this model; the plot beside it names them"));
        return;
    }
    std::vector<double> values;
    for (const double value : ball.radiance_W_m2_sr)
        if (!std::isnan(value))
            values.push_back(value);
    const auto [least, most] = std::ranges::minmax(values);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    const double low = least, high = std::max(std::min(most, brightest * *middle), least * 1.02);
    picture_ = QImage(size_px, size_px, QImage::Format_ARGB32);
    picture_.fill(Qt::transparent);
    for (int row = 0; row < size_px; ++row)
        for (int column = 0; column < size_px; ++column) {
            const double value = ball.at(row, column);
            if (std::isnan(value))
                continue;
            const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
            const int grey = static_cast<int>(std::lround(20.0 + 235.0 * std::sqrt(t)));
            picture_.setPixel(column, row, qRgb(grey, grey, grey));
        }
    caption_ = tr("%1 to %2 W m⁻² sr⁻¹").arg(least, 0, 'g', 3).arg(most, 0, 'g', 3);
    setToolTip(tr("A ball of this material at 300 K in %1 to %2 µm: the sun behind your left "
                  "shoulder, 45° high, a clear sky above and ground below. Brightness goes with "
                  "the root of the radiance, white is ten times the middle of the ball or its "
                  "brightest place")
                   .arg(band.min_um)
                   .arg(band.max_um));
}

void LitBallView::paintEvent(QPaintEvent*) {
    const PlotStyle style = PlotStyle::screen(palette());
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const double side = std::min<double>(width(), height() - captionHeight);
    const QRectF square((width() - side) / 2.0, 0.0, side, side);
    if (!picture_.isNull()) {
        // Its outline is that of a circle, not of pixels.
        QBrush brush(picture_.scaled(QSize(static_cast<int>(side), static_cast<int>(side)),
                                     Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
        brush.setTransform(QTransform::fromTranslate(square.left(), square.top()));
        painter.setBrush(brush);
        painter.setPen(QPen(style.grid, 1.0));
        painter.drawEllipse(square.adjusted(2, 2, -2, -2));
    } else {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(style.faintText, 1.0, Qt::DashLine));
        painter.drawEllipse(square.adjusted(2, 2, -2, -2));
    }
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    painter.setFont(small);
    painter.setPen(style.text);
    painter.drawText(QRectF(0, square.bottom(), width(), captionHeight), Qt::AlignCenter, caption_);
}

} // namespace smat::gui

#include "moc_LitBallView.cpp"
