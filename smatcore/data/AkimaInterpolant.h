#pragma once

#include <cstddef>
#include <vector>

namespace smat {

/// Whether samples go all the way round but for a last step: then the first one comes again.
/// `period` > 0, else never.
bool goesRound(const std::vector<double>& x, double period);

/// Akima's piecewise cubic interpolant (J. ACM 17, 589 (1970)), by which the curve of an adaptive
/// sweep is drawn through its cases: the slope at a sample weighs those of both sides by how little
/// the curve bends beyond them, with divided differences in place of differences, so that parabolas
/// are exact however their samples are spaced. Where the truth is smooth it is smooth and several
/// times as near to it as straight lines are, at a kink between two samples half as far off. At one
/// on a sample it is round, by a third of what a straight line may be off at a kink.
class AkimaInterpolant {
  public:
    /// `x` ascends, all is finite, both are equally long (LogicError). With `period` > 0 the curve
    /// goes on from the last sample to the first of the next turn; x spans less than a period then.
    AkimaInterpolant(const std::vector<double>& x, const std::vector<double>& y,
                     double period = 0.0);

    /// At the part 0 to 1 of the way from sample i to the next, which after the last one of a turn
    /// is the first.
    double between(std::size_t i, double part) const;
    /// Anywhere on a turn; else from the first sample to the last one and no farther, NaN beyond.
    double at(double x) const;

  private:
    std::vector<double> x_, y_; ///< of a turn with the first sample again
    std::vector<double> slopes_;
    double period_;
};

} // namespace smat
