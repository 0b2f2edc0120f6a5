#include "irsg/geometry/flight/FlightOrigin.h"

#include <bit>
#include <cstdint>
#include <vector>

#include "irsg/geometry/flight/FlightRecords.h"

namespace irsg {

namespace {

std::size_t u16(const std::string& stream, std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(stream[at])) << 8 |
           static_cast<unsigned char>(stream[at + 1]);
}

/// The payload of a record with its continuations, byte by byte where it lies in the stream.
class Payload {
  public:
    Payload(std::string& stream, std::size_t at) : stream_(stream) {
        do {
            add(at);
            at += u16(stream, at + 2);
        } while (at + 4 <= stream.size() && u16(stream, at) == flight::continuation);
        end_ = at;
    }

    std::size_t end() const { return end_; }
    std::size_t size() const { return size_; }
    std::uint64_t get(std::size_t at, std::size_t count) const {
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < count; ++i)
            bits = bits << 8 | static_cast<unsigned char>(stream_[place(at + i)]);
        return bits;
    }
    void put(std::size_t at, std::uint64_t bits) {
        for (std::size_t i = 8; i-- > 0; bits >>= 8)
            stream_[place(at + i)] = static_cast<char>(bits & 0xFF);
    }
    void take(std::size_t at, const std::array<double, 3>& origin) {
        for (std::size_t axis = 0; axis < 3 && at + 8 * axis + 8 <= size_; ++axis)
            put(at + 8 * axis, std::bit_cast<std::uint64_t>(
                                   std::bit_cast<double>(get(at + 8 * axis, 8)) - origin[axis]));
    }

  private:
    struct Piece {
        std::size_t begin, end, place; ///< in the payload; in the stream
    };
    void add(std::size_t record) {
        const std::size_t length = u16(stream_, record + 2) - 4;
        pieces_.push_back({size_, size_ + length, record + 4});
        size_ += length;
    }
    std::size_t place(std::size_t at) const {
        for (const Piece& piece : pieces_)
            if (at < piece.end)
                return piece.place + at - piece.begin;
        return stream_.size() - 1;
    }

    std::string& stream_;
    std::vector<Piece> pieces_;
    std::size_t size_ = 0, end_ = 0;
};

} // namespace

void takeOriginFrom(std::string& stream, const std::array<double, 3>& origin) {
    for (std::size_t at = 0; at + 4 <= stream.size();) {
        const std::size_t opcode = u16(stream, at), length = u16(stream, at + 2);
        if (length < 4 || length > stream.size() - at)
            return;
        const bool vertex = opcode >= flight::vertexC && opcode <= flight::vertexCT;
        if (!vertex && opcode != flight::localVertexPool) {
            at += length;
            continue;
        }
        Payload payload(stream, at);
        at = payload.end();
        if (vertex) {
            payload.take(4, origin);
        } else if (payload.size() >= 8) {
            const std::uint64_t count = payload.get(0, 4);
            const std::size_t stride =
                flightPoolStride(static_cast<std::uint32_t>(payload.get(4, 4)));
            for (std::uint64_t i = 0; i < count && 8 + (i + 1) * stride <= payload.size(); ++i)
                payload.take(8 + i * stride, origin);
        }
    }
}

} // namespace irsg
