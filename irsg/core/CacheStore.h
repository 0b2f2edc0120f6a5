#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace irsg {

/// Tells contents apart that come piece by piece. No guard against anybody who wants two of them
/// to be alike.
class ContentDigest {
  public:
    ContentDigest& add(std::span<const std::byte> bytes);
    /// 32 hexadecimal digits.
    std::string text() const;

  private:
    std::array<std::uint64_t, 2> hashes_{0xcbf29ce484222325ULL, 0x84222325cbf29ce4ULL};
};

/// Text that tells what something was made of, number by number to the last bit.
class CacheKey {
  public:
    CacheKey& add(double value);
    CacheKey& add(const std::string& text);
    /// How many numbers there are, and each.
    CacheKey& add(std::span<const double> numbers);
    /// Many numbers by a digest of their bits.
    CacheKey& addDigest(std::span<const double> numbers);
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// Results of one kind that take long to make, kept in a folder so that the next program need not
/// make them: an entry is found by everything that it depends on, which it holds itself, and is in
/// place as a whole or not at all, whoever is killed and however many programs share the folder.
/// What is damaged is as if it were not there. At most `mostBytes` are kept; those that were not
/// used for the longest time go first.
class CacheStore {
  public:
    /// What is kept: its folder below that of the user, and how much of it.
    struct Kind {
        std::string name;
        std::uintmax_t mostBytes;
    };

    CacheStore(std::filesystem::path folder, Kind kind);
    /// That of the user: $SMAT_CACHE/NAME (nowhere if SMAT_CACHE is empty), else
    /// $XDG_CACHE_HOME/smat/NAME, else ~/.cache/smat/NAME.
    static std::optional<CacheStore> ofUser(const Kind& kind);

    std::optional<std::string> find(const std::string& key) const;
    /// Nothing happens where the folder cannot be written, or the content takes more than a quarter
    /// of the room: the next program makes it again.
    void keep(const std::string& key, std::string_view content) const;

  private:
    std::filesystem::path fileOf(const std::string& key) const;
    void makeRoom() const;

    std::filesystem::path folder_;
    Kind kind_;
};

} // namespace irsg
