#include "gui/widgets/DialogButtons.h"

#include <QDialog>
#include <QPushButton>

namespace smat::gui {
namespace {

QDialogButtonBox* buttonsOf(QDialog& dialog, QDialogButtonBox::StandardButtons which) {
    auto* buttons = new QDialogButtonBox(which, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    return buttons;
}

} // namespace

QDialogButtonBox* okAndCancel(QDialog& dialog, const QString& word) {
    auto* buttons = buttonsOf(dialog, QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    if (!word.isEmpty())
        buttons->button(QDialogButtonBox::Ok)->setText(word);
    return buttons;
}

QDialogButtonBox* closeAlone(QDialog& dialog) {
    return buttonsOf(dialog, QDialogButtonBox::Close);
}

} // namespace smat::gui
