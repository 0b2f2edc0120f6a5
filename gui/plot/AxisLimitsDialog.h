#pragma once

#include <vector>

#include <QDialog>

#include "gui/plot/PlotData.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace smat::gui {

/// Takes the ends of the axes of a plot to every digit. Says what is wrong as one types.
class AxisLimitsDialog : public QDialog {
    Q_OBJECT

  public:
    struct Axis {
        QString title; ///< with its unit
        Interval limits;
        bool positive = false; ///< logarithmic: limits above 0 alone
    };

    explicit AxisLimitsDialog(const std::vector<Axis>& axes, QWidget* parent = nullptr);

    /// Those of the fields, in the order of the axes; only while isAcceptable().
    std::vector<Interval> limits() const;
    bool isAcceptable() const { return problems().isEmpty(); }

  private:
    QStringList problems() const;
    void refresh();

    struct Row {
        Axis axis;
        QLineEdit* from = nullptr;
        QLineEdit* to = nullptr;
    };
    std::vector<Row> rows_;
    QLabel* problems_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
