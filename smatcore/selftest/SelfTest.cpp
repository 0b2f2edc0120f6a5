#include "smatcore/selftest/SelfTest.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/reference/Scenes.h"
#include "smatcore/selftest/Checks.h"

namespace smat {
namespace {

using Outcome = SelfTestResult::Outcome;

SelfTestResult resultOf(const SelfTestCheck& check, SelfTestBench& bench) {
    SelfTestResult result;
    result.check = &check;
    const auto start = std::chrono::steady_clock::now();
    try {
        result.found = check.measure(bench);
        result.error = check.errorOf(result.found);
        result.outcome = result.error <= check.bound ? Outcome::passed : Outcome::failed;
    } catch (const irsg::InputError& error) {
        result.outcome = Outcome::notPossible;
        result.remark = error.what();
    } catch (const std::exception& error) {
        result.remark = error.what();
        result.error = std::numeric_limits<double>::infinity();
    }
    result.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

std::size_t countOf(const std::vector<SelfTestResult>& results, Outcome outcome) {
    return static_cast<std::size_t>(std::ranges::count(results, outcome, &SelfTestResult::outcome));
}

} // namespace

std::vector<SelfTestCheck> selftest::withHard(std::vector<SelfTestCheck> checks,
                                              std::vector<SelfTestCheck> hard) {
    for (SelfTestCheck& check : hard) {
        check.hard = true;
        checks.push_back(std::move(check));
    }
    return checks;
}

irsg::InteractiveRenderer& SelfTestBench::irsg() {
    if (!irsg_)
        irsg_ = std::make_unique<irsg::InteractiveRenderer>();
    irsg_->scene.environment =
        irsg::reference::environmentOf(irsg::reference::ConstantAtmosphere{});
    irsg_->scene.entities = {};
    irsg_->scene.skybox = nullptr;
    irsg_->scene.terrain = nullptr;
    irsg_->scene.settings = irsg::RenderSettings::direct();
    return *irsg_;
}

double SelfTestCheck::errorOf(const SelfTestValue& found) const {
    const double difference = std::abs(found.value - found.expected);
    const double size =
        error == Error::relative ? difference / std::abs(found.expected) : difference;
    return std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
}

const std::vector<SelfTestCheck>& selfTestChecks() {
    static const std::vector<SelfTestCheck> all = [] {
        std::vector<SelfTestCheck> checks;
        for (auto room :
             {selftest::radiometryChecks, selftest::signatureChecks, selftest::atmosphereChecks,
              selftest::surfaceChecks, selftest::sceneChecks, selftest::samplingChecks,
              selftest::lightChecks, selftest::scatteringChecks})
            for (SelfTestCheck& check : room())
                checks.push_back(std::move(check));
        return checks;
    }();
    return all;
}

std::vector<const SelfTestCheck*> selfTestChecks(const SelfTestOptions& options) {
    std::vector<const SelfTestCheck*> chosen;
    for (const SelfTestCheck& check : selfTestChecks())
        if ((options.hard || !check.hard) && check.name.find(options.only) != std::string::npos)
            chosen.push_back(&check);
    return chosen;
}

std::vector<SelfTestResult> runSelfTest(const SelfTestOptions& options,
                                        const std::function<void(const SelfTestResult&)>& tell,
                                        const std::stop_token& stop) {
    SelfTestBench bench;
    std::vector<SelfTestResult> results;
    for (const SelfTestCheck* check : selfTestChecks(options)) {
        if (stop.stop_requested())
            break;
        results.push_back(resultOf(*check, bench));
        if (tell)
            tell(results.back());
    }
    return results;
}

std::string_view name(Outcome outcome) {
    switch (outcome) {
    case Outcome::passed:
        return "passed";
    case Outcome::notPossible:
        return "not possible";
    default:
        return "FAILED";
    }
}

std::string selfTestLine(const SelfTestResult& result) {
    const SelfTestCheck& check = *result.check;
    std::string line = fmt::format("{:12} {:38} ", name(result.outcome), check.name);
    if (result.outcome == Outcome::notPossible || !result.remark.empty())
        return line + result.remark + "\n";
    return line +
           fmt::format("{:>14.8g} {:>14.8g} {:14} {:>9.1e} {:>9.1e} {:9} {:>8.3f}\n",
                       result.found.value, result.found.expected, check.unit, result.error,
                       check.bound,
                       check.error == SelfTestCheck::Error::relative ? "relative" : "absolute",
                       result.time_s);
}

std::string selfTestHead() {
    return fmt::format("{:12} {:38} {:>14} {:>14} {:14} {:>9} {:>9} {:9} {:>8}\n", "", "check",
                       "value", "expected", "unit", "error", "bound", "", "time [s]");
}

std::string selfTestCounts(const std::vector<SelfTestResult>& results) {
    return fmt::format("{} checks: {} passed, {} failed, {} not possible here\n", results.size(),
                       countOf(results, Outcome::passed), countOf(results, Outcome::failed),
                       countOf(results, Outcome::notPossible));
}

std::string selfTestPage(const std::vector<SelfTestResult>& results) {
    std::string page =
        "# Known answers\n\n"
        "Made by `smat-batch selftest --hard --page > docs/accuracy.md`, from the catalogue that "
        "[the self-test](selftest.md) runs on any machine:\n"
        "closed forms, published numbers, and independent calculations. *Found* are the results of "
        "this page's machine (Mesa's llvmpipe).\n"
        "Other pages have the [accuracy and cost of sampling](accuracy-sampling.md) and [of the "
        "atmosphere](atmosphere-accuracy.md).\n";
    std::string room;
    for (const SelfTestResult& result : results) {
        const SelfTestCheck& check = *result.check;
        const std::string own = check.name.substr(0, check.name.find('.'));
        if (own != room) {
            room = own;
            page += "\n## " + room +
                    "\n\n| check | comparison | found | known | unit | error | "
                    "bound |\n|---|---|---|---|---|---|---|\n";
        }
        const bool isRelative = check.error == SelfTestCheck::Error::relative;
        page += fmt::format("| {}{} | {} | ", check.name.substr(own.size() + 1),
                            check.hard ? " (hard)" : "", check.says);
        page += result.remark.empty()
                    ? fmt::format("{:.8g} | {:.8g} | {} | {:.1e}", result.found.value,
                                  result.found.expected, check.unit, result.error)
                    : fmt::format("{} | | {} | ", result.remark, check.unit);
        page += fmt::format(" | {:.1e} {} |\n", check.bound, isRelative ? "relative" : "absolute");
    }
    return page;
}

std::string selfTestJson(const std::vector<SelfTestResult>& results) {
    nlohmann::ordered_json checks = nlohmann::ordered_json::array();
    for (const SelfTestResult& result : results) {
        nlohmann::ordered_json one{{"check", result.check->name},
                                   {"says", result.check->says},
                                   {"outcome", name(result.outcome)},
                                   {"time_s", result.time_s}};
        if (result.remark.empty()) {
            one["value"] = result.found.value;
            one["expected"] = result.found.expected;
            one["unit"] = result.check->unit;
            one["error"] = result.error;
            one["bound"] = result.check->bound;
            one["kind"] =
                result.check->error == SelfTestCheck::Error::relative ? "relative" : "absolute";
        } else {
            one["remark"] = result.remark;
        }
        checks.push_back(std::move(one));
    }
    return nlohmann::ordered_json{{"checks", std::move(checks)},
                                  {"passed", countOf(results, Outcome::passed)},
                                  {"failed", countOf(results, Outcome::failed)},
                                  {"not_possible", countOf(results, Outcome::notPossible)}}
        .dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace smat
