#include "gui/analysis/ResultNotesDialog.h"

#include <QPlainTextEdit>
#include <QVBoxLayout>

#include "gui/analysis/ResultStore.h"
#include "gui/widgets/DialogButtons.h"

namespace smat::gui {

ResultNotesDialog::ResultNotesDialog(const ResultEntry& entry, QWidget* parent)
    : QDialog(parent), id_(entry.id) {
    setObjectName("resultNotesDialog");
    setWindowTitle(tr("Notes – %1").arg(entry.title));
    resize(460, 260);
    text_ = new QPlainTextEdit(entry.notes, this);
    text_->setObjectName("notes");
    text_->setTabChangesFocus(true);
    text_->setPlaceholderText(tr("Kept with the result and shown in the list"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->addWidget(text_, 1);
    column->addWidget(okAndCancel(*this));
}

QString ResultNotesDialog::notes() const {
    return text_->toPlainText();
}

} // namespace smat::gui

#include "moc_ResultNotesDialog.cpp"
