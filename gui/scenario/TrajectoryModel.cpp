#include "gui/scenario/TrajectoryModel.h"

#include <algorithm>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/NumberText.h"
#include "gui/widgets/Sentences.h"

namespace smat::gui {
namespace {

using Row = TrajectoryTable::Row;

const TrajectoryColumn& columnOf(TrajectoryTable::Column column) {
    return TrajectoryTable::columns()[column];
}

QString nameOf(TrajectoryTable::Column column) {
    return column == TrajectoryTable::time
               ? TrajectoryModel::tr("time")
               : QString::fromStdString(std::string(columnOf(column).name));
}

/// In twelve digits, so that halfway between 0.6 and 0.7 is 0.65.
double roundedNumber(double value) {
    return QString::number(value, 'g', 12).toDouble();
}

} // namespace

TrajectoryModel::TrajectoryModel(QObject* parent) : QAbstractTableModel(parent) {}

void TrajectoryModel::setTable(const TrajectoryTable& table) {
    if (table == table_)
        return;
    if (table.hasPower != table_.hasPower || table.hasMach != table_.hasMach) {
        beginResetModel();
        table_ = table;
        endResetModel();
        return;
    }
    // Rows come and go at the end, so that what is chosen and typed in stays.
    const int before = points(), after = static_cast<int>(table.rows.size());
    if (after > before)
        beginInsertRows({}, before, after - 1);
    else if (after < before)
        beginRemoveRows({}, after, before - 1);
    table_ = table;
    if (after > before)
        endInsertRows();
    else if (after < before)
        endRemoveRows();
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

TrajectoryTable::Column TrajectoryModel::columnAt(int section) const {
    int seen = -1;
    for (int i = 0; i < TrajectoryTable::columnCount; ++i) {
        const auto column = static_cast<TrajectoryTable::Column>(i);
        if (table_.has(column) && ++seen == section)
            return column;
    }
    return TrajectoryTable::time;
}

int TrajectoryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : points() + 1;
}

int TrajectoryModel::columnCount(const QModelIndex& parent) const {
    const int optional = (table_.hasPower ? 1 : 0) + (table_.hasMach ? 1 : 0);
    return parent.isValid() ? 0 : TrajectoryTable::power + optional;
}

QVariant TrajectoryModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.row() == points())
        return tr("Type a value to add a row");
    if ((role != Qt::DisplayRole && role != Qt::EditRole) || index.row() >= points())
        return {};
    return gui::textOf(
        table_.rows[static_cast<std::size_t>(index.row())][columnAt(index.column())]);
}

QVariant TrajectoryModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole)
        return QAbstractTableModel::headerData(section, orientation, role);
    if (orientation == Qt::Vertical)
        return section < points() ? QVariant(section + 1) : QVariant("+");
    const TrajectoryTable::Column column = columnAt(section);
    const QString unit = formattedUnit(std::string(columnOf(column).unit));
    return unit.isEmpty() ? nameOf(column) : QStringLiteral("%1\n(%2)").arg(nameOf(column), unit);
}

Qt::ItemFlags TrajectoryModel::flags(const QModelIndex&) const {
    return Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemIsEditable;
}

TrajectoryTable::Row TrajectoryModel::nextOf(const std::vector<Row>& rows) {
    if (rows.empty())
        return {};
    Row next = rows.back();
    if (rows.size() < 2) {
        next[TrajectoryTable::time] += 1.0;
        return next;
    }
    const Row& before = rows[rows.size() - 2];
    for (const auto column :
         {TrajectoryTable::time, TrajectoryTable::x, TrajectoryTable::y, TrajectoryTable::z})
        next[column] = roundedNumber(2.0 * next[column] - before[column]);
    return next;
}

std::vector<Row> TrajectoryModel::with(const QModelIndex& cell, double value) const {
    std::vector<Row> rows = table_.rows;
    if (cell.row() == points())
        rows.push_back(nextOf(rows));
    rows[static_cast<std::size_t>(cell.row())][columnAt(cell.column())] = value;
    return rows;
}

std::optional<double> TrajectoryModel::typedIn(const QModelIndex& cell, const QString& text) const {
    const auto& unit = columnOf(columnAt(cell.column())).unit;
    return typedNumber(text, QString::fromStdString(std::string(unit))).value;
}

QString TrajectoryModel::problemOf(const QModelIndex& cell, const QString& text) const {
    if (cell.row() == points() && text.trimmed().isEmpty())
        return {};
    const TrajectoryTable::Column column = columnAt(cell.column());
    const auto number = typedIn(cell, text);
    const QString expected =
        withFormattedUnits(QString::fromStdString(columnOf(column).expectation()));
    if (!number)
        return QStringLiteral("%1: %2").arg(
            nameOf(column), neededInstead(expected, QStringLiteral("“%1”").arg(text)));
    if (*number < columnOf(column).minimum || *number > columnOf(column).maximum)
        return QStringLiteral("%1: %2").arg(nameOf(column), neededInstead(expected, text));
    if (column != TrajectoryTable::time)
        return {};
    for (int row = 0; row < points(); ++row)
        if (row != cell.row() &&
            table_.rows[static_cast<std::size_t>(row)][TrajectoryTable::time] == *number)
            return tr("time: row %1 has %2 s already").arg(row + 1).arg(gui::textOf(*number));
    return {};
}

QString TrajectoryModel::take(std::vector<Row> rows, const QString& step) {
    std::ranges::sort(rows, {}, [](const Row& row) { return row[TrajectoryTable::time]; });
    if (rows.empty())
        return tr("a trajectory needs at least one row");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (int c = 0; c < TrajectoryTable::columnCount; ++c) {
            const auto column = static_cast<TrajectoryTable::Column>(c);
            if (rows[i][column] < columnOf(column).minimum ||
                rows[i][column] > columnOf(column).maximum)
                return tr("row %1, %2: %3")
                    .arg(i + 1)
                    .arg(nameOf(column), neededInstead(withFormattedUnits(QString::fromStdString(
                                                           columnOf(column).expectation())),
                                                       gui::textOf(rows[i][column])));
        }
        if (i > 0 && rows[i][TrajectoryTable::time] == rows[i - 1][TrajectoryTable::time])
            return tr("two rows have the time %1 s")
                .arg(gui::textOf(rows[i][TrajectoryTable::time]));
    }
    TrajectoryTable after = table_;
    after.rows = std::move(rows);
    if (after == table_)
        return {};
    setTable(after);
    emit edited(table_, step);
    return {};
}

QString TrajectoryModel::insertRow(int row) {
    std::vector<Row> rows = table_.rows;
    if (row >= points()) {
        rows.push_back(nextOf(rows));
        return take(std::move(rows), tr("Add a row to a trajectory"));
    }
    const auto at = static_cast<std::size_t>(std::max(row, 0));
    Row between = rows[at];
    if (at > 0)
        for (std::size_t i = 0; i < between.size(); ++i)
            between[i] = roundedNumber((rows[at - 1][i] + rows[at][i]) / 2.0);
    else
        between[TrajectoryTable::time] -=
            rows.size() > 1 ? rows[1][TrajectoryTable::time] - rows[0][TrajectoryTable::time] : 1.0;
    rows.push_back(between);
    return take(std::move(rows),
                tr("Insert a row at %1 s").arg(gui::textOf(between[TrajectoryTable::time])));
}

QString TrajectoryModel::removeRows(const std::vector<int>& rows) {
    std::vector<Row> kept;
    for (int row = 0; row < points(); ++row)
        if (std::ranges::find(rows, row) == rows.end())
            kept.push_back(table_.rows[static_cast<std::size_t>(row)]);
    const auto gone = table_.rows.size() - kept.size();
    if (gone == 0)
        return {};
    return take(std::move(kept), gone == 1 ? tr("Remove a row of a trajectory")
                                           : tr("Remove %1 rows of a trajectory").arg(gone));
}

QString TrajectoryModel::pasteAt(int row, int column,
                                 const std::vector<std::vector<double>>& block) {
    std::vector<Row> rows = table_.rows;
    for (std::size_t i = 0; i < block.size(); ++i) {
        const std::size_t at = static_cast<std::size_t>(row) + i;
        if (at >= rows.size())
            rows.push_back(nextOf(rows));
        for (std::size_t j = 0; j < block[i].size(); ++j)
            rows[at][columnAt(column + static_cast<int>(j))] = block[i][j];
    }
    return take(std::move(rows),
                block.size() == 1 ? tr("Paste a row") : tr("Paste %1 rows").arg(block.size()));
}

QString TrajectoryModel::takeAll(const std::vector<std::vector<double>>& block) {
    std::vector<Row> rows;
    for (const std::vector<double>& numbers : block) {
        Row& row = rows.emplace_back(Row{});
        for (std::size_t j = 0; j < numbers.size(); ++j)
            row[columnAt(static_cast<int>(j))] = numbers[j];
    }
    return take(std::move(rows), tr("Replace a trajectory by %1 rows").arg(block.size()));
}

bool TrajectoryModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const auto number = typedIn(index, value.toString());
    if (role != Qt::EditRole || !number || !problemOf(index, value.toString()).isEmpty())
        return false;
    const auto rows = with(index, *number);
    const double time_s = rows[static_cast<std::size_t>(index.row())][TrajectoryTable::time];
    const TrajectoryTable::Column column = columnAt(index.column());
    return take(rows, column == TrajectoryTable::time
                          ? tr("Move a row to %1 s").arg(gui::textOf(time_s))
                          : tr("Set %1 at %2 s").arg(nameOf(column), gui::textOf(time_s)))
        .isEmpty();
}

} // namespace smat::gui

#include "moc_TrajectoryModel.cpp"
