#pragma once

#include <QObject>

#include "gui/widgets/Dialogs.h"

namespace smat::gui {

class FloatingPages;
class PageTabs;
class ResultPage;
class Workbench;

/// Shows results of a Workbench as pages of a row of tabs, which may float: each once, several
/// overlaid on one page. Pages follow their results: a new name, and their end. The result of a run
/// comes to the front where the person did nothing but wait for it; else its tab stands there with
/// a dot until it is looked at, and a note says so.
class ResultPages : public QObject {
    Q_OBJECT

  public:
    ResultPages(Workbench& workbench, Dialogs dialogs, PageTabs* tabs);

    void show(const QList<int>& ids);
    FloatingPages& floating() { return *floating_; }

  signals:
    /// What is worth saying of the result whose page comes to the front: notes, or how long it
    /// took.
    void said(const QString& sentence);
    /// That no page of a result is in front of which this was said.
    void passed(const QString& sentence);

  protected:
    /// Sees that the person goes on working.
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    std::vector<ResultPage*> pages() const;
    void clearDot();
    void sayOfShown();
    void onRenamed(int id);
    void onRemoved(int id);

    Workbench& workbench_;
    Dialogs dialogs_;
    PageTabs* tabs_;
    FloatingPages* floating_;
    QString said_; ///< of the page in front
    bool isRunning_ = false, isAtWork_ = false;
};

} // namespace smat::gui
