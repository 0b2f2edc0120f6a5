#include "gui/project/ProjectPropertiesDialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include "gui/project/PlacingFields.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/NumberBoxes.h"

namespace smat::gui {
namespace {

constexpr int noEntry = -1, largestIndex = 65535;

QFormLayout* formOf(QWidget* page) {
    auto* form = new QFormLayout(page);
    form->setContentsMargins(14, 14, 14, 14);
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    return form;
}

QSpinBox* entryField(const QString& name, const std::optional<int>& value) {
    auto* box = new WholeBox(name);
    box->setRange(noEntry, largestIndex);
    box->setSpecialValueText(ProjectPropertiesDialog::tr("none: such faces are refused"));
    box->setValue(value.value_or(noEntry));
    return box;
}

std::optional<int> entryOf(const QSpinBox* box) {
    return box->value() == noEntry ? std::nullopt : std::optional(box->value());
}

} // namespace

ProjectPropertiesDialog::ProjectPropertiesDialog(const Project& project, QWidget* parent)
    : QDialog(parent), project_(project) {
    setObjectName("projectPropertiesDialog");
    setWindowTitle(tr("Project properties"));
    resize(640, 600);
    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    auto* page = new QWidget;
    auto* form = formOf(page);
    title_ = new QLineEdit(QString::fromStdString(project.title));
    title_->setObjectName("title");
    notes_ = new QPlainTextEdit(QString::fromStdString(project.notes));
    notes_->setObjectName("notes");
    notes_->setTabChangesFocus(true);
    notes_->setPlaceholderText(tr("What this project is for, and where its data come from"));
    form->addRow(tr("&Title"), title_);
    form->addRow(tr("&Notes"), notes_);
    tabs->addTab(page, tr("Project"));
    for (const auto& model : project.models)
        addModel(model, tabs);

    auto* buttons = okAndCancel(*this);
    const auto judge = [this, buttons] {
        buttons->button(QDialogButtonBox::Ok)
            ->setEnabled(std::ranges::all_of(
                models_, [](const ModelFields& fields) { return fields.placing->isRight(); }));
    };
    for (const ModelFields& fields : models_)
        connect(fields.placing, &PlacingFields::changed, this, judge);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 14);
    column->addWidget(tabs, 1);
    column->addWidget(buttons);
}

void ProjectPropertiesDialog::addModel(const ProjectModel& model, QTabWidget* tabs) {
    auto* page = new QWidget;
    auto* form = formOf(page);
    const QString number = QString::number(models_.size());
    ModelFields fields;
    fields.name = new QLineEdit(QString::fromStdString(model.name));
    fields.name->setObjectName("name." + number);
    fields.name->setPlaceholderText(QString::fromStdString(model.file.stem().string()));
    fields.placing = new PlacingFields("placing." + number);
    fields.placing->setPlacing(model.options.placing);
    fields.placing->setFile(project_.resolve(model.file));
    fields.twoSided = new QCheckBox(tr("Faces show &both sides, whatever the file says"));
    fields.twoSided->setObjectName("twoSided." + number);
    fields.twoSided->setChecked(model.options.forceTwoSided);
    fields.cutTextureAlpha = new QCheckBox(tr("Alpha of te&xtures cuts faces out below 0.5"));
    fields.cutTextureAlpha->setObjectName("cutTextureAlpha." + number);
    fields.cutTextureAlpha->setToolTip(
        tr("What a texture leaves out is no part of its face, in the infrared and in the visible "
           "view. A file's own threshold stands in place of 0.5."));
    fields.cutTextureAlpha->setChecked(model.options.cutsTextureAlpha);
    fields.fallbackTemperature =
        entryField("fallbackTemperature." + number, model.fallbackTemperature);
    fields.fallbackMaterial = entryField("fallbackMaterial." + number, model.fallbackMaterial);
    form->addRow(tr("N&ame"), fields.name);
    form->addRow(fields.placing);
    form->addRow({}, fields.twoSided);
    form->addRow({}, fields.cutTextureAlpha);
    auto* hint = new QLabel(tr("Entries of the database that stand in for codes without one:"));
    hint->setForegroundRole(QPalette::PlaceholderText);
    hint->setWordWrap(true);
    form->addRow({}, hint);
    form->addRow(tr("Fallback te&mperature"), fields.fallbackTemperature);
    form->addRow(tr("Fallback mate&rial"), fields.fallbackMaterial);
    models_.push_back(fields);
    tabs->addTab(page, tr("Model %1")
                           .arg(fields.name->text().isEmpty() ? fields.name->placeholderText()
                                                              : fields.name->text()));
}

Project ProjectPropertiesDialog::project() const {
    Project project = project_;
    project.title = title_->text().trimmed().toStdString();
    project.notes = notes_->toPlainText().toStdString();
    for (std::size_t i = 0; i < models_.size(); ++i) {
        const ModelFields& fields = models_[i];
        ProjectModel& model = project.models[i];
        model.name = fields.name->text().trimmed().toStdString();
        model.options.placing = fields.placing->placing();
        model.options.forceTwoSided = fields.twoSided->isChecked();
        model.options.cutsTextureAlpha = fields.cutTextureAlpha->isChecked();
        model.fallbackTemperature = entryOf(fields.fallbackTemperature);
        model.fallbackMaterial = entryOf(fields.fallbackMaterial);
    }
    return project;
}

} // namespace smat::gui

#include "moc_ProjectPropertiesDialog.cpp"
