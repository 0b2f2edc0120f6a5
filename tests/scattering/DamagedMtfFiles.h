#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tests/scattering/MtfBytes.h"
#include "tests/scattering/SmallDatabase.h"

namespace irsg {

/// A file that is not an MTF database, and what its refusal must name.
struct DamagedMtf {
    std::string name, bytes, position;
};

/// 40 bytes of header, 4 frequencies, then 2 curves of 40 bytes from bytes 72 and 112: 152 bytes.
inline std::vector<DamagedMtf> damagedMtfFiles() {
    const std::string good = smallDatabase().bytes();
    const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    std::vector<DamagedMtf> files;
    const auto number = [&](const std::string& name, std::size_t at, double value) {
        files.push_back({name, good, "byte " + std::to_string(at)});
        putDouble(files.back().bytes, at, value);
    };
    const auto count = [&](const std::string& name, std::size_t at, std::int32_t value,
                           const std::string& position) {
        files.push_back({name, good, position});
        putInt(files.back().bytes, at, value);
    };
    const auto cut = [&](const std::string& name, std::size_t size) {
        files.push_back({name, good.substr(0, size), "byte " + std::to_string(size)});
    };
    cut("empty", 0);
    cut("one byte", 1);
    cut("half a header", 20);
    cut("a header less a byte", 39);
    cut("a header alone", 40);
    cut("cut in the frequencies", 60);
    cut("cut before the curves", 72);
    cut("cut in the first curve", 100);
    cut("cut before the second curve", 112);
    cut("a byte short", 151);
    files.push_back({"a byte more", good + "x", "byte 152"});
    files.push_back({"a curve more", good + good.substr(112), "byte 152"});
    files.push_back(
        {"text", "frequency [1/rad],value\n0,1\n1,0.5\n100,0.25\n200,0.125\n", "byte 32"});
    std::string swapped = good;
    for (std::size_t at = 0; at < swapped.size();) {
        const std::size_t size = at >= 32 && at < 40 ? 4 : 8;
        std::reverse(swapped.begin() + static_cast<std::ptrdiff_t>(at),
                     swapped.begin() + static_cast<std::ptrdiff_t>(at + size));
        at += size;
    }
    files.push_back({"big-endian", swapped, "byte 32"});
    count("no curves", 32, 0, "byte 32");
    count("a negative number of curves", 32, -2, "byte 32");
    count("more curves than there are", 32, 3, "byte 152");
    count("fewer curves than there are", 32, 1, "byte 112");
    count("two thousand million curves", 32, 2000000000, "byte 32");
    count("one point", 36, 1, "byte 36");
    count("a negative number of points", 36, -4, "byte 36");
    count("more points than there are", 36, 5, "byte 152");
    number("a field of view that is not a number", 0, nan);
    number("a negative field of interest", 8, -1.0);
    number("an infinite diameter", 16, infinite);
    number("a negative wave frequency", 24, -1e12);
    number("a negative frequency", 40, -1.0);
    number("a frequency that is not a number", 48, nan);
    number("frequencies that do not ascend", 56, 0.5);
    number("a frequency twice", 64, 10.0);
    number("an optical depth of 0", 72, 0.0);
    number("an optical depth that is not a number", 72, nan);
    number("optical depths that do not ascend", 112, 0.5);
    number("a negative value", 80, -1.0);
    number("a value of 0", 88, 0.0);
    number("a value that is not a number", 96, nan);
    number("an infinite value", 120, infinite);
    number("more light than there was", 120, 20.0);
    return files;
}

} // namespace irsg
