#pragma once

#include "gui/database/EntryNumbers.h"
#include "gui/database/EntryPanel.h"

class QTabWidget;
class QTableView;
class QCheckBox;

namespace smat::gui {

class CartesianPlot;
class SpectrumTableModel;

/// One user-defined spectrum: its reference distance, its components as curves and as a table, and
/// the notes.
class SpectrumPanel : public EntryPanel {
    Q_OBJECT

  public:
    explicit SpectrumPanel(EditorContext& context, QWidget* parent = nullptr);
    QTabWidget* tabs() const { return tabs_; }
    CartesianPlot* plot() const { return plot_; }

  protected:
    void refresh() override;
    void changeEvent(QEvent* event) override;

  private:
    void makePlot();

    EntryNumbers<irsg::UserSpectrum> numbers_;
    QTabWidget* tabs_ = nullptr;
    QWidget* plotPage_ = nullptr;
    CartesianPlot* plot_ = nullptr;
    QCheckBox* logarithmic_ = nullptr;
    SpectrumTableModel* model_ = nullptr;
    QTableView* table_ = nullptr;
    irsg::UserSpectrum shown_;
};

} // namespace smat::gui
