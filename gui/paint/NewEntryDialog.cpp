#include "gui/paint/NewEntryDialog.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/DialogButtons.h"

namespace smat::gui {

NewEntryDialog::NewEntryDialog(EntryKind kind, int index, QWidget* parent) : QDialog(parent) {
    setObjectName("newEntryDialog");
    const bool isMaterial = kind == EntryKind::material;
    setWindowTitle(isMaterial ? tr("New material") : tr("New temperature"));
    name_ = new QLineEdit((isMaterial ? tr("material %1") : tr("temperature %1")).arg(index), this);
    name_->setObjectName("entryName");
    name_->selectAll();
    auto* form = new QFormLayout;
    form->addRow(tr("Index"), new QLabel(QString::number(index), this));
    form->addRow(tr("Name"), name_);
    auto* said = new QLabel(isMaterial ? tr("It begins as a black surface; the editor of the "
                                            "database is open for the rest.")
                                       : tr("It begins as warm as the air; the editor of the "
                                            "database is open for the rest."),
                            this);
    said->setWordWrap(true);
    said->setMinimumWidth(380);
    said->setForegroundRole(QPalette::PlaceholderText);
    auto* buttons = okAndCancel(*this, tr("Add"));
    connect(name_, &QLineEdit::textChanged, this, [buttons](const QString& text) {
        buttons->button(QDialogButtonBox::Ok)->setEnabled(!text.trimmed().isEmpty());
    });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(12);
    column->addLayout(form);
    column->addWidget(said);
    column->addWidget(buttons);
}

std::string NewEntryDialog::name() const {
    return name_->text().trimmed().toStdString();
}

} // namespace smat::gui

#include "moc_NewEntryDialog.cpp"
