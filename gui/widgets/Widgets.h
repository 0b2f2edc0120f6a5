#pragma once

#include <optional>

#include <QString>

class QDockWidget;
class QLineEdit;
class QMainWindow;
class QMenu;
class QTabWidget;
class QToolButton;
class QWidget;

namespace smat::gui {

/// A button of a bar, without a parent.
QToolButton* textButton(const QString& text, const QString& objectName, const QString& toolTip);
/// Opens its menu(), which is empty yet, when it is pressed.
QToolButton* menuButton(const QString& text, const QString& objectName, const QString& toolTip);
/// An empty menu of a widget, the same each time. It stays when it is closed: Qt 6.4 still writes
/// to a menu after the act that was chosen from it, in which its like may be deleted.
QMenu* contextMenu(QWidget* owner, const QString& objectName);

/// Makes the minimum size of tabs that of the page that is shown, not of the largest one.
void letShownPageAloneAskForRoom(QTabWidget& tabs);

/// Takes the fields of a dock that lies behind another one out of reach of the keys: Qt leaves them
/// shown beyond the edge of the window, with the focus that they had.
void keepKeysFromHiddenTab(QDockWidget& dock);

/// Takes the bar of tabs of a single dock, whose others are closed, out of reach of the keys: Qt
/// leaves it in the line, out of sight.
void keepKeysFromEmptyTabBars(QMainWindow& window);

/// Makes Tab go through the fields of a page as one reads them: as they stand in its layouts, not
/// as they were made.
void tabAsOneReads(QWidget& page);

/// The number that a field holds, by the rule of typedNumber(); none for anything else.
std::optional<double> numberIn(const QLineEdit* field, const QString& unit = {});

} // namespace smat::gui
