#include "irsg/atmosphere/ck/CkStore.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "wideband terms 2\n";
constexpr std::string_view suffix = ".ck";

/// FNV-1a from a start of its own.
std::uint64_t hashOf(std::string_view text, std::uint64_t start) {
    for (const char c : text)
        start = (start ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return start;
}

/// Two of them tell texts apart.
std::string digest(std::string_view text) {
    char name[40];
    std::snprintf(name, sizeof name, "%016llx%016llx",
                  static_cast<unsigned long long>(hashOf(text, 0xcbf29ce484222325ULL)),
                  static_cast<unsigned long long>(hashOf(text, 0x84222325cbf29ce4ULL)));
    return name;
}

/// What stands before the content: a content with a digit changed would still be read.
std::string headOf(const std::string& key, std::string_view content) {
    return std::string(magic) + CkKey().add(key).add(digest(content)).text();
}

} // namespace

CkKey& CkKey::add(double value) {
    text_ += numberText(value) + " ";
    return *this;
}

CkKey& CkKey::add(const std::string& text) {
    text_ += std::to_string(text.size()) + ":" + text + " ";
    return *this;
}

CkKey& CkKey::add(const Spectrum& spectrum) {
    for (const auto* numbers : {&spectrum.wavelengths_um(), &spectrum.values()}) {
        add(static_cast<double>(numbers->size()));
        for (const double number : *numbers)
            add(number);
    }
    return *this;
}

CkKey& CkKey::addDigest(std::span<const double> numbers) {
    add(static_cast<double>(numbers.size()));
    return add(digest({reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()}));
}

CkStore::CkStore(fs::path folder, std::uintmax_t bytes)
    : folder_(std::move(folder)), bytes_(bytes) {}

std::optional<CkStore> CkStore::ofUser() {
    auto named = [](const char* variable) -> std::optional<fs::path> {
        const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe)
        return value ? std::optional<fs::path>(value) : std::nullopt;
    };
    if (const auto folder = named("SMAT_CACHE"))
        return folder->empty() ? std::nullopt : std::optional(CkStore(*folder / "wideband"));
    if (const auto folder = named("XDG_CACHE_HOME"); folder && folder->is_absolute())
        return CkStore(*folder / "smat" / "wideband");
    if (const auto home = named("HOME"); home && home->is_absolute())
        return CkStore(*home / ".cache" / "smat" / "wideband");
    return std::nullopt;
}

fs::path CkStore::fileOf(const std::string& key) const {
    return folder_ / (digest(key) + std::string(suffix));
}

std::optional<std::string> CkStore::find(const std::string& key) const {
    const fs::path file = fileOf(key);
    std::error_code none;
    if (!fs::is_regular_file(file, none))
        return std::nullopt;
    std::string text;
    try {
        text = readFile(file, bytes_ + magic.size());
        allowChange(file);
    } catch (const InputError&) {
        return std::nullopt; // taken away by another program, or not ours to read
    }
    const std::size_t head = headOf(key, {}).size();
    if (text.size() < head || !text.starts_with(headOf(key, std::string_view(text).substr(head))))
        return std::nullopt;
    fs::last_write_time(file, fs::file_time_type::clock::now(), none);
    return text.substr(head);
}

void CkStore::keep(const std::string& key, const std::string& content) const {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    try {
        writeFileDurably(fileOf(key), headOf(key, content) + content);
    } catch (const InputError&) {
        return;
    }
    makeRoom();
}

void CkStore::makeRoom() const {
    struct Entry {
        fs::path file;
        fs::file_time_type used;
        std::uintmax_t size;
    };
    std::vector<Entry> entries;
    std::uintmax_t all = 0;
    std::error_code failed;
    for (fs::directory_iterator at(folder_, failed), end; !failed && at != end;
         at.increment(failed)) {
        std::error_code gone;
        const std::uintmax_t size = at->file_size(gone);
        const fs::file_time_type used = at->last_write_time(gone);
        if (gone || at->path().extension() != suffix)
            continue;
        entries.push_back({at->path(), used, size});
        all += size;
    }
    std::ranges::sort(entries, {}, &Entry::used);
    for (const Entry& entry : entries) {
        if (all <= bytes_)
            break;
        std::error_code gone;
        fs::remove(entry.file, gone);
        all -= entry.size;
    }
}

} // namespace irsg
