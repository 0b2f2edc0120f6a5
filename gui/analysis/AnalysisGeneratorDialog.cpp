#include "gui/analysis/AnalysisGeneratorDialog.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/SettingWords.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {
namespace {

/// The file a terminal user would write, by kind.
std::string exampleFile(AnalysisKind kind) {
    return name(kind) + (kind->form == AnalysisForm::image ? ".exr" : ".csv");
}

} // namespace

AnalysisGeneratorDialog::AnalysisGeneratorDialog(const Project& project, const Settings& settings,
                                                 AnalysisKind kind, FileChooser chooseFile,
                                                 QWidget* parent)
    : QDialog(parent),
      project_(project),
      settings_(settings),
      kind_(kind),
      chooseFile_(std::move(chooseFile)) {
    setObjectName("analysisGeneratorDialog");
    setWindowTitle(tr("New analysis – %1").arg(QString::fromStdString(title(kind))));

    auto* heading = new QLabel(QString::fromStdString(title(kind)), this);
    QFont font = heading->font();
    font.setPointSizeF(font.pointSizeF() * 1.4);
    font.setBold(true);
    heading->setFont(font);
    auto* of = new QLabel(tr("of %1").arg(QString::fromStdString(project.displayName())), this);
    of->setForegroundRole(QPalette::PlaceholderText);
    name_ = new QLineEdit(this);
    name_->setObjectName("analysisName");
    name_->setPlaceholderText(tr("Name of the result (optional)"));

    auto* tabs = new QTabWidget(this);
    tabs->setObjectName("pages");
    tabs->setDocumentMode(true);
    addPage(QString::fromStdString(title(kind)), {name(kind)}, tabs);
    addPage(tr("Camera and target"), {"camera", "target", "state", "scaling"}, tabs);
    addPage(tr("Sensor"), {"sensor"}, tabs);
    addPage(tr("Environment"), {"environment"}, tabs);
    addPage(tr("Rendering"), {"render"}, tabs);
    if (kind_->form == AnalysisForm::image)
        addPage(tr("Display"), {"display"}, tabs);

    problems_ = new QLabel(this);
    problems_->setObjectName("problems");
    problems_->setWordWrap(true);
    plan_ = new QLabel(this);
    plan_->setObjectName("plan");
    plan_->setWordWrap(true);
    plan_->setForegroundRole(QPalette::PlaceholderText);
    ignored_ = new QLabel(this);
    ignored_->setObjectName("ignored");
    ignored_->setWordWrap(true);
    ignored_->setForegroundRole(QPalette::PlaceholderText);
    command_ = new QLineEdit(this);
    command_->setObjectName("commandLine");
    command_->setReadOnly(true);
    command_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* copy = new QToolButton(this);
    copy->setText(tr("Copy"));
    copy->setObjectName("copyCommand");
    connect(copy, &QToolButton::clicked, this,
            [this] { QApplication::clipboard()->setText(command_->text()); });
    auto* same = new QLabel(tr("Equivalent command"), this);
    same->setForegroundRole(QPalette::PlaceholderText);

    unsaved_ = new QLabel(this);
    unsaved_->setObjectName("unsavedNote");
    unsaved_->setWordWrap(true);
    unsaved_->hide();

    buttons_ = okAndCancel(*this, tr("Run"));
    buttons_->button(QDialogButtonBox::Ok)->setObjectName("run");

    auto* top = new QHBoxLayout;
    top->addWidget(heading);
    top->addWidget(of, 1, Qt::AlignBottom);
    auto* terminal = new QHBoxLayout;
    terminal->addWidget(command_, 1);
    terminal->addWidget(copy);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(10);
    column->addLayout(top);
    column->addWidget(name_);
    column->addWidget(tabs, 1);
    column->addWidget(plan_);
    column->addWidget(ignored_);
    column->addWidget(problems_);
    column->addWidget(same);
    column->addLayout(terminal);
    column->addWidget(unsaved_);
    column->addWidget(buttons_);
    connect(name_, &QLineEdit::textChanged, this, &AnalysisGeneratorDialog::refresh);
    refresh();
    // As wide as the titles of all pages.
    constexpr int usualWidth_px = 560, usualHeight_px = 700;
    tabs->tabBar()->ensurePolished();
    resize(std::max(usualWidth_px, tabs->tabBar()->sizeHint().width() + 40), usualHeight_px);
}

void AnalysisGeneratorDialog::addPage(const QString& title,
                                      const std::vector<std::string>& sections, QTabWidget* tabs) {
    std::vector<std::string> keys;
    for (const auto& section : sections)
        for (const auto& key : settingKeys(section))
            keys.push_back(key);
    auto* form = new SettingForm(keys, chooseFile_);
    form->setValues(settings_);
    forms_.push_back(form);
    connect(form, &SettingForm::edited, this, &AnalysisGeneratorDialog::refresh);
    connect(form, &SettingForm::validityChanged, this, &AnalysisGeneratorDialog::refresh);
    auto* scroll = new QScrollArea(tabs);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(form);
    tabs->addTab(scroll, title);
}

void AnalysisGeneratorDialog::setName(const QString& name) {
    name_->setText(name);
}

void AnalysisGeneratorDialog::setUnsavedNote(const QString& note) {
    unsaved_->setText(note);
    unsaved_->setVisible(!note.isEmpty());
}

QStringList AnalysisGeneratorDialog::problems() const {
    QStringList list;
    for (const auto* form : forms_)
        list += form->problems();
    if (!list.isEmpty())
        return list;
    // Values that are right one by one may not fit each other.
    const auto collect = [&](const auto& work) {
        try {
            work();
        } catch (const irsg::InputError& error) {
            list << sentencesOf(error);
        }
    };
    const AnalysisData asked = data();
    collect([&] {
        plan_->setText(withFormattedUnits(QString::fromStdString(
            planAnalysis(asked.kind, asked.project, asked.settings).description)));
    });
    collect([&] {
        sensorOf(asked.project, asked.settings);
        bandsOf(asked.project, asked.settings);
    });
    return list;
}

bool AnalysisGeneratorDialog::isAcceptable() const {
    return problems().isEmpty();
}

AnalysisData AnalysisGeneratorDialog::data() const {
    Settings settings = settings_;
    for (const auto* form : forms_)
        form->writeTo(settings);
    AnalysisData data = AnalysisData::of(project_, kind_, settings);
    if (const QString given = name_->text().trimmed(); !given.isEmpty())
        data.name = given.toStdString();
    data.commandLine = data.equivalentCommand(exampleFile(kind_));
    return data;
}

void AnalysisGeneratorDialog::showIgnored() {
    const AnalysisData asked = data();
    std::vector<std::string> keys;
    if (asked.kind->ignored != nullptr)
        keys = asked.kind->ignored(asked.settings);
    for (auto* form : forms_)
        form->setUnused(keys);
    QStringList words;
    for (const std::string& key : keys)
        words << QString::fromStdString(settingWords(asked.settings, key));
    ignored_->setText(tr("Not used by this analysis: %1.").arg(words.join(", ")));
    ignored_->setVisible(!words.isEmpty());
}

void AnalysisGeneratorDialog::refresh() {
    showIgnored();
    const QStringList wrong = problems();
    problems_->setText(wrong.join('\n'));
    problems_->setVisible(!wrong.isEmpty());
    plan_->setVisible(wrong.isEmpty());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty());
    if (wrong.isEmpty()) {
        command_->setText(QString::fromStdString(data().commandLine));
        command_->setToolTip(command_->text());
        command_->setCursorPosition(0);
    }
}

} // namespace smat::gui

#include "moc_AnalysisGeneratorDialog.cpp"
