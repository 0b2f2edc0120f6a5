#include "gui/tools/AtmosphereToolPage.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/analysis/ResultPage.h"
#include "gui/analysis/ResultStore.h"
#include "gui/widgets/FoldingSplitter.h"
#include "gui/widgets/VerticalScrollArea.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

AtmosphereToolPage::AtmosphereToolPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), workbench_(workbench), dialogs_(std::move(dialogs)) {
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    auto* side = new QWidget;
    side->setAutoFillBackground(true);
    side->setBackgroundRole(QPalette::Window);
    inputs_ = new QVBoxLayout;
    inputs_->setSpacing(8);
    problems_ = new QLabel(side);
    problems_->setObjectName("problems");
    problems_->setWordWrap(true);
    problems_->hide();
    figures_ = new QLabel(side);
    figures_->setObjectName("figures");
    figures_->setWordWrap(true);
    figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    figures_->hide();
    compute_ = new QPushButton(tr("Compute"), side);
    compute_->setObjectName("compute");
    compute_->setDefault(true);
    cancel_ = new QPushButton(tr("Cancel"), side);
    cancel_->setObjectName("cancel");
    busy_ = new QProgressBar(side);
    busy_->setObjectName("busy");
    busy_->setRange(0, 0);
    busy_->setTextVisible(false);
    busy_->hide();
    elapsed_ = new QLabel(side);
    elapsed_->setObjectName("elapsed");
    elapsed_->setForegroundRole(QPalette::PlaceholderText);
    elapsed_->hide();
    command_ = new QLineEdit(side);
    command_->setObjectName("commandLine");
    command_->setReadOnly(true);
    command_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* copy = new QToolButton(side);
    copy->setObjectName("copyCommand");
    copy->setText(tr("Copy"));
    connect(copy, &QToolButton::clicked, this,
            [this] { QApplication::clipboard()->setText(command_->text()); });
    auto* same = new QLabel(tr("Equivalent command"), side);
    same->setForegroundRole(QPalette::PlaceholderText);

    auto* run = new QHBoxLayout;
    run->addWidget(compute_, 1);
    run->addWidget(cancel_);
    buttons_ = new QVBoxLayout;
    buttons_->setSpacing(6);
    auto* terminal = new QHBoxLayout;
    terminal->addWidget(command_, 1);
    terminal->addWidget(copy);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(14, 12, 14, 12);
    column->setSpacing(10);
    column->addLayout(inputs_);
    column->addWidget(problems_);
    column->addLayout(run);
    column->addWidget(busy_);
    column->addWidget(elapsed_);
    column->addWidget(figures_);
    column->addStretch(1);
    column->addLayout(buttons_);
    column->addWidget(same);
    column->addLayout(terminal);

    auto* scroll = new VerticalScrollArea(side, this);
    auto* right = new QWidget(this);
    answer_ = new QVBoxLayout(right);
    answer_->setContentsMargins(0, 0, 0, 0);
    empty_ = new QLabel(tr("Press Compute to see the result here."), right);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    answer_->addWidget(empty_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(new FoldingSplitter(scroll, scroll->minimumSizeHint().width(), right, this));

    connect(compute_, &QPushButton::clicked, this, &AtmosphereToolPage::compute);
    connect(cancel_, &QPushButton::clicked, &calculation_, &Calculation::cancel);
    connect(&calculation_, &Calculation::started, this, &AtmosphereToolPage::refreshButtons);
    connect(&calculation_, &Calculation::ended, this, &AtmosphereToolPage::refreshButtons);
    connect(&calculation_, &Calculation::refused, this, [this](const QStringList& sentences) {
        dialogs_.tell(this, refusalTitle(), sentences);
    });
    tick_.setInterval(100);
    connect(&tick_, &QTimer::timeout, this, &AtmosphereToolPage::tellElapsed);
    auto* keepButton = addButton("keepResult", tr("Keep among the results"),
                                 tr("For overlays and differences, and to be saved later"));
    connect(keepButton, &QPushButton::clicked, this, &AtmosphereToolPage::keep);
    refreshButtons();
}

AtmosphereToolPage::~AtmosphereToolPage() = default;

QPushButton* AtmosphereToolPage::addButton(const QString& name, const QString& text,
                                           const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    buttons_->addWidget(button);
    needAnswer_.push_back(button);
    button->setEnabled(!table_.empty());
    return button;
}

QString AtmosphereToolPage::atmosphereWords() const {
    QStringList names;
    for (const auto& file : workbench_.settings()[key::environmentAtmospheres])
        names << QString::fromStdString(file.filename().string());
    return names.isEmpty() ? tr("none: the project has no atmosphere") : names.join(", ");
}

void AtmosphereToolPage::setProblems(const QStringList& problems) {
    inputsRight_ = problems.isEmpty();
    problems_->setText(problems.join('\n'));
    problems_->setVisible(!problems.isEmpty());
    refreshButtons();
}

void AtmosphereToolPage::setCommand(const QString& command) {
    command_->setText(command);
    command_->setToolTip(command);
    command_->setCursorPosition(0);
}

void AtmosphereToolPage::compute() {
    if (inputsRight_)
        calculation_.start(work());
}

void AtmosphereToolPage::refreshButtons() {
    const bool running = calculation_.isRunning();
    compute_->setEnabled(inputsRight_ && !running);
    cancel_->setEnabled(running);
    busy_->setVisible(running);
    if (running)
        tick_.start();
    else
        tick_.stop();
    tellElapsed();
    for (auto* button : needAnswer_)
        button->setEnabled(!running && !table_.empty());
}

void AtmosphereToolPage::tellElapsed() {
    // What is there within a moment needs no clock.
    const double elapsed_s = calculation_.elapsed_s();
    elapsed_->setVisible(calculation_.isRunning() && elapsed_s >= 1.0);
    elapsed_->setText(tr("%1 elapsed").arg(durationText(elapsed_s)));
}

void AtmosphereToolPage::showTable(const ResultTable& table, const QString& title,
                                   const QString& figures) {
    AnalysisData data;
    data.kind = resultKindOf(table.provenance);
    data.table = table;
    ResultEntry entry;
    entry.title = title;
    entry.origin = ResultEntry::Origin::tool;
    entry.data = std::make_shared<const AnalysisData>(std::move(data));
    showTableOn(*new ResultPage({entry}, dialogs_), table, title, figures);
}

void AtmosphereToolPage::take(QWidget& answer, const Exportable& content, const ResultTable& table,
                              const QString& title, const QString& figures) {
    table_ = table;
    title_ = title;
    figures_->setText(figures);
    figures_->setVisible(!figures.isEmpty());
    if (shown_ != &answer)
        delete shown_;
    shown_ = &answer;
    content_ = &content;
    empty_->hide();
    answer_->addWidget(shown_);
    shown_->show();
    refreshButtons();
}

void AtmosphereToolPage::keep() {
    if (!table_.empty())
        workbench_.resultStore().addTable(title_, table_);
}

QStringList AtmosphereToolPage::exportFilters() const {
    if (content_ == nullptr)
        return {};
    return {tr("Values as text (*.csv)"), tr("All inputs and values (*.json)"),
            tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)")};
}

void AtmosphereToolPage::exportTo(const std::filesystem::path& file) const {
    const std::string suffix = file.extension().string();
    if (suffix == ".csv" || suffix == ".json")
        table_.save(file);
    else
        content_->exportTo(file);
}

} // namespace smat::gui

#include "moc_AtmosphereToolPage.cpp"
