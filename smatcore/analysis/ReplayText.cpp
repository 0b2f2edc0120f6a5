#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "smatcore/analysis/Replay.h"

namespace smat {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string nameOf(const ReplayedInput& input) {
    return input.role + (input.name.empty() ? "" : " ") + input.name;
}

std::string inputLine(const ReplayedInput& input) {
    const char* const state = input.hasChanged()        ? "changed"
                              : input.then.empty()      ? "not told"
                              : input.then == input.now ? "same"
                                                        : "gone";
    std::string line = fmt::format("  {:<9} {}", state, nameOf(input));
    if (input.hasChanged())
        line += fmt::format(": {}, now {}", input.then, input.now.empty() ? "gone" : input.now);
    return line + "\n";
}

std::string differenceLine(const ReplayedDifference& difference) {
    const std::string unit = difference.unit.empty() ? "" : " " + difference.unit;
    std::string line = fmt::format("  {:<28} {:.6g}{}", difference.key, difference.largest, unit);
    if (std::isfinite(difference.relative()))
        line += fmt::format(", {:.3g} % of the largest value", 100.0 * difference.relative());
    return line + ", at " + difference.where + "\n";
}

std::string causeText(const ReplayedCause& cause) {
    if (!cause.isKnown)
        return fmt::format("  {}: not told apart; --previous FILE gives the file as it was\n",
                           nameOf(cause.input));
    if (cause.effect.empty())
        return fmt::format("  {}: changes nothing\n", nameOf(cause.input));
    std::string text = fmt::format("  {}:\n", nameOf(cause.input));
    for (const ReplayedDifference& difference : cause.effect)
        text += "  " + differenceLine(difference);
    return text;
}

/// Infinities, which JSON has not, are null.
OrderedJson numberJson(double value) {
    return std::isfinite(value) ? OrderedJson(value) : OrderedJson();
}

OrderedJson differencesJson(const std::vector<ReplayedDifference>& differences) {
    OrderedJson list = OrderedJson::array();
    for (const ReplayedDifference& difference : differences)
        list.push_back({{"name", difference.key},
                        {"unit", difference.unit},
                        {"largest_difference", numberJson(difference.largest)},
                        {"relative", numberJson(difference.relative())},
                        {"at", difference.where}});
    return list;
}

OrderedJson inputJson(const ReplayedInput& input) {
    return {{"role", input.role},
            {"name", input.name},
            {"then", input.then},
            {"now", input.now},
            {"changed", input.hasChanged()}};
}

} // namespace

std::string replayText(const Replay& replay, const std::string& file) {
    std::string text = fmt::format("{}: {} of {}, run again\n", file, name(replay.again.kind),
                                   replay.again.project.displayName());
    for (const ReplayedInput& input : replay.inputs)
        text += inputLine(input);
    for (const std::string& mismatch : replay.mismatches)
        text += mismatch + "\n";
    if (replay.isSame())
        return text + "Every number is the same.\n";
    if (!replay.differences.empty())
        text += "Largest differences:\n";
    for (const ReplayedDifference& difference : replay.differences)
        text += differenceLine(difference);
    if (replay.causes.empty())
        return text + "No cause is known: none of the recorded inputs has changed.\n";
    text += "By cause:\n";
    for (const ReplayedCause& cause : replay.causes)
        text += causeText(cause);
    return text;
}

std::string replayJson(const Replay& replay, const std::string& file) {
    OrderedJson json{{"result", file},
                     {"analysis", name(replay.again.kind)},
                     {"project", replay.again.project.displayName()},
                     {"same", replay.isSame()}};
    json["inputs"] = OrderedJson::array();
    for (const ReplayedInput& input : replay.inputs)
        json["inputs"].push_back(inputJson(input));
    json["mismatches"] = replay.mismatches;
    json["differences"] = differencesJson(replay.differences);
    json["causes"] = OrderedJson::array();
    for (const ReplayedCause& cause : replay.causes) {
        OrderedJson one = inputJson(cause.input);
        one["told_apart"] = cause.isKnown;
        one["effect"] = differencesJson(cause.effect);
        json["causes"].push_back(std::move(one));
    }
    return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace);
}

} // namespace smat
