#include "smatcore/support/Progress.h"

#include <fmt/format.h>

namespace smat {

std::optional<double> Progress::remaining_s() const {
    if (done == 0 || total < done)
        return std::nullopt;
    return elapsed_s / static_cast<double>(done) * static_cast<double>(total - done);
}

std::string Progress::text(const std::string& stage) const {
    std::string line = fmt::format("{}  {}/{}  {:.0f} %  {:.1f} s", what, done, total,
                                   100.0 * fraction(), elapsed_s);
    if (const auto left_s = remaining_s())
        line += fmt::format(", {:.0f} s left", *left_s);
    return stage.empty() ? line : line + "  " + stage;
}

} // namespace smat
