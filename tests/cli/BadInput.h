#pragma once

#include <functional>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Program.h"

namespace smat::test {

using Folder = std::filesystem::path;
using Words = std::vector<std::string>;

/// One bad input: what is written into the folder, how the program is called from there, and what
/// its complaint must name.
struct BadRow {
    const char* name;
    std::function<void(const Folder&)> prepare;
    Words arguments;
    Words named; ///< place, value and expectation: each must be in one line of standard error
};

void PrintTo(const BadRow& row, std::ostream* out);
std::string nameOf(const testing::TestParamInfo<BadRow>& row);

/// Each subject has a file of rows; the test of them all is in BadInput.cpp.
class BadInput : public testing::TestWithParam<BadRow> {};

void nothing(const Folder& folder);
/// A project file of this text.
std::function<void(const Folder&)> project(const std::string& json);
/// A project that is right but for what `more` adds to or puts in place of its parts.
std::string good(const std::string& more = "");
/// A file of this content beside a good project.
std::function<void(const Folder&)> file(const std::string& name, const std::string& content);
/// The first bytes of a sample's file.
std::function<void(const Folder&)> cut(const std::string& from, std::size_t bytes,
                                       const std::string& name);
/// A sample's file with some bytes written over.
std::function<void(const Folder&)> patched(const std::string& from, std::size_t at,
                                           const std::string& bytes, const std::string& name);

/// `first` with `more` behind it.
Words with(Words first, const Words& more);
/// An image of the good project.
Words imageWith(const Words& more = {});

/// The first line of a table of air.
inline const std::string atmosphereHead = "wavelength [um],extinction [km-1]\n";

} // namespace smat::test
