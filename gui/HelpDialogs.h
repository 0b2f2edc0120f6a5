#pragma once

#include <QDialog>

class QAction;
class QMenuBar;

namespace smat::gui {

/// Versions, the GL renderers, and the licences of what is linked.
class AboutDialog : public QDialog {
    Q_OBJECT

  public:
    AboutDialog(const QString& viewRenderer, const QString& sceneRenderer,
                QWidget* parent = nullptr);
};

/// Every key and mouse action of the windows: keys as the actions of a menu bar and of the results
/// have them.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

  public:
    ShortcutsDialog(const QMenuBar& menus, const QList<QAction*>& ofResults,
                    QWidget* parent = nullptr);
};

} // namespace smat::gui
