#include "irsg/core/Utf8.h"

#include <gtest/gtest.h>

namespace irsg {
namespace {

TEST(Utf8, ReadsCharactersOfOneToFourBytes) {
    EXPECT_EQ(charactersOf(""), U"");
    EXPECT_EQ(charactersOf("A\x7f"), U"A\x7f");
    EXPECT_EQ(charactersOf("3–5 µm, 10⁻³, 𝛌"), U"3–5 µm, 10⁻³, 𝛌");
    EXPECT_EQ(charactersOf("\xc2\x80 \xdf\xbf \xe0\xa0\x80 \xef\xbf\xbf \xf0\x90\x80\x80 "
                           "\xf4\x8f\xbf\xbf"),
              U"\U00000080 \U000007ff \U00000800 \U0000ffff \U00010000 \U0010ffff");
}

TEST(Utf8, ReadsWhatIsNoneAsLatin1) {
    EXPECT_EQ(utf8Text("T\xc3\xbcr"), "T\xc3\xbcr");
    EXPECT_EQ(utf8Text("T\xfcr\x80"), "T\xc3\xbcr\xc2\x80");
    EXPECT_TRUE(isUtf8(utf8Text("\xff\xc3")));
    EXPECT_EQ(utf8Text(""), "");
}

TEST(Utf8, TakesTheTextOfAFileFromItsBytes) {
    std::string storage;
    EXPECT_EQ(utf8Of("\xEF\xBB\xBF\u00e9", storage), "\u00e9");
    EXPECT_TRUE(storage.empty());
    EXPECT_EQ(utf8Of(std::string_view("\xFF\xFE\xe9\0", 4), storage), "\u00e9");
    EXPECT_EQ(utf8Of("\xe9", storage), "\u00e9");
    EXPECT_EQ(storage, "\u00e9");
    EXPECT_EQ(utf8Of("", storage), "");
}

TEST(Utf8, TakesEachByteThatIsNoneByItself) {
    const struct {
        const char* name;
        std::string_view text;
        std::u32string_view characters;
    } rows[] = {
        {"a byte that never occurs", "a\xff", U"a\uFFFD"},
        {"a stray continuation", "\x80z", U"\uFFFDz"},
        {"a missing continuation", "\xe2\x88", U"\uFFFD\uFFFD"},
        {"a letter in place of one", "\xe2\x88x", U"\uFFFD\uFFFDx"},
        {"an overlong slash", "\xc0\xaf", U"\uFFFD\uFFFD"},
        {"an overlong letter of three bytes", "\xe0\x9f\xbf", U"\uFFFD\uFFFD\uFFFD"},
        {"an overlong letter of four bytes", "\xf0\x8f\xbf\xbf", U"\uFFFD\uFFFD\uFFFD\uFFFD"},
        {"a surrogate", "\xed\xa0\x80", U"\uFFFD\uFFFD\uFFFD"},
        {"beyond the last", "\xf4\x90\x80\x80", U"\uFFFD\uFFFD\uFFFD\uFFFD"},
    };
    for (const auto& row : rows) {
        EXPECT_EQ(charactersOf(row.text), row.characters) << row.name;
        EXPECT_FALSE(isUtf8(row.text)) << row.name;
    }
    EXPECT_TRUE(isUtf8("3–5 µm"));
    EXPECT_EQ(asciiText("a\xff"), "a\\xff");
}

} // namespace
} // namespace irsg
