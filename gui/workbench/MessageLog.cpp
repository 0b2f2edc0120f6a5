#include "gui/workbench/MessageLog.h"

#include <utility>

namespace smat::gui {

void MessageLog::add(Message message) {
    if (message.sentence.isEmpty())
        return;
    message.time = QDateTime::currentDateTime();
    if (!messages_.empty()) {
        const Message& last = messages_.back();
        if (last.kind == message.kind && last.source == message.source &&
            last.sentence == message.sentence) {
            message.count = last.count + 1;
            messages_.back() = std::move(message);
            emit repeated();
            return;
        }
    }
    messages_.push_back(std::move(message));
    emit added();
    if (messages_.size() > most) {
        messages_.pop_front();
        emit dropped();
    }
}

void MessageLog::clear() {
    messages_.clear();
    emit cleared();
}

} // namespace smat::gui

#include "moc_MessageLog.cpp"
