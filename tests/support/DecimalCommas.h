#pragma once

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace smat::test {

/// A locale whose numbers have commas, for as long as the object lives: made from the system's
/// definitions, which the package "locales" brings, whether or not the system has it ready.
class DecimalCommas {
  public:
    /// `name` without its encoding ("de_DE"); the locale is made in `folder`.
    DecimalCommas(const std::string& name, const std::filesystem::path& folder)
        : before_(std::setlocale(LC_ALL, nullptr)) {
        const std::string full = name + ".UTF-8";
        std::filesystem::create_directories(folder / "locales");
        const std::string make = "localedef -i " + name + " -f UTF-8 '" +
                                 (folder / "locales" / full).string() + "' >/dev/null 2>&1";
        static_cast<void>(std::system(make.c_str()));
        setenv("LOCPATH", (folder / "locales").c_str(), 1);
        setenv("LC_ALL", full.c_str(), 1);
        there_ = std::setlocale(LC_ALL, full.c_str()) != nullptr &&
                 std::string(std::localeconv()->decimal_point) == ",";
    }
    ~DecimalCommas() {
        std::setlocale(LC_ALL, before_.c_str());
        unsetenv("LOCPATH");
        unsetenv("LC_ALL");
    }
    DecimalCommas(const DecimalCommas&) = delete;
    DecimalCommas& operator=(const DecimalCommas&) = delete;

    bool isThere() const { return there_; }

  private:
    std::string before_;
    bool there_ = false;
};

} // namespace smat::test
