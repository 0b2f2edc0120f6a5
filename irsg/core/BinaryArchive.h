#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "irsg/core/Bytes.h"

namespace irsg {

/// Writes values and lists by the same description, archive(value) for each of them, that a
/// BinaryReader reads them by.
class BinaryWriter {
  public:
    template <typename T>
    void operator()(const T& value)
        requires std::is_trivially_copyable_v<T>
    {
        sink_.put(value);
    }
    template <typename T>
    void operator()(const std::vector<T>& values)
        requires std::is_trivially_copyable_v<T>
    {
        sink_.putCount(values.size());
        sink_.putBytes(values.data(), values.size() * sizeof(T));
    }
    void operator()(const std::vector<bool>& values) {
        (*this)(std::vector<char>(values.begin(), values.end()));
    }
    std::string take() { return sink_.take(); }

  private:
    ByteSink sink_;
};

/// Throws DamagedBytes where a value is not there.
class BinaryReader {
  public:
    /// `bytes` must live as long.
    explicit BinaryReader(std::string_view bytes) : source_(bytes) {}

    template <typename T>
    void operator()(T& value)
        requires std::is_trivially_copyable_v<T>
    {
        value = source_.get<T>();
    }
    template <typename T>
    void operator()(std::vector<T>& values)
        requires std::is_trivially_copyable_v<T>
    {
        values.resize(source_.getCount(sizeof(T)));
        const std::string_view bytes = source_.getBytes(values.size() * sizeof(T));
        if (!bytes.empty())
            std::memcpy(values.data(), bytes.data(), bytes.size());
    }
    void operator()(std::vector<bool>& values) {
        std::vector<char> read;
        (*this)(read);
        values.assign(read.begin(), read.end());
    }
    bool atEnd() const { return source_.atEnd(); }

  private:
    ByteSource source_;
};

} // namespace irsg
