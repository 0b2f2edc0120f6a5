#pragma once

#include <vector>

#include <QWidget>

#include "gui/image/ColoredPlane.h"

namespace smat::gui {

/// A plane of values in grey, as large as there is room, with a line of words above it.
class PlanePane : public QWidget {
    Q_OBJECT

  public:
    PlanePane(const QString& name, QWidget* parent = nullptr);

    /// `limits`: the values that are black and white.
    void setPlane(const QString& title, std::vector<float> values, int width, int height,
                  const irsg::DisplayLimits& limits);
    void clear(const QString& title);
    const QString& title() const { return title_; }
    const ColoredPlane& plane() const { return plane_; }
    QSize sizeHint() const override { return {260, 210}; }
    QSize minimumSizeHint() const override { return {120, 90}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    ColoredPlane plane_;
    QString title_;
};

} // namespace smat::gui
