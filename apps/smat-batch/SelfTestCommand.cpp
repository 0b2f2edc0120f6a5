#include <algorithm>

#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "smatcore/selftest/SelfTest.h"

namespace smat::batch {
namespace {

/// `smat-batch selftest [--hard] [--only TEXT]`.
class SelfTestCommand {
  public:
    explicit SelfTestCommand(CLI::App& command) {
        command.add_flag("--hard", options_.hard, "The hard cases as well");
        command.add_flag("--page", isPage_, "As docs/accuracy.md has it");
        command.add_option("--only", options_.only, "Checks whose name holds this text");
    }

    int run(Context& context) const {
        if (selfTestChecks(options_).empty())
            throw refusal("--only", "'" + options_.only + "'",
                          "a part of the name of a check, as scene or planck");
        const StageTimer::Scope scope(&context.timer, "checks");
        const bool isTable = !context.json && !isPage_;
        if (isTable)
            fmt::print("{}", selfTestHead());
        const auto results = runSelfTest(options_, [&](const SelfTestResult& result) {
            if (isTable)
                fmt::print("{}", selfTestLine(result));
        });
        fmt::print("{}", context.json ? selfTestJson(results) + "\n"
                         : isPage_    ? selfTestPage(results)
                                      : selfTestCounts(results));
        const bool failed = std::ranges::any_of(results, [](const SelfTestResult& result) {
            return result.outcome == SelfTestResult::Outcome::failed;
        });
        return failed ? refused : done;
    }

  private:
    SelfTestOptions options_;
    bool isPage_ = false;
};

} // namespace

void addSelfTestCommand(CLI::App& app, Context& context) {
    addCommand<SelfTestCommand>(
        app, context, "selftest",
        "Holds what is computed on this machine against closed forms and published numbers");
}

} // namespace smat::batch
