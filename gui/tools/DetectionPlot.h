#pragma once

#include <filesystem>
#include <memory>

#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "smatcore/analysis/AnalysisData.h"

class QComboBox;
class QStackedLayout;

namespace smat::gui {

class PlotPanel;
class TablePanel;

/// The plot of a detection: a rose over aspect, a table and ball over directions, curves else.
class DetectionPlot : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit DetectionPlot(Dialogs dialogs, QWidget* parent);

    void setResult(std::shared_ptr<const AnalysisData> result);
    /// The rose, or the curves.
    const PlotPanel& plot() const;
    /// Null unless the result is over directions.
    const TablePanel* table() const { return table_; }

    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  private:
    struct Panel {
        PlotPanel* panel = nullptr;
        QComboBox* quantity = nullptr;
    };
    Panel panelOf(bool isPolar);
    void draw();

    Dialogs dialogs_;
    QStackedLayout* pages_ = nullptr;
    Panel rose_, curves_;
    TablePanel* table_ = nullptr;
    std::shared_ptr<const AnalysisData> result_;
};

} // namespace smat::gui
