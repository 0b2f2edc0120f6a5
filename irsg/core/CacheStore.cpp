#include "irsg/core/CacheStore.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "smat cache 3\n";
constexpr std::string_view suffix = ".cache";

std::string digestOf(std::string_view text) {
    return ContentDigest().add(std::as_bytes(std::span(text))).text();
}

/// What stands before the content: a content with a digit changed would still be read.
std::string headOf(const std::string& key, std::string_view content) {
    return std::string(magic) + CacheKey().add(key).add(digestOf(content)).text();
}

} // namespace

/// FNV-1a by words of 64 bits, each of whose high bits reach the low ones before the next; bytes
/// that fill no word count with their number.
ContentDigest& ContentDigest::add(std::span<const std::byte> bytes) {
    const auto addWord = [this](std::uint64_t word) {
        for (std::uint64_t& hash : hashes_) {
            hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32;
        }
    };
    std::uint64_t word = 0;
    std::size_t at = 0;
    for (; at + sizeof word <= bytes.size(); at += sizeof word) {
        std::memcpy(&word, bytes.data() + at, sizeof word);
        addWord(word);
    }
    word = 0;
    std::memcpy(&word, bytes.data() + at, bytes.size() - at);
    addWord(word);
    addWord(bytes.size());
    return *this;
}

std::string ContentDigest::text() const {
    char name[40];
    std::snprintf(name, sizeof name, "%016llx%016llx", static_cast<unsigned long long>(hashes_[0]),
                  static_cast<unsigned long long>(hashes_[1]));
    return name;
}

CacheKey& CacheKey::add(double value) {
    text_ += numberText(value) + " ";
    return *this;
}

CacheKey& CacheKey::add(const std::string& text) {
    text_ += std::to_string(text.size()) + ":" + text + " ";
    return *this;
}

CacheKey& CacheKey::add(std::span<const double> numbers) {
    add(static_cast<double>(numbers.size()));
    for (const double number : numbers)
        add(number);
    return *this;
}

CacheKey& CacheKey::addDigest(std::span<const double> numbers) {
    add(static_cast<double>(numbers.size()));
    return add(ContentDigest().add(std::as_bytes(numbers)).text());
}

CacheStore::CacheStore(fs::path folder, Kind kind)
    : folder_(std::move(folder)), kind_(std::move(kind)) {}

std::optional<CacheStore> CacheStore::ofUser(const Kind& kind) {
    auto named = [](const char* variable) -> std::optional<fs::path> {
        const char* value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe)
        return value ? std::optional<fs::path>(value) : std::nullopt;
    };
    if (const auto folder = named("SMAT_CACHE"))
        return folder->empty() ? std::nullopt
                               : std::optional(CacheStore(*folder / kind.name, kind));
    if (const auto folder = named("XDG_CACHE_HOME"); folder && folder->is_absolute())
        return CacheStore(*folder / "smat" / kind.name, kind);
    if (const auto home = named("HOME"); home && home->is_absolute())
        return CacheStore(*home / ".cache" / "smat" / kind.name, kind);
    return std::nullopt;
}

fs::path CacheStore::fileOf(const std::string& key) const {
    return folder_ / (digestOf(key) + std::string(suffix));
}

std::optional<std::string> CacheStore::find(const std::string& key) const {
    const fs::path file = fileOf(key);
    std::error_code none;
    if (!fs::is_regular_file(file, none))
        return std::nullopt;
    std::string text;
    try {
        text = readFile(file, kind_.mostBytes + magic.size());
        allowChange(file);
    } catch (const InputError&) {
        return std::nullopt; // taken away by another program, or not ours to read
    }
    const std::size_t head = headOf(key, {}).size();
    if (text.size() < head || !text.starts_with(headOf(key, std::string_view(text).substr(head))))
        return std::nullopt;
    fs::last_write_time(file, fs::file_time_type::clock::now(), none);
    text.erase(0, head);
    return text;
}

void CacheStore::keep(const std::string& key, std::string_view content) const {
    if (content.size() > kind_.mostBytes / 4)
        return;
    std::error_code failed;
    fs::create_directories(folder_, failed);
    try {
        FileReplacement file(fileOf(key));
        file.write(headOf(key, content));
        file.write(content);
        file.commit();
    } catch (const InputError&) {
        return;
    }
    makeRoom();
}

void CacheStore::makeRoom() const {
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
        if (all <= kind_.mostBytes)
            break;
        std::error_code gone;
        fs::remove(entry.file, gone);
        all -= entry.size;
    }
}

} // namespace irsg
