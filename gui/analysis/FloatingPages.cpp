#include "gui/analysis/FloatingPages.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QMouseEvent>
#include <QPointer>
#include <QShortcut>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/PageTabs.h"

namespace smat::gui {

/// A page in a window of its own, with a button that puts it back.
class FloatingPages::Window : public QWidget {
  public:
    Window(QWidget* page, const QIcon& pageIcon, const QString& title, FloatingPages& owner)
        : QWidget(owner.tabs_->window(), Qt::Window), page_(page), owner_(owner) {
        setObjectName("floatingPage");
        setAttribute(Qt::WA_DeleteOnClose);
        setAutoFillBackground(true);
        setBackgroundRole(QPalette::Window);
        setWindowTitle(title);
        setWindowIcon(pageIcon);
        auto* back = new QToolButton(this);
        back->setObjectName("attachPage");
        back->setIcon(icon("attach"));
        back->setText(FloatingPages::tr("Back to the tabs"));
        back->setToolTip(FloatingPages::tr("Put this page back (Ctrl+Shift+T)"));
        back->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        back->setAutoRaise(true);
        const auto putBack = [this] { owner_.attach(page_); };
        connect(back, &QToolButton::clicked, this, putBack);
        connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T), this),
                &QShortcut::activated, this, putBack);
        connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_W), this), &QShortcut::activated,
                this, &QWidget::close);
        auto* top = new QHBoxLayout;
        top->setContentsMargins(10, 8, 10, 0);
        top->addStretch(1);
        top->addWidget(back);
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addLayout(top);
        column->addWidget(page, 1);
        page->show();
        // A page that is deleted takes its window along.
        connect(page, &QObject::destroyed, this, [this] {
            std::erase(owner_.windows_, this);
            close();
        });
    }
    ~Window() override {
        if (page_)
            page_->disconnect(this); // it goes with what is left of this window, and takes nothing
    }
    QWidget* page() const { return page_; }
    /// Gives the page away.
    void release() {
        page_->disconnect(this);
        layout()->removeWidget(page_);
    }

  private:
    QPointer<QWidget> page_;
    FloatingPages& owner_;
};

FloatingPages::FloatingPages(PageTabs* tabs) : QObject(tabs), tabs_(tabs) {
    QTabBar* bar = tabs_->tabBar();
    bar->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(bar, &QWidget::customContextMenuRequested, this, &FloatingPages::showMenu);
    bar->installEventFilter(this);
}

FloatingPages::~FloatingPages() {
    for (Window* window : std::vector(windows_))
        delete window;
}

std::vector<QWidget*> FloatingPages::pages() const {
    std::vector<QWidget*> list;
    for (QWidget* page : tabs_->pages())
        if (page != tabs_->widget(0))
            list.push_back(page);
    for (const Window* window : windows_)
        list.push_back(window->page());
    return list;
}

FloatingPages::Window* FloatingPages::windowOf(const QWidget* page) const {
    const auto found = std::find_if(windows_.begin(), windows_.end(),
                                    [page](const Window* w) { return w->page() == page; });
    return found == windows_.end() ? nullptr : *found;
}

bool FloatingPages::isDetached(const QWidget* page) const {
    return windowOf(page) != nullptr;
}

void FloatingPages::show(QWidget* page) {
    if (Window* window = windowOf(page)) {
        window->show();
        window->raise();
        window->activateWindow();
    } else {
        tabs_->bring(page);
    }
}

void FloatingPages::detach(QWidget* page) {
    const int index = tabs_->indexOf(page);
    if (index < 1)
        return;
    const QIcon pageIcon = tabs_->tabIcon(index);
    const QString title = tabs_->tabText(index);
    const QSize size = page->size();
    tabs_->removeTab(index);
    auto* window = new Window(page, pageIcon, title, *this);
    windows_.push_back(window);
    connect(window, &QObject::destroyed, this, [this, window] { std::erase(windows_, window); });
    window->resize(size);
    window->show();
}

void FloatingPages::attach(QWidget* page) {
    Window* window = windowOf(page);
    if (window == nullptr)
        return;
    window->release();
    std::erase(windows_, window);
    tabs_->setCurrentIndex(tabs_->addTab(page, window->windowIcon(), window->windowTitle()));
    window->close();
}

void FloatingPages::setTitle(QWidget* page, const QString& title) {
    if (Window* window = windowOf(page))
        window->setWindowTitle(title);
    else
        tabs_->retitle(page, title);
}

bool FloatingPages::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonDblClick) {
        const auto where = static_cast<QMouseEvent*>(event)->pos();
        if (const int index = tabs_->tabBar()->tabAt(where); index > 0) {
            detach(tabs_->widget(index));
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

void FloatingPages::showMenu(const QPoint& where) {
    const int index = tabs_->tabBar()->tabAt(where);
    if (index < 1)
        return;
    QWidget* page = tabs_->widget(index);
    QMenu* menu = contextMenu(tabs_, "tabMenu");
    menu->addAction(icon("detach"), tr("Open in its own window"), page,
                    [this, page] { detach(page); });
    menu->addAction(icon("columns"), tr("Show beside the other pages"), page,
                    [this, page] { tabs_->moveAcross(page); });
    menu->addAction(icon("remove"), tr("Close"), page, [this, page] { tabs_->close(page); });
    menu->popup(tabs_->tabBar()->mapToGlobal(where));
}

} // namespace smat::gui

#include "moc_FloatingPages.cpp"
