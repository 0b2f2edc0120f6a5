#include "gui/database/NodeEditor.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/database/NodePlot.h"
#include "gui/database/NodeTable.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"

namespace smat::gui {

NodeEditor::NodeEditor(QWidget* parent) : QWidget(parent) {
    setObjectName("nodeEditor");
    model_ = new NodeTableModel(this);
    table_ = new NodeTable(*model_, this);
    plot_ = new NodePlot(this);
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setChildrenCollapsible(false);
    split->addWidget(table_);
    split->addWidget(plot_);
    split->setStretchFactor(0, 2);
    split->setStretchFactor(1, 3);

    bar_ = new QHBoxLayout;
    bar_->setContentsMargins(0, 0, 0, 0);
    bar_->setSpacing(2);
    connect(button("row-insert", "insertRow", tr("Insert a row before the current one (Insert)")),
            &QToolButton::clicked, table_, &NodeTable::insertRow);
    connect(button("row-remove", "removeRows", tr("Remove the selected rows (Delete)")),
            &QToolButton::clicked, table_, &NodeTable::removeRows);
    connect(button("copy-table", "copyTable",
                   tr("Copy the selected rows, or all, for a spreadsheet (Ctrl+C)")),
            &QToolButton::clicked, table_, &NodeTable::copy);
    connect(button("paste-table", "pasteTable",
                   tr("Paste rows from a spreadsheet in place of all rows "
                      "(Ctrl+V in the table pastes at the current cell)")),
            &QToolButton::clicked, table_, &NodeTable::pasteAll);
    message_ = new QLabel(this);
    message_->setObjectName("nodeMessage");
    message_->setWordWrap(true);
    QFont small = message_->font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    message_->setFont(small);
    bar_->addSpacing(6);
    bar_->addWidget(message_, 1);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(bar_);
    column->addWidget(split, 1);

    connect(table_, &NodeTable::problem, this, [this](const QString& sentence) {
        message_->setStyleSheet(
            QStringLiteral("color: %1").arg(colors::errorText(palette()).name()));
        message_->setText(sentence);
    });
    connect(table_, &NodeTable::nodeSelected, plot_, &NodePlot::selectNode);
    connect(plot_, &NodePlot::nodeSelected, table_, &NodeTable::selectNode);
    connect(model_, &NodeTableModel::edited, this, [this](const Nodes& nodes, const QString& what) {
        message_->clear();
        plot_->setNodes(nodes);
        emit edited(nodes, what);
        emit gestureEnded();
    });
    connect(plot_, &NodePlot::edited, this, [this](const Nodes& nodes, double x) {
        message_->clear();
        model_->setNodes(nodes);
        emit edited(nodes, placeText(x));
    });
    connect(plot_, &NodePlot::dragEnded, this, &NodeEditor::gestureEnded);
    connect(plot_, &NodePlot::added, this, [this](const Nodes& nodes, double x) {
        model_->setNodes(nodes);
        table_->selectNode(plot_->selectedNode());
        emit edited(nodes, tr("(node added %1)").arg(placeText(x)));
        emit gestureEnded();
    });
    connect(plot_, &NodePlot::removed, this, [this](const Nodes& nodes, double x) {
        model_->setNodes(nodes);
        emit edited(nodes, tr("(node removed %1)").arg(placeText(x)));
        emit gestureEnded();
    });
}

QToolButton* NodeEditor::button(const QString& picture, const QString& name, const QString& tip) {
    auto* made = new QToolButton(this);
    made->setObjectName(name);
    made->setIcon(icon(picture));
    made->setToolTip(tip);
    made->setAutoRaise(true);
    bar_->addWidget(made);
    return made;
}

void NodeEditor::addToBar(QWidget* widget) {
    bar_->addWidget(widget);
}

QString NodeEditor::placeText(double x) const {
    const QString unit = model_->rules().xUnit;
    return tr("at %1").arg(textOf(x)) + (unit.isEmpty() ? QString() : " " + unit);
}

void NodeEditor::setRules(const NodeRules& rules) {
    model_->setRules(rules);
    plot_->setRules(rules);
}

void NodeEditor::setNodes(const Nodes& nodes) {
    model_->setNodes(nodes);
    if (!(plot_->nodes() == nodes))
        plot_->setNodes(nodes);
}

const Nodes& NodeEditor::nodes() const {
    return model_->nodes();
}

} // namespace smat::gui

#include "moc_NodeEditor.cpp"
