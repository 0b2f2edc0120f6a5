#include "gui/ScenePanel.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "gui/Workbench.h"

namespace smat::gui {

ScenePanel::ScenePanel(Workbench& workbench, FileChooser chooseFile, QWidget* parent)
    : QDockWidget(tr("Scene"), parent), workbench_(workbench) {
    setObjectName("sceneDock");
    auto* body = new QWidget;
    title_ = new QLabel(tr("No project"), body);
    title_->setObjectName("projectTitle");
    QFont font = title_->font();
    font.setPointSizeF(font.pointSizeF() * 1.15);
    font.setBold(true);
    title_->setFont(font);
    title_->setWordWrap(true);
    models_ = new QLabel(body);
    models_->setObjectName("projectModels");
    models_->setForegroundRole(QPalette::PlaceholderText);
    models_->setWordWrap(true);

    std::vector<std::string> keys;
    for (const auto* section : {"camera", "target", "state"}) {
        for (const auto& key : settingKeys(section))
            keys.push_back(key);
    }
    form_ = new SettingForm(keys, std::move(chooseFile), body);
    form_->layout()->setContentsMargins(0, 8, 0, 0);
    form_->setEnabled(false);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(12, 10, 12, 10);
    column->addWidget(title_);
    column->addWidget(models_);
    column->addWidget(form_);
    column->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(body);
    scroll->setMinimumWidth(280);
    setWidget(scroll);

    connect(&workbench_, &Workbench::projectOpened, this, &ScenePanel::refresh);
    connect(&workbench_, &Workbench::settingsChanged, this, &ScenePanel::refresh);
    connect(form_, &SettingForm::edited, this,
            [this](const std::string& key) { workbench_.set(key, form_->value(key)); });
}

void ScenePanel::refresh() {
    const Project& project = workbench_.project();
    const QString title = QString::fromStdString(project.title);
    title_->setText(title.isEmpty() ? QString::fromStdString(project.displayName()) : title);
    QStringList lines;
    for (const auto& model : project.models) {
        lines << QString::fromStdString(model.file.filename().string());
        lines << (model.database.empty()
                      ? tr("no signature database")
                      : QString::fromStdString(model.database.filename().string()));
    }
    models_->setText(lines.join('\n'));
    form_->setEnabled(true);

    // A field that is being typed into holds the same value already and keeps its text.
    for (const auto* section : {"camera", "target", "state"}) {
        for (const auto& key : settingKeys(section)) {
            const std::string& text = workbench_.settings().text(key);
            if (form_->value(key) != text)
                form_->setValue(key, text);
        }
    }
}

} // namespace smat::gui
