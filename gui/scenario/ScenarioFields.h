#pragma once

#include <functional>

#include <QWidget>

#include "smatcore/simulate/Scenario.h"

class QFormLayout;
class QLineEdit;
class QPlainTextEdit;

namespace smat::gui {

class NumberField;

/// Title, times and notes of a scenario.
class ScenarioFields : public QWidget {
    Q_OBJECT

  public:
    explicit ScenarioFields(QWidget* parent = nullptr);
    void show(const Scenario& scenario);

  signals:
    /// By the user, while it goes on; `step` is its name.
    void edited(const QString& step, const std::function<void(smat::Scenario&)>& edit);
    void finished();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    NumberField* timeField(QFormLayout* form, const char* name, const QString& label,
                           const QString& step, double Scenario::*time);

    QLineEdit* title_ = nullptr;
    NumberField *start_ = nullptr, *end_ = nullptr, *step_ = nullptr;
    QPlainTextEdit* notes_ = nullptr;
};

} // namespace smat::gui
