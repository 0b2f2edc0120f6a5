#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "irsg/core/Errors.h"
#include "smatcore/selftest/SelfTest.h"

namespace smat::selftest {

// One list a room, in the order in which they are told.
std::vector<SelfTestCheck> radiometryChecks();
std::vector<SelfTestCheck> signatureChecks();
std::vector<SelfTestCheck> atmosphereChecks();
std::vector<SelfTestCheck> surfaceChecks();
std::vector<SelfTestCheck> sceneChecks();
std::vector<SelfTestCheck> samplingChecks();
std::vector<SelfTestCheck> lightChecks();
std::vector<SelfTestCheck> scatteringChecks();

inline constexpr auto relative = SelfTestCheck::Error::relative;
inline constexpr auto absolute = SelfTestCheck::Error::absolute;

/// The checks of a room, and behind them its hard ones.
std::vector<SelfTestCheck> withHard(std::vector<SelfTestCheck> checks,
                                    std::vector<SelfTestCheck> hard);

/// Of several pairs, the one that lies farthest apart.
class Farthest {
  public:
    explicit Farthest(SelfTestCheck::Error error = relative) : kind_(error) {}

    void add(double value, double expected) {
        const double difference = std::abs(value - expected);
        const double error = kind_ == relative ? difference / std::abs(expected) : difference;
        // What is no number is farther than any.
        if (!(error <= worst_)) {
            worst_ = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
            found_ = {value, expected};
        }
    }
    SelfTestValue found() const { return found_; }

  private:
    SelfTestCheck::Error kind_;
    double worst_ = -1.0;
    SelfTestValue found_;
};

/// Of the pairs that a measurement gives for each of these numbers, the one that lies farthest
/// apart.
inline SelfTestValue farthestOf(const std::vector<double>& numbers,
                                const std::function<SelfTestValue(double)>& measure,
                                SelfTestCheck::Error error = relative) {
    Farthest farthest(error);
    for (const double number : numbers) {
        const SelfTestValue pair = measure(number);
        farthest.add(pair.value, pair.expected);
    }
    return farthest.found();
}

/// How many of these calls are refused with an irsg::InputError.
template <typename... Calls>
int refusals(Calls&&... calls) {
    const auto isRefused = [](auto& call) {
        try {
            call();
        } catch (const irsg::InputError&) {
            return 1;
        }
        return 0;
    };
    return (isRefused(calls) + ...);
}

} // namespace smat::selftest
