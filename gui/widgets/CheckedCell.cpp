#include "gui/widgets/CheckedCell.h"

#include <utility>

#include <QApplication>
#include <QLineEdit>

#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"

namespace smat::gui {

CheckedCell::CheckedCell(QString name, Check problemOf, std::function<void(QString)> report,
                         QObject* parent)
    : QStyledItemDelegate(parent),
      name_(std::move(name)),
      problemOf_(std::move(problemOf)),
      report_(std::move(report)) {}

QWidget* CheckedCell::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                   const QModelIndex& index) const {
    auto* edit = new QLineEdit(parent);
    edit->setObjectName(name_);
    edit->setFrame(false);
    edit->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const QPersistentModelIndex cell(index);
    connect(edit, &QLineEdit::textEdited, this, [this, edit, cell](const QString& text) {
        const QString sentence = problemOf_(cell, text);
        QPalette colours = edit->palette();
        colours.setColor(QPalette::Base, sentence.isEmpty()
                                             ? QApplication::palette().base().color()
                                             : colors::wrongField(QApplication::palette()));
        edit->setPalette(colours);
        report_(sentence);
    });
    return edit;
}

void CheckedCell::setModelData(QWidget* editor, QAbstractItemModel* model,
                               const QModelIndex& index) const {
    const QString text = static_cast<QLineEdit*>(editor)->text();
    if (problemOf_(index, text).isEmpty())
        model->setData(index, text, Qt::EditRole);
}

} // namespace smat::gui

#include "moc_CheckedCell.cpp"
