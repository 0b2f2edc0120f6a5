#pragma once

#include <QWidget>

#include "gui/database/Nodes.h"

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace smat::gui {

class NodePlot;
class NodeTable;
class NodeTableModel;

/// A table of nodes beside its plot; both edit, and both show what the other did.
class NodeEditor : public QWidget {
    Q_OBJECT

  public:
    explicit NodeEditor(QWidget* parent = nullptr);

    void setRules(const NodeRules& rules);
    void setNodes(const Nodes& nodes);
    const Nodes& nodes() const;
    NodePlot* plot() const { return plot_; }
    NodeTable* table() const { return table_; }
    /// Room at the right end of the row of buttons, for what belongs to this table.
    void addToBar(QWidget* widget);

  signals:
    /// By the user. `what` ends the name of the step: "at 4.2 um", "(3 rows pasted)". Edits
    /// belong together until gestureEnded.
    void edited(const smat::gui::Nodes& nodes, const QString& what);
    void gestureEnded();

  private:
    QToolButton* button(const QString& icon, const QString& name, const QString& tip);
    QString placeText(double x) const;

    NodeTableModel* model_ = nullptr;
    NodeTable* table_ = nullptr;
    NodePlot* plot_ = nullptr;
    QLabel* message_ = nullptr;
    QHBoxLayout* bar_ = nullptr;
};

} // namespace smat::gui
