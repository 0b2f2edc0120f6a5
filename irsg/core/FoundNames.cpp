#include "irsg/core/FoundNames.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace irsg {

namespace {

namespace fs = std::filesystem;

thread_local FoundNames* listener = nullptr;

/// What is known where nothing is looked for.
std::optional<std::vector<FoundName>>& known() {
    static std::optional<std::vector<FoundName>> names;
    return names;
}

WrittenPath find(const fs::path& folder, const std::string& written) {
    const WrittenPath found = findWritten(folder, written);
    return found.file.empty() ? findWritten(folder, writtenFileName(written)) : found;
}

} // namespace

void noteFound(const fs::path& folder, const std::string& written, const WrittenPath& found) {
    if (listener)
        listener->names_.push_back({folder, written, found});
}

FoundNames::FoundNames() : outer_(std::exchange(listener, this)) {}

FoundNames::~FoundNames() {
    listener = outer_;
}

std::vector<FoundName> FoundNames::take() {
    return std::exchange(names_, {});
}

void useFoundNames(std::vector<FoundName> names) {
    known() = std::move(names);
}

WrittenPath findWrittenOrBeside(const fs::path& folder, const std::string& written) {
    if (known()) {
        const auto name = std::ranges::find_if(*known(), [&](const FoundName& one) {
            return one.folder == folder && one.written == written;
        });
        return name == known()->end() ? WrittenPath{} : name->found;
    }
    const WrittenPath found = find(folder, written);
    noteFound(folder, written, found);
    return found;
}

} // namespace irsg
