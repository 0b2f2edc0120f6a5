#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QToolButton;

namespace smat::gui {

/// The line of smat-batch that gives the numbers of a comparison, to be read and copied, or why
/// there is none.
class ComparisonCommand : public QWidget {
    Q_OBJECT

  public:
    explicit ComparisonCommand(QWidget* parent = nullptr);

    /// Empty where no file holds an image.
    void setCommand(const QString& command);
    void copy() const;

  private:
    QLabel* words_ = nullptr;
    QLineEdit* line_ = nullptr;
    QToolButton* copy_ = nullptr;
};

} // namespace smat::gui
