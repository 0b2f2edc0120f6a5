#include "gui/tools/CostAccuracyPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "gui/analysis/CostAccuracyPanel.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/NumberText.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

CostAccuracyPage::CostAccuracyPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : ToolPage(workbench, std::move(dialogs), tr("Time against error"), parent) {
    setObjectName("frontierPage");
    QWidget* form = makeForm();
    panel_ = new CostAccuracyPanel(dialogs_, this);
    connect(which_, &QComboBox::currentIndexChanged, this, &CostAccuracyPage::refresh);
    connect(repeats_, &QSpinBox::valueChanged, this, &CostAccuracyPage::refresh);
    connect(target_, &QLineEdit::textChanged, this, &CostAccuracyPage::refresh);
    connect(panel_, &CostAccuracyPanel::useAsked, this,
            [this](const Settings& configuration, const QString& step) {
                workbench_.set(workbench_.settings().with(configuration), step);
            });
    layOut(form, 330, tr("Stops and keeps the configurations that are done"), panel_);
}

QWidget* CostAccuracyPage::makeForm() {
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(10, 10, 10, 10);
    auto* box = new QGroupBox(tr("What is measured"), panel);
    auto* form = new QFormLayout(box);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    which_ = new QComboBox(box);
    which_->setObjectName("ways");
    which_->addItem(tr("Candidates"), true);
    which_->addItem(tr("All"), false);
    which_->setToolTip(
        tr("All configurations, or each choice alone and then those that may be on the front, "
           "as these measurements and a cost model predict"));
    repeats_ = new WholeBox("repeats", box);
    repeats_->setRange(1, 1000);
    repeats_->setValue(2);
    repeats_->setToolTip(tr("Each time is the shortest of this many runs"));
    target_ = new QLineEdit(box);
    target_->setObjectName("targetError");
    target_->setText("1");
    target_->setToolTip(
        tr("The quickest configuration whose true error is at most this is chosen, in %"));
    form->addRow(tr("Configurations"), which_);
    form->addRow(tr("Repeats"), repeats_);
    form->addRow(tr("Target error (%)"), target_);
    count_ = new QLabel(box);
    count_->setObjectName("wayCount");
    count_->setWordWrap(true);
    form->addRow(count_);
    column->addWidget(box);
    auto* note = new QLabel(
        tr("The view of the project is calculated in each configuration and "
           "compared with the finest one. Times are by the clock of this machine: do not "
           "use it meanwhile."),
        panel);
    note->setWordWrap(true);
    note->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(note);
    column->addStretch();
    return panel;
}

CostAccuracyStudy::Options CostAccuracyPage::options() const {
    return {static_cast<std::size_t>(repeats_->value()), which_->currentData().toBool()};
}

AnalysisData CostAccuracyPage::asked() const {
    AnalysisData data;
    data.kind = CostAccuracyStudy::kind();
    data.name = name(data.kind);
    data.project = workbench_.project();
    data.settings = workbench_.editedProject().settings;
    data.settings.set(key::renderTargetError, plainNumber(target_->text(), "%").toStdString(),
                      tr("Target error").toStdString());
    data.commandLine =
        data.equivalentCommand("cost-accuracy.csv") + CostAccuracyStudy::optionWords(options());
    return data;
}

QStringList CostAccuracyPage::problems() const {
    try {
        (void)asked();
    } catch (const irsg::InputError& error) {
        return sentencesOf(error);
    }
    return {};
}

QString CostAccuracyPage::command() const {
    return QString::fromStdString(asked().commandLine);
}

void CostAccuracyPage::refreshed(bool isUsable) {
    panel_->setUsable(workbench_.hasProject());
    if (isUsable)
        countConfigurations();
    else
        count_->clear();
}

void CostAccuracyPage::countConfigurations() {
    counting_.run<CostAccuracyStudy::Size>(
        [data = asked(), options = options()] {
            return CostAccuracyStudy::sizeOf(data.project, data.settings, options);
        },
        [this, options = options()](const CostAccuracyStudy::Size& size) {
            const QString least = durationText(size.least_s), most = durationText(size.most_s);
            count_->setText(
                options.likely
                    ? tr("%1 configurations, of which %2 are measured first and then the likely "
                         "ones: about "
                         "%3 to %4, with rendering in software.")
                          .arg(size.all)
                          .arg(size.alone)
                          .arg(least, most)
                    : tr("%1 configurations: about %2, with rendering in software.")
                          .arg(size.all)
                          .arg(most));
        },
        [this](const std::exception_ptr&) { count_->clear(); }); // the run says what is wrong
}

int CostAccuracyPage::start() {
    return workbench_.start(asked(), options(), this);
}

QString CostAccuracyPage::progressText(const Progress& progress) const {
    return tr("%1 of %2 configurations").arg(progress.done).arg(progress.total);
}

QString CostAccuracyPage::cancelText() const {
    return tr("cancelling; the cases done so far are shown in a moment");
}

void CostAccuracyPage::showResult(const JobResult& result) {
    if (!result.data)
        return;
    panel_->setTable(result.data->table);
    setProgress(0, QString());
}

const Exportable& CostAccuracyPage::content() const {
    return *panel_;
}

} // namespace smat::gui

#include "moc_CostAccuracyPage.cpp"
