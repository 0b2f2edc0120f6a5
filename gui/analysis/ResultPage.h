#pragma once

#include <filesystem>
#include <vector>

#include <QStringList>
#include <QWidget>

#include "gui/analysis/ResultStore.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"

class QComboBox;

namespace smat::gui {

class CartesianPlot;
class ImageView;
class MonteCarloPlots;
class PlotPanel;
class PolarPlot;

/// A page with one result, or several on one plot: an image, a polar plot or a Cartesian one, with
/// what belongs to it.
class ResultPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    /// LogicError for no result; irsg::InputError for results that do not go on one plot.
    explicit ResultPage(const std::vector<ResultEntry>& results,
                        Dialogs dialogs = Dialogs::ofDesktop(), QWidget* parent = nullptr);

    const QList<int>& resultIds() const { return ids_; }
    ImageView* imageView() const { return image_; }
    PlotPanel* panel() const { return panel_; }
    MonteCarloPlots* monteCarlo() const { return draws_; }
    PolarPlot* polarPlot() const;
    CartesianPlot* cartesianPlot() const;
    /// Another name of one of its results, which its curve takes.
    void rename(int id, const QString& title);

    /// Filters of a file dialog for what this page can be written as, data first.
    QStringList exportFilters() const override;
    /// By the suffix of the file. Throws irsg::InputError.
    void exportTo(const std::filesystem::path& file) const override;

  private:
    void showImage(Dialogs dialogs);
    void showPlot(Dialogs dialogs);
    void showMonteCarlo();
    void drawQuantity();

    std::vector<ResultEntry> results_;
    QList<int> ids_;
    ImageView* image_ = nullptr;
    PlotPanel* panel_ = nullptr;
    MonteCarloPlots* draws_ = nullptr;
    QComboBox* quantity_ = nullptr;
    bool drawn_ = false;
};

} // namespace smat::gui
