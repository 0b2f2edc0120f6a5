#include "gui/workbench/PageTabs.h"

#include <QTabBar>

#include "gui/analysis/ResultPage.h"
#include "gui/widgets/Exportable.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/DocumentPage.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

PageTabs::PageTabs(QWidget* parent) : QTabWidget(parent) {
    setObjectName("tabs");
    setTabsClosable(true);
    setMovable(false);
    setDocumentMode(true);
}

PageTabs::~PageTabs() {
    blockSignals(true); // pages that go with it are no news
}

void PageTabs::setFirst(QWidget* page, const QString& title) {
    addTab(page, icon("axes"), title);
    for (const auto side : {QTabBar::LeftSide, QTabBar::RightSide})
        tabBar()->setTabButton(0, side, nullptr);
    connect(this, &QTabWidget::tabCloseRequested, this, &PageTabs::close);
    letShownPageAloneAskForRoom(*this);
    connect(this, &QTabWidget::currentChanged, this, &PageTabs::shownChanged);
}

void PageTabs::addPage(QWidget* page, const QIcon& icon, const QString& title) {
    setCurrentIndex(addTab(page, icon, title));
}

void PageTabs::retitle(QWidget* page, const QString& title) {
    setTabText(indexOf(page), title);
    emit shownChanged();
}

ResultPage* PageTabs::currentResult() const {
    return qobject_cast<ResultPage*>(currentWidget());
}

DocumentPage* PageTabs::shownDocument() const {
    return dynamic_cast<DocumentPage*>(currentWidget());
}

void PageTabs::close(int index) {
    if (index <= 0)
        return;
    auto* document = dynamic_cast<DocumentPage*>(widget(index));
    if (document == nullptr || document->mayClose())
        delete widget(index);
}

bool PageTabs::mayCloseAll() const {
    for (int i = 1; i < count(); ++i) {
        auto* document = dynamic_cast<DocumentPage*>(widget(i));
        if (document != nullptr && !document->mayClose())
            return false;
    }
    return true;
}

bool PageTabs::mayExportShown() const {
    return dynamic_cast<Exportable*>(currentWidget()) != nullptr;
}

void PageTabs::exportShown(const Dialogs& dialogs) {
    const auto* page = dynamic_cast<Exportable*>(currentWidget());
    if (page == nullptr || page->exportFilters().isEmpty()) {
        emit said(tr("This page has nothing to export yet"));
        return;
    }
    const QString file = dialogs.saveFile(window(), tr("Export"), page->exportFilters(), {});
    if (file.isEmpty())
        return;
    try {
        page->exportTo(file.toStdString());
        emit said(tr("Wrote %1").arg(file));
    } catch (const irsg::InputError& error) {
        dialogs.tell(window(), tr("This cannot be written"), sentencesOf(error));
    }
}

} // namespace smat::gui

#include "moc_PageTabs.cpp"
