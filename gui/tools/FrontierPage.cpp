#include "gui/tools/FrontierPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/analysis/FrontierPanel.h"
#include "gui/tools/RunFoot.h"
#include "gui/widgets/Readable.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/UnsavedNote.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

FrontierPage::FrontierPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), workbench_(workbench), dialogs_(std::move(dialogs)) {
    setObjectName("frontierPage");
    auto* columns = new QSplitter(Qt::Horizontal, this);
    columns->addWidget(makeForm());
    panel_ = new FrontierPanel(dialogs_, columns);
    columns->addWidget(panel_);
    columns->setStretchFactor(1, 1);
    columns->setSizes({330, 930});
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(columns);

    connect(run_, &QPushButton::clicked, this, &FrontierPage::run);
    connect(cancel_, &QPushButton::clicked, this, &FrontierPage::cancel);
    connect(which_, &QComboBox::currentIndexChanged, this, &FrontierPage::refresh);
    connect(repeats_, &QSpinBox::valueChanged, this, &FrontierPage::refresh);
    connect(target_, &QLineEdit::textChanged, this, &FrontierPage::refresh);
    connect(panel_, &FrontierPanel::useAsked, this,
            [this](const Settings& way, const QString& step) {
                workbench_.set(workbench_.settings().with(way), step);
            });
    for (const auto signal :
         {&Workbench::projectOpened, &Workbench::projectChanged, &Workbench::settingsChanged})
        connect(&workbench_, signal, this, &FrontierPage::refresh);
    connectJobs();
    refresh();
}

QWidget* FrontierPage::makeForm() {
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(10, 10, 10, 10);
    auto* box = new QGroupBox(tr("What is measured"), panel);
    auto* form = new QFormLayout(box);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    which_ = new QComboBox(box);
    which_->setObjectName("ways");
    which_->addItem(tr("Likely ones"), true);
    which_->addItem(tr("All"), false);
    which_->setToolTip(tr("All ways, or each choice alone and then those that may be on the front "
                          "by what these showed and a model of costs"));
    repeats_ = new QSpinBox(box);
    repeats_->setObjectName("repeats");
    repeats_->setRange(1, 1000);
    repeats_->setValue(2);
    repeats_->setToolTip(tr("Each time is the least of so many cases"));
    target_ = new QLineEdit(box);
    target_->setObjectName("targetError");
    target_->setText("1");
    target_->setToolTip(tr("The quickest way whose true error is at most this is chosen, in %"));
    form->addRow(tr("Ways"), which_);
    form->addRow(tr("Cases of a time"), repeats_);
    form->addRow(tr("Target error (%)"), target_);
    count_ = new QLabel(box);
    count_->setObjectName("wayCount");
    count_->setWordWrap(true);
    form->addRow(count_);
    column->addWidget(box);
    auto* note = new QLabel(tr("The view of the project is calculated in each way and held against "
                               "the finest one. Times are by the clock of this machine: let it "
                               "rest beside."),
                            panel);
    note->setWordWrap(true);
    note->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(note);
    column->addStretch();

    auto* foot = new RunFoot(tr("Stops and keeps the ways there are"), this);
    foot->progress->setFormat(QString());
    problem_ = foot->problem;
    run_ = foot->run;
    cancel_ = foot->cancel;
    progress_ = foot->progress;
    command_ = foot->command;
    unsaved_ = foot->unsaved;
    return RunFoot::below(panel, foot, this);
}

Frontier::Options FrontierPage::options() const {
    return {static_cast<std::size_t>(repeats_->value()), which_->currentData().toBool()};
}

AnalysisData FrontierPage::asked() const {
    AnalysisData data;
    data.kind = Frontier::kind();
    data.name = name(data.kind);
    data.project = workbench_.project();
    data.settings = workbench_.editedProject().settings;
    data.settings.set(key::renderTargetError, target_->text().trimmed().toStdString(),
                      tr("Target error").toStdString());
    data.commandLine =
        data.equivalentCommand("cost-accuracy.csv") + Frontier::optionWords(options());
    return data;
}

void FrontierPage::refresh() {
    const bool hasProject = workbench_.hasProject();
    QStringList problems;
    command_->clear();
    if (!hasProject) {
        problems << tr("Open a project first.");
    } else {
        try {
            command_->setText(QString::fromStdString(asked().commandLine));
            command_->setCursorPosition(0);
            command_->setToolTip(command_->text());
        } catch (const irsg::InputError& error) {
            problems << sentencesOf(error);
        }
    }
    const QString note = hasProject ? unsavedNote(workbench_) : QString();
    unsaved_->setText(note);
    unsaved_->setVisible(!note.isEmpty());
    problem_->setText(problems.join('\n'));
    problem_->setVisible(!problems.isEmpty());
    run_->setEnabled(problems.isEmpty() && !isRunning());
    cancel_->setEnabled(isRunning() && !cancelled_);
    panel_->setUsable(hasProject);
    if (problems.isEmpty())
        countWays();
    else
        count_->clear();
}

void FrontierPage::countWays() {
    counting_.run<Frontier::Size>(
        [data = asked(), options = options()] {
            return Frontier::sizeOf(data.project, data.settings, options);
        },
        [this, options = options()](const Frontier::Size& size) {
            const QString least = durationText(size.least_s), most = durationText(size.most_s);
            count_->setText(
                options.likely
                    ? tr("%1 ways, of which %2 are measured first and then the likely ones: about "
                         "%3 to %4, where drawing is done in software.")
                          .arg(size.all)
                          .arg(size.alone)
                          .arg(least, most)
                    : tr("%1 ways: about %2, where drawing is done in software.")
                          .arg(size.all)
                          .arg(most));
        },
        [this](const std::exception_ptr&) { count_->clear(); }); // the run says what is wrong
}

void FrontierPage::run() {
    if (isRunning())
        return;
    try {
        const AnalysisData data = asked();
        cancelled_ = false;
        progress_->setValue(0);
        progress_->setFormat(workbench_.isRunning() ? tr("waiting in line") : tr("starting"));
        number_ = workbench_.start(data, options(), this);
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("Time against error"), sentencesOf(error));
    }
    refresh();
}

bool FrontierPage::isRunning() const {
    return number_ != 0 && workbench_.jobs().holds(number_);
}

void FrontierPage::cancel() {
    if (!isRunning())
        return;
    cancelled_ = true;
    cancel_->setEnabled(false);
    workbench_.jobs().cancel(number_);
}

void FrontierPage::connectJobs() {
    const JobQueue& jobs = workbench_.jobs();
    const auto rest = [this] {
        progress_->setValue(0);
        progress_->setFormat(cancelled_ ? tr("cancelled; the ways so far follow in a moment")
                                        : QString());
        refresh();
        emit ended();
    };
    connect(&jobs, &JobQueue::progressed, this, [this](int number, const Progress& progress) {
        if (number != number_ || cancelled_)
            return;
        progress_->setValue(static_cast<int>(1000.0 * progress.fraction()));
        progress_->setFormat(tr("%1 of %2 ways").arg(progress.done).arg(progress.total));
    });
    connect(&jobs, &JobQueue::finished, this, [this](int number, const JobResult& result) {
        if (number != number_ || !result.data)
            return;
        panel_->setTable(result.data->table);
        progress_->setFormat(QString());
    });
    connect(&jobs, &JobQueue::ended, this, [this, rest](int number) {
        if (number == number_)
            rest();
    });
    connect(&jobs, &JobQueue::waitingChanged, this, [this] { refresh(); });
}

QStringList FrontierPage::exportFilters() const {
    return panel_->exportFilters();
}

void FrontierPage::exportTo(const std::filesystem::path& file) const {
    panel_->exportTo(file);
}

} // namespace smat::gui

#include "moc_FrontierPage.cpp"
