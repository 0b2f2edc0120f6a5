#pragma once

#include <memory>

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>

#include "gui/widgets/Dialogs.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace smat::gui {

class PlacingFields;

/// Writes a model in another form and keeps its codes, through irsg::convertModel in the
/// background, in metres and the axes of the program, and says what was read and written. A cancel
/// answers at once, and so does closing: nothing is written then.
class ConvertModelDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ConvertModelDialog(Dialogs& dialogs, QWidget* parent = nullptr);
    ~ConvertModelDialog() override;
    void setInput(const QString& file);
    bool isRunning() const { return work_ != nullptr; }
    /// What was written and is to be opened now; empty for none.
    QString fileToOpen() const;
    /// Closes, or cancels what runs.
    void reject() override;

  private:
    struct Work;
    QLineEdit* addFile(QGridLayout* grid, const QString& name, const QString& label);
    void start();
    void cancel();
    void onDone();
    void tellElapsed();
    void refresh();

    Dialogs& dialogs_;
    QLineEdit* input_ = nullptr;
    QLineEdit* output_ = nullptr;
    QCheckBox* openIt_ = nullptr;
    PlacingFields* placing_ = nullptr;
    QPlainTextEdit* report_ = nullptr;
    QProgressBar* bar_ = nullptr;
    QLabel* elapsed_ = nullptr;
    QPushButton* convert_ = nullptr;
    QPushButton* close_ = nullptr;
    QTimer watch_;
    QElapsedTimer clock_;
    std::shared_ptr<Work> work_; ///< shared with the thread, which outlives a dialog that closes
    QString written_;
};

} // namespace smat::gui
