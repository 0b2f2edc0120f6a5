#include "irsg/signature/Sha256.h"

#include <array>
#include <bit>
#include <cstdint>

namespace irsg {

namespace {

using Word = std::uint32_t;
using State = std::array<Word, 8>;

constexpr std::size_t blockBytes = 64;

// Fractional parts of the square roots of the first 8 primes (FIPS 180-4, 5.3.3).
constexpr State initialState = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

// Fractional parts of the cube roots of the first 64 primes (FIPS 180-4, 4.2.2).
constexpr std::array<Word, 64> roundConstants = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

Word bigEndian(std::string_view bytes, std::size_t at) {
    Word word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    return word;
}

void digestBlock(std::string_view block, State& state) {
    // The message schedule (6.2.2, step 1).
    std::array<Word, 64> w{};
    for (std::size_t t = 0; t < 16; ++t)
        w[t] = bigEndian(block, 4 * t);
    for (std::size_t t = 16; t < 64; ++t) {
        const Word s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ w[t - 15] >> 3;
        const Word s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ w[t - 2] >> 10;
        w[t] = s1 + w[t - 7] + s0 + w[t - 16];
    }

    // The 64 rounds (steps 2 to 4), with the letters of the standard.
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < 64; ++t) {
        const Word sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const Word choice = (e & f) ^ (~e & g);
        const Word t1 = h + sum1 + choice + roundConstants[t] + w[t];
        const Word sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const Word majority = (a & b) ^ (a & c) ^ (b & c);
        const Word t2 = sum0 + majority;
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + t2;
    }
    const State round = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < state.size(); ++i)
        state[i] += round[i];
}

} // namespace

Sha256::Sha256() : state_(initialState) {}

void Sha256::add(std::string_view bytes) {
    added_B_ += bytes.size();
    if (!rest_.empty()) {
        const std::string_view fills = bytes.substr(0, blockBytes - rest_.size());
        rest_ += fills;
        bytes.remove_prefix(fills.size());
        if (rest_.size() < blockBytes)
            return;
        digestBlock(rest_, state_);
        rest_.clear();
    }
    for (; bytes.size() >= blockBytes; bytes.remove_prefix(blockBytes))
        digestBlock(bytes.substr(0, blockBytes), state_);
    rest_ = bytes;
}

std::string Sha256::text() {
    // Padding: a one bit, zeros, and the length in bits as 64 bits (5.1.1).
    std::string tail = rest_ + '\x80';
    while (tail.size() % blockBytes != blockBytes - 8)
        tail += '\0';
    const std::uint64_t bits = added_B_ * 8;
    for (int shift = 56; shift >= 0; shift -= 8)
        tail += static_cast<char>(bits >> shift & 0xff);
    for (std::size_t at = 0; at < tail.size(); at += blockBytes)
        digestBlock(std::string_view(tail).substr(at, blockBytes), state_);

    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const Word word : state_)
        for (int shift = 28; shift >= 0; shift -= 4)
            text += digits[word >> shift & 0xf];
    return text;
}

std::string sha256(std::string_view bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.text();
}

} // namespace irsg
