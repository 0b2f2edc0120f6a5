#pragma once

#include <QByteArray>
#include <QObject>
#include <QSize>
#include <QStringList>

class QMainWindow;

namespace smat::gui {

/// Size, place and docks of a window: fitting on the screen at the first start, as they were left
/// on that screen later, and the docks away and back by one key.
class WindowLayout : public QObject {
    Q_OBJECT

  public:
    explicit WindowLayout(QMainWindow& window);

    /// The usual size, or less where the screen has less, without the frame of the window.
    static QSize firstSize(const QSize& screen);
    /// Takes what was kept for the screen that the window is on. A layout of other docks is not
    /// taken.
    void restore();
    void save();
    /// Hides all docks that are in sight, or shows those again that it hid.
    void toggleDocks();

  private:
    QString key(const char* what) const;

    QMainWindow& window_;
    QStringList hidden_;
};

} // namespace smat::gui
