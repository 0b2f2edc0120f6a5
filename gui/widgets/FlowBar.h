#pragma once

#include <QWidget>

class QBoxLayout;
class QHBoxLayout;

namespace smat::gui {

/// Two groups of fields and buttons in a row, the second at its end; one above the other where the
/// row is too narrow for both.
class FlowBar : public QWidget {
    Q_OBJECT

  public:
    explicit FlowBar(QWidget* parent = nullptr);
    QHBoxLayout* first() const { return first_; }
    QHBoxLayout* second() const { return second_; }
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void arrange();
    QBoxLayout* both_ = nullptr;
    QHBoxLayout* first_ = nullptr;
    QHBoxLayout* second_ = nullptr;
};

} // namespace smat::gui
