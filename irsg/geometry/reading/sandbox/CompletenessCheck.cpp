#include "irsg/geometry/reading/sandbox/CompletenessCheck.h"
#include "irsg/geometry/reading/sandbox/GraphExtent.h"
#include "irsg/geometry/reading/text/ModelText.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

struct Shortage {
    std::size_t at = 0; ///< byte; lines are counted where the file is a text
    std::string value, expected;
};

[[noreturn]] void refuse(std::size_t at, std::string value, std::string expected) {
    throw Shortage{at, std::move(value), std::move(expected)};
}

using Remarks = std::vector<std::string>;

/// Readers of others walk their file level by level and run out of stack; a graph may have
/// mostLevels of them, each of which is at most two brackets, tags or objects in a file.
constexpr long mostNested = 2 * mostLevels + 100;

void checkDepth(long levels, std::size_t at) {
    if (levels > mostNested)
        refuse(at, "more than " + std::to_string(mostNested) + " levels in each other",
               "a model in fewer levels");
}

/// Texts in quotation marks may hold brackets.
void checkBrackets(std::string_view text, Remarks&) {
    long open = 0;
    std::size_t last = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (quoted && text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            quoted = !quoted;
        else if (!quoted && text[i] == '{')
            checkDepth(++open, last = i);
        else if (!quoted && text[i] == '}' && --open < 0)
            refuse(i, "a bracket \"}\" that nothing opened", "as many \"{\" before it");
    if (quoted)
        refuse(text.size(), "the end of the file in a text in quotation marks", "its end");
    if (open > 0)
        refuse(last,
               "the end of the file before " + std::to_string(open) + " brackets \"{\" are closed",
               "a whole file");
}

void checkTags(std::string_view text, Remarks&) {
    long levels = 0;
    for (auto at = text.find('<'); at != text.npos; at = text.find('<', at + 1)) {
        const auto close = text.find('>', at);
        const char next = at + 1 < text.size() ? text[at + 1] : '\0';
        if (next == '/')
            --levels;
        else if (next != '?' && next != '!' && close != text.npos && text[close - 1] != '/')
            checkDepth(++levels, at);
    }
    const auto end = text.find_last_not_of(" \t\r\n");
    const auto begin = end == text.npos ? text.npos : text.rfind('<', end);
    if (begin == text.npos || text[end] != '>' || text.substr(begin, 2) != "</")
        refuse(text.size(), "the end of the file before its outermost tag is closed",
               "a whole file");
}

std::size_t number(std::string_view bytes, std::size_t at, bool bigEndian) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[at + (bigEndian ? i : 3 - i)]);
        value = value << 8 | byte;
    }
    return value;
}

/// Chunks of 3D Studio: two bytes of kind, four of length with all that is in it. Those that hold
/// others stand in two levels, so that more of them are no model but a way to run out of stack.
void checkChunks(std::string_view bytes, std::size_t begin, std::size_t end,
                 std::map<std::size_t, long>& found, int levels = 8) {
    if (levels == 0 && begin < end)
        refuse(begin, "a chunk in 8 others", "chunks in at most 7 others");
    for (std::size_t at = begin; at < end;) {
        if (end - at < 6)
            refuse(at, "a chunk of " + std::to_string(end - at) + " bytes", "6 bytes or more");
        const std::size_t kind = static_cast<unsigned char>(bytes[at]) |
                                 static_cast<unsigned>(static_cast<unsigned char>(bytes[at + 1]))
                                     << 8;
        const std::size_t length = number(bytes, at + 2, false);
        if (length < 6 || length > end - at)
            refuse(at, "a chunk of " + std::to_string(length) + " bytes",
                   "6 to " + std::to_string(end - at) + " bytes, which are left");
        ++found[kind];
        // Those with chunks in them and nothing before, and objects, behind their names.
        if (kind == 0x4D4D || kind == 0x3D3D || kind == 0x4100)
            checkChunks(bytes, at + 6, at + length, found, levels - 1);
        if (const std::size_t name = bytes.find('\0', at + 6); kind == 0x4000 && name < at + length)
            checkChunks(bytes, name + 1, at + length, found, levels - 1);
        at += length;
    }
}

void checkStudio(std::string_view bytes, Remarks& remarks) {
    if (bytes.size() < 6)
        refuse(bytes.size(), "the end of the file", "a chunk of 6 bytes or more");
    std::map<std::size_t, long> found;
    checkChunks(bytes, 0, std::min(bytes.size(), std::max<std::size_t>(6, number(bytes, 2, false))),
                found);
    for (const auto& [kind, what] :
         {std::pair{0x0100u, " scale of the scene (chunk 0100) is not followed: a unit is 1 m"},
          {0x4010u, " objects are hidden (chunk 4010) and are read nevertheless"},
          {0x4600u, " lights (chunk 4600) are left out"},
          {0x4700u, " cameras (chunk 4700) are left out"},
          {0xB000u, " keyframes (chunk B000) are not played: parts are where the file puts them"}})
        if (const auto known = found.find(kind); known != found.end())
            remarks.push_back(std::to_string(known->second) + what);
    if (number(bytes, 2, false) > bytes.size())
        refuse(2, "a file of " + std::to_string(number(bytes, 2, false)) + " bytes",
               "at most " + std::to_string(bytes.size()) + ", which there are");
}

void checkForm(std::string_view bytes, Remarks&) {
    if (bytes.size() < 12 || bytes.substr(0, 4) != "FORM")
        refuse(0, "a file that does not begin with FORM", "a Lightwave object");
    if (number(bytes, 4, true) + 8 > bytes.size())
        refuse(4, "a form of " + std::to_string(number(bytes, 4, true)) + " bytes",
               "at most " + std::to_string(bytes.size() - 8) + ", which are left");
}

/// Objects with so many others in them, lines of vertices and of corners, surfaces: as many of each
/// as an AC3D file says. Counts of objects that were left as they were when somebody took objects
/// out are common; the file then ends behind a whole object.
void checkObjects(std::string_view text, Remarks& remarks) {
    double objects = 1.0, surfaces = 0.0;
    long open = 0;            ///< objects whose last line, "kids", has not come
    std::vector<double> kids; ///< of the objects around a place: those that have not come
    long lights = 0, subdivided = 0, hidden = 0;
    long beyond = 0; ///< objects behind the last that is counted
    bool wasAny = false, isBeyond = false;
    std::size_t at = 0, lastCount = 0;
    const auto line = [&] {
        const std::size_t begin = at;
        at = std::min(text.find('\n', at), text.size() - 1) + 1;
        return text.substr(begin, at - begin);
    };
    while (at < text.size()) {
        const std::size_t begin = at;
        std::string_view whole = line();
        whole.remove_prefix(std::min(whole.find_first_not_of(" \t"), whole.size()));
        const auto space = whole.find_first_of(" \t");
        const std::string_view word = whole.substr(0, std::min(space, whole.find_first_of("\r\n")));
        std::string_view rest = space == whole.npos ? "" : whole.substr(space);
        rest = rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size()));
        rest = rest.substr(0, rest.find_first_of(" \t\r\n"));
        const double count = parseNumber(rest).value_or(0.0);
        if (word == "OBJECT") {
            while (!kids.empty() && kids.back() <= 0.0)
                kids.pop_back();
            if (!kids.empty())
                kids.back() -= 1.0;
            isBeyond = isBeyond || (kids.empty() && wasAny);
            beyond += isBeyond ? 1 : 0;
            wasAny = true;
            objects -= 1.0;
            ++open;
            lastCount = begin;
            lights += rest == "light" ? 1 : 0;
        } else if (word == "subdiv" && count > 0.0) {
            ++subdivided;
        } else if (word == "hidden") {
            ++hidden;
        } else if (word == "SURF") {
            surfaces -= 1.0;
        } else if (word == "kids" || word == "numsurf") {
            (word == "kids" ? objects : surfaces) += count;
            if (word == "kids") {
                kids.push_back(count);
                checkDepth(static_cast<long>(kids.size()), begin);
            }
            open -= word == "kids";
            lastCount = begin;
        } else if (word == "data") {
            at = count < static_cast<double>(text.size() - at)
                     ? at + static_cast<std::size_t>(std::max(count, 0.0))
                     : text.size();
        } else if (word == "numvert" || word == "refs") {
            double found = 0.0;
            while (found < count && at < text.size()) {
                line();
                ++found;
            }
            if (found < count || (count > 0.0 && text.back() != '\n' && at >= text.size()))
                refuse(begin, "the end of the file within " + numberText(count) + " lines",
                       "all of them");
        }
    }
    const auto say = [&](long number, const char* what) {
        if (number > 0)
            remarks.push_back(std::to_string(number) + what);
    };
    say(lights, " objects of kind light are left out");
    say(subdivided, " objects are subdivided where they are shown (subdiv): they are read as the "
                    "file has them");
    say(beyond, " objects stand behind the last that the file counts (kids) and are left out");
    say(hidden, " objects are hidden and are read nevertheless");
    std::string_view last = text.substr(lastCount);
    last.remove_prefix(std::min(last.find_first_not_of(" \t"), last.size()));
    const bool endsWhole = open == 0 && surfaces <= 0.0 &&
                           (last.starts_with("kids ") || last.starts_with("kids\t")) &&
                           last.find_first_of("0123456789") != last.npos &&
                           last.find_first_not_of(" \t\n", last.find('\n')) == last.npos;
    if (endsWhole && objects > 0.0)
        remarks.push_back("the file counts " + numberText(objects) +
                          " more objects than it has (kids): miscounted, or cut behind an object");
    else if (surfaces > 0.0 || objects > 0.0 || open > 0)
        refuse(lastCount,
               "the end of the file before " + (surfaces > 0.0  ? numberText(surfaces) + " surfaces"
                                                : objects > 0.0 ? numberText(objects) + " objects"
                                                                : "the end of an object"),
               "a whole file");
}

struct Check {
    const char* extension;
    void (*check)(std::string_view, Remarks&);
    bool isText;
};

constexpr Check checks[] = {
    {".osg", checkBrackets, true}, {".osgt", checkBrackets, true}, {".x", checkBrackets, true},
    {".osgx", checkTags, true},    {".3ds", checkStudio, false},   {".lwo", checkForm, false},
    {".ac", checkObjects, true},
};

} // namespace

std::vector<std::string> checkCompleteness(const std::filesystem::path& place,
                                           const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    const auto* check = std::ranges::find_if(
        checks, [&](const Check& known) { return extension == known.extension; });
    if (check == std::end(checks))
        return {};
    const std::string bytes = readModelBytes(place, file);
    // Binary files of some kinds have the extension of text.
    if (check->isText && bytes.substr(0, 256).find('\0') != bytes.npos)
        return {};
    try {
        Remarks remarks;
        check->check(bytes, remarks);
        return remarks;
    } catch (const Shortage& shortage) {
        const std::size_t at = std::min(shortage.at, bytes.size());
        const auto lines =
            1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        throw InputError(
            {file.string(),
             check->isText ? "line " + std::to_string(lines) : "byte " + std::to_string(at),
             shortage.value, shortage.expected});
    }
}

} // namespace irsg
