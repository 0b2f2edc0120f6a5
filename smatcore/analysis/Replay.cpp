#include "smatcore/analysis/Replay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisOfResult.h"
#include "smatcore/analysis/InputFiles.h"
#include "smatcore/data/TableAxes.h"

namespace smat {
namespace {

constexpr const char *inputKey = "input", *buildRole = "build", *rendererRole = "renderer",
                     *placeRole = "place";

/// Largest difference so far of numbers that come one by one.
class Largest {
  public:
    void add(double a, double b, std::size_t at) {
        if (std::isfinite(a))
            scale_ = std::max(scale_, std::abs(a));
        if (a == b || (std::isnan(a) && std::isnan(b)))
            return;
        const double apart = std::abs(a - b);
        const double size = std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
        if (!at_ || size > largest_) {
            largest_ = size;
            at_ = at;
        }
    }
    template <typename Where>
    void addTo(std::vector<ReplayedDifference>& differences, const std::string& key,
               const std::string& unit, Where where) const {
        if (at_)
            differences.push_back({key, unit, largest_, scale_, where(*at_)});
    }

  private:
    double largest_ = 0.0, scale_ = 0.0;
    std::optional<std::size_t> at_;
};

void compareTables(const ResultTable& a, const ResultTable& b,
                   std::vector<ReplayedDifference>& differences) {
    const std::size_t rows = std::min(a.rowCount(), b.rowCount());
    const std::vector<const ResultColumn*> axes = axesOf(a);
    for (const ResultColumn& column : a.columns()) {
        const ResultColumn* const other = b.find(column.key);
        if (other == nullptr)
            continue;
        Largest largest;
        for (std::size_t i = 0; i < rows; ++i)
            largest.add(column.values[i], other->values[i], i);
        largest.addTo(differences, column.key, column.unit, [&](std::size_t i) {
            return axes.size() > 1 ? rowPlace(axes, i)
                                   : axisPlace(*axes.front(), axes.front()->values[i], true);
        });
    }
}

void compareImages(const irsg::RadianceImage& a, const irsg::RadianceImage& b,
                   std::vector<ReplayedDifference>& differences) {
    for (const irsg::ImageChannel& channel : a.channels) {
        const irsg::ImageChannel* const other = b.find(channel.name);
        if (other == nullptr || other->values.size() != channel.values.size())
            continue;
        Largest largest;
        for (std::size_t i = 0; i < channel.values.size(); ++i)
            largest.add(static_cast<double>(channel.values[i]),
                        static_cast<double>(other->values[i]), i);
        largest.addTo(differences, channel.name, channel.unit, [&](std::size_t i) {
            const auto width = static_cast<std::size_t>(a.width());
            return fmt::format("pixel {},{}", i % width, i / width);
        });
    }
}

std::vector<std::string> mismatchesOf(const AnalysisData& a, const AnalysisData& b) {
    std::vector<std::string> found;
    if (!a.image.empty()) {
        for (const irsg::ImageChannel& channel : a.image.channels)
            if (b.image.find(channel.name) == nullptr)
                found.push_back("channel " + channel.name + " is missing now");
        return found;
    }
    if (a.table.rowCount() != b.table.rowCount())
        found.push_back(
            fmt::format("{} rows then, {} now", a.table.rowCount(), b.table.rowCount()));
    for (const ResultColumn& column : a.table.columns())
        if (b.table.find(column.key) == nullptr)
            found.push_back("column " + column.key + " is missing now");
    for (const ResultColumn& column : b.table.columns())
        if (a.table.find(column.key) == nullptr)
            found.push_back("column " + column.key + " is new");
    return found;
}

/// Values of a key, one by one; of an image they are joined.
std::vector<std::string> valuesOf(const AnalysisData& data, const std::string& wanted) {
    std::vector<std::string> values;
    for (const auto& [key, value] : data.table.provenance.entries) {
        if (key != wanted)
            continue;
        std::size_t first = 0;
        for (;;) {
            const std::size_t end =
                data.image.empty() ? std::string::npos : value.find("; ", first);
            values.push_back(value.substr(first, end == std::string::npos ? end : end - first));
            if (end == std::string::npos)
                break;
            first = end + 2;
        }
    }
    return values;
}

using Inputs = std::map<std::pair<std::string, std::string>, std::string>;

/// What a result says of what it follows from, by role and name.
Inputs inputsOf(const AnalysisData& data) {
    Inputs inputs;
    for (const std::string& value : valuesOf(data, inputKey)) {
        const std::size_t role = value.find(' ') + 1, name = value.find(' ', role) + 1;
        if (role != 0 && name != 0)
            // Two of one name count as one.
            inputs[{value.substr(role, name - role - 1), value.substr(name)}] +=
                value.substr(0, role - 1);
    }
    for (const char* const one : {buildRole, rendererRole})
        for (const std::string& value : valuesOf(data, one))
            inputs[{one, ""}] = value;
    const auto places = valuesOf(data, placeRole);
    for (std::size_t i = 0; i < places.size(); ++i)
        inputs[{placeRole, "of model " + std::to_string(i + 2)}] = places[i];
    return inputs;
}

std::vector<ReplayedInput> comparedInputs(const AnalysisData& then, const AnalysisData& now) {
    std::vector<ReplayedInput> all;
    const Inputs before = inputsOf(then);
    Inputs after = inputsOf(now);
    for (const auto& [key, value] : before) {
        all.push_back({key.first, key.second, value, after[key]});
        after.erase(key);
    }
    for (const auto& [key, value] : after)
        all.push_back({key.first, key.second, "", value});
    return all;
}

/// The inputs that have changed and of which the former file is given.
class FormerFiles {
  public:
    FormerFiles(const std::vector<std::filesystem::path>& files, const AnalysisData& asked,
                const std::vector<ReplayedInput>& inputs) {
        const auto now = inputFilesOf(asked.project, asked.settings, asked.kind);
        for (const std::filesystem::path& file : files) {
            const std::string hash = contentHash(file);
            const auto input = std::ranges::find_if(inputs, [&](const ReplayedInput& one) {
                return one.hasChanged() && one.then == hash;
            });
            if (input == inputs.end())
                throw irsg::InputError(
                    {file.string(), "", hash.empty() ? "no file" : hash,
                     "the content of one of the files that have changed since: " +
                         changed(inputs)});
            const auto found = std::ranges::find_if(now, [&](const InputFile& one) {
                return one.role == input->role && one.file.filename() == input->name;
            });
            if (found == now.end() || !isReplaceable(*found))
                throw irsg::InputError(
                    {file.string(), "", input->role + " " + input->name,
                     "a file that the project itself names; this one lies beside another, where "
                     "it can be put back by hand"});
            files_.push_back({*input, *found, std::filesystem::absolute(file)});
        }
    }

    struct File {
        ReplayedInput input;
        InputFile instead;
        std::filesystem::path former;
    };
    const std::vector<File>& all() const { return files_; }

  private:
    static std::string changed(const std::vector<ReplayedInput>& inputs) {
        std::string names;
        for (const ReplayedInput& input : inputs)
            if (input.hasChanged() && !input.name.empty())
                names += (names.empty() ? "" : ", ") + input.name + " (" + input.then + ")";
        return names.empty() ? "none has" : names;
    }

    std::vector<File> files_;
};

} // namespace

double ReplayedDifference::relative() const {
    return scale > 0.0 ? largest / scale : std::numeric_limits<double>::infinity();
}

double Replay::largestRelative() const {
    return differences.empty() ? 0.0 : differences.front().relative();
}

std::vector<ReplayedDifference> differencesOf(const AnalysisData& a, const AnalysisData& b) {
    std::vector<ReplayedDifference> differences;
    if (!a.image.empty())
        compareImages(a.image, b.image, differences);
    else
        compareTables(a.table, b.table, differences);
    std::ranges::stable_sort(differences, std::greater(), &ReplayedDifference::relative);
    return differences;
}

Replay replay(const AnalysisData& loaded, const std::filesystem::path& file,
              const std::vector<std::filesystem::path>& former, const RunAnalysis& run,
              const std::optional<Project>& project) {
    Replay result;
    std::vector<Project> open;
    if (project)
        open.push_back(*project);
    const AnalysisData asked = analysisOfResult(loaded, file, open, &result.remarks);
    if (project && asked.project.displayName() != project->displayName())
        throw irsg::InputError(
            {file.string(), "project", project->displayName(),
             "the project that the result names: " + asked.project.displayName()});
    result.again = asked;
    run(result.again);
    result.inputs = comparedInputs(loaded, result.again);
    result.differences = differencesOf(loaded, result.again);
    result.mismatches = mismatchesOf(loaded, result.again);

    const FormerFiles files(former, asked, result.inputs);
    for (const ReplayedInput& input : result.inputs)
        if (input.hasChanged())
            result.causes.push_back({input, false, {}});
    if (result.causes.size() == 1) {
        result.causes.front().isKnown = true;
        result.causes.front().effect = result.differences;
        return result;
    }
    for (const FormerFiles::File& one : files.all()) {
        AnalysisData back = asked;
        replaceInput(back.project, back.settings, one.instead, one.former);
        run(back);
        for (ReplayedCause& cause : result.causes)
            if (cause.input.role == one.input.role && cause.input.name == one.input.name) {
                cause.isKnown = true;
                cause.effect = differencesOf(back, result.again);
            }
    }
    // With all of them back, the one that is left has done the rest.
    const auto isUnknown = [](const ReplayedCause& cause) { return !cause.isKnown; };
    if (std::ranges::count_if(result.causes, isUnknown) == 1 && !files.all().empty()) {
        AnalysisData back = asked;
        for (const FormerFiles::File& one : files.all())
            replaceInput(back.project, back.settings, one.instead, one.former);
        run(back);
        ReplayedCause& last = *std::ranges::find_if(result.causes, isUnknown);
        last.isKnown = true;
        last.effect = differencesOf(loaded, back);
    }
    return result;
}

} // namespace smat
