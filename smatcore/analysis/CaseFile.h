#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/CaseStore.h"

namespace smat {

/// Part `part` of `parts`, from 1: which cases of a sweep it draws. Cases that follow each other
/// share drawings and air, so that a part has runs of them, from all over the sweep.
struct CaseShare {
    std::size_t part = 1, parts = 1;

    bool has(std::size_t i, std::size_t cases) const;
    /// The part, from 1, that a case below `cases` belongs to.
    std::size_t partOf(std::size_t i, std::size_t cases) const;
    bool isAll() const { return parts == 1; }
    /// "2/4". Throws InputError naming `option`.
    static CaseShare fromText(std::string_view text, const std::string& option);
    bool operator==(const CaseShare&) const = default;
};

/// The cases of a sweep that one run has done, on disk, so that another can go on after a kill and
/// parts can be joined. Lines of JSON: what the result says of itself, then a case a line, each
/// written as soon as it is done. A last line that was cut off counts for nothing.
class CaseFile : public CaseStore {
  public:
    struct Options {
        CaseShare share;
        bool resumes = false; ///< goes on with what the file holds, if it is there
        /// Files and their contents that the cases follow from (inputHashes()).
        std::map<std::string, std::string> inputs;
        /// The file is not begun before so much time has passed, s.
        double waits_s = 0.0;
    };
    /// Reads what there is. Throws InputError for a file that is damaged before its end.
    CaseFile(std::filesystem::path file, Options options);

    /// Where the cases of a result go: "table.csv.cases", or "table.csv.part2of4".
    static std::filesystem::path besides(const std::filesystem::path& result,
                                         const CaseShare& share);

    /// Throws InputError where the file holds cases of other inputs, settings or programs. A file
    /// that is not gone on with is kept beside as FILE.old.
    void begin(const AnalysisData& data, std::size_t cases) override;
    void rehearse(const AnalysisData& data, std::size_t cases) override;
    /// What another process that draws of the same sweep says of it (headText). Throws InputError
    /// where it is of other inputs, settings or programs; `who` it is.
    void checkSameSweep(const std::string& head, const std::string& who) const;
    const CaseRecord* known(std::size_t i) const override;
    bool isMine(std::size_t i) const override { return options_.share.has(i, cases_); }
    void add(std::size_t i, const CaseRecord& record) override;

    /// Writes what was held back.
    void flush();
    /// Takes the file away again, once the result is saved, and what was set aside for it.
    void remove();
    const std::filesystem::path& file() const { return file_; }

    /// What a result says of itself before its first case, and a case: a line each.
    static std::string headText(const AnalysisData& data, std::size_t cases,
                                const Options& options);
    static std::string recordText(std::size_t i, const CaseRecord& record);
    static std::pair<std::size_t, CaseRecord> recordFrom(const std::string& text,
                                                         const std::string& who);
    /// True where begin() set cases of an earlier run aside, and they are still there.
    bool keptOld() const { return keptOld_; }
    /// Where it did, the sentence that says so of these, "cases".
    std::vector<std::string> remarksOn(const std::string& cases) const;

  private:
    std::filesystem::path oldFile() const;
    void checkResumed(const std::string& head) const;
    void write(const std::string& line);

    std::filesystem::path file_;
    Options options_;
    std::size_t cases_ = 0;
    std::string head_, pending_;
    std::map<std::size_t, CaseRecord> known_;
    std::vector<std::string> lastAnswers_;
    std::uintmax_t whole_B_ = 0; ///< of the file, up to its last whole line
    bool existed_ = false, keptOld_ = false;
    std::ofstream out_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Joins the files of all parts of a sweep, in any order, to the result of one run: the same bytes
/// but for the command. Throws InputError naming what is missing, twice there and different, or of
/// another sweep.
AnalysisData joinedCases(const std::vector<std::filesystem::path>& files);

/// SHA-256 of the files that were read since irsg::protectInputs(), by name.
std::map<std::string, std::string> inputHashes();

} // namespace smat
