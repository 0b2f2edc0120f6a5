#pragma once

#include <memory>

#include <QDialog>
#include <QTimer>

class QCheckBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace smat::gui {

/// The checks of `smat-batch selftest` on this machine, each told of as it ends. They run beside
/// the window; closing the dialog ends them after the one that runs.
class SelfTestDialog : public QDialog {
    Q_OBJECT

  public:
    explicit SelfTestDialog(QWidget* parent = nullptr);
    ~SelfTestDialog() override;

    bool isRunning() const;

  private:
    struct Run;
    void start();
    void stop();
    /// Shows what ended since the last time.
    void follow();
    void copy() const;

    std::shared_ptr<Run> run_;
    QTimer timer_;
    QCheckBox* hard_ = nullptr;
    QPushButton* start_ = nullptr;
    QPushButton* copy_ = nullptr;
    QTreeWidget* table_ = nullptr;
    QLabel* counts_ = nullptr;
};

} // namespace smat::gui
