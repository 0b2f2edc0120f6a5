#include "irsg/signature/Sha256.h"

#include <gtest/gtest.h>

namespace irsg {
namespace {

struct Vector {
    const char* name;
    std::string message;
    const char* digest;
};
void PrintTo(const Vector& row, std::ostream* out) {
    *out << row.name;
}

class PublishedVector : public testing::TestWithParam<Vector> {};

TEST_P(PublishedVector, IsReproduced) {
    EXPECT_EQ(sha256(GetParam().message), GetParam().digest);
}

// The examples of FIPS 180-4 and of the NIST Cryptographic Algorithm Validation Program.
INSTANTIATE_TEST_SUITE_P(
    Sha256, PublishedVector,
    testing::Values(
        Vector{"Empty", "", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        Vector{"Abc", "abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        Vector{"TwoBlocks", "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
               "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
        Vector{"FourTimes112Bits",
               "abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn"
               "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu",
               "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1"},
        Vector{"MillionTimesA", std::string(1000000, 'a'),
               "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"},
        Vector{"OneByteBd", "\xbd",
               "68325720aabd7c82f30f554b313d0570c95accbb7dc4b5aae11204c08ffe732b"},
        Vector{"FourBytes", "\xc9\x8c\x8e\x55",
               "7abc22c0ae5af26ce93dbb94433a0e0b2e119d014f8e7f65bd56c61ccccd9504"},
        Vector{"Zeros55", std::string(55, '\0'),
               "02779466cdec163811d078815c633f21901413081449002f24aa3e80f0b88ef7"},
        Vector{"Zeros56", std::string(56, '\0'),
               "d4817aa5497628e7c77e6b606107042bbba3130888c5f47a375e6179be789fbb"},
        Vector{"Zeros57", std::string(57, '\0'),
               "65a16cb7861335d5ace3c60718b5052e44660726da4cd13bb745381b235a1785"},
        Vector{"Zeros64", std::string(64, '\0'),
               "f5a5fd42d16a20302798ef6ed309979b43003d2320d9f0e8ea9831a92759fb4b"}),
    [](const auto& row) { return row.param.name; });

TEST(Sha256, IsThatOfTheWholeHoweverItsPiecesAreCut) {
    std::string bytes;
    for (int i = 0; i < 1000; ++i) {
        bytes += static_cast<char>(i * i % 251);
    }
    for (const std::size_t piece : {1, 7, 63, 64, 65, 128, 999, 1000}) {
        Sha256 hash;
        for (std::size_t at = 0; at < bytes.size(); at += piece) {
            hash.add(std::string_view(bytes).substr(at, piece));
            hash.add("");
        }
        EXPECT_EQ(hash.text(), sha256(bytes)) << piece;
    }
}

} // namespace
} // namespace irsg
