#pragma once

#include <vector>

#include <QPoint>
#include <QTabWidget>

#include "gui/widgets/Dialogs.h"

namespace smat::gui {

class DocumentPage;
class ResultPage;

/// The pages of the window: the model first, which stays, and those of results, images and tools,
/// which can be closed. A second row stands beside them while it has pages: one goes there by the
/// menu of its tab or when its tab is dragged to the right half, and comes back likewise. What is
/// shown is the page that has the focus, else that of the first row.
class PageTabs : public QTabWidget {
    Q_OBJECT

  public:
    explicit PageTabs(QWidget* parent = nullptr);
    ~PageTabs() override;

    /// The one that stays.
    void setFirst(QWidget* page, const QString& title);
    /// Shows a page of its own. One that is Exportable takes part in exportShown.
    void addPage(QWidget* page, const QIcon& icon, const QString& title);
    void retitle(QWidget* page, const QString& title);

    /// The second row, to be placed beside this one.
    QTabWidget* beside() const { return beside_; }
    bool isBeside(const QWidget* page) const;
    /// Moves a page from one row to the other, where it is shown. The first page stays.
    void moveAcross(QWidget* page);
    /// Whether the shown page may go to the other row.
    bool mayMoveShown() const { return shownPage() != widget(0); }
    QWidget* shownPage() const;
    /// Of both rows.
    std::vector<QWidget*> pages() const;
    /// Shows a page in the row that has it.
    void bring(QWidget* page);

    /// The page that is shown; null where it is none of a result.
    ResultPage* currentResult() const;
    /// The page that is shown, where it edits a file of its own; else null.
    DocumentPage* shownDocument() const;
    bool mayCloseShown() const { return mayMoveShown(); }
    /// Asks where there are changes that are not saved; not the first page.
    void close(QWidget* page);
    void closeShown() { close(shownPage()); }
    /// Whether a person wants to give up or has saved what every page has of its own.
    bool mayCloseAll() const;
    bool mayExportShown() const;
    /// Asks for a file and writes the page that is shown to it.
    void exportShown(const Dialogs& dialogs);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    class Row;
    /// The tab that was pressed is let go.
    void drop(QTabWidget& row, const QPoint& global);
    void noteFocus();

    QTabWidget* beside_ = nullptr;
    QWidget* dragged_ = nullptr;
    QWidget* shown_ = nullptr; ///< as it was told last

  signals:
    /// Another page is shown, or one by another name.
    void shownChanged();
    void said(const QString& sentence);
};

} // namespace smat::gui
