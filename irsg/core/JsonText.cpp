#include "irsg/core/JsonText.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

using nlohmann::json;

constexpr std::size_t longestValue = 80;

/// The words of a JSON text, one behind the other.
class Words {
  public:
    struct Word {
        char kind; ///< a bracket, comma or colon; '"' a string, '0' any other value, '\0' the end
        std::size_t begin, end;
    };

    Words(std::string_view text, bool mayComment) : text_(text), mayComment_(mayComment) {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF"; // allowed before JSON
        if (text_.starts_with(byteOrderMark))
            at_ = byteOrderMark.size();
    }

    Word next() {
        while (skipBlank() || (mayComment_ && skipComment())) {
        }
        if (at_ >= text_.size())
            return {'\0', at_, at_};
        const std::size_t begin = at_;
        const char c = text_[at_];
        if (std::string_view("{}[],:").find(c) != std::string_view::npos) {
            ++at_;
            return {c, begin, at_};
        }
        if (c == '"') {
            for (++at_; at_ < text_.size() && text_[at_] != '"';)
                at_ += text_[at_] == '\\' ? 2 : 1;
            at_ = std::min(at_ + 1, text_.size());
            return {'"', begin, at_};
        }
        at_ = std::min(text_.find_first_of("{}[],:\" \t\r\n/", at_ + 1), text_.size());
        return {'0', begin, at_};
    }
    /// Of the last word, from 1.
    int line() const { return line_; }

  private:
    bool skipBlank() {
        const std::size_t from = at_;
        for (; at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])); ++at_)
            line_ += text_[at_] == '\n';
        return at_ > from;
    }
    bool skipComment() {
        const std::string_view begin = text_.substr(std::min(at_, text_.size()), 2);
        if (begin != "//" && begin != "/*")
            return false;
        const std::size_t end = text_.find(begin == "//" ? "\n" : "*/", at_ + 2);
        const std::size_t behind = end == text_.npos ? text_.size() : end + (begin == "//" ? 0 : 2);
        line_ +=
            static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                        text_.begin() + static_cast<std::ptrdiff_t>(behind), '\n'));
        at_ = behind;
        return true;
    }

    std::string_view text_;
    bool mayComment_;
    std::size_t at_ = 0;
    int line_ = 1;
};

/// The first byte at which more than `depth` lists and objects are open, or npos.
std::size_t byteOfNesting(const std::string& text, const JsonForm& form) {
    int open = 0;
    Words words(text, form.mayComment);
    for (auto word = words.next(); word.kind != '\0'; word = words.next()) {
        if ((word.kind == '{' || word.kind == '[') && ++open > form.deepest)
            return word.begin;
        open -= word.kind == '}' || word.kind == ']';
    }
    return std::string::npos;
}

/// One object or list that is open.
struct Level {
    bool isObject = false;
    std::size_t index = 0; ///< of the next value of a list
    std::string key = {};  ///< of the next value of an object
    bool keyIsNext = true;
    std::set<std::string> keys = {}; ///< of an object, so far
};

/// Of the next value; its beginning is left out where it is long, as who makes keys up may make
/// them so.
std::string pathOf(const std::vector<Level>& open) {
    constexpr std::size_t longest = 300;
    std::string path;
    for (auto level = open.rbegin(); level != open.rend(); ++level) {
        path = joinedKeyPath(level->isObject ? level->key : std::to_string(level->index), path);
        if (path.size() > longest)
            return "..." + path.substr(path.size() - longest);
    }
    return path;
}

std::string textOfString(std::string_view quoted) {
    if (quoted.find('\\') == quoted.npos && quoted.size() >= 2)
        return std::string(quoted.substr(1, quoted.size() - 2));
    return json::parse(quoted).get<std::string>();
}

/// Follows the objects and lists of a text that is JSON. Calls `value` for every value (with the
/// levels that are open around it, its line and whether it is an object or a list itself), `close`
/// behind every object and list, and `twice` (with the levels and the line) for every key that its
/// object has already.
template <typename Value, typename Close, typename Twice>
void walk(std::string_view text, bool mayComment, const Value& value, const Close& close,
          const Twice& twice) {
    std::vector<Level> open;
    Words words(text, mayComment);
    // Whoever says JSON and hands over something else would read and write beside the stack.
    const auto innermost = [&]() -> Level& {
        if (open.empty())
            throw LogicError("a text that is not JSON was searched for its lines");
        return open.back();
    };
    for (auto word = words.next(); word.kind != '\0'; word = words.next()) {
        switch (word.kind) {
        case '{':
        case '[':
            value(open, words.line(), true);
            open.push_back({.isObject = word.kind == '{'});
            break;
        case '}':
        case ']':
            innermost();
            open.pop_back();
            close();
            break;
        case ',':
            ++innermost().index;
            innermost().keyIsNext = true;
            break;
        case ':':
            break;
        default:
            if (word.kind == '"' && !open.empty() && open.back().isObject &&
                open.back().keyIsNext) {
                open.back().key = textOfString(text.substr(word.begin, word.end - word.begin));
                open.back().keyIsNext = false;
                if (!open.back().keys.insert(open.back().key).second)
                    twice(open, words.line());
            } else
                value(open, words.line(), false);
        }
    }
}

std::string placeOf(const std::string& text, std::size_t byte) {
    const std::string_view before = std::string_view(text).substr(0, byte);
    const std::size_t lineBegin = before.rfind('\n') + 1;
    return "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n')) +
           ", column " + std::to_string(1 + before.size() - lineBegin);
}

/// "runs[3].kind" as "runs.3.kind"; brackets that are part of a key ("range [m]") stay.
std::string plainPath(const std::string& path) {
    std::string plain;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const std::size_t end = path.find_first_not_of("0123456789", i + 1);
        if (path[i] == '[' && end != path.npos && end > i + 1 && path[end] == ']') {
            plain += '.' + path.substr(i + 1, end - i - 1);
            i = end;
        } else
            plain += path[i];
    }
    return plain;
}

} // namespace

json parseJson(const std::string& text, const std::string& file, const JsonForm& form) {
    const auto refuse = [&](std::size_t byte, std::string value, std::string expected) {
        throw InputError({file, placeOf(text, byte), std::move(value), std::move(expected)});
    };
    if (const std::size_t zero = text.find('\0'); zero != text.npos)
        refuse(zero, "a zero byte", form.expected);
    if (const std::size_t tooDeep = byteOfNesting(text, form); tooDeep != text.npos)
        refuse(tooDeep,
               "lists or objects nested more than " + std::to_string(form.deepest) + " deep",
               form.expected);
    json root;
    try {
        root = json::parse(text, nullptr, true, form.mayComment);
    } catch (const json::parse_error& error) {
        const bool ended = error.byte > text.size() || text.empty();
        refuse(error.byte > 0 ? error.byte - 1 : 0,
               ended ? "the end of the text" : "text that is not JSON", form.expected);
    } catch (const json::out_of_range& error) {
        // The library's words: "number overflow parsing '1e999'".
        const std::string_view words = error.what();
        const std::size_t from = words.find('\''), to = words.rfind('\'');
        const std::string number(from < to ? words.substr(from + 1, to - from - 1) : "");
        refuse(std::min(text.find(number), text.size()),
               "the number " + number + ", which is too large",
               "numbers of magnitude below 1.8e308");
    }
    std::vector<Diagnostic> twice;
    walk(
        text, form.mayComment, [](const auto&, int, bool) {}, [] {},
        [&](const std::vector<Level>& open, int line) {
            twice.push_back({file, pathOf(open) + ", line " + std::to_string(line),
                             "a key that occurs twice", "every key once"});
        });
    if (!twice.empty())
        throw InputError(std::move(twice));
    return root;
}

std::string shownJson(const json& value) {
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > longestValue)
        text = text.substr(0, longestValue - 3) + "...";
    return text;
}

std::string joinedKeyPath(const std::string& path, const std::string& key) {
    return path.empty() ? key : key.empty() ? path : path + "." + key;
}

/// The lines of the values of objects and lists; what a value takes does not grow with its path.
struct JsonPlaces::Tree {
    struct Place {
        int line = 0;
        int node = -1; ///< of an object or a list
    };
    struct Node {
        std::map<std::string, Place, std::less<>> members;
        std::vector<Place> items;

        /// The value that a path begins with, and what follows it in the path.
        std::pair<const Place*, std::string_view> find(std::string_view path) const {
            if (members.empty()) {
                const std::size_t end = std::min(path.find_first_not_of("0123456789"), path.size());
                std::size_t index = items.size();
                std::from_chars(path.data(), path.data() + end, index);
                return {index < items.size() ? &items[index] : nullptr, behind(path, end)};
            }
            // Keys may hold what separates them from each other.
            for (std::size_t end = path.size();;) {
                if (const auto found = members.find(path.substr(0, end)); found != members.end())
                    return {&found->second, behind(path, end)};
                end = end == 0 ? path.npos : path.find_last_of("., ", end - 1);
                if (end == path.npos)
                    return {nullptr, {}};
            }
        }
        static std::string_view behind(std::string_view path, std::size_t end) {
            return end < path.size() && path[end] == '.' ? path.substr(end + 1)
                                                         : std::string_view();
        }
    };
    std::vector<Node> nodes;
    Place root;

    explicit Tree(std::string_view text, bool mayComment) {
        std::vector<int> open;
        walk(
            text, mayComment,
            [&](const std::vector<Level>& levels, int line, bool holdsMore) {
                Place place{line, holdsMore ? static_cast<int>(nodes.size()) : -1};
                if (levels.empty())
                    root = place;
                else if (Node& around = nodes[static_cast<std::size_t>(open.back())];
                         levels.back().isObject)
                    around.members.emplace(levels.back().key, place);
                else
                    around.items.push_back(place);
                if (holdsMore) {
                    open.push_back(place.node);
                    nodes.emplace_back();
                }
            },
            [&] { open.pop_back(); }, [](const std::vector<Level>&, int) {});
    }

    /// The line of the value, or where there is none of what should hold it; and which of both.
    std::pair<int, bool> find(std::string_view path) const {
        Place place = root;
        while (!path.empty()) {
            if (place.node < 0)
                return {place.line, false};
            const auto [next, rest] = nodes[static_cast<std::size_t>(place.node)].find(path);
            if (!next)
                return {place.line, false};
            place = *next;
            path = rest;
        }
        return {place.line, true};
    }
};

const JsonPlaces::Tree& JsonPlaces::tree() const {
    if (!tree_)
        tree_ = std::make_shared<const Tree>(text_, mayComment_);
    return *tree_;
}

int JsonPlaces::line(const std::string& path) const {
    const auto [line, isThere] = tree().find(plainPath(path));
    return isThere ? line : 0;
}

std::string JsonPlaces::position(const std::string& path) const {
    if (path.empty() || text_.find('\n') >= text_.find_last_not_of(" \t\r\n"))
        return path;
    return path + ", line " + std::to_string(tree().find(plainPath(path)).first);
}

} // namespace irsg
