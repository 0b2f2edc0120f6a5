#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// Text that tells what something was made of, number by number to the last bit.
class CkKey {
  public:
    CkKey& add(double value);
    CkKey& add(const std::string& text);
    /// Its nodes and values; a constant has a value and no wavelength.
    CkKey& add(const Spectrum& spectrum);
    /// Many numbers by a digest of their bits.
    CkKey& addDigest(std::span<const double> numbers);
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// Wideband quadrature points that were trained once, kept in a folder so that the next program
/// need not train them: an entry is found by everything that its training depended on, which it
/// holds itself, and is in place as a whole or not at all, whoever is killed and however many
/// programs share the folder. What is damaged is as if it were not there. At most `mostBytes` are
/// kept; those that were not used for the longest time go first.
class CkStore {
  public:
    static constexpr std::uintmax_t mostBytes = std::uintmax_t{32} << 20;

    explicit CkStore(std::filesystem::path folder, std::uintmax_t bytes = mostBytes);
    /// That of the user: $SMAT_CACHE/wideband (nowhere if SMAT_CACHE is empty), else
    /// $XDG_CACHE_HOME/smat/wideband, else ~/.cache/smat/wideband.
    static std::optional<CkStore> ofUser();

    std::optional<std::string> find(const std::string& key) const;
    /// Nothing happens where the folder cannot be written: the next program trains again.
    void keep(const std::string& key, const std::string& content) const;

  private:
    std::filesystem::path fileOf(const std::string& key) const;
    void makeRoom() const;

    std::filesystem::path folder_;
    std::uintmax_t bytes_;
};

} // namespace irsg
