#include "gui/database/EntryPanel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace smat::gui {

EntryPanel::EntryPanel(EditorContext& context, EntryKind kind, QWidget* parent)
    : QWidget(parent), context_(context), kind_(kind) {
    connect(&context_.session(), &DatabaseSession::changed, this, &EntryPanel::update);
    connect(&context_.session(), &DatabaseSession::opened, this, &EntryPanel::update);
    connect(&context_, &EditorContext::surroundingsChanged, this, &EntryPanel::update);
}

void EntryPanel::show(const std::optional<EntryKey>& key) {
    if (key != key_)
        endGesture();
    key_ = key;
    update();
}

void EntryPanel::update() {
    const bool there =
        key_ && context_.session().isOpen() && contains(context_.session().value(), *key_);
    setEnabled(there);
    if (there)
        refresh();
}

void EntryPanel::edit(const QString& what, const QString& field,
                      const DatabaseSession::Edit& change) {
    if (!key_ || !context_.session().isOpen() || !contains(context_.session().value(), *key_))
        return;
    context_.session().edit(what, change, QString::fromStdString(placeOf(*key_)) + "." + field);
}

std::string* EntryPanel::textOfEntry(irsg::SignatureDatabase& database, bool notes) const {
    switch (kind_) {
    case EntryKind::material: {
        auto& entry = database.materials.at(key_->index);
        return notes ? &entry.notes : &entry.name;
    }
    case EntryKind::temperature: {
        auto& entry = database.temperatures.at(key_->index);
        return notes ? &entry.notes : &entry.name;
    }
    case EntryKind::spectrum:
        return notes ? &database.spectra.at(key_->name).notes : nullptr;
    }
    return nullptr;
}

QWidget* EntryPanel::makeHeading() {
    auto* holder = new QWidget(this);
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    caption_ = new QLabel(holder);
    caption_->setObjectName("entryCaption");
    caption_->setForegroundRole(QPalette::PlaceholderText);
    if (kind_ == EntryKind::spectrum) {
        caption_->setWordWrap(true);
        row->addWidget(caption_, 1);
        return holder;
    }
    name_ = new QLineEdit(holder);
    name_->setObjectName("entryName");
    name_->setPlaceholderText(tr("Name"));
    QFont bold = name_->font();
    bold.setBold(true);
    name_->setFont(bold);
    connect(name_, &QLineEdit::textEdited, this, [this](const QString& text) {
        const QString kind = kind_ == EntryKind::material ? tr("material") : tr("temperature");
        edit(tr("Rename %1 %2").arg(kind).arg(key_->index), "name",
             [&](irsg::SignatureDatabase& database) {
                 *textOfEntry(database, false) = text.toStdString();
             });
    });
    connect(name_, &QLineEdit::editingFinished, this, [this] { endGesture(); });
    row->addWidget(name_, 1);
    row->addWidget(caption_);
    return holder;
}

QWidget* EntryPanel::makeNotes() {
    auto* holder = new QWidget(this);
    notes_ = new QPlainTextEdit(holder);
    notes_->setObjectName("entryNotes");
    notes_->setTabChangesFocus(true);
    notes_->setPlaceholderText(
        tr("Where the numbers come from: measurement, handbook, assumption; who, when, how sure"));
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 8, 0, 0);
    column->addWidget(notes_);
    connect(notes_, &QPlainTextEdit::textChanged, this, [this] {
        if (!key_)
            return;
        edit(tr("Edit notes of %1").arg(context_.title(*key_)), "notes",
             [&](irsg::SignatureDatabase& database) {
                 *textOfEntry(database, true) = notes_->toPlainText().toStdString();
             });
    });
    return holder;
}

void EntryPanel::showTexts(const std::string& name, const std::string& notes,
                           const QString& caption) {
    caption_->setText(caption);
    if (name_ != nullptr && name_->text() != QString::fromStdString(name))
        name_->setText(QString::fromStdString(name));
    if (notes_ != nullptr && notes_->toPlainText() != QString::fromStdString(notes)) {
        const QSignalBlocker quiet(notes_);
        notes_->setPlainText(QString::fromStdString(notes));
    }
}

} // namespace smat::gui

#include "moc_EntryPanel.cpp"
