#pragma once

#include <QWidget>

#include "smatcore/analysis/DetectionRequest.h"

class QComboBox;
class QFormLayout;
class QLineEdit;

namespace smat::gui {

class RealBox;

/// What a detection is a table of: the range over aspects or directions, against wind, hour, band
/// or paint, or the probability over ranges.
class DetectionCasesBox : public QWidget {
    Q_OBJECT

  public:
    explicit DetectionCasesBox(QWidget* parent);

    /// Sets cases, comparison, ranges and draws. Throws irsg::InputError for fields that say
    /// nothing usable.
    void fill(DetectionRequest& request) const;
    /// Whether a range is sought, not the probability at given ones.
    bool seeksRange() const;
    /// Whether a row is a case, not the mean of all.
    bool isByCase() const;
    RangeCases cases() const;

  signals:
    void changed();

  private:
    void showFields();

    QFormLayout* form_ = nullptr;
    QComboBox* what_ = nullptr;
    QLineEdit *values_ = nullptr, *paint_ = nullptr, *sunOf_ = nullptr, *ranges_ = nullptr;
    RealBox* draws_ = nullptr;
};

} // namespace smat::gui
