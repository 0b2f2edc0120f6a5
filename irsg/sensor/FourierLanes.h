#pragma once

#include <cstddef>
#include <vector>

namespace irsg {

/// One-dimensional discrete Fourier transforms of one length, sum of f exp(-2 pi i k x / size), of
/// `lanes` lines at once: the sums of neighbouring lines are the same, so the compiler makes
/// vectors of them. Stockham's scheme with radix 4, 2, 3 and 5, other prime factors by their
/// definition. Real: float or double.
template <typename Real>
class FourierLanes {
  public:
    static constexpr std::size_t lanes = 16;

    /// Number x of line l stands at x * lanes + l.
    struct Lines {
        explicit Lines(std::size_t size) : real(size * lanes), imaginary(size * lanes) {}
        std::vector<Real> real, imaginary;
    };

    /// Of at least 1 number.
    explicit FourierLanes(std::size_t size);

    /// Replaces lines by their transforms; `scratch` is of the same size. It may be called by
    /// several threads at once.
    void transform(Lines& lines, Lines& scratch) const { run(lines, scratch, false); }
    /// By exp(+2 pi i k x / size), without a factor 1 / size.
    void transformBack(Lines& lines, Lines& scratch) const { run(lines, scratch, true); }

  private:
    /// Number j of a sum of `radix` numbers at `groups` places is turned by turns[place * (radix -
    /// 1) + j - 1].
    struct Stage {
        std::size_t radix, groups, stride;
        std::vector<Real> cosines, sines;
    };
    void run(Lines& lines, Lines& scratch, bool isBack) const;

    std::vector<Stage> stages_;
};

extern template class FourierLanes<float>;
extern template class FourierLanes<double>;

} // namespace irsg
