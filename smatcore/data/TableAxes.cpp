#include "smatcore/data/TableAxes.h"

#include <bit>
#include <cstdint>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "smatcore/data/ResultDifference.h"

namespace smat {

namespace {

/// Sets of rows that agree in all columns so far.
class RowSets {
  public:
    explicit RowSets(std::size_t rows) : setOf_(rows, 0), count_(rows == 0 ? 0 : 1) {}
    bool areSingle() const { return count_ == setOf_.size(); }
    /// True where rows of one set differ in this column, which parts them.
    bool part(const ResultColumn& column) {
        std::map<std::pair<std::size_t, std::uint64_t>, std::size_t> parts;
        std::vector<std::size_t> next;
        for (std::size_t row = 0; row < setOf_.size(); ++row) {
            // As bits, so that what is no number equals itself; -0 is 0.
            const auto value = std::bit_cast<std::uint64_t>(column.values[row] + 0.0);
            next.push_back(parts.try_emplace({setOf_[row], value}, parts.size()).first->second);
        }
        const bool isParted = parts.size() > count_;
        if (isParted) {
            setOf_ = std::move(next);
            count_ = parts.size();
        }
        return isParted;
    }

  private:
    std::vector<std::size_t> setOf_;
    std::size_t count_;
};

} // namespace

std::vector<const ResultColumn*> axesOf(const ResultTable& table) {
    if (table.columns().empty())
        return {};
    std::vector<const ResultColumn*> axes = {table.find(abscissaKey(table))};
    RowSets sets(table.rowCount());
    sets.part(*axes.front());
    for (const ResultColumn& column : table.columns()) {
        if (sets.areSingle())
            break;
        if (isAbscissa(table, column) && sets.part(column))
            axes.push_back(&column);
    }
    return axes;
}

std::string axisPlace(const ResultColumn& axis, double value, bool isNamed) {
    return fmt::format("{}{:.6g}{}{}", isNamed ? axis.key + " " : "", value,
                       axis.unit.empty() ? "" : " ", axis.unit);
}

std::string rowPlace(const std::vector<const ResultColumn*>& axes, std::size_t row) {
    std::string place;
    for (const ResultColumn* axis : axes)
        place +=
            (place.empty() ? "" : ", ") + axisPlace(*axis, axis->values.at(row), axes.size() > 1);
    return place;
}

} // namespace smat
