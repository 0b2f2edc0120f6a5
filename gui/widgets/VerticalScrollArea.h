#pragma once

#include <QScrollArea>

namespace smat::gui {

/// A column of fields beside what they are about: as wide as the fields need, so that none is
/// clipped, and scrolled up and down where the window is low.
class VerticalScrollArea : public QScrollArea {
    Q_OBJECT

  public:
    explicit VerticalScrollArea(QWidget* body, QWidget* parent = nullptr, int leastWidth_px = 330);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    int leastWidth_px_;
};

} // namespace smat::gui
