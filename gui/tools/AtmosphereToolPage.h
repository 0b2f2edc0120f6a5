#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>

#include "gui/tools/Calculation.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "smatcore/data/ResultTable.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace smat::gui {

class Workbench;

/// A tool that asks the air of the project, or a gas, something: inputs and buttons on the left,
/// the answer as a plot on the right. It computes in a thread of its own, shows the command line
/// that does the same, saves the answer with its provenance and keeps it among the results.
class AtmosphereToolPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    AtmosphereToolPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);
    ~AtmosphereToolPage() override;

    bool isRunning() const { return calculation_.isRunning(); }
    /// The last answer; empty before the first.
    const ResultTable& table() const { return table_; }
    void compute();

    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  protected:
    /// Where the inputs of a tool go.
    QVBoxLayout* inputs() const { return inputs_; }
    QPushButton* addButton(const QString& name, const QString& text, const QString& tip);
    /// To be called when an input changes: what is wrong now, or nothing.
    void setProblems(const QStringList& problems);
    void setCommand(const QString& command);
    /// On a page of results.
    void showTable(const ResultTable& table, const QString& title, const QString& figures);
    /// On a widget that exports what it shows; the one before is deleted where it is another.
    template <typename Answer>
    void showTableOn(Answer& answer, const ResultTable& table, const QString& title,
                     const QString& figures) {
        take(answer, answer, table, title, figures);
    }
    const QString& title() const { return title_; }
    Workbench& workbench() const { return workbench_; }
    const Dialogs& dialogs() const { return dialogs_; }
    /// The files that the project names as its air, as a label says it.
    QString atmosphereWords() const;

    /// What is computed; captures values alone.
    virtual Calculation::Work work() = 0;
    /// The title of what is said where it cannot be computed.
    virtual QString refusalTitle() const { return tr("The atmosphere gives no values here"); }

  private:
    void take(QWidget& answer, const Exportable& content, const ResultTable& table,
              const QString& title, const QString& figures);
    void keep();
    void refreshButtons();
    void tellElapsed();

    Workbench& workbench_;
    Dialogs dialogs_;
    ResultTable table_;
    QString title_;
    QVBoxLayout* inputs_ = nullptr;
    QVBoxLayout* buttons_ = nullptr;
    QVBoxLayout* answer_ = nullptr;
    QLabel* problems_ = nullptr;
    QLabel* figures_ = nullptr;
    QLabel* empty_ = nullptr;
    QLineEdit* command_ = nullptr;
    QPushButton* compute_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* busy_ = nullptr;
    QLabel* elapsed_ = nullptr;
    std::vector<QPushButton*> needAnswer_;
    QWidget* shown_ = nullptr;            ///< the answer
    const Exportable* content_ = nullptr; ///< the same
    bool inputsRight_ = true;
    QTimer tick_;             ///< while it computes
    Calculation calculation_; ///< last: nothing of it is heard once the rest goes
};

} // namespace smat::gui
