#pragma once

#include <QWidget>

#include "gui/widgets/Exportable.h"
#include "smatcore/analysis/MonteCarlo.h"

class QLabel;
class QSlider;
class QSplitter;
class QwtPlot;

namespace smat::gui {

class CartesianPlot;
class RankingBars;

/// What a Monte Carlo analysis found: bands over the abscissa, the histogram at one abscissa, and
/// the ranking of the scales.
class MonteCarloPlots : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit MonteCarloPlots(QWidget* parent = nullptr);

    void setData(const MonteCarloData& data);
    const MonteCarloData& data() const { return data_; }
    const CartesianPlot* bands() const { return bands_; }
    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void makePlots();
    void drawBands();
    void drawHistogram();
    void drawRanking();

    MonteCarloData data_;
    QSplitter* columns_ = nullptr;
    QSplitter* below_ = nullptr;
    CartesianPlot* bands_ = nullptr;
    QWidget* histogramPart_ = nullptr;
    QwtPlot* histogram_ = nullptr;
    QSlider* place_ = nullptr;
    QLabel* placeText_ = nullptr;
    QLabel* empty_ = nullptr; ///< in the place of the plots before the first run
    RankingBars* ranking_ = nullptr;
};

} // namespace smat::gui
