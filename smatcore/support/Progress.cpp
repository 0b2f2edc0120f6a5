#include "smatcore/support/Progress.h"

namespace smat {

std::optional<double> Progress::remaining_s() const {
    if (done == 0 || total < done)
        return std::nullopt;
    return elapsed_s / static_cast<double>(done) * static_cast<double>(total - done);
}

} // namespace smat
