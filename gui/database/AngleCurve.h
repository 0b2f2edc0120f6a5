#pragma once

#include <functional>
#include <vector>

#include <QWidget>

namespace smat::gui {

/// A small curve from 0 to 1 over the viewing angle from 0 to 90 degrees, with dotted ones to
/// compare it with.
class AngleCurve : public QWidget {
    Q_OBJECT

  public:
    /// Of the cosine of the viewing angle.
    using Value = std::function<double(double cosine)>;

    /// `quantity`: beside the axis.
    explicit AngleCurve(QString quantity, QWidget* parent = nullptr);
    /// cos^N, between those of N = 0, 0.25, 1 and 3 (report figure 47).
    void showFactor(double factor);
    void show(const Value& value, const std::vector<Value>& toCompare = {});
    /// No curve, and why there is none.
    void clear(const QString& why = {});
    const QString& whyEmpty() const { return why_; }
    QSize sizeHint() const override { return {240, 150}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    using Values = std::vector<double>; // one a degree
    static Values tabulated(const Value& value);

    QString quantity_, why_;
    Values shown_;
    std::vector<Values> compared_;
};

} // namespace smat::gui
