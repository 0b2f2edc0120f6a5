#include "gui/database/ReflectanceEditor.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/NumberText.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

namespace {

using Direction = irsg::ReflectanceTable::Row;

/// Of a new table.
constexpr double firstAngles_deg[] = {0.0, 20.0, 40.0, 60.0, 70.0, 80.0, 85.0};
constexpr int firstWavelengths = 5;
/// Rows that are seen at once.
constexpr int rowsSeen = 6;

} // namespace

void ReflectanceModel::setTable(const irsg::ReflectanceTable& table) {
    if (table == table_)
        return;
    if (table.rows().size() == table_.rows().size() && table.isBrdf() == table_.isBrdf() &&
        table.wavelengths_um() == table_.wavelengths_um()) {
        table_ = table;
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    table_ = table;
    endResetModel();
}

int ReflectanceModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(table_.rows().size());
}

int ReflectanceModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || table_.empty()
               ? 0
               : angles() + static_cast<int>(table_.wavelengths_um().size());
}

QVariant ReflectanceModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    const Direction& row = table_.rows()[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    if (column >= angles())
        return textOf(row.values[static_cast<std::size_t>(column - angles())]);
    const double all_deg[] = {row.incidence_deg, row.reflection_deg, row.azimuth_deg};
    return textOf(all_deg[column]);
}

QVariant ReflectanceModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole)
        return QAbstractTableModel::headerData(section, orientation, role);
    if (orientation == Qt::Vertical)
        return section + 1;
    if (section >= angles()) {
        const double at_um = table_.wavelengths_um()[static_cast<std::size_t>(section - angles())];
        return table_.isBrdf() ? tr("at %1 µm\n(sr⁻¹)").arg(at_um) : tr("at %1 µm").arg(at_um);
    }
    const QString names[] = {tr("incidence\n(deg)"), tr("reflection\n(deg)"), tr("azimuth\n(deg)")};
    return table_.isBrdf() ? names[section] : tr("angle\n(deg)");
}

Qt::ItemFlags ReflectanceModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags seen = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
    return table_.isBrdf() && index.column() < angles() ? seen : seen | Qt::ItemIsEditable;
}

std::vector<Direction> ReflectanceModel::with(const QModelIndex& cell, double value) const {
    std::vector<Direction> rows = table_.rows();
    put(rows[static_cast<std::size_t>(cell.row())], cell.column(), value);
    return rows;
}

void ReflectanceModel::put(Direction& row, int column, double value) const {
    if (column < angles())
        row.incidence_deg = value;
    else
        row.values[static_cast<std::size_t>(column - angles())] = value;
}

QString ReflectanceModel::pasteAt(const QModelIndex& cell,
                                  const std::vector<std::vector<double>>& block) {
    const int columns = static_cast<int>(block.front().size());
    const int rowsBelow = rowCount() - cell.row(), columnsBeside = columnCount() - cell.column();
    if (columns > columnsBeside)
        return tr("%1 columns do not fit: from this one on the table has %2")
            .arg(columns)
            .arg(columnsBeside);
    if (static_cast<int>(block.size()) > rowsBelow)
        return tr("%1 rows do not fit: from this one on the table has %2")
            .arg(block.size())
            .arg(rowsBelow);
    if (table_.isBrdf() && cell.column() < angles())
        return tr("the directions of a BRDF stay: paste into its values");
    std::vector<Direction> rows = table_.rows();
    for (std::size_t i = 0; i < block.size(); ++i)
        for (int j = 0; j < columns; ++j)
            put(rows[static_cast<std::size_t>(cell.row()) + i], cell.column() + j,
                block[i][static_cast<std::size_t>(j)]);
    try {
        take(std::move(rows), tr("(%1 rows pasted)").arg(block.size()));
    } catch (const irsg::InputError& error) {
        return sentencesOf(error).join("; ");
    }
    return {};
}

QString ReflectanceModel::problemOf(const QModelIndex& cell, const QString& text) const {
    const TypedNumber typed = typedNumber(text, unitOf(cell));
    const auto number = typed.value;
    if (!number)
        return typed.problem;
    const Direction& row = table_.rows()[static_cast<std::size_t>(cell.row())];
    if (cell.column() < angles())
        for (const Direction& other : table_.rows())
            if (&other != &row && other.incidence_deg == *number)
                return tr("%1 deg has a row already").arg(textOf(*number));
    try {
        Direction alone = with(cell, *number)[static_cast<std::size_t>(cell.row())];
        irsg::ReflectanceTable(table_.isBrdf(), table_.wavelengths_um(), {std::move(alone)});
    } catch (const irsg::InputError& error) {
        return sentencesOf(error).join("; ");
    }
    return {};
}

void ReflectanceModel::take(std::vector<Direction> rows, const QString& what) {
    setTable({table_.isBrdf(), table_.wavelengths_um(), std::move(rows)});
    emit edited(table_, what);
}

bool ReflectanceModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !problemOf(index, value.toString()).isEmpty())
        return false;
    std::vector<Direction> rows = with(index, *typedNumber(value.toString(), unitOf(index)).value);
    if (rows != table_.rows())
        take(std::move(rows), tr("in row %1").arg(index.row() + 1));
    return true;
}

void ReflectanceModel::insertAfter(int row) {
    if (table_.empty() || table_.isBrdf())
        return;
    std::vector<Direction> rows = table_.rows();
    const auto i = static_cast<std::size_t>(std::clamp(row, 0, rowCount() - 1));
    Direction next = rows[i];
    const bool isLast = i + 1 == rows.size();
    const double end_deg = isLast ? 90.0 : rows[i + 1].incidence_deg;
    if (!(end_deg > next.incidence_deg))
        return;
    next.incidence_deg = 0.5 * (next.incidence_deg + end_deg);
    if (!isLast)
        for (std::size_t w = 0; w < next.values.size(); ++w)
            next.values[w] = 0.5 * (next.values[w] + rows[i + 1].values[w]);
    rows.push_back(std::move(next));
    take(std::move(rows), tr("(row added)"));
}

void ReflectanceModel::remove(const std::set<int>& rows) {
    if (table_.isBrdf())
        return;
    std::vector<Direction> left = table_.rows();
    for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        if (left.size() > 1)
            left.erase(left.begin() + *row);
    if (left.size() < table_.rows().size())
        take(std::move(left), tr("(rows removed)"));
}

ReflectanceView::ReflectanceView(ReflectanceModel& model, QWidget* parent)
    : NumericTableView(
          model, "reflectanceCell",
          [&model](const QModelIndex& cell, const QString& text) {
              return model.problemOf(cell, text);
          },
          parent),
      model_(model) {
    setObjectName("reflectanceTable");
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    setMinimumHeight((rowsSeen + 1) * (fontMetrics().height() + 8));
}

void ReflectanceView::insertRow() {
    model_.insertAfter(currentIndex().row());
}

void ReflectanceView::removeRows() {
    model_.remove(chosenRows());
}

QString ReflectanceView::pasteAt(const QModelIndex& cell, const Rows& block) {
    return model_.pasteAt(cell, block);
}

ReflectanceEditor::ReflectanceEditor(QWidget* parent) : QWidget(parent) {
    setObjectName("reflectanceEditor");
    model_ = new ReflectanceModel(this);
    view_ = new ReflectanceView(*model_, this);
    message_ = new QLabel(this);
    message_->setObjectName("reflectanceMessage");
    message_->setWordWrap(true);
    connect(view_, &ReflectanceView::problem, this, &ReflectanceEditor::refuse);
    begin_ = new QPushButton(tr("Start from the emissivity"), this);
    begin_->setObjectName("beginReflectance");
    begin_->setToolTip(tr("Makes a table over angle of what emissivity and transmissivity leave, "
                          "equal at every angle, to be edited"));
    connect(begin_, &QPushButton::clicked, this, [this] {
        emit edited(ofEmissivity(), tr("from the emissivity"));
        emit gestureEnded();
    });
    auto* bar = new QHBoxLayout;
    bar->setSpacing(2);
    const auto button = [&](const char* picture, const char* name, const QString& tip) {
        auto* made = new QToolButton(this);
        made->setObjectName(name);
        made->setIcon(icon(picture));
        made->setToolTip(tip);
        made->setAutoRaise(true);
        bar->addWidget(made);
        return made;
    };
    insert_ = button("row-insert", "insertReflectance", tr("Add a row after the current one"));
    remove_ = button("row-remove", "removeReflectance", tr("Remove the selected rows"));
    connect(insert_, &QToolButton::clicked, view_, &ReflectanceView::insertRow);
    connect(remove_, &QToolButton::clicked, view_, &ReflectanceView::removeRows);
    bar->addWidget(begin_);
    bar->addWidget(message_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(bar);
    column->addWidget(view_, 1);
    connect(model_, &ReflectanceModel::edited, this,
            [this](const irsg::ReflectanceTable& table, const QString& what) {
                emit edited(table, what);
                emit gestureEnded();
            });
}

void ReflectanceEditor::refuse(const QString& problem) {
    if (problem.isEmpty())
        return show(material_, band_);
    message_->setStyleSheet(QStringLiteral("color: %1").arg(colors::errorText(palette()).name()));
    message_->setText(problem);
}

void ReflectanceEditor::show(const irsg::Material& material, const irsg::SpectralRange& band) {
    material_ = material;
    band_ = band;
    const irsg::ReflectanceTable& table = material.reflectanceTable;
    model_->setTable(table);
    begin_->setVisible(table.empty());
    view_->setVisible(!table.empty());
    const bool hasRowsOfItsOwn = !table.empty() && !table.isBrdf();
    insert_->setVisible(hasRowsOfItsOwn);
    remove_->setVisible(hasRowsOfItsOwn);
    message_->setStyleSheet({});
    message_->setText(table.empty() ? QString()
                                    : tr("%1 of %2 directions at %3 wavelengths")
                                          .arg(table.isBrdf() ? tr("BRDF") : tr("Reflectance"))
                                          .arg(table.rows().size())
                                          .arg(table.wavelengths_um().size()));
}

irsg::ReflectanceTable ReflectanceEditor::ofEmissivity() const {
    std::vector<double> at_um;
    if (material_.emissivity.isConstant() && material_.transmissivity.isConstant())
        at_um = {band_.centre_um()};
    else
        for (int i = 0; i < firstWavelengths; ++i)
            at_um.push_back(band_.min_um + band_.width_um() * i / (firstWavelengths - 1));
    std::vector<Direction> rows;
    for (const double angle_deg : firstAngles_deg) {
        Direction& row = rows.emplace_back(Direction{angle_deg, 0.0, 0.0, {}});
        for (const double each_um : at_um)
            // As people write it.
            row.values.push_back(std::round(1e6 * material_.reflectivityAt(each_um)) / 1e6);
    }
    return {false, std::move(at_um), std::move(rows)};
}

} // namespace smat::gui

#include "moc_ReflectanceEditor.cpp"
