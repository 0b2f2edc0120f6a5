#pragma once

#include <QFrame>

#include "gui/database/EditorContext.h"

class QHBoxLayout;
class QLabel;

namespace smat::gui {

/// Says above the editor what stands between a person and the database, with buttons for what can
/// be done about it: edits that an ended window left, a file that another program changed, that is
/// write-protected or being edited elsewhere, or that cannot be opened. Hidden where all is well.
class DatabaseBanner : public QFrame {
    Q_OBJECT

  public:
    explicit DatabaseBanner(EditorContext& context, QWidget* parent = nullptr);
    QString text() const;

  signals:
    void newRequested();
    void firstSignatureRequested();
    void openRequested();
    void saveAsRequested();
    void overwriteRequested();

  private:
    void refresh();
    void say(const QString& text);
    template <typename Act>
    void offer(const QString& name, const QString& words, Act act);
    void attempt(const std::function<void()>& act);

    EditorContext& context_;
    QLabel* words_ = nullptr;
    QHBoxLayout* buttons_ = nullptr;
    bool changedOnDisk_ = false;
};

} // namespace smat::gui
