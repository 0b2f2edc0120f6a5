#include "gui/database/FindingsPanel.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/database/FindingsScope.h"
#include "gui/widgets/Theme.h"

namespace smat::gui {
namespace {

constexpr int lookDelay_ms = 150;
constexpr int remedyRole = Qt::UserRole + 1;

} // namespace

FindingsPanel::FindingsPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent), context_(context), scope_(new FindingsScope(context, this)) {
    setObjectName("findingsPanel");
    summary_ = new QLabel(this);
    summary_->setObjectName("findingsSummary");
    list_ = new QTreeWidget(this);
    list_->setObjectName("findings");
    list_->setColumnCount(4);
    list_->setHeaderLabels({tr("Place"), tr("Value"), tr("Reason"), tr("Repair")});
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setWordWrap(true);
    list_->header()->setSectionResizeMode(2, QHeaderView::Stretch);
    list_->header()->setStretchLastSection(false);
    list_->setToolTip(tr("Double click: go to the place"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(6);
    column->addWidget(summary_);
    // Above the list: seen in a dock that is too low for both, too.
    detail_ = new QLabel(this);
    detail_->setObjectName("findingDetail");
    detail_->setWordWrap(true);
    detail_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    detail_->setMinimumHeight(4 * fontMetrics().height());
    detail_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    column->addWidget(detail_);
    column->addWidget(list_, 1);

    timer_ = new QTimer(this);
    timer_->setSingleShot(true);
    timer_->setInterval(lookDelay_ms);
    connect(timer_, &QTimer::timeout, this, &FindingsPanel::look);
    const auto soon = [this] { timer_->start(); };
    connect(&context_.session(), &DatabaseSession::changed, this, soon);
    connect(&context_.session(), &DatabaseSession::opened, this, &FindingsPanel::look);
    connect(&context_, &EditorContext::surroundingsChanged, this, soon);
    connect(scope_, &FindingsScope::changed, this, &FindingsPanel::look);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        detail_->setText(item == nullptr ? QString()
                                         : QStringLiteral("%1: %2\n%3\n%4")
                                               .arg(item->text(0), item->text(1), item->text(2),
                                                    item->data(0, remedyRole).toString()));
    });
    connect(list_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        emit placeRequested(item->data(0, Qt::UserRole).toString());
    });
    look();
}

void FindingsPanel::look() {
    timer_->stop();
    list_->clear();
    errors_ = warnings_ = 0;
    if (!context_.session().isOpen()) {
        summary_->setText({});
        emit countsChanged();
        return;
    }
    for (const auto& finding : scope_->findings()) {
        const bool error = finding.isError();
        ++(error ? errors_ : warnings_);
        auto* item = new QTreeWidgetItem({QString::fromStdString(finding.place),
                                          QString::fromStdString(finding.value),
                                          QString::fromStdString(finding.reason)});
        item->setIcon(0, icon(error ? "error" : "warning"));
        item->setData(0, Qt::UserRole, QString::fromStdString(finding.entry));
        item->setData(0, remedyRole, QString::fromStdString(finding.remedy));
        for (int i = 0; i < 3; ++i)
            item->setToolTip(i, item->text(i));
        list_->addTopLevelItem(item);
        const QString remedy = QString::fromStdString(finding.remedy);
        if (!finding.repair) {
            item->setText(3, remedy);
            item->setToolTip(3, remedy);
            continue;
        }
        auto* button = new QPushButton(finding.removes ? tr("Delete") : tr("Repair"), list_);
        button->setToolTip(remedy);
        button->setObjectName("repair");
        connect(button, &QPushButton::clicked, this, [this, repair = finding.repair, remedy, item] {
            const QString place = item->text(0);
            context_.session().edit(tr("Repair %1: %2").arg(place, remedy), repair);
            look();
        });
        list_->setItemWidget(item, 3, button);
    }
    for (const int i : {0, 1, 3})
        list_->resizeColumnToContents(i);
    list_->setColumnWidth(0, std::min(list_->columnWidth(0), 220));
    list_->setColumnWidth(1, std::min(list_->columnWidth(1), 160));
    list_->setColumnWidth(3, std::clamp(list_->columnWidth(3), 80, 150));
    summary_->setText(errors_ + warnings_ == 0
                          ? tr("No findings in the band %1 to %2 µm.")
                                .arg(context_.band().min_um)
                                .arg(context_.band().max_um)
                          : tr("%1 and %2. A database with errors cannot be saved.")
                                .arg(counted(errors_, tr("error"), tr("errors")),
                                     counted(warnings_, tr("warning"), tr("warnings"))));
    if (list_->topLevelItemCount() > 0)
        list_->setCurrentItem(list_->topLevelItem(0));
    emit countsChanged();
}

} // namespace smat::gui

#include "moc_FindingsPanel.cpp"
