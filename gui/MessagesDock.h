#pragma once

#include <QDockWidget>

class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace smat::gui {

class MessageLog;
struct Message;

/// The messages of a log with time, source and a button that shows what each is about. A double
/// click or Enter on a row does what its button does.
class MessagesDock : public QDockWidget {
    Q_OBJECT

  public:
    explicit MessagesDock(MessageLog& log, QWidget* parent = nullptr);
    ~MessagesDock() override;

    /// A button for the status bar: how many messages came since the panel was last seen. It shows
    /// the panel.
    QToolButton* counter() const { return counter_; }
    int unseenCount() const { return unseen_; }

  private:
    void makeList();
    void append();
    void fill(QTreeWidgetItem& item, const Message& message);
    void goThere(QTreeWidgetItem* item);
    void copy() const;
    void noteNew();
    void refresh();

    MessageLog& log_;
    QTreeWidget* list_ = nullptr;
    QToolButton* clear_ = nullptr;
    QToolButton* copy_ = nullptr;
    QToolButton* counter_ = nullptr;
    int unseen_ = 0;
};

} // namespace smat::gui
