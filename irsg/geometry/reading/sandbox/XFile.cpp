#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/geometry/reading/sandbox/DeclaredContents.h"
#include "irsg/geometry/reading/text/ModelText.h"
#include "irsg/geometry/reading/text/UnitWords.h"

namespace irsg {

namespace {

/// What would move vertices of a mesh, or describes them in another form.
constexpr std::string_view notFollowed[] = {"SkinWeights",
                                            "DeclData",
                                            "FVFData",
                                            "PMInfo",
                                            "MeshFaceWraps",
                                            "FaceAdjacency",
                                            "VertexDuplicationIndices"};

/// A text of DirectX, word by word: names and numbers, brackets, texts in quotation marks, and what
/// stands between values.
class XText {
  public:
    explicit XText(std::string_view text) : text_(text) {}

    DeclaredContents read() {
        findMaterials();
        DeclaredContents stated;
        stated.axes.up = ModelAxis::plusZ;
        stated.axes.reason = "the custom of .x: y up, turned to z on reading";
        stated.text = rewritten();
        stated.axes.spokenUnit = unit_;
        for (const auto& [kind, count] : others_)
            stated.remarks.push_back(std::to_string(count) + " " + kind +
                                     " are left out: meshes have their faces as the file lists "
                                     "them");
        return stated;
    }

  private:
    struct Word {
        std::size_t begin = 0, end = 0;
        char first = '\0'; ///< '\0' behind the last word
    };

    /// The next word; comments and blanks before it are passed over.
    Word next() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            const bool comment = c == '#' || text_.substr(at_).starts_with("//");
            if (comment) {
                const std::size_t end = std::min(text_.find('\n', at_), text_.size());
                if (!unit_)
                    unit_ = unitInWords(text_.substr(at_, end - at_));
                at_ = end;
            } else if (std::isspace(static_cast<unsigned char>(c))) {
                ++at_;
            } else {
                break;
            }
        }
        if (at_ >= text_.size())
            return {at_, at_, '\0'};
        const std::size_t begin = at_;
        const char c = text_[at_];
        constexpr std::string_view marks = "{};,\"<>[]";
        if (c == '"')
            at_ = std::min(text_.find('"', at_ + 1), text_.size() - 1) + 1;
        else if (marks.find(c) != marks.npos)
            ++at_;
        else
            while (at_ < text_.size() && marks.find(text_[at_]) == marks.npos &&
                   !std::isspace(static_cast<unsigned char>(text_[at_])))
                ++at_;
        return {begin, at_, c};
    }
    std::string_view at(const Word& word) const {
        return text_.substr(word.begin, word.end - word.begin);
    }
    bool isName(const Word& word) {
        return std::isalpha(static_cast<unsigned char>(word.first)) != 0 || word.first == '_';
    }

    /// Materials that stand for themselves, by name, with their brackets.
    void findMaterials() {
        at_ = 0;
        int level = 0;
        Word before, last;
        std::string name;
        std::size_t begin = 0;
        for (Word word = next(); word.first != '\0'; word = next()) {
            if (word.first == '{' && level++ == 0) {
                name = isName(last) && at(before) == "Material" ? std::string(at(last)) : "";
                begin = word.begin;
            } else if (word.first == '}' && --level == 0 && !name.empty()) {
                materials_.emplace(name, text_.substr(begin, word.end - begin));
            }
            before = last;
            last = word;
        }
    }

    /// For Assimp: it takes "1,0" for a number with a fraction, finds only the materials of the
    /// first mesh by their names, and gives a mesh the name of its frame. So a blank follows each
    /// comma, materials stand where they are referred to, and a mesh with a name gets a frame of
    /// that name.
    std::string rewritten() {
        at_ = 0;
        std::string text;
        text.reserve(text_.size() + text_.size() / 4);
        std::size_t copied = 0;
        const auto copyTo = [&](std::size_t end) {
            text += text_.substr(copied, end - copied);
            copied = end;
        };
        const std::size_t most = 8 * text_.size() + 65536;
        std::vector<bool> isFramed; ///< by open bracket
        Word before, last;
        for (Word word = next(); word.first != '\0'; word = next()) {
            if (word.first == ',') {
                copyTo(word.end);
                text += ' ';
            } else if (word.first == '{') {
                if (isName(last) && at(before) != "template")
                    ++others_[std::string(at(isName(before) ? before : last))];
                const bool framed = isName(last) && at(before) == "Mesh";
                if (framed) {
                    copyTo(before.begin);
                    text += "Frame " + std::string(at(last)) + " {\n";
                }
                isFramed.push_back(framed);
            } else if (word.first == '}' && !isFramed.empty()) {
                const auto material = before.first == '{' && isName(last)
                                          ? materials_.find(std::string(at(last)))
                                          : materials_.end();
                if (material != materials_.end() && text.size() < most) {
                    copyTo(before.begin);
                    text += "Material " + material->first + " " + spaced(material->second);
                    copied = word.end;
                }
                if (isFramed.back()) {
                    copyTo(word.end);
                    text += "\n}";
                }
                isFramed.pop_back();
            }
            before = last;
            last = word;
        }
        copyTo(text_.size());
        std::erase_if(others_, [](const auto& one) {
            return std::ranges::find(notFollowed, one.first) == std::end(notFollowed);
        });
        return text;
    }

    static std::string spaced(std::string_view text) {
        std::string wide;
        for (const char c : text) {
            wide += c;
            if (c == ',')
                wide += ' ';
        }
        return wide;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::map<std::string, std::string_view> materials_;
    std::map<std::string, long> others_; ///< objects by their kind
    std::optional<UnitInWords> unit_;
};

} // namespace

DeclaredContents readXFile(const std::filesystem::path& place, const std::filesystem::path& file) {
    const std::string bytes = readModelBytes(place, file);
    constexpr std::size_t headSize = 16; // "xof 0303txt 0032"
    if (bytes.size() < headSize || bytes.substr(8, 4) != "txt ")
        return {};
    return XText(bytes).read();
}

} // namespace irsg
