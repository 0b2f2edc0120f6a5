#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/scene/InteractiveRenderer.h"

namespace smat {

/// What a check found beside what is right.
struct SelfTestValue {
    double value = 0.0, expected = 0.0;
};

/// What checks share: renderers cost time to make.
class SelfTestBench {
  public:
    /// A renderer with default settings, nothing to see and dark air.
    irsg::InteractiveRenderer& irsg();

  private:
    std::unique_ptr<irsg::InteractiveRenderer> irsg_;
};

/// One thing whose answer is known: in closed form, published, or computed by other means.
struct SelfTestCheck {
    enum class Error { relative, absolute };

    std::string name; ///< "scene.sphere-intensity", unique: room and what
    std::string says; ///< what is held against what, with its source
    std::string unit; ///< of the value
    double bound;     ///< of the error, in its kind
    Error error = Error::relative;
    /// Throws irsg::InputError where the machine cannot do it.
    std::function<SelfTestValue(SelfTestBench&)> measure;
    /// One of the hard cases, at the edge of what may be asked; they run on demand.
    bool hard = false;

    /// How far a value lies from the right one; infinite where it is not a number.
    double errorOf(const SelfTestValue& found) const;
};

struct SelfTestResult {
    enum class Outcome { passed, failed, notPossible };

    const SelfTestCheck* check = nullptr;
    Outcome outcome = Outcome::failed;
    SelfTestValue found;
    double error = 0.0, time_s = 0.0;
    std::string remark; ///< why it could not be done, or what broke it
};

struct SelfTestOptions {
    bool hard = false; ///< the hard cases as well
    /// Those whose name holds this text; all where it is empty. Hard ones only with `hard`.
    std::string only;
};

/// All checks by room, from Planck's law to whole scenes: docs/accuracy.md is made of them.
const std::vector<SelfTestCheck>& selfTestChecks();
/// Those of the options, in order.
std::vector<const SelfTestCheck*> selfTestChecks(const SelfTestOptions& options);

/// Runs them one after the other and tells of each as it ends. Ends early on a stop.
std::vector<SelfTestResult> runSelfTest(const SelfTestOptions& options,
                                        const std::function<void(const SelfTestResult&)>& tell = {},
                                        const std::stop_token& stop = {});

/// "passed", "FAILED" or "not possible".
std::string_view name(SelfTestResult::Outcome outcome);
// As a table for people: its head, one line each, and how many there were of each outcome.
std::string selfTestHead();
std::string selfTestLine(const SelfTestResult& result);
std::string selfTestCounts(const std::vector<SelfTestResult>& results);
/// docs/accuracy.md: a table a room of what each check says, found and is bound by.
std::string selfTestPage(const std::vector<SelfTestResult>& results);
/// All of it, with what each check says.
std::string selfTestJson(const std::vector<SelfTestResult>& results);

} // namespace smat
