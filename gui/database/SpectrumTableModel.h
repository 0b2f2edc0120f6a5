#pragma once

#include <QAbstractTableModel>

#include "irsg/signature/UserSpectrum.h"

namespace smat::gui {

/// The numbers of a user-defined spectrum: a row a wavelength, a column a component.
class SpectrumTableModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    void setSpectrum(const irsg::UserSpectrum& spectrum);
    /// All of it with headings, tabs between columns.
    QString spreadsheetText() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    double number(int row, int column) const;

    irsg::UserSpectrum spectrum_;
};

} // namespace smat::gui
