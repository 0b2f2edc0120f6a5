#pragma once

#include <optional>

#include "gui/image/ColorBar.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {

/// The strip of colours with its ticks and its title, and swatches of what is outside of it.
class ColorBar::Scale : public QWidget {
  public:
    /// In the colours of the screen, or in those of paper.
    Scale(const ColorBar* bar, QWidget* parent, std::optional<PlotStyle> style = {});
    QSize sizeHint() const override { return {120, 240}; }

    void paint(QPainter& painter) const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    struct Swatch {
        irsg::Rgb color;
        QString words;
    };
    QList<Swatch> swatchesBelow() const;
    void drawSwatch(QPainter& painter, double top, const Swatch& swatch) const;
    void drawStrip(QPainter& painter, const QRectF& strip) const;
    double drawTicks(QPainter& painter, const QRectF& strip) const;

    PlotStyle style() const;

    const ColorBar* bar_;
    std::optional<PlotStyle> style_;
};

} // namespace smat::gui
