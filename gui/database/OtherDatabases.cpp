#include <algorithm>
#include <utility>

#include "gui/database/DatabaseSession.h"

// The part of the session that keeps the databases of other models while one is edited.

namespace smat::gui {

namespace fs = std::filesystem;

void DatabaseSession::keepOpen(std::set<fs::path> files) {
    keep_ = std::move(files);
    // Their copies of unsaved edits stay, and are offered again with their file.
    std::erase_if(others_, [this](const auto& one) { return !keep_.contains(one.first); });
}

DatabaseSession::Values DatabaseSession::unsavedOthers() const {
    Values values;
    for (const auto& [file, other] : others_)
        if (other.dirty)
            values[file] = other.value;
    return values;
}

void DatabaseSession::leaveOrKeepOpen(const fs::path& next) {
    if (isOpen() && file_ != next && keep_.contains(file_))
        keepCurrentOpen();
    else
        leave();
}

void DatabaseSession::keepCurrentOpen() {
    if (dirty_)
        writeRecoveryNow();
    recoveryTimer_.stop();
    OpenDatabase& other = others_[file_];
    other = {std::move(value_),
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

bool DatabaseSession::takeFromOthers(const fs::path& file) {
    const auto found = others_.find(file);
    if (found == others_.end())
        return false;
    OpenDatabase other = std::move(found->second);
    others_.erase(found);
    // Nothing is lost by reading a file again that was not edited here.
    if (!other.dirty && irsg::stampOf(file) != other.stamp)
        return false;
    leaveOrKeepOpen(file);
    file_ = file;
    value_ = std::move(other.value);
    saved_ = std::move(other.saved);
    isNew_ = other.isNew;
    acceptedOutside_ = other.acceptedOutside;
    dirty_ = other.dirty;
    access_ = other.access;
    otherWindow_ = other.otherWindow;
    taken_ = other.taken;
    stamp_ = other.stamp;
    lock_ = std::move(other.lock);
    recovery_ = std::move(other.recovery);
    recoveryProblem_ = std::move(other.recoveryProblem);
    left_ = std::move(other.left);
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
        std::ranges::find_if(others_, [&](const auto& one) { return one.second.taken == taken; });
    if (found == others_.end())
        return false;
    const fs::path file = found->first;
    emit wanted(file);
    if (taken != taken_)
        takeFromOthers(file);
    return taken == taken_;
}

} // namespace smat::gui
