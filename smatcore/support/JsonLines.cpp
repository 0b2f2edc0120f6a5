#include "smatcore/support/JsonLines.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "irsg/radiometry/Errors.h"

namespace smat {

namespace {

/// One object or array that is open.
struct Level {
    std::string path;
    bool isObject = false;
    std::size_t index = 0; ///< of the next value of an array
    std::string key = {};  ///< of the next value of an object
    bool keyIsNext = true;
};

/// The end of the string that begins with the quote at `begin`: the position behind its last quote.
std::size_t endOfString(std::string_view text, std::size_t begin) {
    std::size_t i = begin + 1;
    while (i < text.size() && text[i] != '"') {
        i += text[i] == '\\' ? 2 : 1;
    }
    return std::min(i + 1, text.size());
}

} // namespace

JsonLines::JsonLines(std::string_view text) {
    std::vector<Level> open;
    int line = 1;
    // Whoever says JSON and hands over something else would read and write beside the stack.
    const auto innermost = [&]() -> Level& {
        if (open.empty()) {
            throw irsg::LogicError("a text that is not JSON was searched for its lines");
        }
        return open.back();
    };
    const auto pathOfNext = [&] {
        if (open.empty()) {
            return std::string();
        }
        const Level& level = open.back();
        return joinedKeyPath(level.path, level.isObject ? level.key : std::to_string(level.index));
    };
    const auto note = [&](const std::string& path) {
        if (!lines_.emplace(path, line).second) {
            duplicates_.emplace_back(path, line);
        }
    };
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF"; // allowed before JSON
    for (std::size_t i = text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
         i < text.size();) {
        const char c = text[i];
        if (c == '{' || c == '[') {
            const std::string path = pathOfNext();
            note(path);
            open.push_back({.path = path, .isObject = c == '{'});
            ++i;
        } else if (c == '}' || c == ']') {
            innermost();
            open.pop_back();
            ++i;
        } else if (c == ',') {
            ++innermost().index;
            innermost().keyIsNext = true;
            ++i;
        } else if (c == '"') {
            const std::size_t end = endOfString(text, i);
            if (!open.empty() && open.back().isObject && open.back().keyIsNext) {
                open.back().key = nlohmann::json::parse(text.substr(i, end - i)).get<std::string>();
                open.back().keyIsNext = false;
            } else {
                note(pathOfNext());
            }
            i = end;
        } else if (c == ':' || c == ' ' || c == '\t' || c == '\r' || c == '\n') {
            line += c == '\n' ? 1 : 0;
            ++i;
        } else {
            note(pathOfNext()); // a number, true, false or null
            i = std::min(text.find_first_of(",]} \t\r\n", i), text.size());
        }
    }
}

int JsonLines::line(const std::string& path) const {
    const auto found = lines_.find(path);
    return found == lines_.end() ? 0 : found->second;
}

int lineOfByte(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

std::size_t byteOfNesting(std::string_view text, int depth) {
    int open = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') {
            i = endOfString(text, i) - 1;
        } else if (text[i] == '{' || text[i] == '[') {
            if (++open > depth) {
                return i;
            }
        } else if (text[i] == '}' || text[i] == ']') {
            --open;
        }
    }
    return std::string_view::npos;
}

std::string joinedKeyPath(const std::string& path, const std::string& key) {
    return path.empty() ? key : key.empty() ? path : path + "." + key;
}

} // namespace smat
