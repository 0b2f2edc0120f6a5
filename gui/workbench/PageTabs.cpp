#include "gui/workbench/PageTabs.h"

#include <utility>

#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QTabBar>

#include "gui/analysis/ResultPage.h"
#include "gui/widgets/Exportable.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/DocumentPage.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

/// The second row: there while it has pages.
class PageTabs::Row : public QTabWidget {
  public:
    explicit Row(QWidget* parent) : QTabWidget(parent) {
        setObjectName("tabsBeside");
        setTabsClosable(true);
        setDocumentMode(true);
        hide();
    }
    ~Row() override { blockSignals(true); }

    bool isInFront = false; ///< what was used last is a page of it

  protected:
    void tabInserted(int) override { setVisible(true); }
    void tabRemoved(int) override { setVisible(count() > 0); }
};

PageTabs::PageTabs(QWidget* parent) : QTabWidget(parent), beside_(new Row(parent)) {
    setObjectName("tabs");
    setTabsClosable(true);
    setMovable(false);
    setDocumentMode(true);
}

PageTabs::~PageTabs() {
    blockSignals(true); // pages that go with it are no news
    if (qApp != nullptr)
        disconnect(qApp, nullptr, this, nullptr);
}

void PageTabs::setFirst(QWidget* page, const QString& title) {
    addTab(page, icon("axes"), title);
    for (const auto side : {QTabBar::LeftSide, QTabBar::RightSide})
        tabBar()->setTabButton(0, side, nullptr);
    connect(this, &QTabWidget::tabCloseRequested, this,
            [this](int index) { close(widget(index)); });
    connect(beside_, &QTabWidget::tabCloseRequested, this,
            [this](int index) { close(beside_->widget(index)); });
    for (QTabWidget* row : {static_cast<QTabWidget*>(this), beside_}) {
        letShownPageAloneAskForRoom(*row);
        const auto use = [this, row] {
            static_cast<Row*>(beside_)->isInFront = row == beside_;
            emit shownChanged();
        };
        connect(row, &QTabWidget::currentChanged, this, use);
        connect(row, &QTabWidget::tabBarClicked, this, use);
        row->tabBar()->installEventFilter(this);
    }
    QTabBar* bar = beside_->tabBar();
    bar->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(bar, &QWidget::customContextMenuRequested, this, [this, bar](const QPoint& where) {
        QWidget* page = beside_->widget(bar->tabAt(where));
        if (page == nullptr)
            return;
        QMenu* menu = contextMenu(this, "besideMenu");
        menu->addAction(icon("attach"), tr("Back to the other pages"), page,
                        [this, page] { moveAcross(page); });
        menu->addAction(icon("remove"), tr("Close"), page, [this, page] { close(page); });
        menu->popup(bar->mapToGlobal(where));
    });
    connect(qApp, &QApplication::focusChanged, this, &PageTabs::noteFocus);
}

void PageTabs::addPage(QWidget* page, const QIcon& icon, const QString& title) {
    setCurrentIndex(addTab(page, icon, title));
}

void PageTabs::retitle(QWidget* page, const QString& title) {
    QTabWidget* row = isBeside(page) ? beside_ : this;
    row->setTabText(row->indexOf(page), title);
    emit shownChanged();
}

bool PageTabs::isBeside(const QWidget* page) const {
    return beside_->indexOf(page) >= 0;
}

void PageTabs::moveAcross(QWidget* page) {
    const bool back = isBeside(page);
    QTabWidget* from = back ? beside_ : this;
    QTabWidget* to = back ? this : beside_;
    const int index = from->indexOf(page);
    if (index < (back ? 0 : 1))
        return;
    const QIcon mark = from->tabIcon(index);
    const QString title = from->tabText(index);
    from->removeTab(index);
    to->setCurrentIndex(to->addTab(page, mark, title));
    static_cast<Row*>(beside_)->isInFront = to == beside_;
    page->setFocus();
    emit shownChanged();
}

std::vector<QWidget*> PageTabs::pages() const {
    std::vector<QWidget*> all;
    for (const QTabWidget* row :
         {static_cast<const QTabWidget*>(this), static_cast<const QTabWidget*>(beside_)})
        for (int i = 0; i < row->count(); ++i)
            all.push_back(row->widget(i));
    return all;
}

void PageTabs::bring(QWidget* page) {
    QTabWidget* row = isBeside(page) ? beside_ : this;
    row->setCurrentWidget(page);
    static_cast<Row*>(beside_)->isInFront = row == beside_;
    emit shownChanged();
}

QWidget* PageTabs::shownPage() const {
    QWidget* other = beside_->currentWidget();
    return other != nullptr && static_cast<Row*>(beside_)->isInFront ? other : currentWidget();
}

void PageTabs::noteFocus() {
    const QWidget* focus = QApplication::focusWidget();
    if (focus == nullptr)
        return;
    // What has the focus elsewhere, a dock or a menu, is about the page that was used last.
    auto& row = static_cast<Row&>(*beside_);
    if (row.isAncestorOf(focus) || focus == &row)
        row.isInFront = true;
    else if (isAncestorOf(focus) || focus == this)
        row.isInFront = false;
    QWidget* shown = shownPage();
    if (shown == shown_)
        return;
    shown_ = shown;
    emit shownChanged();
}

bool PageTabs::eventFilter(QObject* watched, QEvent* event) {
    QTabWidget* row = watched == tabBar() ? this : beside_;
    switch (event->type()) {
    case QEvent::MouseButtonPress: {
        const auto& mouse = static_cast<QMouseEvent&>(*event);
        if (mouse.button() == Qt::LeftButton)
            dragged_ = row->widget(row->tabBar()->tabAt(mouse.pos()));
        break;
    }
    case QEvent::MouseMove:
        if (dragged_ == nullptr)
            break;
        if (!row->tabBar()->rect().contains(static_cast<QMouseEvent&>(*event).pos()) &&
            dragged_ != widget(0))
            row->tabBar()->setCursor(Qt::DragMoveCursor);
        else
            row->tabBar()->unsetCursor();
        break;
    case QEvent::MouseButtonRelease:
        if (dragged_ == nullptr)
            break;
        row->tabBar()->unsetCursor();
        drop(*row, static_cast<QMouseEvent&>(*event).globalPosition().toPoint());
        break;
    default:
        break;
    }
    return QTabWidget::eventFilter(watched, event);
}

void PageTabs::drop(QTabWidget& row, const QPoint& global) {
    QWidget* page = std::exchange(dragged_, nullptr);
    // It may have been closed meanwhile.
    if (row.indexOf(page) < 0 || row.tabBar()->rect().contains(row.tabBar()->mapFromGlobal(global)))
        return;
    const QPoint here = mapFromGlobal(global), there = beside_->mapFromGlobal(global);
    const bool isOverRightHalf = rect().contains(here) && 2 * here.x() > width();
    const bool isOverOther = beside_->isVisible() && beside_->rect().contains(there);
    if (&row == this ? isOverOther || isOverRightHalf : rect().contains(here))
        moveAcross(page);
}

ResultPage* PageTabs::currentResult() const {
    return qobject_cast<ResultPage*>(shownPage());
}

DocumentPage* PageTabs::shownDocument() const {
    return dynamic_cast<DocumentPage*>(shownPage());
}

void PageTabs::close(QWidget* page) {
    if (page == nullptr || page == widget(0))
        return;
    auto* document = dynamic_cast<DocumentPage*>(page);
    if (document == nullptr || document->mayClose())
        delete page;
}

bool PageTabs::mayCloseAll() const {
    for (QWidget* page : pages()) {
        auto* document = dynamic_cast<DocumentPage*>(page);
        if (document != nullptr && !document->mayClose())
            return false;
    }
    return true;
}

bool PageTabs::mayExportShown() const {
    return dynamic_cast<Exportable*>(shownPage()) != nullptr;
}

void PageTabs::exportShown(const Dialogs& dialogs) {
    const auto* page = dynamic_cast<Exportable*>(shownPage());
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
