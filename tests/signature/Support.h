#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/signature/SignatureDatabase.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {

using smat::test::TemporaryFolder;

inline std::string readBytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::filesystem::path writeBytes(const std::filesystem::path& file,
                                        const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
}

/// What an action is refused with; a failure and nothing when it is not.
template <typename Action>
std::vector<Diagnostic> refusalOf(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.diagnostics();
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
}

/// A database in which every field, every table and every kind of spectrum is used, with values
/// that have no short decimal form, and in which nothing is wrong.
SignatureDatabase completeDatabase();

} // namespace irsg
