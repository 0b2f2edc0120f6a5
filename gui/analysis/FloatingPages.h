#pragma once

#include <vector>

#include <QObject>

class QWidget;

namespace smat::gui {

class PageTabs;

/// Pages of a row of tabs that may leave it for windows of their own and come back: by the menu of
/// a tab or its double click, and by the button in the corner of such a window. Closing the window
/// closes the page. The first tab stays.
class FloatingPages : public QObject {
    Q_OBJECT

  public:
    explicit FloatingPages(PageTabs* tabs);
    ~FloatingPages() override;

    /// Pages in both rows of tabs and in windows of their own, without the first tab.
    std::vector<QWidget*> pages() const;
    /// Brings a page to the front wherever it is.
    void show(QWidget* page);
    void detach(QWidget* page);
    void attach(QWidget* page);
    bool isDetached(const QWidget* page) const;
    /// Of a tab, or the title of its window.
    void setTitle(QWidget* page, const QString& title);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    class Window;
    void showMenu(const QPoint& where);
    Window* windowOf(const QWidget* page) const;

    PageTabs* tabs_;
    std::vector<Window*> windows_;
};

} // namespace smat::gui
