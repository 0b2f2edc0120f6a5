#pragma once

#include <functional>
#include <limits>
#include <optional>

#include <QLineEdit>

#include "gui/widgets/NumberText.h"

namespace smat::gui {

/// A number with its unit inside the field, typed by the rule of typedNumber(). Reddens and says
/// why while its text is no number of its range, and goes back to what was there before such a
/// text; steps with the arrow keys.
class NumberField : public QLineEdit {
    Q_OBJECT

  public:
    explicit NumberField(const QString& unit, QWidget* parent = nullptr);

    void setRange(double minimum, double maximum);
    /// The sentence why a number cannot stand, empty where it can: asked before the range.
    using Check = std::function<QString(double value)>;
    void setCheck(Check check) { check_ = std::move(check); }
    void setStep(double step) { step_ = step; }
    /// Leaves the text alone where it says this already.
    void setValue(double value);
    double value() const { return value_; }
    bool isRight() const { return problem_.isEmpty(); }
    /// Why what is typed cannot stand; empty where it can.
    const QString& problem() const { return problem_; }

  signals:
    /// By the user, a number within the range.
    void edited(double value);
    /// The typing is over.
    void finished();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    void onText(const QString& text);
    void finish();
    void mark(const QString& problem);
    /// What may be below 0 K is a difference of temperatures.
    NumberMeaning meaning() const {
        return minimum_ < 0.0 ? NumberMeaning::difference : NumberMeaning::value;
    }

    QString unit_, help_, problem_;
    Check check_;
    double minimum_ = -std::numeric_limits<double>::infinity();
    double maximum_ = std::numeric_limits<double>::infinity();
    double step_ = 1.0, value_ = 0.0;
    std::optional<double> before_; ///< the typing that goes on
};

} // namespace smat::gui
