#include "irsg/scattering/FinishedBatches.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"

namespace irsg {

namespace {

/// Takes what comes before the next of a separator.
std::string_view taken(std::string_view& text, char separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

std::optional<std::uint64_t> countOf(std::string_view word) {
    std::uint64_t count = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    return error == std::errc{} && stop == word.data() + word.size() ? std::optional(count)
                                                                     : std::nullopt;
}

std::string lineOf(const FinishedBatches::Key& key, const PhotonSums& sums) {
    std::string line = std::to_string(key.first) + ' ' + std::to_string(key.second) + ' ' +
                       std::to_string(sums.photons);
    for (const std::vector<double>* numbers : {&sums.sums, &sums.squares})
        for (const double number : *numbers)
            line += ' ' + numberText(number);
    return line + " .\n";
}

void take(std::string_view line, std::size_t frequencies,
          std::map<FinishedBatches::Key, PhotonSums>& done) {
    const auto depth = countOf(taken(line, ' ')), batch = countOf(taken(line, ' ')),
               photons = countOf(taken(line, ' '));
    if (!depth || !batch || !photons)
        return;
    PhotonSums sums;
    sums.photons = *photons;
    for (std::vector<double>* numbers : {&sums.sums, &sums.squares})
        for (std::size_t i = 0; i < frequencies; ++i) {
            const std::optional<double> number = parseNumber(taken(line, ' '));
            if (!number)
                return;
            numbers->push_back(*number);
        }
    if (line == ".")
        done[{*depth, *batch}] = std::move(sums);
}

} // namespace

FinishedBatches::FinishedBatches(const std::filesystem::path& file, const std::string& recipe,
                                 std::size_t frequencies)
    : done_(read(file, recipe, frequencies)) {
    // Written anew, so that a line cut short is gone before others follow it.
    std::string whole = recipe + "\n";
    for (const auto& [key, sums] : done_)
        whole += lineOf(key, sums);
    writeFileDurably(file, whole);
    out_.open(file, std::ios::app);
    if (!out_)
        throw InputError({file.string(), "", "cannot be written",
                          "a file in a folder that exists and can be written"});
}

std::map<FinishedBatches::Key, PhotonSums> FinishedBatches::read(const std::filesystem::path& file,
                                                                 const std::string& recipe,
                                                                 std::size_t frequencies) {
    std::error_code none;
    if (!std::filesystem::exists(file, none))
        return {};
    const std::string text = readFile(file);
    allowChange(file);
    std::string_view rest = text;
    const std::string_view found = taken(rest, '\n');
    if (!text.empty() && !found.starts_with(firstWords))
        throw InputError({file.string(), "line 1", "something else than batches of photons",
                          "no such file, or what a build that was stopped left there"});
    std::map<Key, PhotonSums> done;
    while (found == recipe && rest.find('\n') != std::string_view::npos)
        take(taken(rest, '\n'), frequencies, done);
    return done;
}

const PhotonSums* FinishedBatches::find(const Key& key) const {
    const auto known = done_.find(key);
    return known == done_.end() ? nullptr : &known->second;
}

void FinishedBatches::keep(const Key& key, const PhotonSums& sums) {
    const std::lock_guard lock(mutex_);
    out_ << lineOf(key, sums) << std::flush;
}

} // namespace irsg
