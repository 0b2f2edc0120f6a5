#pragma once

#include <QDialog>

class QMenuBar;

namespace smat::gui {

/// Versions, the GL renderers, and the licences of what is linked.
class AboutDialog : public QDialog {
    Q_OBJECT

  public:
    AboutDialog(const QString& viewRenderer, const QString& sceneRenderer,
                QWidget* parent = nullptr);
};

/// Every key and mouse action of the windows: keys as the actions of a menu bar have them.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ShortcutsDialog(const QMenuBar& menus, QWidget* parent = nullptr);
};

} // namespace smat::gui
