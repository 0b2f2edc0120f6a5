#pragma once

#include <QSplitter>

namespace smat::gui {

/// A form beside what it makes; above it where the width is too small for both, so that a page is
/// never cut at its right.
class FoldingSplitter : public QSplitter {
    Q_OBJECT

  public:
    /// `form_px`: its width beside `result`, which takes the rest.
    FoldingSplitter(QWidget* form, int form_px, QWidget* result, QWidget* parent);
    /// As wide as the wider of the two, and as high as both where one is above the other.
    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QList<int> beside_;  ///< sizes to come back to
    QSizePolicy policy_; ///< of the form beside its result
};

} // namespace smat::gui
