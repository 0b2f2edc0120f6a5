#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QWidget>

#include "gui/plot/TablePlot.h"
#include "gui/widgets/Dialogs.h"
#include "smatcore/tables/TableFormats.h"

class QComboBox;
class QLabel;

namespace smat::gui {

/// A signature table with the choice of what is seen of it: quantity, band, range and state, scale
/// and colours; and what copies and writes it.
class TablePanel : public QWidget {
    Q_OBJECT

  public:
    /// Throws irsg::InputError as SignatureTable does.
    TablePanel(std::shared_ptr<const ResultTable> table, Dialogs dialogs,
               QWidget* parent = nullptr);

    TablePlot* plot() const { return plot_; }
    void setTitle(const QString& title);
    void setConditions(const QString& conditions);
    /// As exportTable does. Throws irsg::InputError.
    void exportTo(const std::filesystem::path& file) const;

  private:
    QComboBox* box(const QString& name, const QString& tip);
    void fillBar();
    void choose();
    void save();

    Dialogs dialogs_;
    TablePlot* plot_ = nullptr;
    TableVariables variables_;
    QComboBox *quantity_ = nullptr, *band_ = nullptr, *scale_ = nullptr, *colors_ = nullptr;
    std::vector<QComboBox*> axes_;
    QLabel* readout_ = nullptr;
};

} // namespace smat::gui
