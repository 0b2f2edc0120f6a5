#pragma once

#include "gui/image/ColorBar.h"

namespace smat::gui {

/// The strip of colours with its ticks and its title, and swatches of what is outside of it.
class ColorBar::Scale : public QWidget {
  public:
    explicit Scale(ColorBar* bar);
    QSize sizeHint() const override { return {120, 240}; }

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

    ColorBar* bar_;
};

} // namespace smat::gui
