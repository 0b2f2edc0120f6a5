#include <array>
#include <cmath>
#include <cstdint>

#include "irsg/signature/LookupTable.h"
#include "irsg/signature/SurfaceTemperature.h"
#include "irsg/signature/random/Philox.h"
#include "irsg/signature/random/SobolSequence.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

using irsg::EntityState;
using irsg::LookupTable;
using irsg::TemperatureTerms;

/// T0 + a T_amb (1 + 0.2 r M^2 + dT / T_amb) with numbers that can be followed by hand:
/// 10 + 0.9 * 250 * (1 + 0.2 * 0.85 * 4 + 20 / 250) = 10 + 225 * 1.76.
SelfTestValue recovery(SelfTestBench&) {
    TemperatureTerms terms;
    terms.base_K = 10.0;
    terms.ambientFactor = 0.9;
    terms.recoveryFactor = 0.85;
    terms.ambientOffset_K = 20.0;
    return {irsg::surfaceTemperature_K(terms, {.mach = 2.0, .ambient_K = 250.0}), 406.0};
}

/// Each table adds its own: 100 + 7 (time) + 30 (power) - 5 (altitude) + 12 (Mach).
SelfTestValue tables(SelfTestBench&) {
    TemperatureTerms terms;
    terms.base_K = 100.0;
    terms.time = LookupTable({0.0, 10.0}, {2.0, 12.0});
    terms.power = LookupTable({0.0, 1.0}, {0.0, 60.0});
    terms.altitude = LookupTable({0.0, 10000.0}, {0.0, -50.0});
    terms.mach = LookupTable({0.0, 2.0}, {0.0, 24.0});
    return {irsg::surfaceTemperature_K(
                terms, {.time_s = 5.0, .power = 0.5, .mach = 1.0, .altitude_m = 1000.0}),
            144.0};
}

/// A saw tooth of period 4 from 0 to 8, far outside its nodes on either side.
SelfTestValue loops(SelfTestBench&) {
    const LookupTable saw({1.0, 5.0}, {0.0, 8.0}, true);
    Farthest farthest(absolute);
    for (const double x : {1.0, 2.5, 4.5, 6.0, -2.0, 41.5, -38.25}) {
        const double phase = std::fmod(std::fmod(x - 1.0, 4.0) + 4.0, 4.0);
        farthest.add(saw.at(x), 2.0 * phase);
    }
    return farthest.found();
}

SelfTestValue philox(SelfTestBench&) {
    // The known answers that come with the authors' library Random123.
    struct Known {
        std::array<std::uint32_t, 4> counter;
        std::array<std::uint32_t, 2> key;
        std::array<std::uint32_t, 4> words;
    };
    const Known known[] = {
        {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
        {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
         {0xffffffff, 0xffffffff},
         {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
        {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
         {0xa4093822, 0x299f31d0},
         {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
    };
    int equal = 0;
    for (const Known& one : known)
        equal += irsg::philox4x32(one.counter, one.key) == one.words ? 1 : 0;
    return {static_cast<double>(equal), 3.0};
}

/// Mean of prod (1 + (x_i - 1/2)) over eight dimensions, which is 1, by 4096 scrambled points.
SelfTestValue sobol(SelfTestBench&) {
    const irsg::SobolSequence sequence(8, 1, 0);
    double sum = 0.0;
    constexpr std::uint32_t points = 4096;
    for (std::uint32_t i = 0; i < points; ++i) {
        double product = 1.0;
        for (int d = 0; d < 8; ++d)
            product *= 0.5 + sequence.at(i, d);
        sum += product;
    }
    return {sum / points, 1.0};
}

} // namespace

std::vector<SelfTestCheck> signatureChecks() {
    return withHard(
        {
            {"signature.recovery-temperature",
             "Eq. 7 with ambient factor, recovery at Mach 2 and offset, by hand", "K", 1e-12,
             relative, recovery},
            {"signature.tables",
             "Eq. 7 with its tables of time, power, altitude and Mach number, by hand", "K", 1e-12,
             relative, tables},
            {"signature.table-loops", "A looping table far outside its nodes against the remainder",
             "K", 1e-9, absolute, loops},
            {"signature.table-ends", "A table that does not loop holds its end values", "K", 0.0,
             absolute,
             [](auto&) {
                 const LookupTable table({0.0, 10.0}, {3.0, 7.0});
                 return SelfTestValue{table.at(-1e9) + 10.0 * table.at(1e9), 73.0};
             }},
            {"signature.random-words",
             "Philox4x32-10 against the three known answers of its authors (Random123)", "equal",
             0.0, absolute, philox},
            {"signature.sobol-mean",
             "A product of eight coordinates over 4096 scrambled points of Sobol' against its mean",
             "", 1e-3, relative, sobol},
            {"signature.students-interval",
             "95 % interval of the mean of 1 ... 10 against Student's t of 9 degrees of freedom "
             "(2.262157)",
             "", 1e-5, relative,
             [](auto&) {
                 std::vector<double> values(10);
                 for (std::size_t i = 0; i < 10; ++i)
                     values[i] = static_cast<double>(i + 1);
                 const Estimate mean = estimate(values, {});
                 return SelfTestValue{mean.high95,
                                      5.5 + 2.2621571628 * std::sqrt(55.0 / 6.0 / 10.0)};
             }},
        },
        {
            {"signature.refusals", "Tables whose axis goes back, repeats or is no number: refused",
             "refusals", 0.0, absolute,
             [](auto&) {
                 return SelfTestValue{static_cast<double>(refusals(
                                          [] {
                                              LookupTable({1.0, 0.0}, {1.0, 1.0});
                                          },
                                          [] {
                                              LookupTable({1.0, 1.0}, {1.0, 1.0});
                                          },
                                          [] {
                                              LookupTable({1.0}, {1.0, 1.0});
                                          },
                                          [] { LookupTable({1.0}, {1.0}, true); })),
                                      4.0};
             }},
        });
}

} // namespace smat::selftest
