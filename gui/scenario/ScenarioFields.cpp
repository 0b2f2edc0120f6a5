#include "gui/scenario/ScenarioFields.h"

#include <QEvent>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>

#include "gui/widgets/NumberField.h"
#include "gui/widgets/NumberFormat.h"

namespace smat::gui {
namespace {

constexpr int notesRows = 4;

} // namespace

ScenarioFields::ScenarioFields(QWidget* parent) : QWidget(parent) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    title_ = new QLineEdit(this);
    title_->setObjectName("scenarioTitle");
    form->addRow(tr("Title"), title_);
    start_ =
        timeField(form, "scenarioStart", tr("Start"), tr("Change the start"), &Scenario::start_s);
    end_ = timeField(form, "scenarioEnd", tr("End"), tr("Change the end"), &Scenario::end_s);
    step_ = timeField(form, "scenarioStep", tr("Step"), tr("Change the step"), &Scenario::dt_s);
    step_->setRange(1e-6, 1e9);
    step_->setStep(0.1);
    for (NumberField* field : {start_, end_})
        field->setRange(-1e9, 1e9);
    notes_ = new QPlainTextEdit(this);
    notes_->setObjectName("scenarioText");
    notes_->setAccessibleName(tr("Notes"));
    notes_->setTabChangesFocus(true);
    notes_->setFixedHeight(notesRows * fontMetrics().lineSpacing() + 16);
    notes_->installEventFilter(this);
    form->addRow(tr("Notes"), notes_);
    connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
        emit edited(tr("Change the title"),
                    [title = text.toStdString()](Scenario& to) { to.title = title; });
    });
    connect(title_, &QLineEdit::editingFinished, this, &ScenarioFields::finished);
    connect(notes_, &QPlainTextEdit::textChanged, this, [this] {
        emit edited(tr("Change the notes"), [notes = notes_->toPlainText().toStdString()](
                                                Scenario& to) { to.notes = notes; });
    });
}

NumberField* ScenarioFields::timeField(QFormLayout* form, const char* name, const QString& label,
                                       const QString& step, double Scenario::*time) {
    auto* field = new NumberField("s", this);
    field->setObjectName(name);
    field->setAccessibleName(label);
    form->addRow(label, field);
    connect(field, &NumberField::edited, this, [this, step, time](double value) {
        emit edited(step, [time, value](Scenario& to) { to.*time = value; });
    });
    connect(field, &NumberField::finished, this, &ScenarioFields::finished);
    return field;
}

void ScenarioFields::show(const Scenario& scenario) {
    if (title_->text() != textOf(scenario.title))
        title_->setText(textOf(scenario.title));
    start_->setValue(scenario.start_s);
    end_->setValue(scenario.end_s);
    step_->setValue(scenario.dt_s);
    if (notes_->toPlainText() != textOf(scenario.notes)) {
        const QSignalBlocker quiet(notes_);
        notes_->setPlainText(textOf(scenario.notes));
    }
}

bool ScenarioFields::eventFilter(QObject* watched, QEvent* event) {
    if (watched == notes_ && event->type() == QEvent::FocusOut)
        emit finished();
    return QWidget::eventFilter(watched, event);
}

} // namespace smat::gui

#include "moc_ScenarioFields.cpp"
