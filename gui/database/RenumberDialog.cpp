#include "gui/database/RenumberDialog.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/DialogButtons.h"

namespace smat::gui {

RenumberDialog::RenumberDialog(const EditorContext& context, const EntryKey& entry, QWidget* parent)
    : QDialog(parent), context_(context), entry_(entry) {
    setObjectName("renumberDialog");
    const bool byName = entry_.kind == EntryKind::spectrum;
    setWindowTitle(byName ? tr("Rename %1").arg(context_.title(entry_))
                          : tr("Renumber %1").arg(context_.title(entry_)));
    field_ = new QLineEdit(
        byName ? QString::fromStdString(entry_.name) : QString::number(entry_.index), this);
    field_->setObjectName("newKey");
    field_->selectAll();
    auto* form = new QFormLayout;
    form->addRow(byName ? tr("New name") : tr("New index"), field_);
    consequence_ = new QLabel(this);
    consequence_->setObjectName("consequence");
    consequence_->setWordWrap(true);
    consequence_->setMinimumSize(400, 60);
    consequence_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    consequence_->setForegroundRole(QPalette::PlaceholderText);
    buttons_ = okAndCancel(*this, byName ? tr("Rename") : tr("Renumber"));
    connect(field_, &QLineEdit::textChanged, this, &RenumberDialog::validate);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(12);
    column->addLayout(form);
    column->addWidget(consequence_, 1);
    column->addWidget(buttons_);
    validate();
}

EntryKey RenumberDialog::wanted() const {
    EntryKey key = entry_;
    const QString text = field_->text().trimmed();
    if (entry_.kind == EntryKind::spectrum) {
        key.name = text.toStdString();
    } else {
        bool whole = false;
        key.index = text.toInt(&whole);
        if (!whole)
            return entry_;
    }
    const bool taken = contains(context_.session().value(), key);
    return taken || text.isEmpty() ? entry_ : key;
}

void RenumberDialog::validate() {
    const EntryKey key = wanted();
    const bool right = key != entry_;
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(right);
    if (!right) {
        consequence_->setText(entry_.kind == EntryKind::spectrum
                                  ? tr("A name that no other spectrum has.")
                                  : tr("A whole number that no other entry has."));
        return;
    }
    if (entry_.kind == EntryKind::spectrum) {
        const auto users = usersOfSpectrum(context_.session().value(), entry_.name);
        consequence_->setText(users.empty()
                                  ? tr("No temperature uses it.")
                                  : tr("What uses it follows: %1.")
                                        .arg(counted(static_cast<long>(users.size()),
                                                     tr("temperature"), tr("temperatures"))));
        return;
    }
    QStringList lines;
    if (const int faces = context_.facesOf(entry_); faces > 0)
        lines << tr("%1 of the model with code %2 keep it and will have no entry.")
                     .arg(counted(faces, tr("face"), tr("faces")))
                     .arg(entry_.index);
    if (const int faces = context_.facesOf(key); faces > 0)
        lines << tr("%1 of the model with code %2 will look like this entry.")
                     .arg(counted(faces, tr("face"), tr("faces")))
                     .arg(key.index);
    if (lines.isEmpty())
        lines << tr("No face of the model carries either index.");
    consequence_->setText(lines.join('\n'));
}

} // namespace smat::gui

#include "moc_RenumberDialog.cpp"
