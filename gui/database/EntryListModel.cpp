#include "gui/database/EntryList.h"

#include <algorithm>

#include <QApplication>
#include <QPainter>
#include <QPixmap>

#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/image/ColorMap.h"
#include "irsg/signature/SurfaceTemperature.h"

namespace smat::gui {
namespace {

/// Temperatures from cold to hot in the colours of a hot iron.
QColor temperatureColor(double temperature_K) {
    const double part = std::clamp((temperature_K - 230.0) / (900.0 - 230.0), 0.0, 1.0);
    const irsg::Rgb rgb = irsg::ColorMap::named("ironbow").at(std::sqrt(part));
    return {rgb.red, rgb.green, rgb.blue};
}

/// "293.1 K", to a tenth.
QString temperatureWords(double temperature_K) {
    const ShownUnit* unit = shownUnitOf("K");
    return QStringLiteral("%1 %2")
        .arg(unit == nullptr ? temperature_K : unit->shown(temperature_K), 0, 'f', 1)
        .arg(unit == nullptr ? QStringLiteral("K") : unit->unit);
}

QColor emissivityShade(double emissivity) {
    const int grey = static_cast<int>(std::clamp(emissivity, 0.0, 1.0) * 255.0);
    return {grey, grey, grey};
}

QPixmap drawSwatch(const QColor& color) {
    QPixmap pixmap(28, 28);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QApplication::palette().color(QPalette::PlaceholderText), 1.0));
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(1.0, 1.0, 12.0, 12.0), 3.0, 3.0);
    return pixmap;
}

} // namespace

EntryListModel::EntryListModel(EditorContext& context, EntryKind kind, QObject* parent)
    : QAbstractTableModel(parent), context_(context), kind_(kind) {
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this,
            &EntryListModel::refresh);
}

std::vector<EntryListModel::Row> EntryListModel::rowsNow() const {
    std::vector<Row> rows;
    if (!context_.session().isOpen())
        return rows;
    const auto& database = context_.session().value();
    if (kind_ == EntryKind::material) {
        for (const auto& [number, material] : database.materials) {
            const double mean = context_.bandMean(material.emissivity);
            rows.push_back({{kind_, number},
                            QString::fromStdString(material.name),
                            QString::number(mean, 'f', 3),
                            0,
                            emissivityShade(mean)});
        }
    } else if (kind_ == EntryKind::temperature) {
        for (const auto& [number, entry] : database.temperatures) {
            const bool measured = entry.mode == irsg::EmissionMode::userSpectrum;
            const double now_K = irsg::surfaceTemperature_K(entry.terms, context_.state());
            rows.push_back(
                {{kind_, number},
                 QString::fromStdString(entry.name),
                 measured ? QString::fromStdString(entry.userSpectrum) : temperatureWords(now_K),
                 0,
                 measured ? colors::measuredEntry() : temperatureColor(now_K)});
        }
    } else {
        int number = 0;
        const PlotStyle style = PlotStyle::screen(QApplication::palette());
        for (const auto& [key, spectrum] : database.spectra) {
            const auto users = usersOfSpectrum(database, key).size();
            rows.push_back({{kind_, 0, key},
                            QString::fromStdString(key),
                            counted(static_cast<long>(spectrum.components.size()), tr("component"),
                                    tr("components")),
                            static_cast<int>(users),
                            style.curve(number++)});
        }
    }
    if (kind_ != EntryKind::spectrum)
        for (auto& row : rows)
            row.faces = context_.facesOf(row.key);
    return rows;
}

void EntryListModel::refresh() {
    auto now = rowsNow();
    if (now == rows_)
        return;
    const bool sameKeys =
        std::ranges::equal(now, rows_, {}, &Row::key, &Row::key) && !rows_.empty();
    if (!sameKeys)
        beginResetModel();
    rows_ = std::move(now);
    if (sameKeys)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    else
        endResetModel();
}

std::optional<EntryKey> EntryListModel::keyAt(int row) const {
    if (row < 0 || row >= rowCount())
        return std::nullopt;
    return rows_[static_cast<std::size_t>(row)].key;
}

int EntryListModel::rowOf(const EntryKey& key) const {
    const auto found = std::ranges::find(rows_, key, &Row::key);
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int EntryListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int EntryListModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 4;
}

QVariant EntryListModel::data(const QModelIndex& cell, int role) const {
    const Row& row = rows_[static_cast<std::size_t>(cell.row())];
    const bool byName = kind_ == EntryKind::spectrum;
    if (role == Qt::DecorationRole && cell.column() == indexColumn)
        return drawSwatch(row.swatch);
    if (role == Qt::TextAlignmentRole && cell.column() >= facesColumn)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ForegroundRole && cell.column() == facesColumn && row.faces == 0)
        return QApplication::palette().color(QPalette::PlaceholderText);
    if (role == Qt::ToolTipRole && cell.column() == facesColumn)
        return byName ? tr("Temperatures that use this spectrum")
                      : tr("Faces of the model that carry this index");
    if (role != Qt::DisplayRole)
        return {};
    switch (cell.column()) {
    case indexColumn:
        return byName ? QVariant() : QVariant(row.key.index);
    case nameColumn:
        return row.name;
    case facesColumn:
        return !byName && !context_.knowsModel() ? QVariant("–") : QVariant(row.faces);
    default:
        return row.value;
    }
}

QVariant EntryListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case indexColumn:
        return kind_ == EntryKind::spectrum ? QString() : tr("Index");
    case nameColumn:
        return tr("Name");
    case facesColumn:
        return kind_ == EntryKind::spectrum ? tr("Used by") : tr("Faces");
    default:
        return kind_ == EntryKind::material      ? tr("ε in band")
               : kind_ == EntryKind::temperature ? tr("Now")
                                                 : tr("Content");
    }
}

} // namespace smat::gui
