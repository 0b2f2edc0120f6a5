#pragma once

#include <array>
#include <optional>

#include <QWidget>

#include "irsg/image/ImageComparison.h"

class QLabel;
class QLineEdit;

namespace smat::gui {

/// The thresholds of a comparison, failures beside warnings, in fields that take what the command
/// line takes. What cannot be used is told below and leaves the thresholds as they were.
class ThresholdForm : public QWidget {
    Q_OBJECT

  public:
    explicit ThresholdForm(QWidget* parent = nullptr);

    const irsg::ComparisonLevel& fail() const { return levels_[0]; }
    const irsg::ComparisonLevel& warn() const { return levels_[1]; }
    /// Unit of the absolute thresholds.
    void setUnit(const QString& unit);
    /// As options of `smat-batch compare`, those that are not the defaults.
    QString options() const;

  signals:
    void changed();

  private:
    enum Row { absolute, relative, percent, hard, allowed, rowCount };
    void read();
    void write();
    std::optional<irsg::ComparisonLevel> levelIn(std::size_t column, QStringList& wrong) const;

    std::array<irsg::ComparisonLevel, 2> levels_; ///< fail, warn
    std::array<std::array<QLineEdit*, rowCount>, 2> fields_{};
    std::array<QLabel*, rowCount> names_{};
    QLabel* wrong_ = nullptr;
};

} // namespace smat::gui
