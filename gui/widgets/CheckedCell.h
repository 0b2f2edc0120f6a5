#pragma once

#include <functional>

#include <QStyledItemDelegate>

namespace smat::gui {

/// The field in which a cell of a table of numbers is typed: reddens while its text cannot stand,
/// and then gives the cell back unchanged.
class CheckedCell : public QStyledItemDelegate {
    Q_OBJECT

  public:
    /// `problemOf` says why a text cannot stand in a cell, empty where it can; `report` is given
    /// that while one types.
    using Check = std::function<QString(const QModelIndex& cell, const QString& text)>;
    CheckedCell(QString name, Check problemOf, std::function<void(QString)> report,
                QObject* parent);

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;

  private:
    QString name_; ///< of the fields, as objects
    Check problemOf_;
    std::function<void(QString)> report_;
};

} // namespace smat::gui
