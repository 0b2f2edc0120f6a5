#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/results/ResultDocument.h"

namespace smat {

/// The folder beside a project that keeps its results: `ship.results` beside `ship.smat`. A result
/// is a few files of one stem, `003-polar`: `003-polar.result` (JSON: title, notes, when and how it
/// was made, and what was asked, as a project of its own) beside the numbers in the program's usual
/// forms, `.json` for tables, `.exr` for an image, `-draws.exr` for the single draws of a Monte
/// Carlo run. Each result stands alone: one that is damaged or gone takes no other with it. The
/// `.result` is written last, so that it never speaks of numbers that are not there.
class ResultFolder {
  public:
    /// Of this project file, which need not exist; `name` is that of the folder where it is not the
    /// usual one.
    explicit ResultFolder(const std::filesystem::path& projectFile, const std::string& name = {});
    /// "ship.results" of "ship.smat".
    static std::string usualName(const std::filesystem::path& projectFile);

    const std::filesystem::path& path() const { return folder_; }
    /// Stems of the results there are, by number; none where there is no folder.
    std::vector<std::string> documents() const;
    bool holds(const std::string& stem) const;

    /// Throws InputError for a result that is damaged, of a newer version, or whose numbers are
    /// gone.
    ResultDocument load(const std::string& stem) const;
    /// Writes a new result under the next free number, at least `number`, and returns its stem.
    /// Throws InputError where it cannot be written.
    std::string save(const ResultDocument& document, int number = 1) const;
    /// Writes title, notes and all else that is no number of one that is there.
    void saveWords(const ResultDocument& document, const std::string& stem) const;
    /// Takes a result away; nothing happens where it is gone. Throws InputError where it stays.
    void remove(const std::string& stem) const;

  private:
    std::filesystem::path file(const std::string& stem, const char* ending) const;
    std::string freeStem(const ResultDocument& document, int number) const;

    std::filesystem::path projectFile_, folder_;
};

} // namespace smat
