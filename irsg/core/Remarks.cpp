#include "irsg/core/Remarks.h"

#include <mutex>

#include "irsg/core/AppendUnique.h"

namespace irsg {

namespace {

thread_local CollectedRemarks* collecting = nullptr;

struct Listener {
    std::mutex mutex;
    std::function<void(const std::string&)> call;
};

Listener& listenerOfProcess() {
    static Listener listener;
    return listener;
}

} // namespace

CollectedRemarks::CollectedRemarks() : outer_(collecting) {
    collecting = this;
}

CollectedRemarks::~CollectedRemarks() {
    collecting = outer_;
}

void CollectedRemarks::add(const std::string& sentence) {
    appendUnique(sentences_, sentence);
}

void remarkOn(const std::string& file, std::string_view sentence) {
    const std::string whole =
        file.empty() ? std::string(sentence) : file + ": " + std::string(sentence);
    if (collecting != nullptr) {
        collecting->add(whole);
        return;
    }
    Listener& listener = listenerOfProcess();
    std::function<void(const std::string&)> call;
    {
        const std::scoped_lock lock(listener.mutex);
        call = listener.call;
    }
    if (call)
        call(whole);
}

void setRemarkListener(std::function<void(const std::string&)> listener) {
    Listener& current = listenerOfProcess();
    const std::scoped_lock lock(current.mutex);
    current.call = std::move(listener);
}

} // namespace irsg
