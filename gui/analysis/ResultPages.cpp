#include "gui/analysis/ResultPages.h"

#include <utility>

#include <QTabWidget>

#include "gui/analysis/CostAccuracyPanel.h"
#include "gui/analysis/FloatingPages.h"
#include "gui/analysis/ResultPage.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"

namespace smat::gui {

ResultPages::ResultPages(Workbench& workbench, Dialogs dialogs, QTabWidget* tabs)
    : QObject(tabs),
      workbench_(workbench),
      dialogs_(std::move(dialogs)),
      tabs_(tabs),
      floating_(new FloatingPages(tabs)) {
    const ResultStore& store = workbench_.resultStore();
    connect(&store, &ResultStore::added, this, [this](int id) { show({id}); });
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
        tabs_->setCurrentIndex(tabs_->addTab(page, icon(entries.front().kind()->icon), title));
    } catch (const irsg::InputError& error) {
        dialogs_.tell(tabs_, tr("These results cannot be shown"), sentencesOf(error));
    }
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
