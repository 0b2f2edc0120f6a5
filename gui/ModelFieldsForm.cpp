#include "gui/ModelFieldsForm.h"

#include <utility>

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

#include "gui/settings/SettingForm.h"
#include "gui/settings/TypedSetting.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/RefusedText.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {

ModelFieldsForm::ModelFieldsForm(Workbench& workbench, QWidget* parent)
    : QWidget(parent), workbench_(workbench) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    for (const ModelField& field : modelFields())
        if (field.key != "yaw") // the heading says it
            addRow(grid, field);
}

void ModelFieldsForm::addRow(QGridLayout* grid, const ModelField& field) {
    auto* edit = new QLineEdit(this);
    edit->setObjectName(textOf(field.info.key));
    edit->setAlignment(Qt::AlignRight);
    edit->setToolTip(SettingForm::helpText(field.info));
    if (field.info.kind == SettingKind::choiceOrReal)
        edit->setPlaceholderText(tr("as the target"));
    auto* caption = new QLabel(textOf(field.info.label), this);
    caption->setBuddy(edit);
    caption->setToolTip(edit->toolTip());
    auto* unit = new QLabel(formattedUnit(field.info.unit), this);
    unit->setForegroundRole(QPalette::PlaceholderText);
    const int line = grid->rowCount();
    grid->addWidget(caption, line, 0);
    grid->addWidget(edit, line, 1);
    grid->addWidget(unit, line, 2);
    fields_[field.key] = edit;
    connect(edit, &QLineEdit::textEdited, this, [this, &field] { onText(field); });
    connect(edit, &QLineEdit::editingFinished, this, [this, &field] { finish(field); });
}

std::string ModelFieldsForm::valueOf(const ModelField& field) const {
    return typedSetting(field.info, typedIn(field)).value_or("");
}

QString ModelFieldsForm::typedIn(const ModelField& field) const {
    const QString text = fields_.at(field.key)->text().trimmed();
    const bool hasChoice = field.info.kind == SettingKind::choiceOrReal;
    return hasChoice && text.isEmpty() ? textOf(std::string(asTheTarget)) : text;
}

void ModelFieldsForm::finish(const ModelField& field) {
    QLineEdit& edit = *fields_.at(field.key);
    const QString problem = problemOf(field.info, typedIn(field));
    // A text that cannot stay takes along what its first letters did.
    if (const auto before = std::exchange(before_, std::nullopt);
        before && !problem.isEmpty() && workbench_.chosenModel() == shown_) {
        sayRefused(edit, problem, *before == asTheTarget ? tr("as the target") : textOf(*before));
        workbench_.setField(shown_, field, *before);
    }
    workbench_.closeStep();
    edit.clear();
    refresh();
}

void ModelFieldsForm::onText(const ModelField& field) {
    if (!before_ && shown_ < workbench_.project().models.size())
        before_ = smat::textOf(workbench_.project(), shown_, field);
    const std::string text = valueOf(field);
    QPalette colours; // of the theme, but for a mark
    if (text.empty())
        colours.setColor(QPalette::Base, colors::wrongField(palette()));
    fields_.at(field.key)->setPalette(colours);
    if (!text.empty() && workbench_.chosenModel() == shown_)
        workbench_.setField(shown_, field, text);
}

void ModelFieldsForm::refresh() {
    const std::size_t model = workbench_.chosenModel();
    const bool isOther = model != shown_;
    shown_ = model;
    if (!workbench_.hasProject() || model == 0 || model >= workbench_.project().models.size())
        return;
    for (const ModelField& field : modelFields()) {
        const auto found = fields_.find(field.key);
        if (found == fields_.end())
            continue;
        // A field that is being typed into holds the same value already and keeps its text.
        const std::string text = smat::textOf(workbench_.project(), model, field);
        // -90 degrees of heading are 270, too.
        ProjectModel typed = workbench_.project().models[model];
        const std::string value = valueOf(field);
        if (!value.empty())
            field.set(typed, value);
        if (isOther || value.empty() || field.text(typed) != text) {
            found->second->setText(text == asTheTarget ? QString() : QString::fromStdString(text));
            found->second->setPalette(QPalette());
        }
    }
}

} // namespace smat::gui

#include "moc_ModelFieldsForm.cpp"
