#pragma once

#include <optional>

#include <QWidget>

#include "gui/database/EditorContext.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace smat::gui {

/// What editing one entry looks like whatever its kind: its name above, its notes in a tab, and the
/// way from a widget to a step of the session.
class EntryPanel : public QWidget {
    Q_OBJECT

  public:
    EntryPanel(EditorContext& context, EntryKind kind, QWidget* parent = nullptr);

    /// Shows an entry; nothing where it is none or not there.
    void show(const std::optional<EntryKey>& key);
    const std::optional<EntryKey>& key() const { return key_; }

  protected:
    /// Puts the entry, which is there, into the widgets.
    virtual void refresh() = 0;
    /// Runs `change` as a step of the entry; steps with equal `field` merge until a gesture ends.
    void edit(const QString& what, const QString& field, const DatabaseSession::Edit& change);
    void endGesture() { context_.session().endGesture(); }
    /// Name field and caption in one row.
    QWidget* makeHeading();
    QWidget* makeNotes();
    void showTexts(const std::string& name, const std::string& notes, const QString& caption);

    EditorContext& context_;
    const EntryKind kind_;
    std::optional<EntryKey> key_;

  private:
    std::string* textOfEntry(irsg::SignatureDatabase& database, bool notes) const;
    void update();

    QLineEdit* name_ = nullptr;
    QLabel* caption_ = nullptr;
    QPlainTextEdit* notes_ = nullptr;
};

} // namespace smat::gui
