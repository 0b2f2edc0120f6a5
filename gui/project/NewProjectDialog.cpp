#include "gui/project/NewProjectDialog.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/project/PlacingFields.h"
#include "gui/project/ProjectFiles.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {

NewProjectDialog::NewProjectDialog(Dialogs& dialogs, QWidget* parent)
    : QDialog(parent), dialogs_(dialogs) {
    setObjectName("newProjectDialog");
    setWindowTitle(tr("New project"));
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    model_ = addFile(form, "model", tr("&Model"), tr("Model of the project"),
                     {ProjectFiles::modelFilter(), tr("All files (*)")});
    database_ =
        addFile(form, "database", tr("Signature &database"), tr("Signature database of the model"),
                {tr("Signature databases (*.sigdb)")});
    database_->setPlaceholderText(tr("none yet"));
    title_ = new QLineEdit(this);
    title_->setObjectName("title");
    form->addRow(tr("&Title"), title_);
    placing_ = new PlacingFields("placing", this);
    remark_ = new QLabel(this);
    remark_->setObjectName("remark");
    remark_->setForegroundRole(QPalette::PlaceholderText);
    remark_->setWordWrap(true);

    auto* buttons = okAndCancel(*this, tr("Create"));
    create_ = buttons->button(QDialogButtonBox::Ok);
    create_->setObjectName("create");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(14);
    column->addLayout(form);
    column->addWidget(remark_);
    column->addWidget(placing_, 1);
    column->addWidget(buttons);
    setMinimumWidth(560);
    connect(model_, &QLineEdit::textChanged, this, &NewProjectDialog::onModelChanged);
    connect(database_, &QLineEdit::textChanged, this, &NewProjectDialog::refresh);
    connect(placing_, &PlacingFields::changed, this, &NewProjectDialog::refresh);
    refresh();
}

QLineEdit* NewProjectDialog::addFile(QFormLayout* form, const QString& name, const QString& label,
                                     const QString& title, const QStringList& filters) {
    auto* edit = new QLineEdit(this);
    edit->setObjectName(name);
    auto* browse = new QToolButton(this);
    browse->setObjectName(name + ".browse");
    browse->setIcon(icon("open"));
    browse->setToolTip(tr("Choose a file"));
    connect(browse, &QToolButton::clicked, this, [this, edit, title, filters] {
        if (const QString file = dialogs_.openFile(this, title, filters); !file.isEmpty())
            edit->setText(file);
    });
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(edit, 1);
    row->addWidget(browse);
    auto* caption = new QLabel(label, this);
    caption->setBuddy(edit);
    form->addRow(caption, row);
    return edit;
}

void NewProjectDialog::onModelChanged() {
    // Title and database follow the model until they are the person's own.
    const Project proposal = projectOfModel(model_->text().trimmed().toStdString());
    if (!title_->isModified())
        title_->setText(QString::fromStdString(proposal.title));
    if (!database_->isModified())
        database_->setText(QString::fromStdString(proposal.models.front().database.string()));
    const QString file = model_->text().trimmed();
    placing_->setFile(QFileInfo(file).isFile() ? file.toStdString() : std::string());
    refresh();
}

bool NewProjectDialog::isAcceptable() const {
    const QString database = database_->text().trimmed();
    return QFileInfo(model_->text().trimmed()).isFile() && placing_->isRight() &&
           (database.isEmpty() || QFileInfo(database).isFile());
}

void NewProjectDialog::refresh() {
    const QString model = model_->text().trimmed();
    const QString database = database_->text().trimmed();
    remark_->setText(model.isEmpty()              ? tr("Choose the model this project is about.")
                     : !QFileInfo(model).isFile() ? tr("There is no file %1.").arg(model)
                     : database.isEmpty()
                         ? tr("Without a signature database the model can be looked "
                              "at, but not analysed.")
                     : !QFileInfo(database).isFile() ? tr("There is no file %1.").arg(database)
                                                     : QString());
    create_->setEnabled(isAcceptable());
}

std::optional<irsg::BoundingBox> NewProjectDialog::bounds() const {
    return placing_->bounds();
}

Project NewProjectDialog::project() const {
    const auto absolute = [](const QString& file) {
        return file.isEmpty() ? std::filesystem::path()
                              : std::filesystem::absolute(file.toStdString()).lexically_normal();
    };
    Project project = projectOfModel(absolute(model_->text().trimmed()));
    project.title = title_->text().trimmed().toStdString();
    project.models.front().database = absolute(database_->text().trimmed());
    project.models.front().options.placing = placing_->placing();
    return project;
}

} // namespace smat::gui

#include "moc_NewProjectDialog.cpp"
