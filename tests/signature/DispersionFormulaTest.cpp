#include "irsg/signature/DispersionFormula.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

TEST(DispersionFormula, GivesPublishedIndices) {
    const struct {
        const char* name;
        int formula;
        std::vector<double> coefficients;
        double wavelength_um, index, tolerance;
    } rows[] = {
        // Malitson 1965: fused silica.
        {"silica, D line",
         1,
         {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161},
         0.58756,
         1.45846,
         1e-5},
        {"silica, t line",
         1,
         {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161},
         1.01398,
         1.45025,
         1e-5},
        // Schott: N-BK7, n_d.
        {"BK7",
         2,
         {0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653},
         0.5875618,
         1.51680,
         1e-5},
        // Ciddor 1996: standard air, n - 1 = 2.7653e-4 at 0.633 um.
        {"air", 6, {0, 0.05792105, 238.0185, 0.00167917, 57.362}, 0.633, 1.00027653, 5e-8},
        // Edwards and Ochoa 1980.
        {"silicon", 7, {3.41983, 0.159906, -0.123109, 1.26878e-6, -1.95104e-9}, 5.0, 3.4261, 1e-4},
        // Loria 1909: methane in Cauchy's form.
        {"gas", 5, {1.0007330, 6.822764e-6, -2}, 0.6, 1.000751952, 1e-9},
        // Schroeter 1931: silver bromide, n = 2.2526 at 0.589 um.
        {"silver bromide", 8, {0.452505, 0.09939, 0.070537, -0.00150}, 0.589, 2.2526, 4e-3},
    };
    for (const auto& row : rows) {
        EXPECT_NEAR(dispersionIndex(row.formula, row.coefficients, row.wavelength_um), row.index,
                    row.tolerance)
            << row.name;
    }
}

TEST(DispersionFormula, FollowsItsDefinition) {
    // n^2 at 2 um, by hand.
    EXPECT_DOUBLE_EQ(dispersionIndex(3, std::vector{2.0, 0.5, 2.0, 3.0, -1.0}, 2.0),
                     std::sqrt(2.0 + 0.5 * 4.0 + 3.0 / 2.0));
    EXPECT_DOUBLE_EQ(
        dispersionIndex(4, std::vector{2.0, 3.0, 1.0, 0.5, 2.0, 1.0, 2.0, 3.0, 1.0, 0.25, 2.0},
                        2.0),
        std::sqrt(2.0 + 3.0 * 2.0 / (4.0 - 0.25) + 4.0 / (4.0 - 3.0) + 0.25 * 4.0));
    EXPECT_DOUBLE_EQ(dispersionIndex(7, std::vector{1.5, 0.1, 0.2, 0.01, 0.001, 0.0001}, 2.0),
                     1.5 + 0.1 / 3.972 + 0.2 / (3.972 * 3.972) + 0.04 + 0.016 + 0.0064);
    EXPECT_DOUBLE_EQ(dispersionIndex(9, std::vector{2.0, 0.5, 1.0, 3.0, 0.5, 0.25}, 2.0),
                     std::sqrt(2.0 + 0.5 / 3.0 + 3.0 * 1.5 / (2.25 + 0.25)));
    // (n^2 - 1) / (n^2 + 2) = 0.25 for n = sqrt 2.
    EXPECT_DOUBLE_EQ(dispersionIndex(8, std::vector{0.25}, 2.0), std::sqrt(2.0));
}

TEST(DispersionFormula, TermsOfZeroAddNothingAtTheirPole) {
    EXPECT_EQ(dispersionIndex(1, std::vector{0.0, 0.0, 2.0}, 2.0), 1.0);
    EXPECT_EQ(dispersionIndex(4, std::vector{4.0}, 1.0), 2.0);
    EXPECT_FALSE(std::isfinite(dispersionIndex(1, std::vector{0.0, 1.0, 2.0}, 2.0)));
    EXPECT_TRUE(std::isnan(dispersionIndex(3, std::vector{-1.0}, 2.0)));
}

TEST(DispersionFormula, IsCountedFromOneToNine) {
    EXPECT_EQ(mostCoefficients(1), 17U);
    EXPECT_EQ(mostCoefficients(9), 6U);
    EXPECT_THROW(mostCoefficients(0), LogicError);
    EXPECT_THROW(mostCoefficients(10), LogicError);
    EXPECT_THROW(dispersionIndex(8, std::vector<double>(5, 0.1), 2.0), LogicError);
    EXPECT_THROW(dispersionIndex(8, std::vector<double>(), 2.0), LogicError);
}

} // namespace
} // namespace irsg
