#include "gui/atmosphere/AtmospherePage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/atmosphere/AtmospherePlots.h"
#include "gui/atmosphere/AtmosphereRecovery.h"
#include "gui/atmosphere/AtmosphereSight.h"
#include "gui/atmosphere/ParameterForm.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/FoldingSplitter.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/widgets/VerticalScrollArea.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

/// Spectra, or why there are none; the profile where there is one.
struct AtmospherePage::Answer {
    AtmosphereSpectra spectra;
    AtmosphereProfile column;
    QStringList problems;
};

AtmospherePage::AtmospherePage(std::unique_ptr<AtmosphereDocument> document, Workbench& workbench,
                               Dialogs dialogs, QWidget* parent)
    : QWidget(parent),
      document_(std::move(document)),
      workbench_(workbench),
      dialogs_(std::move(dialogs)) {
    setObjectName("airPage");
    recovery_ = new AtmosphereRecovery(*document_, this);
    connect(recovery_, &AtmosphereRecovery::failed, this, &AtmospherePage::said);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    auto* side = makeSide();
    row->addWidget(new FoldingSplitter(side, side->minimumSizeHint().width(), makePicture(), this));
    connect(document_.get(), &AtmosphereDocument::changed, this, &AtmospherePage::ask);
    connect(document_.get(), &AtmosphereDocument::stateChanged, this, [this] {
        refreshButtons();
        emit titleChanged(title());
    });
    connect(sight_, &AtmosphereSight::changed, this, &AtmospherePage::ask);
    connect(form_, &ParameterForm::entered, this,
            [this](const irsg::SmartParameter& parameter) { help_->setText(helpText(parameter)); });
    connect(form_, &ParameterForm::problemChanged, this, [this] {
        if (!form_->problem().isEmpty())
            tell({form_->problem()});
        else
            ask();
    });
    connect(&workbench_, &Workbench::projectOpened, this, &AtmospherePage::refreshButtons);
    connect(&workbench_, &Workbench::settingsChanged, this, &AtmospherePage::refreshButtons);
    refreshButtons();
    ask();
}

QWidget* AtmospherePage::makeSide() {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(6);
    form_ = new ParameterForm(*document_, dialogs_);
    form_->layout()->setContentsMargins(10, 10, 10, 4);
    column->addWidget(new VerticalScrollArea(form_, side), 1);
    help_ = new QLabel(tr("Help for the field being edited."), side);
    help_->setObjectName("parameterHelp");
    help_->setTextFormat(Qt::RichText);
    help_->setWordWrap(true);
    help_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    help_->setForegroundRole(QPalette::PlaceholderText);
    help_->setContentsMargins(12, 0, 12, 0);
    help_->setFixedHeight(6 * fontMetrics().lineSpacing());
    help_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(help_);
    save_ = new QPushButton(tr("Save atmosphere"), side);
    save_->setObjectName("saveAir");
    save_->setToolTip(tr("Save this atmosphere (Ctrl+S); a new one asks for a file name"));
    use_ = new QPushButton(tr("Use in the project"), side);
    use_->setObjectName("useAir");
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(10, 0, 10, 0);
    buttons->addWidget(save_);
    buttons->addWidget(use_);
    buttons->addStretch(1);
    column->addLayout(buttons);
    connect(save_, &QPushButton::clicked, this, &AtmospherePage::save);
    connect(use_, &QPushButton::clicked, this, &AtmospherePage::useInProject);
    return side;
}

QWidget* AtmospherePage::makePicture() {
    auto* picture = new QWidget(this);
    picture->setAutoFillBackground(true);
    picture->setBackgroundRole(QPalette::Base);
    auto* column = new QVBoxLayout(picture);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(6);
    // A bar of its own: fields are seen on the colour of windows alone.
    sight_ = new AtmosphereSight(workbench_, picture);
    sight_->setAutoFillBackground(true);
    sight_->setBackgroundRole(QPalette::Window);
    column->addWidget(sight_);
    problems_ = new QLabel(picture);
    problems_->setContentsMargins(12, 0, 12, 0);
    problems_->setObjectName("airProblems");
    problems_->setWordWrap(true);
    problems_->hide();
    column->addWidget(problems_);
    plots_ = new AtmospherePlots(picture);
    column->addWidget(plots_, 1);
    remarks_ = new QLabel(picture);
    remarks_->setObjectName("airRemarks");
    remarks_->setWordWrap(true);
    remarks_->setContentsMargins(12, 0, 12, 0);
    remarks_->setForegroundRole(QPalette::PlaceholderText);
    remarks_->hide();
    column->addWidget(remarks_);
    return picture;
}

bool AtmospherePage::isBusy() const {
    return task_.isBusy() || sight_->isBusy();
}

void AtmospherePage::ask() {
    remarks_->setText(document_->remarks().join('\n'));
    remarks_->setVisible(!remarks_->text().isEmpty());
    const std::vector<irsg::Diagnostic> wrong = document_->diagnostics();
    if (!wrong.empty()) {
        task_.cancel();
        QStringList sentences;
        for (const irsg::Diagnostic& diagnostic : wrong)
            sentences << sentenceOf(diagnostic);
        plots_->clear();
        return tell(sentences);
    }
    const AtmospherePreviewQuery query{document_->parameters(), document_->file(), sight_->path(),
                                       sight_->sun()};
    task_.run<Answer>(
        [query] {
            Answer answer;
            try {
                answer.column = atmosphereProfile(query);
                answer.spectra = atmosphereSpectra(query);
            } catch (const irsg::InputError& error) {
                answer.problems = sentencesOf(error);
            }
            return answer;
        },
        [this](const Answer& answer) { showAnswer(answer); });
}

void AtmospherePage::showAnswer(const Answer& answer) {
    plots_->showColumn(answer.column);
    if (answer.problems.isEmpty())
        plots_->showSpectra(answer.spectra);
    else
        plots_->clear();
    tell(form_->problem().isEmpty() ? answer.problems : QStringList{form_->problem()});
}

void AtmospherePage::tell(const QStringList& problems) {
    problems_->setStyleSheet(QStringLiteral("color: %1").arg(colors::errorText(palette()).name()));
    problems_->setText(problems.join('\n'));
    problems_->setVisible(!problems.isEmpty());
}

QString AtmospherePage::title() const {
    return document_->displayName() + (document_->isModified() ? " *" : "");
}

bool AtmospherePage::save() {
    if (document_->file().empty() || isOfSample(document_->file()))
        return saveAs();
    if (document_->isModified() && document_->isChangedOnDisk() &&
        dialogs_.ask(this, tr("The file has changed"),
                     tr("Another program has changed this atmosphere since it was read."),
                     {tr("&Replace it with mine")}) != 0)
        return false;
    return saveTo(document_->file());
}

bool AtmospherePage::saveAs() {
    const QString suggestion =
        document_->file().empty() ? "air.xml" : textOf(ownPlaceOf(document_->file()));
    QString file =
        dialogs_.saveFile(this, tr("Save the atmosphere"), {tr("Air (*.xml)")}, suggestion);
    if (file.isEmpty())
        return false;
    return saveTo(file.toStdString());
}

bool AtmospherePage::saveTo(const std::filesystem::path& file) {
    try {
        document_->saveAs(file);
        emit said(tr("Saved %1").arg(textOf(document_->file())));
        rememberFile(document_->file());
        return true;
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This atmosphere cannot be saved"), sentencesOf(error));
        return false;
    }
}

bool AtmospherePage::mayClose() {
    if (!document_->isModified())
        return true;
    const int answer =
        dialogs_.ask(this, tr("Unsaved atmosphere"),
                     tr("%1 has edits that are not saved.").arg(document_->displayName()),
                     {tr("&Save"), tr("&Discard")});
    if (answer == 1)
        recovery_->forget();
    return answer == 1 || (answer == 0 && save());
}

void AtmospherePage::useInProject() {
    if ((document_->isModified() || document_->file().empty()) && !save())
        return;
    const std::string before = workbench_.settings().text(key::environmentAtmospheres);
    Settings changed = workbench_.settings();
    changed.set(key::environmentAtmospheres,
                document_->file().string() +
                    (before == "none" || before.empty() ? "" : ";" + before));
    workbench_.set(changed, tr("Use %1").arg(document_->displayName()));
}

void AtmospherePage::refreshButtons() {
    save_->setEnabled(document_->isModified() || document_->file().empty());
    bool isUsed = false;
    if (workbench_.hasProject() && !document_->file().empty())
        for (const auto& listed : workbench_.settings()[key::environmentAtmospheres])
            isUsed = isUsed || workbench_.project().resolve(listed) == document_->file();
    use_->setEnabled(workbench_.hasProject() && !isUsed);
    use_->setToolTip(!workbench_.hasProject() ? tr("Needs a project")
                     : isUsed
                         ? tr("The project already uses this atmosphere")
                         : tr("Save this atmosphere and put it first among those of the project"));
}

} // namespace smat::gui

#include "moc_AtmospherePage.cpp"
