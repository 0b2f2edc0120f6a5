#pragma once

#include <deque>
#include <functional>

#include <QDateTime>
#include <QObject>

namespace smat::gui {

/// How serious a message is: what was taken for granted, what numbers lack, what was not done.
enum class MessageKind { remark, warning, error };

/// A sentence of the program that does not ask for an answer.
struct Message {
    MessageKind kind = MessageKind::remark;
    QString source; ///< a result, a file, a title: "1  Polar plot", "heron.ac"
    QString sentence;
    std::function<void()> goThere = {}; ///< shows what it is about; empty where there is no place
    QDateTime time = {};                ///< of the last time, where it came several times in a row
    int count = 1;                      ///< how many times in a row it came
};

/// Every warning and remark since the start of the program, the newest last. The oldest go where
/// there are more than `most`. Knows no widget.
class MessageLog : public QObject {
    Q_OBJECT

  public:
    static constexpr std::size_t most = 1000;

    using QObject::QObject;

    /// Keeps a message with the time of now. One that says the same as the last one is that one
    /// once more. A message without a sentence is none.
    void add(Message message);
    const std::deque<Message>& messages() const { return messages_; }
    void clear();

  signals:
    /// The last of messages() is new.
    void added();
    /// The last of messages() came once more.
    void repeated();
    /// The first of messages() went.
    void dropped();
    void cleared();

  private:
    std::deque<Message> messages_;
};

} // namespace smat::gui
