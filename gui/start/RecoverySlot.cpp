#include "gui/start/RecoverySlot.h"

#include <algorithm>

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QLockFile>
#include <QRegularExpression>

#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

/// More copies of one file than anybody leaves behind.
constexpr int mostCopies = 999;

std::unique_ptr<QLockFile> lockOf(const std::filesystem::path& copy) {
    auto lock = std::make_unique<QLockFile>(textOf(copy) + ".lock");
    lock->setStaleLockTime(0); // only that of a process that is gone
    return lock;
}

bool isKept(const std::filesystem::path& copy) {
    const auto lock = lockOf(copy);
    return !lock->tryLock(0) && lock->error() == QLockFile::LockFailedError;
}

bool lies(const std::filesystem::path& file) {
    std::error_code none;
    return std::filesystem::exists(std::filesystem::symlink_status(file, none));
}

/// Every copy there is, whoever wrote it, the newest first.
std::vector<std::filesystem::path> copiesOf(const std::filesystem::path& base) {
    const auto first = RecoverySlot::placeOf(base);
    const QRegularExpression isOne(QRegularExpression::anchoredPattern(
        QRegularExpression::escape(textOf(first.stem())) + R"((\.\d{1,3})?\.recovery)"));
    std::vector<std::filesystem::path> copies;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(first.parent_path(), none))
        if (entry.is_regular_file(none) && isOne.match(textOf(entry.path().filename())).hasMatch())
            copies.push_back(entry.path());
    std::ranges::sort(copies, std::greater{}, [](const std::filesystem::path& copy) {
        return QFileInfo(textOf(copy)).lastModified();
    });
    return copies;
}

} // namespace

RecoverySlot::RecoverySlot() = default;
RecoverySlot::~RecoverySlot() = default;

const std::filesystem::path& RecoverySlot::claim(const std::filesystem::path& base) {
    if (lock_)
        return copy_;
    std::filesystem::create_directories(placeOf(base).parent_path());
    for (int number = 1; number <= mostCopies; ++number) {
        const auto copy = placeOf(base, number);
        if (lies(copy))
            continue;
        auto lock = lockOf(copy);
        if (!lock->tryLock(0)) {
            if (lock->error() == QLockFile::LockFailedError)
                continue;
            throw irsg::InputError({copy.string(), "", "a file that cannot be written",
                                    "a folder that can be written to"});
        }
        // Somebody else may have written it and gone since it was looked for.
        if (lies(copy))
            continue;
        copy_ = copy;
        lock_ = std::move(lock);
        return copy_;
    }
    throw irsg::InputError({placeOf(base).string(), "",
                            std::to_string(mostCopies) + " recovery copies that were left behind",
                            "a place for one more"});
}

bool RecoverySlot::takeOver(const std::filesystem::path& copy) {
    auto lock = lockOf(copy);
    if (!lock->tryLock(0))
        return false;
    copy_ = copy;
    lock_ = std::move(lock);
    return isWritten_ = true;
}

void RecoverySlot::forget() {
    if (isWritten_)
        remove(copy_);
    isWritten_ = false;
    lock_.reset();
}

std::filesystem::path RecoverySlot::placeOf(const std::filesystem::path& base, int number) {
    return base.string() + (number > 1 ? "." + std::to_string(number) : std::string()) +
           ".recovery";
}

std::vector<std::filesystem::path> RecoverySlot::leftBehind(const std::filesystem::path& base) {
    auto copies = copiesOf(base);
    std::erase_if(copies, isKept);
    return copies;
}

bool RecoverySlot::isInUse(const std::filesystem::path& base) {
    return std::ranges::any_of(copiesOf(base), isKept);
}

void RecoverySlot::remove(const std::filesystem::path& copy) {
    std::error_code none;
    std::filesystem::remove(copy, none);
}

QString whenWritten(const std::filesystem::path& copy) {
    return QLocale::system().toString(QFileInfo(textOf(copy)).lastModified(), QLocale::ShortFormat);
}

} // namespace smat::gui
