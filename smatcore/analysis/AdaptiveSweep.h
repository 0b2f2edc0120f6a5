#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/data/ResultTable.h"

namespace smat {

/// Puts more cases into a sweep where its curves bend, until straight lines between its cases are
/// within `AnalysisPlan::largestBend` of them: intensity, contrast, irradiance and intensity of the
/// source of all objects, in every band, as a part of what they are there or of a tenth of the
/// largest of the curve.
///
/// Between two cases a curve departs from the straight line by h^2 / 8 |y''|, with the larger
/// second difference of both, or, where it bends otherwise than beside, by that of a kink, h / 4
/// times what its slope changes by. Where it is too much their middle becomes a case, down to the
/// least step of the axis; differences within the stated errors are no bend. What lies wholly
/// between two cases of the first steps is not seen. Where several axes are refined, each is so at
/// all places of the others, so that their grid stays one. With `AnalysisPlan::mostRefined` cases
/// go to the worst intervals first.
class AdaptiveSweep {
  public:
    /// `columns` are those of the result.
    AdaptiveSweep(const AnalysisPlan& plan, const ResultTable& columns);

    /// What a case came to; returns the place of its row among those added so far.
    std::size_t add(const std::vector<double>& row);
    /// The next cases, in their order; none where the curves are known well enough.
    std::vector<AnalysisCase> next();
    /// "adaptive steps: 72 + 46 cases, straight lines between which are within 0.91 % of the
    /// curves", and where they are not.
    std::string sentence() const;

  private:
    using Place = std::vector<double>; ///< the coordinates of a case
    Place placeOf(const AnalysisCase& one) const;
    void setOrder(const std::vector<AnalysisCase>& all);
    /// An interval that bends too much.
    struct Bent {
        std::size_t interval = 0;
        double part = 0.0;   ///< of the curve, by which it may be off
        double excess = 0.0; ///< that in terms of what is allowed
    };
    std::vector<Bent> bent(std::size_t axis);
    void chooseWorst(std::vector<Bent>& found) const;
    double bendOf(const std::vector<const std::vector<double>*>& curve, std::size_t column,
                  std::size_t interval, std::size_t axis) const;

    const AnalysisPlan& plan_;
    std::vector<RefinedAxis> axes_;
    struct Curve {
        std::size_t column, error; ///< `error` is that of the column, or it again
    };
    std::vector<Curve> curves_;
    std::size_t coordinates_ = 0, first_ = 0;
    std::map<Place, std::vector<double>> rows_;
    std::map<Place, std::size_t> order_;
    std::vector<std::size_t> known_; ///< places in the order of those that were added, ascending
    double bend_ = 0.0;              ///< largest that was left, where it could be refined
    std::size_t steps_ = 0;          ///< intervals of the least step that still bend
    bool hasTooMany_ = false;
    bool isFull_ = false; ///< `mostRefined` are there
};

} // namespace smat
