#pragma once

#include <QStyledItemDelegate>

namespace smat::gui {

/// A result in the list: its title, below it a fainter line that says when, how long and what. The
/// title is edited in place.
class ResultItemDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    static constexpr int idRole = Qt::UserRole;
    static constexpr int detailRole = Qt::UserRole + 1;

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
};

} // namespace smat::gui
