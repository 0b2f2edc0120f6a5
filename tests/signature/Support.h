#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "irsg/radiometry/Errors.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// A folder of the running test alone, removed behind it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = "smat_" + std::string(test->test_suite_name()) + "_" + test->name() +
                           "_" + std::to_string(getpid());
        for (char& c : name) {
            c = c == '/' ? '_' : c;
        }
        path_ = std::filesystem::temp_directory_path() / name;
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path file(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

inline std::string readBytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::filesystem::path writeBytes(const std::filesystem::path& file,
                                        const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
}

/// The folder of shared material; it may be absent.
inline std::filesystem::path sharedFolder() {
    const char* const named = std::getenv("SMAT_SHARED");
    return named != nullptr ? std::filesystem::path(named)
                            : std::filesystem::path(SMAT_SOURCE_DIR) / ".." / "shared";
}

/// What an action is refused with; a failure and nothing when it is not.
template <typename Action>
std::vector<Offence> refusalOf(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.offences();
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}

/// A database in which every field, every table and every kind of spectrum is used, with values
/// that have no short decimal form, and in which nothing is wrong.
SignatureDatabase completeDatabase();

} // namespace irsg
