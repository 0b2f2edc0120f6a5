#pragma once

#include <QTextBrowser>

namespace smat::gui {

/// The user guide as a page of the window, chapter by chapter.
class GuidePage : public QTextBrowser {
    Q_OBJECT

  public:
    /// Opens at "first-signature.md", say; the guide has to be there, see isThere().
    explicit GuidePage(const QString& chapter, QWidget* parent = nullptr);
    static bool isThere();

  protected:
    /// Pictures no wider than the page.
    QVariant loadResource(int type, const QUrl& name) override;
};

} // namespace smat::gui
