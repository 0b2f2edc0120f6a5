#pragma once

#include <QWidget>

namespace smat::gui {

/// The small curve of cos^N of the viewing angle from 0 to 90 degrees, between those of N = 0,
/// 0.25, 1 and 3 (report figure 47).
class AngleCurve : public QWidget {
    Q_OBJECT

  public:
    explicit AngleCurve(QWidget* parent = nullptr);
    void setFactor(double factor);
    QSize sizeHint() const override { return {240, 150}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    double factor_ = 0.0;
};

} // namespace smat::gui
