#include "gui/analysis/ResultPages.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QEvent>
#include <QPainter>

#include "gui/analysis/CostAccuracyPanel.h"
#include "gui/analysis/FloatingPages.h"
#include "gui/analysis/ResultPage.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/PageTabs.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat::gui {
namespace {

/// Property of a page that was not looked at yet: the icon of its tab.
constexpr const char* unseen = "unseen";

QIcon dotted(const QIcon& plain, const QSize& size, double pixelRatio) {
    QPixmap picture = plain.pixmap(size, pixelRatio);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QApplication::palette().color(QPalette::Highlight));
    const double across = 0.45 * size.width();
    painter.drawEllipse(QRectF(size.width() - across, 0.0, across, across));
    return picture;
}

} // namespace

ResultPages::ResultPages(Workbench& workbench, Dialogs dialogs, PageTabs* tabs)
    : QObject(tabs),
      workbench_(workbench),
      dialogs_(std::move(dialogs)),
      tabs_(tabs),
      floating_(new FloatingPages(tabs)) {
    const ResultStore& store = workbench_.resultStore();
    connect(&store, &ResultStore::added, this, [this](int id) { show({id}); });
    connect(&workbench_, &Workbench::jobStarted, this, [this] {
        isRunning_ = true;
        isAtWork_ = false;
    });
    // The result comes right behind the end of its run.
    connect(
        &workbench_, &Workbench::jobEnded, this, [this] { isRunning_ = workbench_.isRunning(); },
        Qt::QueuedConnection);
    qApp->installEventFilter(this);
    connect(tabs_, &QTabWidget::currentChanged, this, &ResultPages::clearDot);
    connect(&store, &ResultStore::renamed, this, &ResultPages::onRenamed);
    connect(&store, &ResultStore::removed, this, &ResultPages::onRemoved);
    connect(tabs_, &QTabWidget::currentChanged, this, &ResultPages::sayOfShown);
}

std::vector<ResultPage*> ResultPages::pages() const {
    std::vector<ResultPage*> list;
    for (QWidget* page : floating_->pages())
        if (auto* result = qobject_cast<ResultPage*>(page))
            list.push_back(result);
    return list;
}

void ResultPages::show(const QList<int>& ids) {
    for (ResultPage* page : pages()) {
        if (page->resultIds() == ids) {
            floating_->show(page);
            return;
        }
    }
    std::vector<ResultEntry> entries;
    for (const int id : ids)
        if (const auto* entry = workbench_.result(id))
            entries.push_back(*entry);
    if (entries.empty())
        return;
    try {
        auto* page = new ResultPage(entries, dialogs_);
        page->setModels(workbench_.models());
        if (CostAccuracyPanel* costAccuracy = page->costAccuracy()) {
            const auto follow = [this, costAccuracy] {
                costAccuracy->setUsable(workbench_.hasProject());
            };
            follow();
            connect(&workbench_, &Workbench::projectOpened, costAccuracy, follow);
            connect(costAccuracy, &CostAccuracyPanel::useAsked, this,
                    [this](const Settings& way, const QString& step) {
                        workbench_.set(workbench_.settings().with(way), step);
                    });
        }
        const QString title =
            entries.size() > 1 ? tr("Overlay of %1").arg(entries.size()) : entries.front().title;
        const QIcon mark = icon(entries.front().kind()->icon);
        if (!(isRunning_ && isAtWork_)) {
            tabs_->setCurrentIndex(tabs_->addTab(page, mark, title));
            return;
        }
        page->setProperty(unseen, mark);
        tabs_->addTab(page, dotted(mark, tabs_->iconSize(), tabs_->devicePixelRatioF()), title);
        const bool isPartial = std::ranges::any_of(entries, [](const ResultEntry& entry) {
            return entry.data->state == AnalysisState::partial;
        });
        emit said((isPartial ? tr("%1 is partial: a dot marks its tab")
                             : tr("%1 is ready: a dot marks its tab"))
                      .arg(title));
    } catch (const irsg::InputError& error) {
        dialogs_.tell(tabs_, tr("These results cannot be shown"), sentencesOf(error));
    }
}

bool ResultPages::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::KeyPress ||
        event->type() == QEvent::Wheel)
        isAtWork_ = true;
    return false;
}

void ResultPages::clearDot() {
    QWidget* page = tabs_->currentWidget();
    if (page == nullptr || !page->property(unseen).isValid())
        return;
    tabs_->setTabIcon(tabs_->currentIndex(), page->property(unseen).value<QIcon>());
    page->setProperty(unseen, QVariant());
}

void ResultPages::sayOfShown() {
    const auto* page = qobject_cast<ResultPage*>(tabs_->currentWidget());
    const auto* entry = page != nullptr ? workbench_.result(page->resultIds().last()) : nullptr;
    const QString before = std::exchange(said_, {});
    if (entry == nullptr) {
        if (!before.isEmpty())
            emit passed(before);
        return;
    }
    QStringList notes;
    for (const auto& warning : entry->data->warnings)
        notes << QString::fromStdString(warning);
    if (notes.isEmpty())
        notes << (entry->canRunAgain() ? tr("Done in %1").arg(durationText(entry->data->elapsed_s))
                                       : entry->title + ": " + stateOf(*entry));
    said_ = notes.join("   ");
    emit said(said_);
}

void ResultPages::onRenamed(int id) {
    const ResultEntry* entry = workbench_.result(id);
    for (ResultPage* page : pages()) {
        if (!page->resultIds().contains(id))
            continue;
        page->rename(id, entry->title);
        if (page->resultIds().size() == 1)
            floating_->setTitle(page, entry->title);
    }
}

void ResultPages::onRemoved(int id) {
    for (ResultPage* page : pages())
        if (page->resultIds().contains(id))
            delete page;
}

} // namespace smat::gui

#include "moc_ResultPages.cpp"
