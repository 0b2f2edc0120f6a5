#pragma once

#include <vector>

#include <QAbstractButton>

namespace smat::gui {

/// A stage of a chain as a card to choose: its name, its transfer function as a small curve from
/// frequency 0 to the last, and a number.
class StageCard : public QAbstractButton {
    Q_OBJECT

  public:
    StageCard(const QString& name, const QString& title, QWidget* parent = nullptr);

    /// Values 0 to 1 at equal steps of frequency; none for a stage without a transfer function.
    void setCurve(std::vector<double> values, const QString& number);
    const std::vector<double>& curve() const { return curve_; }
    const QString& number() const { return number_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::vector<double> curve_;
    QString number_;
};

} // namespace smat::gui
