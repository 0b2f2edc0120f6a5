#include "irsg/scattering/Mie.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scattering/WaterIndex.h"

namespace irsg {
namespace {

/// A number as it is printed, and how much its last digit leaves open.
struct Printed {
    double value, half;
};
constexpr Printed six(double value) {
    return {value, 0.5e-6};
}
constexpr Printed four(double value) {
    return {value, 0.5e-4};
}
constexpr Printed notPrinted{0.0, -1.0};

struct Case {
    const char* name;
    std::complex<double> index;
    double size;
    Printed extinction, scattering, asymmetry;
};

// W. J. Wiscombe 1979, Mie scattering calculations, NCAR/TN-140+STR, and the edition of 1996 with
// MIEV0 (test cases 5 to 19; the asymmetry of case 16 is 0.846309958109 in arithmetic of 40 digits,
// which is 0.846310 rounded to the six digits of the table: it prints 0.846309); C. F. Bohren and
// D. R. Huffman 1983, appendix A.
const Case cases[] = {
    {"Wiscombe 5", {0.75, 0.0}, 0.099, six(0.000007), six(0.000007), six(0.001448)},
    {"Wiscombe 6", {0.75, 0.0}, 0.101, six(0.000008), six(0.000008), six(0.001507)},
    {"Wiscombe 7", {0.75, 0.0}, 10.0, six(2.232265), six(2.232265), six(0.896473)},
    {"Wiscombe 8", {0.75, 0.0}, 1000.0, six(1.997908), six(1.997908), six(0.844944)},
    {"Wiscombe 9", {1.33, 1e-5}, 1.0, six(0.093952), six(0.093923), six(0.184517)},
    {"Wiscombe 10", {1.33, 1e-5}, 100.0, six(2.101321), six(2.096594), six(0.868959)},
    {"Wiscombe 11", {1.33, 1e-5}, 10000.0, six(2.004089), six(1.723857), six(0.907840)},
    {"Wiscombe 12", {1.5, 1.0}, 0.055, six(0.101491), six(0.000011), six(0.000491)},
    {"Wiscombe 13", {1.5, 1.0}, 0.056, six(0.103347), six(0.000012), six(0.000509)},
    {"Wiscombe 14", {1.5, 1.0}, 1.0, six(2.336321), six(0.663454), six(0.192136)},
    {"Wiscombe 15", {1.5, 1.0}, 100.0, six(2.097502), six(1.283697), six(0.850252)},
    {"Wiscombe 16", {1.5, 1.0}, 10000.0, six(2.004368), six(1.236574), {0.846309, 1e-6}},
    {"Wiscombe 17", {10.0, 10.0}, 1.0, six(2.532993), six(2.049405), six(-0.110664)},
    {"Wiscombe 18", {10.0, 10.0}, 100.0, six(2.071124), six(1.836785), six(0.556215)},
    {"Wiscombe 19", {10.0, 10.0}, 10000.0, six(2.005914), six(1.795393), six(0.548194)},
    {"Wiscombe 1979, 10", {1.5, 0.0}, 10.0, four(2.8820), four(2.8820), notPrinted},
    {"Wiscombe 1979, 100", {1.5, 0.0}, 100.0, four(2.0944), four(2.0944), notPrinted},
    {"Wiscombe 1979, 1000", {1.5, 0.0}, 1000.0, four(2.0139), four(2.0139), notPrinted},
    {"Wiscombe 1979, 5000", {1.5, 0.0}, 5000.0, four(2.0086), four(2.0086), notPrinted},
    {"Bohren and Huffman",
     {1.55, 0.0},
     2.0 * pi * 0.525 / 0.6328,
     {3.10543, 0.5e-5},
     {3.10543, 0.5e-5},
     notPrinted},
};

void expectPrinted(double value, const Printed& printed, const char* what) {
    if (printed.half < 0.0) {
        return;
    }
    EXPECT_NEAR(value, printed.value, printed.half * (1.0 + 1e-6)) << what;
}

TEST(Mie, HasEveryPrintedDigitOfPublishedEfficiencies) {
    for (const Case& one : cases) {
        SCOPED_TRACE(one.name);
        const MieEfficiencies of = MieSphere(one.index, one.size).efficiencies();
        expectPrinted(of.extinction, one.extinction, "extinction");
        expectPrinted(of.scattering, one.scattering, "scattering");
        expectPrinted(of.asymmetry, one.asymmetry, "asymmetry");
    }
}

TEST(Mie, HasThePrintedAmplitudes) {
    // Wiscombe's test case 14, every 30 degrees: re S1, im S1, re S2, im S2 of his time factor
    // exp(+i omega t), whose numbers are the complex conjugates of ours.
    const double printed[][4] = {
        {0.584080, 0.190515, 0.584080, 0.190515},   {0.565702, 0.187200, 0.500161, 0.145611},
        {0.517525, 0.178443, 0.287964, 0.041054},   {0.456340, 0.167167, 0.0362285, -0.0618265},
        {0.400212, 0.156643, -0.174875, -0.122959}, {0.362157, 0.149391, -0.305682, -0.143846},
        {0.348844, 0.146829, -0.348844, -0.146829}};
    std::vector<double> cosines;
    for (int i = 0; i < 7; ++i) {
        cosines.push_back(std::cos(radians(30.0 * i)));
    }
    const auto amplitudes = MieSphere({1.5, 1.0}, 1.0).amplitudes(cosines);
    for (std::size_t i = 0; i < 7; ++i) {
        SCOPED_TRACE(30 * i);
        EXPECT_NEAR(amplitudes[i].across.real(), printed[i][0], 0.51e-6);
        EXPECT_NEAR(std::abs(amplitudes[i].across.imag()), std::abs(printed[i][1]), 0.51e-6);
        EXPECT_NEAR(amplitudes[i].along.real(), printed[i][2], 0.51e-6);
        EXPECT_NEAR(std::abs(amplitudes[i].along.imag()), std::abs(printed[i][3]), 0.51e-6);
    }
}

TEST(Mie, HasThePrintedPhaseFunctionOfBohrenAndHuffman) {
    // Their appendix A: S11 over its value at 0 and the polarisation, every 9 degrees, x = 5.213.
    const double printed[][2] = {{1.0, 0.0},
                                 {0.785390, -0.459811e-2},
                                 {0.356897, -0.458541e-1},
                                 {0.766119e-1, -0.364744},
                                 {0.355355e-1, -0.534997},
                                 {0.701845e-1, 0.959953e-2},
                                 {0.574313e-1, 0.477927e-1},
                                 {0.219660e-1, -0.440604},
                                 {0.125959e-1, -0.831996},
                                 {0.173750e-1, 0.341670e-1},
                                 {0.124601e-1, 0.230462},
                                 {0.679093e-2, -0.713472},
                                 {0.954239e-2, -0.756255},
                                 {0.863419e-2, -0.281215},
                                 {0.227421e-2, -0.239612},
                                 {0.543998e-2, -0.850804},
                                 {0.160243e-1, -0.706334},
                                 {0.188852e-1, -0.891081},
                                 {0.195254e-1, -0.783319},
                                 {0.301676e-1, -0.196194},
                                 {0.383189e-1, 0.0}};
    std::vector<double> cosines;
    for (int i = 0; i <= 20; ++i) {
        cosines.push_back(std::cos(radians(9.0 * i)));
    }
    const auto s = MieSphere({1.55, 0.0}, 2.0 * pi * 0.525 / 0.6328).amplitudes(cosines);
    const double forward = std::norm(s[0].across) + std::norm(s[0].along);
    for (std::size_t i = 0; i <= 20; ++i) {
        SCOPED_TRACE(9 * i);
        const double all = std::norm(s[i].across) + std::norm(s[i].along);
        // Six significant digits.
        const double last = std::pow(10.0, std::floor(std::log10(printed[i][0])) - 5.0);
        EXPECT_NEAR(all / forward, printed[i][0], 0.51 * last);
        EXPECT_NEAR((std::norm(s[i].across) - std::norm(s[i].along)) / all, printed[i][1], 1.5e-6);
    }
}

TEST(Mie, ScattersWhatItExtinguishesWhereNothingAbsorbs) {
    for (const double x : {0.01, 0.1, 1.0, 31.4, 100.0, 1234.5, 10000.0}) {
        const MieEfficiencies of = MieSphere({1.33, 0.0}, x).efficiencies();
        EXPECT_NEAR(of.scattering / of.extinction, 1.0, x < 0.1 ? 1e-7 : 1e-11) << x;
    }
}

TEST(Mie, FollowsRayleighForSmallSpheres) {
    const std::complex<double> m{1.33, 0.0}, alpha = (m * m - 1.0) / (m * m + 2.0);
    const double x = 0.01;
    const MieEfficiencies of = MieSphere(m, x).efficiencies();
    EXPECT_NEAR(of.scattering / (8.0 / 3.0 * std::pow(x, 4) * std::norm(alpha)), 1.0, 1e-3);
    EXPECT_NEAR(of.asymmetry, 0.0, 1e-4);
}

TEST(Mie, TendsToTwiceTheShadow) {
    EXPECT_NEAR(MieSphere({1.33, 0.01}, 10000.0).efficiencies().extinction, 2.0, 0.01);
    EXPECT_NEAR(MieSphere({1.33, 0.01}, 20000.0).efficiencies().extinction, 2.0, 0.005);
}

TEST(Mie, SumsItsAnglesToItsEfficiency) {
    const MieSphere sphere({1.351, 0.0046}, 78.5);
    std::vector<double> cosines;
    constexpr int count = 20001;
    for (int i = 0; i < count; ++i) {
        cosines.push_back(std::cos(pi * i / (count - 1)));
    }
    const auto s = sphere.amplitudes(cosines);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        sum += (std::norm(s[static_cast<std::size_t>(i)].across) +
                std::norm(s[static_cast<std::size_t>(i)].along)) *
               std::sin(pi * i / (count - 1)) * pi / (count - 1);
    }
    EXPECT_NEAR(sum / (78.5 * 78.5), sphere.efficiencies().scattering, 1e-5);
}

TEST(Mie, RefusesWhatIsOutsideTheTheory) {
    EXPECT_THROW(MieSphere({1.33, 0.0}, 1e-4), LogicError);
    EXPECT_THROW(MieSphere({1.33, 0.0}, 1e5), LogicError);
    EXPECT_THROW(MieSphere({1.33, 0.0}, std::nan("")), LogicError);
    EXPECT_THROW(MieSphere({1.33, -0.1}, 1.0), LogicError);
}

TEST(WaterIndex, HasTheRowsOfHaleAndQuerry) {
    EXPECT_EQ(waterIndex(0.4), std::complex<double>(1.339, 1.86e-9));
    EXPECT_NEAR(waterIndex(4.0).real(), 1.351, 1e-12);
    EXPECT_NEAR(waterIndex(10.0).imag(), 0.0508, 1e-12);
    EXPECT_NEAR(waterIndex(14.0).imag(), 0.370, 1e-12);
    EXPECT_NEAR(waterIndex(10.25).real(), 0.5 * (1.218 + 1.185), 1e-12);
}

TEST(WaterIndex, IsNotKnownElsewhere) {
    EXPECT_THROW(waterIndex(0.39), InputError);
    EXPECT_THROW(waterIndex(14.1), InputError);
    EXPECT_THROW(waterIndex(std::nan("")), InputError);
}

} // namespace
} // namespace irsg
