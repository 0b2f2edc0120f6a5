#include "gui/widgets/Widgets.h"

#include <map>

#include <QChildEvent>
#include <QDockWidget>
#include <QGridLayout>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include "gui/widgets/NumberText.h"

namespace smat::gui {

QToolButton* textButton(const QString& text, const QString& objectName, const QString& toolTip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setObjectName(objectName);
    button->setToolTip(toolTip);
    return button;
}

namespace {

/// Leaves room for the arrow in its corner.
class MenuButton : public QToolButton {
  public:
    using QToolButton::QToolButton;
    QSize sizeHint() const override { return QToolButton::sizeHint() + QSize(16, 0); }
    QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace

QToolButton* menuButton(const QString& text, const QString& objectName, const QString& toolTip) {
    auto* button = new MenuButton;
    button->setText(text);
    button->setObjectName(objectName);
    button->setToolTip(toolTip);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setMenu(new QMenu(button));
    return button;
}

QMenu* contextMenu(QWidget* owner, const QString& objectName) {
    auto* menu = owner->findChild<QMenu*>(objectName, Qt::FindDirectChildrenOnly);
    if (menu == nullptr) {
        menu = new QMenu(owner);
        menu->setObjectName(objectName);
    }
    menu->clear();
    return menu;
}

namespace {

void listFields(QWidget* part, QWidgetList& fields);

QList<QLayoutItem*> itemsAsOneReads(const QLayout& layout) {
    QList<QLayoutItem*> items;
    for (int i = 0; i < layout.count(); ++i)
        items << layout.itemAt(i);
    if (const auto* grid = qobject_cast<const QGridLayout*>(&layout)) {
        std::map<std::pair<int, int>, QLayoutItem*> byPlace;
        for (int i = 0; i < grid->count(); ++i) {
            int row = 0, column = 0, rows = 0, columns = 0;
            grid->getItemPosition(i, &row, &column, &rows, &columns);
            byPlace.emplace(std::pair(row, column), grid->itemAt(i));
        }
        items = QList<QLayoutItem*>();
        for (const auto& [place, item] : byPlace)
            items << item;
    }
    return items;
}

void listFields(const QLayout& layout, QWidgetList& fields) {
    for (QLayoutItem* item : itemsAsOneReads(layout))
        if (item->widget() != nullptr)
            listFields(item->widget(), fields);
        else if (item->layout() != nullptr)
            listFields(*item->layout(), fields);
}

void listFields(QWidget* part, QWidgetList& fields) {
    // No stops of their own: what scrolls follows its fields, which Qt takes for a part of it, and
    // tabs stand for their bar, to which Tab would jump from wherever they are in the line.
    if (qobject_cast<QTabWidget*>(part) != nullptr)
        part->setFocusProxy(nullptr);
    if (qobject_cast<QTabWidget*>(part) != nullptr || qobject_cast<QScrollArea*>(part) != nullptr)
        part->setFocusPolicy(Qt::NoFocus);
    if ((part->focusPolicy() & Qt::TabFocus) != 0 && part->focusProxy() == nullptr)
        fields << part;
    if (auto* tabs = qobject_cast<QTabWidget*>(part)) {
        listFields(tabs->tabBar(), fields);
        for (int i = 0; i < tabs->count(); ++i)
            listFields(tabs->widget(i), fields);
    } else if (auto* splitter = qobject_cast<QSplitter*>(part)) {
        for (int i = 0; i < splitter->count(); ++i)
            listFields(splitter->widget(i), fields);
    } else if (auto* scroll = qobject_cast<QScrollArea*>(part)) {
        if (scroll->widget() != nullptr)
            listFields(scroll->widget(), fields);
    } else if (auto* dock = qobject_cast<QDockWidget*>(part)) {
        if (dock->widget() != nullptr)
            listFields(dock->widget(), fields);
    } else if (part->layout() != nullptr) {
        listFields(*part->layout(), fields);
    } else {
        for (auto* child : part->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
            if (!child->isWindow() && child->focusProxy() != part)
                listFields(child, fields);
    }
}

} // namespace

void letShownPageAloneAskForRoom(QTabWidget& tabs) {
    const auto ask = [&tabs](int shown) {
        for (int i = 0; i < tabs.count(); ++i) {
            const auto policy = i == shown ? QSizePolicy::Preferred : QSizePolicy::Ignored;
            tabs.widget(i)->setSizePolicy(policy, policy);
        }
    };
    ask(tabs.currentIndex());
    QObject::connect(&tabs, &QTabWidget::currentChanged, &tabs, ask);
}

void keepKeysFromHiddenTab(QDockWidget& dock) {
    QWidget* content = dock.widget();
    // The tab keeps its size, whichever dock is in front.
    QSizePolicy policy = content->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    content->setSizePolicy(policy);
    QObject::connect(&dock, &QDockWidget::visibilityChanged, content, &QWidget::setVisible);
}

void keepKeysFromEmptyTabBars(QMainWindow& window) {
    /// Follows the bars of tabs that Qt puts beside docks, as they come and change their size.
    class BarsOfDocks : public QObject {
      public:
        using QObject::QObject;
        bool eventFilter(QObject* object, QEvent* event) override {
            if (event->type() == QEvent::ChildPolished) {
                if (auto* bar = qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child())) {
                    bar->installEventFilter(this);
                    follow(*bar);
                }
            } else if (event->type() == QEvent::Resize || event->type() == QEvent::Move ||
                       event->type() == QEvent::Show) {
                if (auto* bar = qobject_cast<QTabBar*>(object))
                    follow(*bar);
            }
            return QObject::eventFilter(object, event);
        }

      private:
        static void follow(QTabBar& bar) {
            const bool isSeen = bar.parentWidget()->rect().intersects(bar.geometry());
            bar.setFocusPolicy(isSeen ? Qt::TabFocus : Qt::NoFocus);
        }
    };
    window.installEventFilter(new BarsOfDocks(&window));
}

void tabAsOneReads(QWidget& page) {
    QWidgetList fields;
    listFields(&page, fields);
    for (int i = 1; i < fields.size(); ++i)
        QWidget::setTabOrder(fields[i - 1], fields[i]);
}

std::optional<double> numberIn(const QLineEdit* field, const QString& unit) {
    return typedNumber(field->text(), unit).value;
}

} // namespace smat::gui
