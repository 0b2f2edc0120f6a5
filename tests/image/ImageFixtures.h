#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/image/RadianceImage.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg::test {

using smat::test::TemporaryFolder;

inline constexpr float nanValue = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinity = std::numeric_limits<float>::infinity();

/// Floats that a careless writer or reader loses.
inline const std::vector<float> hardValues = {0.0F,
                                              -0.0F,
                                              1.0F,
                                              -3.5F,
                                              1e6F,
                                              123.25F,
                                              1e-6F,
                                              0.1F,
                                              1.0F / 3.0F,
                                              16777217.0F,
                                              nanValue,
                                              infinity,
                                              -infinity,
                                              std::numeric_limits<float>::denorm_min(),
                                              -1e-40F,
                                              std::numeric_limits<float>::max(),
                                              std::numeric_limits<float>::lowest(),
                                              std::numeric_limits<float>::min(),
                                              300.00003F,
                                              -7.0e-12F};

/// An image whose pixels are all different, with the hard values strewn in.
inline RadianceImage patternImage(int width, int height) {
    RadianceImage image(width, height);
    std::vector<float>& values = image.primary().values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = i % 3 == 0 ? hardValues[(i / 3) % hardValues.size()]
                               : 0.1F * static_cast<float>(i) + 1.0F;
    }
    return image;
}

inline std::vector<std::uint32_t> bitsOf(const std::vector<float>& values) {
    std::vector<std::uint32_t> bits;
    for (const float value : values) {
        bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
    return bits;
}

/// The message of the InputError that `call` throws, "" where it throws none.
template <typename Call>
std::string inputErrorOf(Call&& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace irsg::test
