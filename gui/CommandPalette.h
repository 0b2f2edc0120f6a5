#pragma once

#include <QDialog>
#include <QPointer>

class QAction;
class QLineEdit;
class QMenu;
class QMenuBar;
class QTreeWidget;

namespace smat::gui {

/// Finds an entry of the menus by words of its name: those that hold every word that is typed, in
/// the order of the menus, with their keys. Entries that cannot be chosen now are left out.
class CommandPalette : public QDialog {
    Q_OBJECT

  public:
    explicit CommandPalette(const QMenuBar& menus, QWidget* parent = nullptr);

    /// The entry to be done once the dialog is accepted; null where nothing fits.
    QAction* chosen() const;

  protected:
    /// Arrows and pages move in the list while one types.
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Command {
        QPointer<QAction> action;
        QString path; ///< "View → Wireframe"
    };
    void collect(const QMenu& menu, const QString& path);
    void refresh();

    QList<Command> commands_;
    QLineEdit* words_ = nullptr;
    QTreeWidget* list_ = nullptr;
};

} // namespace smat::gui
