#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "smatcore/analysis/AnalysisData.h"

namespace smat {
struct JobControl;
}

namespace smat::batch {

/// Options of a command that hold numbers, read as numbers are read everywhere else, so that a word
/// in the place of a number is refused with the name of its option.
class NumberOptions {
  public:
    explicit NumberOptions(CLI::App& command) : command_(command) {}

    void add(const std::string& option, const std::string& unit, const std::string& help);
    /// No value where the option was not given.
    std::optional<double> value(const std::string& option) const;
    /// Or `otherwise` where it was not given. Throws InputError for one that is not above 0;
    /// `expected` says what is.
    double positive(const std::string& option, double otherwise,
                    const char* expected = "a number above 0") const;
    /// The whole number of an option, or what is there where it was not given. Throws InputError
    /// for one that is not whole, or not from `least` to `most`.
    template <std::integral Number>
    void takeWhole(const std::string& option, Number& number, double least = 0.0,
                   double most = 1e9) const {
        if (const auto given = wholeNumber(option, least, most))
            number = static_cast<Number>(*given);
    }
    /// Throws InputError naming every option that holds no finite number.
    void check() const;

  private:
    std::optional<double> wholeNumber(const std::string& option, double least, double most) const;

    CLI::App& command_;
    std::map<std::string, std::string> texts_; ///< the parser keeps pointers into it
};

/// What the text of an option lists between commas, without blanks at the ends.
std::vector<std::string> wordsOf(const std::string& text);

/// The numbers of at least 0 that the text of an option lists, separated by commas. Throws
/// InputError naming the option.
std::vector<double> numbersOf(const char* option, const std::string& text);

/// The files a table goes to: `--out`, at least one, each .csv or .json.
class TableFiles {
  public:
    explicit TableFiles(CLI::App& command);

    /// Throws InputError for no file, unless the table is printed as JSON, and for an extension
    /// that is none of a table.
    void check(const std::string& example, bool isPrinted) const;
    bool isGiven() const { return !files_.empty(); }
    /// Throws InputError with all files that could not be written.
    void checkWritable() const;
    /// The same control, under which that is done when a scene is built: inputs are known by then.
    JobControl checkedOn(JobControl control) const;
    /// Saves, what is not complete beside a result that is (placeOfPartial), then prints a summary
    /// for people, or all numbers as JSON. `kind` is the command.
    void write(const std::string& kind, const ResultTable& table,
               const std::vector<SummaryItem>& summary, const std::vector<std::string>& warnings,
               bool json, bool isComplete = true) const;

  private:
    std::vector<std::string> files_;
};

} // namespace smat::batch
