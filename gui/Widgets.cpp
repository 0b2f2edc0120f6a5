#include "gui/Widgets.h"

#include <cmath>

#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QTabWidget>
#include <QToolButton>

#include "irsg/radiometry/CsvTable.h"

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

std::optional<double> numberIn(const QLineEdit* field) {
    const auto number = irsg::parseNumber(field->text().trimmed().toStdString());
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace smat::gui
