#pragma once

#include <filesystem>
#include <vector>

#include <QStringList>
#include <QWidget>

#include "gui/analysis/ResultStore.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"

class QCheckBox;
class QComboBox;

namespace smat::gui {

class CartesianPlot;
class CostAccuracyPanel;
class ImageView;
class ModelStore;
class MonteCarloPlots;
class PlotPanel;
class PolarPlot;
class TablePanel;

/// A page with one result, or several on one plot: an image, a polar plot or a Cartesian one, with
/// what belongs to it.
class ResultPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    /// LogicError for no result; irsg::InputError for results that do not go on one plot.
    explicit ResultPage(const std::vector<ResultEntry>& results,
                        Dialogs dialogs = Dialogs::ofDesktop(), QWidget* parent = nullptr);

    const QList<int>& resultIds() const { return ids_; }
    /// An image is explained with these models; the page lets go of them with itself.
    void setModels(const std::shared_ptr<ModelStore>& models);
    ImageView* imageView() const { return image_; }
    TablePanel* tablePanel() const { return tables_; }
    PlotPanel* panel() const { return panel_; }
    MonteCarloPlots* monteCarlo() const { return draws_; }
    CostAccuracyPanel* costAccuracy() const { return costAccuracy_; }
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
    void showTable(Dialogs dialogs);
    void showCostAccuracy(Dialogs dialogs);
    void drawQuantity();

    std::vector<ResultEntry> results_;
    QList<int> ids_;
    ImageView* image_ = nullptr;
    PlotPanel* panel_ = nullptr;
    TablePanel* tables_ = nullptr;
    MonteCarloPlots* draws_ = nullptr;
    CostAccuracyPanel* costAccuracy_ = nullptr;
    QComboBox* quantity_ = nullptr;
    QCheckBox* stack_ = nullptr; ///< null where nothing can be stacked
    bool drawn_ = false;
};

} // namespace smat::gui
