#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace irsg {

/// Values and lists as this machine has them, one behind the other: for what the same program reads
/// on the same machine.
class BinaryWriter {
  public:
    template <typename T>
    void operator()(const T& value)
        requires std::is_trivially_copyable_v<T>
    {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <typename T>
    void operator()(const std::vector<T>& values)
        requires std::is_trivially_copyable_v<T>
    {
        (*this)(static_cast<std::uint64_t>(values.size()));
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    void operator()(const std::vector<bool>& values) {
        (*this)(std::vector<char>(values.begin(), values.end()));
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

/// Reads what a BinaryWriter wrote, in the same order. What ends too early leaves the value as it
/// was, and that which follows; isWhole tells.
class BinaryReader {
  public:
    /// `bytes` must live as long.
    explicit BinaryReader(std::string_view bytes) : bytes_(bytes) {}

    template <typename T>
    void operator()(T& value)
        requires std::is_trivially_copyable_v<T>
    {
        if (take(sizeof value))
            std::memcpy(&value, taken_, sizeof value);
    }
    template <typename T>
    void operator()(std::vector<T>& values)
        requires std::is_trivially_copyable_v<T>
    {
        std::uint64_t count = 0;
        (*this)(count);
        if (count > bytes_.size() / sizeof(T)) {
            isWhole_ = false;
            return;
        }
        take(count * sizeof(T));
        values.resize(count);
        if (count > 0)
            std::memcpy(values.data(), taken_, count * sizeof(T));
    }
    void operator()(std::vector<bool>& values) {
        std::vector<char> read;
        (*this)(read);
        values.assign(read.begin(), read.end());
    }
    /// Whether something was not there, or nothing is left.
    bool hasEnded() const { return !isWhole_ || bytes_.empty(); }
    /// Whether everything was there so far, and nothing is left.
    bool isWhole() const { return isWhole_ && bytes_.empty(); }

  private:
    bool take(std::size_t size) {
        if (!isWhole_ || size > bytes_.size())
            return isWhole_ = false;
        taken_ = bytes_.data();
        bytes_.remove_prefix(size);
        return true;
    }

    std::string_view bytes_;
    const char* taken_ = nullptr;
    bool isWhole_ = true;
};

} // namespace irsg
