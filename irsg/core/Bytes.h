#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace irsg {

/// Bytes of another process, or of an earlier one, do not hold together.
class DamagedBytes : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Values one behind the other, as processes of one machine hand them to each other.
class ByteSink {
  public:
    template <typename Value>
    void put(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        putBytes(&value, sizeof value);
    }
    void putText(std::string_view text) {
        putCount(text.size());
        putBytes(text.data(), text.size());
    }
    void putCount(std::size_t count) { put(static_cast<std::uint64_t>(count)); }
    void putBytes(const void* from, std::size_t size) {
        room(size).append(static_cast<const char*>(from), size);
    }
    /// Many numbers, each as `Value`: number(i) for every i below `count`.
    template <typename Value, typename Number>
    void putEach(std::size_t count, const Number& number) {
        std::string& piece = room(count * sizeof(Value));
        const std::size_t begin = piece.size();
        piece.resize(begin + count * sizeof(Value));
        for (std::size_t i = 0; i < count; ++i) {
            const Value value = static_cast<Value>(number(i));
            std::memcpy(piece.data() + begin + i * sizeof value, &value, sizeof value);
        }
    }
    /// All that another holds, without a copy of it.
    void append(ByteSink other) {
        pieces_.insert(pieces_.end(), std::make_move_iterator(other.pieces_.begin()),
                       std::make_move_iterator(other.pieces_.end()));
    }
    /// What was put, in pieces, one behind the other: a large model is never moved as a whole.
    const std::vector<std::string>& pieces() const { return pieces_; }
    std::size_t size() const {
        std::size_t sum = 0;
        for (const std::string& piece : pieces_)
            sum += piece.size();
        return sum;
    }
    /// The same in one.
    std::string take() {
        std::string all;
        all.reserve(size());
        for (const std::string& piece : std::exchange(pieces_, {}))
            all += piece;
        return all;
    }

  private:
    /// The last piece, with room for so many bytes more.
    std::string& room(std::size_t size) {
        constexpr std::size_t least = 1u << 12, most = 1u << 20;
        if (pieces_.empty() || pieces_.back().capacity() - pieces_.back().size() < size) {
            const std::size_t before = pieces_.empty() ? 0 : pieces_.back().capacity();
            pieces_.emplace_back().reserve(std::max(size, std::clamp(2 * before, least, most)));
        }
        return pieces_.back();
    }

    std::vector<std::string> pieces_;
};

/// The same on the other side, which trusts none of it: throws DamagedBytes for whatever is not
/// there.
class ByteSource {
  public:
    explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

    template <typename Value>
    Value get() {
        static_assert(std::is_trivially_copyable_v<Value>);
        Value value;
        std::memcpy(&value, getBytes(sizeof value).data(), sizeof value);
        return value;
    }
    bool getFlag() { return get<std::uint8_t>() != 0; }
    std::string_view getBytes(std::size_t size) {
        if (size > bytes_.size())
            throw DamagedBytes("an answer that ends too early");
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }
    /// A count of things of `each` bytes or more that follow.
    std::size_t getCount(std::size_t each) {
        const auto count = get<std::uint64_t>();
        if (count > bytes_.size() / each)
            throw DamagedBytes("a count beyond the end of the answer");
        return static_cast<std::size_t>(count);
    }
    std::string getText() { return std::string(getBytes(getCount(1))); }
    /// A number below `end`.
    std::uint32_t getIndex(std::size_t end) {
        const auto index = get<std::uint32_t>();
        if (index >= end)
            throw DamagedBytes("a reference to what is not there");
        return index;
    }
    bool atEnd() const { return bytes_.empty(); }

  private:
    std::string_view bytes_;
};

} // namespace irsg
