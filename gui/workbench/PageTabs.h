#pragma once

#include <QTabWidget>

#include "gui/widgets/Dialogs.h"

namespace smat::gui {

class DocumentPage;
class ResultPage;

/// The pages of the window: the model first, which stays, and those of results, images and tools,
/// which can be closed.
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
    /// The page that is shown; null where it is none of a result.
    ResultPage* currentResult() const;
    /// The page that is shown, where it edits a file of its own; else null.
    DocumentPage* shownDocument() const;
    bool mayCloseShown() const { return currentIndex() > 0; }
    void closeShown() { close(currentIndex()); }
    /// Whether a person wants to give up or has saved what every page has of its own.
    bool mayCloseAll() const;
    bool mayExportShown() const;
    /// Asks for a file and writes the page that is shown to it.
    void exportShown(const Dialogs& dialogs);

  private:
    void close(int index);

  signals:
    /// Another page is shown, or one by another name.
    void shownChanged();
    void said(const QString& sentence);
};

} // namespace smat::gui
