#include <algorithm>
#include <utility>

#include "gui/database/DatabaseSession.h"

// The part of the session that keeps the databases of other models while one is edited.

namespace smat::gui {

namespace fs = std::filesystem;

void DatabaseSession::keepAside(std::set<fs::path> files) {
    keep_ = std::move(files);
    // Their copies of unsaved edits stay, and are offered again with their file.
    std::erase_if(aside_, [this](const auto& one) { return !keep_.contains(one.first); });
}

DatabaseSession::Values DatabaseSession::unsavedAside() const {
    Values values;
    for (const auto& [file, aside] : aside_)
        if (aside.dirty)
            values[file] = aside.value;
    return values;
}

void DatabaseSession::leaveOrPutAside(const fs::path& next) {
    if (isOpen() && file_ != next && keep_.contains(file_))
        putAside();
    else
        leave();
}

void DatabaseSession::putAside() {
    if (dirty_)
        writeRecoveryNow();
    recoveryTimer_.stop();
    Aside& aside = aside_[file_];
    aside = {std::move(value_),
             std::move(saved_),
             isNew_,
             acceptedOutside_,
             dirty_,
             access_,
             otherWindow_,
             taken_,
             stamp_,
             std::move(lock_),
             std::exchange(recovery_, {}),
             std::exchange(recoveryProblem_, {}),
             std::exchange(left_, {})};
    value_ = saved_ = nullptr;
    dirty_ = isNew_ = acceptedOutside_ = false;
}

bool DatabaseSession::takeFromAside(const fs::path& file) {
    const auto found = aside_.find(file);
    if (found == aside_.end())
        return false;
    Aside aside = std::move(found->second);
    aside_.erase(found);
    // Nothing is lost by reading a file again that was not edited here.
    if (!aside.dirty && irsg::stampOf(file) != aside.stamp)
        return false;
    leaveOrPutAside(file);
    file_ = file;
    value_ = std::move(aside.value);
    saved_ = std::move(aside.saved);
    isNew_ = aside.isNew;
    acceptedOutside_ = aside.acceptedOutside;
    dirty_ = aside.dirty;
    access_ = aside.access;
    otherWindow_ = aside.otherWindow;
    taken_ = aside.taken;
    stamp_ = aside.stamp;
    lock_ = std::move(aside.lock);
    recovery_ = std::move(aside.recovery);
    recoveryProblem_ = std::move(aside.recoveryProblem);
    left_ = std::move(aside.left);
    ++gesture_;
    watch();
    emit opened();
    emit stateChanged();
    if (isChangedOnDisk())
        emit changedOnDisk();
    return true;
}

bool DatabaseSession::bring(int taken) {
    if (taken == taken_)
        return true;
    const auto found =
        std::ranges::find_if(aside_, [&](const auto& one) { return one.second.taken == taken; });
    if (found == aside_.end())
        return false;
    const fs::path file = found->first;
    emit wanted(file);
    if (taken != taken_)
        takeFromAside(file);
    return taken == taken_;
}

} // namespace smat::gui
