#include "irsg/sensor/PupilTransfer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

using enum PupilShape;

/// The autocorrelation of a pupil by its definition: a sum over a fine grid in two dimensions.
double byGrid(PupilShape shape, double obscuration, double waves, double shiftX, double shiftY) {
    const auto isInside = [&](double x, double y) {
        const double radius = std::hypot(x, y);
        return shape == square ? std::max(std::abs(x), std::abs(y)) < 1.0
                               : radius < 1.0 && radius >= obscuration;
    };
    constexpr int steps = 1500;
    double sum = 0.0, area = 0.0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double x = 4.0 * (i + 0.5) / steps - 2.0, y = 4.0 * (j + 0.5) / steps - 2.0;
            if (isInside(x, y)) {
                area += 1.0;
            }
            const double ax = x + 0.5 * shiftX, ay = y + 0.5 * shiftY;
            const double bx = x - 0.5 * shiftX, by = y - 0.5 * shiftY;
            if (isInside(ax, ay) && isInside(bx, by)) {
                sum += std::cos(2.0 * pi * waves * (ax * ax + ay * ay - bx * bx - by * by));
            }
        }
    }
    return sum / area;
}

TEST(PupilTransfer, AClearCircleHasItsClosedForm) {
    for (const double shift : {0.0, 0.1, 0.5, 1.0, 1.5, 1.9, 1.999}) {
        const double u = 0.5 * shift;
        const double expected = 2.0 / pi * (std::acos(u) - u * std::sqrt(1.0 - u * u));
        EXPECT_NEAR(pupilTransfer(circular, 0.0, 0.0, shift, 0.0), expected, 1e-12) << shift;
        // The integral that defocus is computed by, without any.
        EXPECT_NEAR(pupilTransfer(circular, 0.0, 1e-9, 0.0, shift), expected, 1e-9) << shift;
    }
    EXPECT_EQ(pupilTransfer(circular, 0.0, 0.5, 1.5, 1.5), 0.0);
}

TEST(PupilTransfer, AnAnnulusHasOneillsClosedForm) {
    // E. L. O'Neill, "Transfer function for an annular aperture", J. Opt. Soc. Am. 46, 285 (1956).
    for (const double e : {0.2, 0.5, 0.8}) {
        for (const double u : {0.0, 0.03, 0.2, 0.45, 0.6, 0.8, 0.97}) {
            const auto circle = [](double v) {
                return v >= 1.0 ? 0.0 : std::acos(v) - v * std::sqrt(1.0 - v * v);
            };
            double c = 0.0;
            if (u <= 0.5 * (1.0 - e)) {
                c = -pi * e * e;
            } else if (u < 0.5 * (1.0 + e)) {
                const double phi = std::acos((1.0 + e * e - 4.0 * u * u) / (2.0 * e));
                c = -pi * e * e + e * std::sin(phi) + 0.5 * phi * (1.0 + e * e) -
                    (1.0 - e * e) * std::atan((1.0 + e) / (1.0 - e) * std::tan(0.5 * phi));
            }
            const double expected =
                2.0 / pi * (circle(u) + e * e * circle(u / e) + c) / (1.0 - e * e);
            EXPECT_NEAR(pupilTransfer(annular, e, 0.0, 2.0 * u, 0.0), expected, 1e-8)
                << e << " " << u;
        }
    }
}

TEST(PupilTransfer, DefocusIsTheAutocorrelationItself) {
    struct Row {
        PupilShape shape;
        double obscuration, waves, x, y;
    };
    for (const Row& row : {Row{circular, 0.0, 0.25, 0.6, 0.0}, Row{circular, 0.0, 1.0, 0.3, 0.4},
                           Row{circular, 0.0, 3.0, 0.2, 0.1}, Row{annular, 0.4, 0.5, 0.5, 0.2},
                           Row{annular, 0.3, 2.0, 0.3, 0.0}, Row{annular, 0.6, 1.0, 1.3, 0.0},
                           Row{square, 0.0, 0.7, 0.4, 0.3}, Row{square, 0.0, 0.0, 1.5, 0.2}}) {
        EXPECT_NEAR(pupilTransfer(row.shape, row.obscuration, row.waves, row.x, row.y),
                    byGrid(row.shape, row.obscuration, row.waves, row.x, row.y), 1.5e-3)
            << row.waves << " " << row.x;
    }
}

TEST(PupilTransfer, DefocusOfACircleIsHopkinsSeriesOfBesselFunctions) {
    // H. H. Hopkins, Proc. Roy. Soc. A 231, 91 (1955), eq. 12, by its definition: a = 4 pi W s'.
    for (const double waves : {0.1, 0.5, 1.0, 2.5}) {
        for (const double shift : {0.1, 0.3, 0.8, 1.4}) {
            const double a = 4.0 * pi * waves * shift, beta = std::acos(0.5 * shift);
            const double half = 0.5 * shift;
            double h1 = beta * std::cyl_bessel_j(1.0, a) +
                        0.5 * std::sin(2.0 * beta) *
                            (std::cyl_bessel_j(1.0, a) - std::cyl_bessel_j(3.0, a));
            double h2 = std::sin(beta) * (std::cyl_bessel_j(0.0, a) - std::cyl_bessel_j(2.0, a));
            double sign = -1.0;
            for (int n = 2; n < 60; ++n, sign = -sign) {
                const double even = 2.0 * n;
                h1 += sign * std::sin(even * beta) / even *
                      (std::cyl_bessel_j(even - 1.0, a) - std::cyl_bessel_j(even + 1.0, a));
            }
            sign = -1.0;
            for (int n = 1; n < 60; ++n, sign = -sign) {
                const double odd = 2.0 * n + 1.0;
                h2 += sign * std::sin(odd * beta) / odd *
                      (std::cyl_bessel_j(odd - 1.0, a) - std::cyl_bessel_j(odd + 1.0, a));
            }
            const double expected =
                4.0 / (pi * a) * (std::cos(a * half) * h1 - std::sin(a * half) * h2);
            EXPECT_NEAR(pupilTransfer(circular, 0.0, waves, shift, 0.0), expected, 1e-8)
                << waves << " " << shift;
        }
    }
}

TEST(PupilTransfer, DefocusAndShiftHaveNoSign) {
    const double value = pupilTransfer(annular, 0.3, 0.8, 0.5, 0.1);
    EXPECT_EQ(pupilTransfer(annular, 0.3, -0.8, 0.5, 0.1), value);
    EXPECT_EQ(pupilTransfer(annular, 0.3, 0.8, -0.5, 0.1), value);
}

TEST(PupilTransfer, ManyWavesReverseContrastAndStayBounded) {
    double least = 1.0;
    for (double shift = 0.0; shift < 2.0; shift += 0.01) {
        const double value = pupilTransfer(circular, 0.0, 20.0, shift, 0.0);
        least = std::min(least, value);
        EXPECT_LE(std::abs(value), 1.0 + 1e-9);
    }
    EXPECT_LT(least, -0.05);
}

} // namespace

} // namespace irsg
