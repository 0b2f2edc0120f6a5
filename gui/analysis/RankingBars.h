#pragma once

#include <vector>

#include <QWidget>

#include "smatcore/analysis/SampleStatistics.h"

namespace smat::gui {

/// One bar of a ranking: a scale, what it does alone and what it does in all.
struct RankingBar {
    QString name;
    Estimate firstOrder, total;
};

/// Sobol' indices as horizontal bars with their 95 % intervals, the most important one at the top:
/// filled to the first-order index, outlined to the total one.
class RankingBars : public QWidget {
    Q_OBJECT

  public:
    explicit RankingBars(QWidget* parent = nullptr);

    void setBars(std::vector<RankingBar> bars);
    const std::vector<RankingBar>& bars() const { return bars_; }
    /// What is said in place of bars.
    void setHint(const QString& hint);

    QSize sizeHint() const override { return {360, 240}; }
    QSize minimumSizeHint() const override { return {130, 120}; }

    /// Shares that the axis goes over, round ones: an estimate of an index may lie below 0.
    struct Axis {
        double least, most, step;
    };
    Axis axis() const;
    /// Below the axis: of what, and what an index below 0 means where there is one.
    QString caption() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

  private:
    int rowHeight() const;

    std::vector<RankingBar> bars_;
    QString hint_;
};

} // namespace smat::gui
