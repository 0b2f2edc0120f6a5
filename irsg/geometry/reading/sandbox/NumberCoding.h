#pragma once

#include <cstring>
#include <string_view>

#include "irsg/core/Bytes.h"

namespace irsg {

/// A vector or matrix of OpenSceneGraph, which is nothing but its numbers, as bytes.
template <typename Numbers>
void putNumbers(ByteSink& sink, const Numbers& numbers) {
    sink.putBytes(numbers.ptr(), sizeof numbers);
}

template <typename Numbers>
Numbers getNumbers(ByteSource& source) {
    Numbers numbers;
    const std::string_view bytes = source.getBytes(sizeof numbers);
    std::memcpy(numbers.ptr(), bytes.data(), bytes.size());
    return numbers;
}

} // namespace irsg
