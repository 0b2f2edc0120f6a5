#pragma once

#include <QWidget>

#include "gui/image/ComparedPair.h"

class QLabel;
class QTabWidget;

namespace smat::gui {

class ComparisonCommand;
class FiguresTable;
class ImageInspector;
class ThresholdForm;

/// What is to be said of a compared pair, beside its difference: the verdict, and in tabs the
/// numbers, the thresholds with the command line below them, and the histogram.
class ComparisonReport : public QWidget {
    Q_OBJECT

  public:
    enum Tab { numbersTab, thresholdsTab, histogramTab };
    explicit ComparisonReport(QWidget* parent = nullptr);

    /// Verdict, sentence and numbers.
    void show(const ComparedPair& pair);
    /// A tab, or the numbers where it is shown already.
    void toggle(Tab tab);
    FiguresTable* numbers() const { return numbers_; }
    ThresholdForm* thresholds() const { return thresholds_; }
    ComparisonCommand* command() const { return command_; }
    ImageInspector* inspector() const { return inspector_; }

  private:
    QWidget* makeThresholdsTab();
    void showNumbers(const ComparedPair& pair);
    void showVerdict(const ComparedPair& pair);

    FiguresTable* numbers_ = nullptr;
    ThresholdForm* thresholds_ = nullptr;
    ComparisonCommand* command_ = nullptr;
    ImageInspector* inspector_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    QLabel* verdict_ = nullptr;
    QLabel* sentence_ = nullptr;
};

} // namespace smat::gui
