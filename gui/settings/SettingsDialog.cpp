#include "gui/settings/SettingsDialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>

#include "gui/settings/MtfNote.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/VerticalScrollArea.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

std::vector<SettingsPage> SettingsDialog::pages() {
    return {
        {tr("Band and mode"), "spectrum", settingsOn(SettingPage::bandAndMode), {key::sensorMode}},
        {tr("Sensor"), "sensor", settingsOn(SettingPage::sensor)},
        {tr("Camera and model"), "axes", settingsOn(SettingPage::cameraAndModel)},
        {tr("Sun and fluxes"), "sun", settingsOn(SettingPage::sunAndFluxes)},
        {tr("Atmosphere"), "air", settingsOn(SettingPage::atmosphere)},
        {tr("Scattering"), "air", settingsOn(SettingPage::scattering)},
        {tr("Background"), "image", settingsOn(SettingPage::background)},
        {tr("Skybox"), "sky", settingsOn(SettingPage::skybox)},
        {tr("Terrain"), "terrain", settingsOn(SettingPage::terrain)},
        {tr("Antialiasing"), "options", settingsOn(SettingPage::antialiasing)},
        {tr("Colours"), "infrared", settingsOn(SettingPage::colours)},
        {tr("Scalings"), "montecarlo", settingsOn(SettingPage::scalings)}};
}

SettingsDialog::SettingsDialog(Workbench& workbench, FileChooser chooseFile, QWidget* parent)
    : SettingsDialog({.title = tr("Settings"),
                      .settings = [&workbench] { return workbench.settings(); },
                      .set =
                          [&workbench](const Settings& edited) {
                              workbench.set(edited, tr("Change settings"));
                              return QString();
                          },
                      .resolve =
                          [&workbench](const std::filesystem::path& path) {
                              return workbench.project().resolve(path);
                          }},
                     pages(), std::move(chooseFile), parent) {}

SettingsDialog::SettingsDialog(SettingsSubject subject, std::vector<SettingsPage> pages,
                               FileChooser chooseFile, QWidget* parent)
    : QDialog(parent), subject_(std::move(subject)), pages_(std::move(pages)) {
    setObjectName("settingsDialog");
    setWindowTitle(subject_.title);
    resize(800, 600);
    search_ = new QLineEdit(this);
    search_->setObjectName("settingsSearch");
    search_->setPlaceholderText(tr("Search"));
    search_->setClearButtonEnabled(true);
    search_->setFixedWidth(180);
    connect(search_, &QLineEdit::textChanged, this, &SettingsDialog::search);
    list_ = new QListWidget(this);
    list_->setObjectName("pageList");
    list_->setFixedWidth(180);
    list_->setIconSize(QSize(20, 20));
    list_->setSpacing(2);
    auto* stack = new QStackedWidget(this);
    for (const auto& page : pages_) {
        new QListWidgetItem(icon(page.icon), page.title, list_);
        auto* form = new SettingForm(page.keys, chooseFile, nullptr, true);
        form->setValues(subject_.settings());
        connect(form, &SettingForm::edited, this, &SettingsDialog::refresh);
        connect(form, &SettingForm::validityChanged, this, &SettingsDialog::refresh);
        forms_.push_back(form);
        addNotes(form);
        auto* scroll = new VerticalScrollArea(form, stack);
        scroll->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        stack->addWidget(scroll);
    }
    connect(list_, &QListWidget::currentRowChanged, stack, &QStackedWidget::setCurrentIndex);
    problems_ = new QLabel(this);
    problems_->setObjectName("problems");
    problems_->setWordWrap(true);
    experts_ = new QCheckBox(tr("Show &expert settings"), this);
    experts_->setObjectName("showExperts");
    experts_->setVisible(std::any_of(pages_.begin(), pages_.end(), [](const auto& page) {
        return std::any_of(page.keys.begin(), page.keys.end(), [&](const auto& key) {
            return settingInfo(key).audience == SettingAudience::expert &&
                   std::find(page.always.begin(), page.always.end(), key) == page.always.end();
        });
    }));
    connect(experts_, &QCheckBox::toggled, this, &SettingsDialog::showExperts);
    buttons_ = okAndCancel(*this);
    auto* apply = buttons_->addButton(QDialogButtonBox::Apply);
    apply->setObjectName("apply");
    apply->setIcon({});
    connect(apply, &QPushButton::clicked, this, &SettingsDialog::apply);

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(16, 14, 16, 14);
    grid->setHorizontalSpacing(14);
    grid->setVerticalSpacing(10);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(1, 1);
    grid->addWidget(search_, 0, 0);
    grid->addWidget(list_, 1, 0);
    grid->addWidget(stack, 0, 1, 2, 1);
    grid->addWidget(problems_, 2, 0, 1, 2);
    grid->addWidget(experts_, 3, 0);
    grid->addWidget(buttons_, 3, 1);
    showPage(0);
    showExperts(false);
    refresh();
}

void SettingsDialog::addNotes(SettingForm* form) {
    const std::string key = key::environmentMtf;
    if (std::ranges::find(form->keys(), key) == form->keys().end())
        return;
    auto* note = new MtfNote(form);
    dynamic_cast<QFormLayout&>(*form->layout()).addRow(note);
    const auto tell = [this, form, note, key] {
        const std::string file = form->value(key);
        note->tell(file.empty() ? std::filesystem::path() : subject_.resolve(file));
    };
    connect(form, &SettingForm::edited, note, tell);
    tell();
}

void SettingsDialog::showPage(int page) {
    list_->setCurrentRow(page);
}

void SettingsDialog::showPage(const QString& title) {
    for (std::size_t i = 0; i < pages_.size(); ++i)
        if (pages_[i].title == title)
            showPage(static_cast<int>(i));
}

void SettingsDialog::search(const QString& words) {
    const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
    int first = -1;
    for (std::size_t i = 0; i < forms_.size(); ++i) {
        const int row = static_cast<int>(i);
        const bool has = wanted.isEmpty() || forms_[i]->showMatching(wanted) > 0;
        list_->item(row)->setHidden(!has);
        first = has && first < 0 ? row : first;
    }
    if (wanted.isEmpty())
        showExperts(experts_->isChecked());
    else if (first >= 0)
        showPage(first);
}

void SettingsDialog::showExperts(bool visible) {
    for (std::size_t i = 0; i < forms_.size(); ++i)
        forms_[i]->setExpertVisible(visible, pages_[i].always);
}

bool SettingsDialog::isAcceptable() const {
    return std::all_of(forms_.begin(), forms_.end(),
                       [](const auto* form) { return form->isValid(); });
}

Settings SettingsDialog::edited() const {
    Settings settings = subject_.settings();
    for (const auto* form : forms_)
        form->writeTo(settings);
    return settings;
}

void SettingsDialog::refresh() {
    QStringList problems;
    for (const auto* form : forms_)
        problems += form->problems();
    problems_->setText(problems.join('\n'));
    problems_->setVisible(!problems.isEmpty());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(problems.isEmpty());
    buttons_->button(QDialogButtonBox::Apply)
        ->setEnabled(problems.isEmpty() && edited() != subject_.settings());
}

bool SettingsDialog::apply() {
    if (!isAcceptable())
        return false;
    const QString problem = subject_.set(edited());
    refresh();
    if (problem.isEmpty())
        return true;
    problems_->setText(problem);
    problems_->show();
    return false;
}

void SettingsDialog::accept() {
    if (apply())
        QDialog::accept();
}

} // namespace smat::gui

#include "moc_SettingsDialog.cpp"
