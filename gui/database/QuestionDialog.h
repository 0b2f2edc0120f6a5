#pragma once

#include <QDialog>
#include <QStringList>

namespace smat::gui {

/// A question with a few answers and Cancel.
class QuestionDialog : public QDialog {
    Q_OBJECT

  public:
    /// The buttons are named answer0, answer1 and so on; the first is the usual one.
    QuestionDialog(const QString& title, const QString& text, const QStringList& answers,
                   QWidget* parent = nullptr);

    /// Number of the answer that was given; the first until then.
    int answer() const { return answer_; }

  private:
    int answer_ = 0;
};

} // namespace smat::gui
