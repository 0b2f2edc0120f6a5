#include "gui/database/NodeTable.h"

#include <algorithm>
#include <set>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>

namespace smat::gui {

NodeTableModel::NodeTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void NodeTableModel::setRules(NodeRules rules) {
    rules_ = std::move(rules);
    emit headerDataChanged(Qt::Horizontal, 0, 1);
}

void NodeTableModel::setNodes(const Nodes& nodes) {
    if (nodes == nodes_)
        return;
    if (nodes.size() == nodes_.size()) {
        nodes_ = nodes;
        emit dataChanged(index(0, 0), index(rowCount() - 1, 1));
        return;
    }
    beginResetModel();
    nodes_ = nodes;
    endResetModel();
}

int NodeTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(nodes_.size()) + 1;
}

int NodeTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 2;
}

QVariant NodeTableModel::data(const QModelIndex& index, int role) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && row == nodes_.size())
        return tr("Type a value to add a row");
    if ((role != Qt::DisplayRole && role != Qt::EditRole) || row >= nodes_.size())
        return {};
    return textOf(index.column() == 0 ? nodes_[row].x : nodes_[row].y);
}

QVariant NodeTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const bool isTitle = orientation == Qt::Horizontal && role == Qt::ToolTipRole;
    if (role != Qt::DisplayRole && !isTitle)
        return QAbstractTableModel::headerData(section, orientation, role);
    if (orientation == Qt::Horizontal)
        return QString(section == 0 ? rules_.xTitle() : rules_.yTitle()).replace(" (", "\n(");
    return section < static_cast<int>(nodes_.size()) ? QVariant(section + 1) : QVariant("+");
}

Qt::ItemFlags NodeTableModel::flags(const QModelIndex&) const {
    return Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable;
}

Nodes NodeTableModel::with(const QModelIndex& cell, double value) const {
    Nodes changed = nodes_;
    const auto row = static_cast<std::size_t>(cell.row());
    if (row == changed.size()) {
        const Node next = changed.empty() ? Node{rules_.xStep, rules_.yStart}
                                          : Node{changed.back().x + rules_.xStep, changed.back().y};
        changed.push_back(next);
    }
    (cell.column() == 0 ? changed[row].x : changed[row].y) = value;
    return changed;
}

QString NodeTableModel::problemOf(const QModelIndex& cell, const QString& text) const {
    const bool isNew = cell.row() == static_cast<int>(nodes_.size());
    if (isNew && text.trimmed().isEmpty())
        return {};
    const TypedNumber typed = typedNumber(text, unitOf(cell));
    const auto number = typed.value;
    if (!number)
        return typed.problem;
    const Nodes changed = with(cell, *number);
    const auto row = static_cast<std::size_t>(cell.row());
    if (cell.column() == 1)
        return rules_.problemOfY(changed[row].x, *number);
    if (const QString problem = rules_.problemOfX(*number); !problem.isEmpty())
        return problem;
    if (row > 0 && *number <= changed[row - 1].x)
        return tr("%1 has to be above %2, the row before")
            .arg(rules_.xName, textOf(changed[row - 1].x));
    if (row + 1 < changed.size() && *number >= changed[row + 1].x)
        return tr("%1 has to be below %2, the row after")
            .arg(rules_.xName, textOf(changed[row + 1].x));
    return rules_.problemOfY(*number, changed[row].y);
}

bool NodeTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const auto number = typedNumber(value.toString(), unitOf(index)).value;
    if (role != Qt::EditRole || !number)
        return false;
    const auto row = static_cast<std::size_t>(index.row());
    const Nodes changed = with(index, *number);
    const QString unit = rules_.xUnit.isEmpty() ? QString() : " " + rules_.xUnit;
    return changed == nodes_ ||
           take(changed, tr("at %1%2").arg(textOf(changed[row].x), unit)).isEmpty();
}

QString NodeTableModel::take(const Nodes& nodes, const QString& what) {
    // A few nodes fewer than a table needs are on their way to it, or to none.
    if (const QString problem = rules_.problemOf(nodes); !problem.isEmpty())
        return problem;
    setNodes(nodes);
    emit edited(nodes_, what);
    return {};
}

NodeTable::NodeTable(NodeTableModel& model, QWidget* parent)
    : NumericTableView(
          model, "nodeCell",
          [&model](const QModelIndex& cell, const QString& text) {
              return model.problemOf(cell, text);
          },
          parent),
      model_(model) {
    setObjectName("nodeTable");
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    horizontalHeader()->setTextElideMode(Qt::ElideRight);
    setMinimumWidth(185);
}

QString NodeTable::pasteAt(const QModelIndex& cell, const Rows& block) {
    const std::size_t columns = block.front().size();
    if (columns > 2)
        return tr("%1 columns do not fit: a table has two").arg(columns);
    if (columns == 1 && cell.row() + block.size() > model_.nodes().size())
        return tr("one column of %1 rows does not fit below row %2")
            .arg(block.size())
            .arg(cell.row() + 1);
    Nodes nodes = model_.nodes();
    for (std::size_t i = 0; i < block.size(); ++i) {
        const std::size_t row = static_cast<std::size_t>(cell.row()) + i;
        if (row >= nodes.size())
            nodes.resize(row + 1);
        if (columns == 2)
            nodes[row] = {block[i][0], block[i][1]};
        else
            (cell.column() == 0 ? nodes[row].x : nodes[row].y) = block[i][0];
    }
    return model_.take(nodes, tr("(%1 rows pasted)").arg(block.size()));
}

void NodeTable::pasteAll() {
    if (isReadOnly())
        return;
    const auto rows = clipboardRows();
    if (!rows)
        return;
    if (rows->front().size() != 2) {
        emit problem(tr("two columns are needed, %1 and %2; these rows have %3")
                         .arg(model_.rules().xName, model_.rules().yName)
                         .arg(rows->front().size()));
        return;
    }
    Nodes nodes;
    for (const auto& row : *rows)
        nodes.push_back({row[0], row[1]});
    if (nodes.size() > 1 && nodes.front().x > nodes.back().x)
        std::reverse(nodes.begin(), nodes.end());
    emit problem(model_.take(nodes, tr("(%1 rows pasted)").arg(nodes.size())));
}

void NodeTable::copy() const {
    Nodes chosen;
    for (const int row : chosenRows())
        if (row < static_cast<int>(model_.nodes().size()))
            chosen.push_back(model_.nodes()[static_cast<std::size_t>(row)]);
    QApplication::clipboard()->setText(
        spreadsheetText(chosen.size() > 1 ? chosen : model_.nodes()));
}

void NodeTable::insertRow() {
    if (isReadOnly())
        return;
    Nodes nodes = model_.nodes();
    const auto row = static_cast<std::size_t>(std::max(currentIndex().row(), 0));
    if (nodes.empty() || row >= nodes.size()) {
        setCurrentIndex(model_.index(static_cast<int>(nodes.size()), 0));
        edit(currentIndex());
        return;
    }
    // Halfway to the row before, or as far before the first as the second is behind it.
    Node between = nodes[row];
    if (row > 0) {
        // In twelve digits, so that 0.6 and 0.7 give 0.65 and not 0.6499999999999999.
        const auto middle = [](double a, double b) {
            return QString::number((a + b) / 2.0, 'g', 12).toDouble();
        };
        between = {middle(nodes[row - 1].x, nodes[row].x), middle(nodes[row - 1].y, nodes[row].y)};
    } else {
        between.x -= nodes.size() > 1 ? nodes[1].x - nodes[0].x : model_.rules().xStep;
        if (!model_.rules().problemOfX(between.x).isEmpty()) {
            emit problem(tr("there is no room before the first row"));
            return;
        }
    }
    nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(row), between);
    emit problem(model_.take(nodes, tr("(row inserted at %1)").arg(textOf(between.x))));
    selectNode(static_cast<int>(row));
}

void NodeTable::removeRows() {
    if (isReadOnly())
        return;
    std::set<int> rows = chosenRows();
    if (currentIndex().isValid())
        rows.insert(currentIndex().row());
    Nodes kept;
    for (std::size_t i = 0; i < model_.nodes().size(); ++i)
        if (!rows.contains(static_cast<int>(i)))
            kept.push_back(model_.nodes()[i]);
    const auto gone = model_.nodes().size() - kept.size();
    if (gone == 0)
        return;
    emit problem(
        model_.take(kept, gone == 1 ? tr("(row removed)") : tr("(%1 rows removed)").arg(gone)));
}

void NodeTable::selectNode(int row) {
    if (row >= 0 && row < model_.rowCount() && row != currentIndex().row())
        setCurrentIndex(model_.index(row, std::max(currentIndex().column(), 0)));
}

void NodeTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    NumericTableView::currentChanged(current, previous);
    if (current.row() < static_cast<int>(model_.nodes().size()))
        emit nodeSelected(current.row());
}

} // namespace smat::gui

#include "moc_NodeTable.cpp"
