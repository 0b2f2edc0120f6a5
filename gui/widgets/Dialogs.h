#pragma once

#include <functional>

#include <QStringList>

class QDialog;
class QWidget;

namespace smat::gui {

/// How the window talks to a person, so that a test can answer in a person's place.
struct Dialogs {
    /// Asks for a file to open, or to write, with filters such as "Picture (*.png)"; empty for
    /// none.
    std::function<QString(QWidget* parent, const QString& title, const QStringList& filters)>
        openFile;
    std::function<QString(QWidget* parent, const QString& title, const QStringList& filters,
                          const QString& suggestion)>
        saveFile;
    /// Asks for a folder to write into; empty for none.
    std::function<QString(QWidget* parent, const QString& title, const QString& suggestion)>
        chooseFolder = [](QWidget*, const QString&, const QString&) { return QString(); };
    /// Says what went wrong, one sentence each.
    std::function<void(QWidget* parent, const QString& title, const QStringList& sentences)> tell;
    /// Asks a question; the number of the answer, -1 where it was closed without one.
    std::function<int(QWidget* parent, const QString& title, const QString& question,
                      const QStringList& answers)>
        ask = [](QWidget*, const QString&, const QString&, const QStringList&) { return -1; };
    /// Shows a dialog and waits; true where it was accepted.
    std::function<bool(QDialog& dialog)> run;

    /// Those of the desktop.
    static Dialogs ofDesktop();
};

} // namespace smat::gui
