#include "gui/analysis/ResultDetailsDialog.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/analysis/ResultStore.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/NumberFormat.h"

namespace smat::gui {
namespace {

/// "Time: load" and "0.0123 s, 4.5 %" for each stage that took any, the sum last.
QList<QStringList> stageRows(const std::vector<StageTimer::Stage>& stages) {
    double sum_s = 0.0;
    for (const auto& stage : stages)
        sum_s += stage.seconds;
    QList<QStringList> rows;
    for (const auto& stage : stages)
        if (stage.seconds > 0.0)
            rows.push_back({ResultDetailsDialog::tr("Time: %1").arg(stage.name.c_str()),
                            ResultDetailsDialog::tr("%1 s, %2 %")
                                .arg(stage.seconds, 0, 'f', 4)
                                .arg(100.0 * stage.seconds / sum_s, 0, 'f', 1)});
    if (sum_s > 0.0)
        rows.push_back({ResultDetailsDialog::tr("Time: sum"),
                        ResultDetailsDialog::tr("%1 s").arg(sum_s, 0, 'f', 4)});
    return rows;
}

} // namespace

ResultDetailsDialog::ResultDetailsDialog(const ResultEntry& entry, QWidget* parent)
    : QDialog(parent) {
    setObjectName("resultDetailsDialog");
    setWindowTitle(tr("How this result was made – %1").arg(entry.title));
    resize(680, 560);

    const QString command = QString::fromStdString(entry.data->commandLine);
    auto* text = new QPlainTextEdit(this);
    text->setObjectName("commandLine");
    text->setReadOnly(true);
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text->setMaximumHeight(84);
    text->setPlainText(command.isEmpty() ? tr("No command line is known for this result.")
                                         : command);
    auto* copy = new QPushButton(tr("Copy"), this);
    copy->setObjectName("copyCommand");
    copy->setEnabled(!command.isEmpty());
    connect(copy, &QPushButton::clicked, this,
            [command] { QApplication::clipboard()->setText(command); });
    auto* head = new QLabel(tr("Command line"), this);
    head->setForegroundRole(QPalette::PlaceholderText);
    auto* row = new QHBoxLayout;
    row->addWidget(text, 1);
    row->addWidget(copy, 0, Qt::AlignTop);

    auto* list = new QTreeWidget(this);
    list->setObjectName("provenance");
    list->setColumnCount(2);
    list->setHeaderLabels({tr("What"), tr("Value")});
    list->setRootIsDecorated(false);
    list->setAlternatingRowColors(true);
    list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    for (const QString& line : describe(entry).mid(1)) {
        const qsizetype colon = line.indexOf(": ");
        const QString what = line.left(colon), value = line.mid(colon + 2);
        auto* item =
            colon > 0 ? new QTreeWidgetItem({withFormattedUnits(what),
                                             what == "command" ? value : withFormattedUnits(value)})
                      : new QTreeWidgetItem({tr("Made"), line});
        item->setToolTip(1, item->text(1));
        list->addTopLevelItem(item);
    }
    for (const QStringList& row : stageRows(entry.data->stages))
        list->addTopLevelItem(new QTreeWidgetItem(row));
    auto* buttons = closeAlone(*this);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 14, 16, 14);
    column->setSpacing(8);
    column->addWidget(head);
    column->addLayout(row);
    column->addSpacing(4);
    column->addWidget(list, 1);
    column->addWidget(buttons);
}

} // namespace smat::gui

#include "moc_ResultDetailsDialog.cpp"
