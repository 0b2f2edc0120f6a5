#include "gui/database/SpectrumTableModel.h"

#include "gui/database/Nodes.h"

namespace smat::gui {

void SpectrumTableModel::setSpectrum(const irsg::UserSpectrum& spectrum) {
    beginResetModel();
    spectrum_ = spectrum;
    endResetModel();
}

int SpectrumTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || spectrum_.components.empty()
               ? 0
               : static_cast<int>(spectrum_.components.front().radiance.size());
}

int SpectrumTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(spectrum_.components.size()) + 1;
}

double SpectrumTableModel::number(int row, int column) const {
    const auto i = static_cast<std::size_t>(row);
    return column == 0
               ? spectrum_.components.front().radiance.wavelengths_um()[i]
               : spectrum_.components[static_cast<std::size_t>(column) - 1].radiance.values()[i];
}

QVariant SpectrumTableModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    return QString::number(number(index.row(), index.column()), 'g', 7);
}

QVariant SpectrumTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role == Qt::ToolTipRole && orientation == Qt::Horizontal && section > 0)
        return tr("W·m⁻²·sr⁻¹·µm⁻¹");
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Vertical)
        return section + 1;
    return section == 0 ? tr("wavelength\n(µm)")
                        : QString::fromStdString(
                              spectrum_.components[static_cast<std::size_t>(section) - 1].name);
}

QString SpectrumTableModel::spreadsheetText() const {
    QString text;
    for (int column = 0; column < columnCount(); ++column)
        text += (column == 0 ? QString() : "\t") +
                headerData(column, Qt::Horizontal, Qt::DisplayRole).toString().replace("\n", " ");
    text += "\n";
    for (int row = 0; row < rowCount(); ++row) {
        for (int column = 0; column < columnCount(); ++column)
            text += (column == 0 ? QString() : "\t") + textOf(number(row, column));
        text += "\n";
    }
    return text;
}

} // namespace smat::gui

#include "moc_SpectrumTableModel.cpp"
