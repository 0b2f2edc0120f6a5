#include "irsg/sensor/FourierTransform.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Lines that are transformed side by side.
constexpr std::size_t lanes = 8;

/// A transform of one length.
class Plan {
  public:
    Plan(std::size_t size, double sign) : size_(size), sign_(sign), cos_(size), sin_(size) {
        std::size_t rest = size;
        for (const std::size_t factor : {4, 2, 3, 5})
            for (; rest % factor == 0; rest /= factor)
                factors_.push_back(factor);
        if (rest != 1)
            throw LogicError("a transform of " + std::to_string(size) + " points");
        for (std::size_t i = 0; i < size; ++i) {
            const double angle = 2.0 * pi * static_cast<double>(i) / static_cast<double>(size);
            cos_[i] = std::cos(angle);
            sin_[i] = sign * std::sin(angle);
        }
    }

    std::size_t size() const { return size_; }

    struct Lines {
        explicit Lines(std::size_t size) : re(size * lanes), im(size * lanes) {}
        std::vector<double> re, im; ///< the points of a place side by side
    };

    /// Of `lanes` lines; the result is in `lines`.
    void run(Lines& lines, Lines& other) const {
        std::size_t done = 1, left = size_;
        for (const std::size_t factor : factors_) {
            left /= factor;
            for (std::size_t j = 0; j < left; ++j)
                step(lines, other, factor, done, left, j);
            std::swap(lines.re, other.re);
            std::swap(lines.im, other.im);
            done *= factor;
        }
    }

  private:
    /// One group of butterflies: factor inputs, each a run of `done * lanes` numbers.
    void step(const Lines& from, Lines& to, std::size_t factor, std::size_t done, std::size_t left,
              std::size_t j) const {
        const std::size_t run = done * lanes;
        for (std::size_t r = 0; r < factor; ++r) {
            double* const re = &to.re[run * (factor * j + r)];
            double* const im = &to.im[run * (factor * j + r)];
            std::fill_n(re, run, 0.0);
            std::fill_n(im, run, 0.0);
            for (std::size_t s = 0; s < factor; ++s) {
                // exp(i sign 2 pi (r s / factor + r j / (factor left)))
                const std::size_t turn =
                    (r * s * (size_ / factor) + r * j * (size_ / (factor * left))) % size_;
                const double c = cos_[turn], w = sin_[turn];
                const double* const a = &from.re[run * (j + left * s)];
                const double* const b = &from.im[run * (j + left * s)];
                for (std::size_t k = 0; k < run; ++k) {
                    re[k] += a[k] * c - b[k] * w;
                    im[k] += a[k] * w + b[k] * c;
                }
            }
        }
    }

    std::size_t size_;
    double sign_;
    std::vector<double> cos_, sin_;
    std::vector<std::size_t> factors_;
};

/// `count` lines, whose points are `pointStride` apart, `lineStride` from each other.
void transformLines(ComplexPlane& plane, const Plan& plan, std::size_t count,
                    std::size_t lineStride, std::size_t pointStride, double scale) {
    const std::size_t groups = (count + lanes - 1) / lanes;
    parallelFor(groups, [&](std::size_t group) {
        Plan::Lines lines(plan.size()), other(plan.size());
        const std::size_t first = group * lanes, used = std::min(lanes, count - first);
        for (std::size_t i = 0; i < plan.size(); ++i)
            for (std::size_t lane = 0; lane < used; ++lane) {
                const std::size_t at = (first + lane) * lineStride + i * pointStride;
                lines.re[i * lanes + lane] = plane.re[at];
                lines.im[i * lanes + lane] = plane.im[at];
            }
        plan.run(lines, other);
        for (std::size_t i = 0; i < plan.size(); ++i)
            for (std::size_t lane = 0; lane < used; ++lane) {
                const std::size_t at = (first + lane) * lineStride + i * pointStride;
                plane.re[at] = scale * lines.re[i * lanes + lane];
                plane.im[at] = scale * lines.im[i * lanes + lane];
            }
    });
}

void transformPlane(ComplexPlane& plane, double sign, double scale) {
    transformLines(plane, Plan(plane.width, sign), plane.height, plane.width, 1, 1.0);
    transformLines(plane, Plan(plane.height, sign), plane.width, 1, plane.width, scale);
}

} // namespace

std::size_t smoothSize(std::size_t size) {
    for (std::size_t candidate = std::max<std::size_t>(1, size);; ++candidate) {
        std::size_t rest = candidate;
        for (const std::size_t factor : {2, 3, 5})
            while (rest % factor == 0)
                rest /= factor;
        if (rest == 1)
            return candidate;
    }
}

void transform(ComplexPlane& plane) {
    transformPlane(plane, -1.0, 1.0);
}

void transformBack(ComplexPlane& plane) {
    transformPlane(plane, 1.0, 1.0 / static_cast<double>(plane.width * plane.height));
}

} // namespace irsg
