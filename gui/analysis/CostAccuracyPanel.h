#pragma once

#include <optional>

#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/settings/Settings.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSplitter;
class QTreeWidget;

namespace smat::gui {

class PlotPanel;

/// What Frontier measured: time over true error of every way, both logarithmic, with the front as a
/// line and the chosen way; below it the ways with their settings. One of them is marked in plot
/// and table, and can be taken.
class CostAccuracyPanel : public QWidget, public Exportable {
    Q_OBJECT

  public:
    explicit CostAccuracyPanel(Dialogs dialogs, QWidget* parent = nullptr);

    /// A table of CostAccuracyStudy::run.
    void setTable(const ResultTable& table);
    const ResultTable& table() const { return table_; }
    PlotPanel& plot() const { return *plot_; }
    /// A row of the table; none where nothing is marked.
    std::optional<std::size_t> marked() const;
    void mark(std::size_t row);
    /// Without it there is nothing that a way could be used for.
    void setUsable(bool usable);

    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  signals:
    /// The settings of the way that is marked, and its name for a step: "time against error: mode
    /// 4, ...".
    void useAsked(const smat::Settings& settings, const QString& step);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fillPlot();
    void fillConfigurations();
    void showMark();
    void askToUse();
    std::optional<std::size_t> configurationNear(const QPointF& canvasPoint) const;

    ResultTable table_;
    PlotPanel* plot_ = nullptr;
    QSplitter* parts_ = nullptr;
    QTreeWidget* configurations_ = nullptr;
    QCheckBox* all_ = nullptr;
    QLabel* said_ = nullptr;
    QPushButton* use_ = nullptr;
    bool usable_ = false;
};

} // namespace smat::gui
