// All that the programs say, collected from their sources into one table to read.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/FileReading.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

struct Sentence {
    std::string file; ///< from the top of the tree
    int line = 0;
    std::string text;
};

/// The literals of a source, adjacent ones joined: no comments, no raw literals, which are shaders
/// and docstrings, and no names of included files.
std::vector<Sentence> literalsOf(const std::string& source, const std::string& file) {
    std::vector<Sentence> all;
    int line = 1;
    bool isJoined = false, isIncluding = false;
    for (std::size_t i = 0; i < source.size(); ++i) {
        const char c = source[i];
        if (c == '\n') {
            ++line;
            isIncluding = false;
        } else if (c == '#') {
            isIncluding = source.compare(i, 8, "#include") == 0;
        } else if (source.compare(i, 2, "//") == 0) {
            i = std::min(source.find('\n', i), source.size()) - 1;
        } else if (source.compare(i, 2, "R\"") == 0) {
            const std::size_t open = source.find('(', i);
            const std::string close = ")" + source.substr(i + 2, open - i - 2) + "\"";
            const std::size_t end = source.find(close, open) + close.size() - 1;
            line += static_cast<int>(std::count(source.begin() + static_cast<std::ptrdiff_t>(i),
                                                source.begin() + static_cast<std::ptrdiff_t>(end),
                                                '\n'));
            i = end;
            isJoined = false;
        } else if (c == '\'') {
            // A character, or a separator of digits.
            if (i > 0 && std::isalnum(static_cast<unsigned char>(source[i - 1])) == 0) {
                i = source.find('\'', i + (source[i + 1] == '\\' ? 3 : 2));
            }
            isJoined = false;
        } else if (c == '"') {
            std::string text;
            for (++i; i < source.size() && source[i] != '"'; ++i) {
                if (source[i] == '\\') {
                    text += source[i++];
                }
                text += source[i];
            }
            if (isIncluding) {
                continue;
            }
            if (isJoined) {
                all.back().text += text;
            } else {
                all.push_back({file, line, text});
            }
            isJoined = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            isJoined = false;
        }
    }
    return all;
}

/// Literals of three words or more.
std::vector<Sentence> sentences() {
    static const std::regex words("[A-Za-z]{2,}[^A-Za-z]+[A-Za-z]{2,}[^A-Za-z]+[A-Za-z]{2,}");
    std::vector<Sentence> all;
    for (const char* top : {"gui", "smatcore", "apps", "irsg", "python/src"}) {
        const fs::path root(SMAT_SOURCE_DIR);
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            const auto kind = entry.path().extension();
            if (kind != ".cpp" && kind != ".h") {
                continue;
            }
            for (Sentence& one : literalsOf(irsg::readFile(entry.path()),
                                            entry.path().lexically_relative(root).string())) {
                if (one.text.find(' ') != one.text.npos && std::regex_search(one.text, words)) {
                    all.push_back(std::move(one));
                }
            }
        }
    }
    std::ranges::sort(all, {}, [](const Sentence& one) { return std::pair(one.file, one.line); });
    return all;
}

/// What no sentence has, and what is said instead.
struct Rule {
    const char *wrong, *why;
    const char* where = ""; ///< of files whose path begins so
};
constexpr Rule rules[] = {
    {"\\b(the|a|an|of|to|is|in|and|that|for) \\1\\b", "a word stands twice"},
    {"(^|[ (])a [aeio][a-z]", "'an' before a vowel"},
    {"(^|[ (])an [bcdfgjklmnpqrstvwz][a-z]", "'a' before a consonant"},
    {"[a-z] ,", "no blank before a comma"},
    {"[a-z] ?\\.\\.\\.", "… in one character, behind the word", "gui/"},
    {"\\bcan not\\b", "cannot"},
    {"there is as it was", "the old file is unchanged"},
    {"[Ll]ight between surfaces follows", "adding inter-reflections"},
    {"\\bStbd\\b", "starboard"},
    {"[Dd]ocks\\b", "panels", "gui/"},
    {"\\b[Tt]his air\\b|\\b[Nn]ew air\\b|\\bAir of the\\b", "atmosphere", "gui/"},
    {"[Aa]ntialiasing windows", "antialiasing tiles"},
    {"bar below says", "the bar below shows the progress"},
    {"cannot be kept", "cannot be saved", "gui/"},
    {"\\b(Largest|Least) (pixel|detection range|altitude)", "highest, lowest; longest, shortest"},
    {"\\bapart by\\b", "separated by"},
    {"is drawn anew", "is rendered again"},
};

} // namespace

TEST(SentenceTable, LiteralsAreFoundInSources) {
    const auto found = literalsOf("#include \"a b c\"\nf(\"one two\"\n  \" three\", 'x', '\"');\n"
                                  "// \"no\"\ng(R\"(raw\n text)\", \"a \\\"b\\\"\", 1'000);\n",
                                  "f.cpp");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].text, "one two three");
    EXPECT_EQ(found[0].line, 2);
    EXPECT_EQ(found[1].text, "a \\\"b\\\"");
    EXPECT_EQ(found[1].line, 6);
}

// The table lies in the build folder as sentences.tsv: file and line, and what is said.
TEST(SentenceTable, HasNoneThatAnEngineerWouldNotSay) {
    const std::vector<Sentence> all = sentences();
    ASSERT_GT(all.size(), 4000u);
    std::ofstream table(fs::path(SMAT_BINARY_DIR) / "sentences.tsv");
    for (const Sentence& one : all) {
        table << one.file << ':' << one.line << '\t' << one.text << '\n';
    }
    for (const Rule& rule : rules) {
        const std::regex wrong(rule.wrong);
        for (const Sentence& one : all) {
            if (one.file.starts_with(rule.where)) {
                EXPECT_FALSE(std::regex_search(one.text, wrong))
                    << one.file << ":" << one.line << ": \"" << one.text << "\"\n"
                    << rule.why;
            }
        }
    }
}

} // namespace smat::gui
