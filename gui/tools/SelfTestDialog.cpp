#include "gui/tools/SelfTestDialog.h"

#include <mutex>
#include <stop_token>
#include <vector>

#include <QCheckBox>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/widgets/BackgroundPool.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/Theme.h"
#include "smatcore/selftest/SelfTest.h"

namespace smat::gui {

/// What the thread of the checks and the window share.
struct SelfTestDialog::Run {
    std::stop_source stop;
    std::mutex mutex;
    std::vector<SelfTestResult> results; ///< guarded
    bool ended = false;                  ///< guarded
    std::size_t shown = 0;               ///< of the window
};

namespace {

enum CheckColumn { checkColumn, valueColumn, expectedColumn, errorColumn, boundColumn, timeColumn };

QString number(double value) {
    return QString::number(value, 'g', 8);
}
QString shortNumber(double value) {
    return QString::number(value, 'e', 1);
}

QTreeWidgetItem* rowOf(const SelfTestResult& result) {
    const SelfTestCheck& check = *result.check;
    const QString unit = QString::fromStdString(check.unit);
    const auto withUnit = [&](double value) {
        return unit.isEmpty() ? number(value) : number(value) + " " + unit;
    };
    auto* item = new QTreeWidgetItem;
    item->setText(checkColumn, QString::fromStdString(check.name));
    const bool passed = result.outcome == SelfTestResult::Outcome::passed;
    const bool failed = result.outcome == SelfTestResult::Outcome::failed;
    item->setIcon(checkColumn, icon(passed ? "check-physics" : failed ? "error" : "info"));
    if (result.remark.empty()) {
        item->setText(valueColumn, withUnit(result.found.value));
        item->setText(expectedColumn, withUnit(result.found.expected));
        item->setText(errorColumn, shortNumber(result.error));
        item->setText(boundColumn, shortNumber(check.bound));
    } else {
        item->setText(valueColumn, QString::fromStdString(result.remark));
    }
    item->setText(timeColumn, QStringLiteral("%1 s").arg(result.time_s, 0, 'f', 3));
    for (const CheckColumn column : {errorColumn, boundColumn, timeColumn})
        item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    const QString says = QString::fromStdString(check.says);
    for (int column = 0; column <= timeColumn; ++column)
        item->setToolTip(column, says);
    return item;
}

} // namespace

SelfTestDialog::SelfTestDialog(QWidget* parent) : QDialog(parent) {
    setObjectName("selfTestDialog");
    setWindowTitle(tr("Self-test"));
    resize(900, 560);
    auto* column = new QVBoxLayout(this);
    auto* says = new QLabel(tr("Compares the results of this machine with closed forms, published "
                               "numbers and other methods."),
                            this);
    says->setWordWrap(true);
    column->addWidget(says);
    auto* row = new QHBoxLayout;
    start_ = new QPushButton(this);
    start_->setObjectName("selfTestStart");
    hard_ = new QCheckBox(tr("Hard cases as well"), this);
    hard_->setObjectName("selfTestHard");
    hard_->setChecked(true);
    counts_ = new QLabel(this);
    counts_->setObjectName("selfTestCounts");
    copy_ = new QPushButton(tr("Copy the table"), this);
    copy_->setObjectName("selfTestCopy");
    row->addWidget(start_);
    row->addWidget(hard_);
    row->addWidget(counts_, 1);
    row->addWidget(copy_);
    column->addLayout(row);
    table_ = new QTreeWidget(this);
    table_->setObjectName("selfTestTable");
    table_->setRootIsDecorated(false);
    table_->setUniformRowHeights(true);
    table_->setAlternatingRowColors(true);
    table_->setHeaderLabels(
        {tr("Check"), tr("Value"), tr("Expected"), tr("Error"), tr("Bound"), tr("Time")});
    table_->header()->setSectionResizeMode(QHeaderView::Interactive);
    for (const auto& [section, width_px] : {std::pair<int, int>{checkColumn, 250},
                                            {valueColumn, 200},
                                            {expectedColumn, 200},
                                            {errorColumn, 70},
                                            {boundColumn, 70},
                                            {timeColumn, 70}})
        table_->setColumnWidth(section, width_px);
    column->addWidget(table_, 1);
    column->addWidget(closeAlone(*this));

    connect(start_, &QPushButton::clicked, this, [this] { isRunning() ? stop() : start(); });
    connect(copy_, &QPushButton::clicked, this, &SelfTestDialog::copy);
    timer_.setInterval(50);
    connect(&timer_, &QTimer::timeout, this, &SelfTestDialog::follow);
    follow();
}

SelfTestDialog::~SelfTestDialog() {
    stop();
}

bool SelfTestDialog::isRunning() const {
    return timer_.isActive();
}

void SelfTestDialog::start() {
    table_->clear();
    run_ = std::make_shared<Run>();
    backgroundPool().start(
        [run = run_, options = SelfTestOptions{.hard = hard_->isChecked(), .only = {}}] {
            runSelfTest(
                options,
                [&](const SelfTestResult& result) {
                    const std::scoped_lock lock(run->mutex);
                    run->results.push_back(result);
                },
                run->stop.get_token());
            const std::scoped_lock lock(run->mutex);
            run->ended = true;
        });
    timer_.start();
    follow();
}

void SelfTestDialog::stop() {
    if (run_)
        run_->stop.request_stop();
}

void SelfTestDialog::follow() {
    if (run_) {
        const std::scoped_lock lock(run_->mutex);
        for (; run_->shown < run_->results.size(); ++run_->shown) {
            auto* item = rowOf(run_->results[run_->shown]);
            table_->addTopLevelItem(item);
            table_->scrollToItem(item);
        }
        if (run_->ended)
            timer_.stop();
        counts_->setText(QString::fromStdString(selfTestCounts(run_->results)).trimmed());
    }
    start_->setText(isRunning() ? tr("Stop") : tr("Start"));
    hard_->setEnabled(!isRunning());
    copy_->setEnabled(!isRunning() && table_->topLevelItemCount() > 0);
}

void SelfTestDialog::copy() const {
    const std::scoped_lock lock(run_->mutex);
    std::string text = selfTestHead();
    for (const SelfTestResult& result : run_->results)
        text += selfTestLine(result);
    QGuiApplication::clipboard()->setText(
        QString::fromStdString(text + selfTestCounts(run_->results)));
}

} // namespace smat::gui

#include "moc_SelfTestDialog.cpp"
