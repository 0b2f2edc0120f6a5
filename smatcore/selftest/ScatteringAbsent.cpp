#include "smatcore/selftest/Checks.h"

namespace smat::selftest {

std::vector<SelfTestCheck> scatteringChecks() {
    return {};
}

} // namespace smat::selftest
