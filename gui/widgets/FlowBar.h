#pragma once

#include <QHBoxLayout>
#include <QWidget>

namespace smat::gui {

/// A row of fields and buttons that goes on in further rows where it is too narrow for all.
class WrappingRow : public QHBoxLayout {
    Q_OBJECT

  public:
    using QHBoxLayout::QHBoxLayout;
    QSize minimumSize() const override;
    /// As high as its rows.
    QSize maximumSize() const override { return {QLAYOUTSIZE_MAX, QLAYOUTSIZE_MAX}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    int minimumHeightForWidth(int width) const override { return heightForWidth(width); }
    void setGeometry(const QRect& room) override;

  private:
    /// Where its items stand in a room of this width, counted from its top left; the height.
    int place(int width, QList<std::pair<QLayoutItem*, QRect>>* places) const;
};

/// Two groups of fields and buttons in a row, the second at its end; one above the other where the
/// row is too narrow for both, and each in further rows where that is too narrow for it.
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
    void showEvent(QShowEvent* event) override;

  private:
    void arrange();
    QBoxLayout* both_ = nullptr;
    WrappingRow *first_ = nullptr, *second_ = nullptr;
};

} // namespace smat::gui
