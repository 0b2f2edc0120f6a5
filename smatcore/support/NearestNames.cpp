#include "smatcore/support/NearestNames.h"

#include <algorithm>

#include "irsg/core/Wording.h"

namespace smat {

namespace {

constexpr std::size_t mostNames = 3, lettersOfAnEdit = 3;

/// Edits from one word to the other, each stretch edited once (optimal string alignment); more than
/// `most` where there are more.
std::size_t editsBetween(std::string_view a, std::string_view b, std::size_t most) {
    if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > most)
        return most + 1;
    std::vector<std::size_t> twoBefore, before(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        before[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            now[j] = std::min(
                {before[j] + 1, now[j - 1] + 1, before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], twoBefore[j - 2] + 1);
        }
        twoBefore = before;
        before = now;
    }
    return before.back();
}

/// Without the dashes of an option.
std::string_view bare(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of('-'), text.size()));
    return text;
}

std::string_view lastPart(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

} // namespace

std::vector<std::string> nearestNames(std::string_view word,
                                      const std::vector<std::string>& names) {
    const std::string text = irsg::lowerCase(std::string(word));
    const std::string_view letters = bare(text);
    if (std::ranges::none_of(letters, [](char c) { return c >= 'a' && c <= 'z'; }))
        return {};
    const std::size_t most =
        letters.size() < 2 ? 0 : std::max<std::size_t>(1, letters.size() / lettersOfAnEdit);
    std::size_t least = most;
    std::vector<std::string> nearest, beginning;
    for (const std::string& name : names) {
        const std::string lower = irsg::lowerCase(name);
        std::size_t edits = editsBetween(text, lower, most);
        if (text.find('.') == std::string::npos)
            edits = std::min(edits, editsBetween(text, lastPart(lower), most));
        if (edits < least)
            nearest.clear();
        if (edits <= least && nearest.size() < mostNames)
            nearest.push_back(name);
        least = std::min(least, edits);
        if (letters.size() >= lettersOfAnEdit && beginning.size() < mostNames &&
            (lower.starts_with(text) || lastPart(lower).starts_with(text)))
            beginning.push_back(name);
    }
    return nearest.empty() ? beginning : nearest;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& names) {
    std::vector<std::string> nearest = nearestNames(word, names);
    if (nearest.empty())
        return "";
    for (std::string& name : nearest)
        name = "'" + name + "'";
    return "; did you mean " + irsg::alternatives(nearest) + "?";
}

std::string oneOf(const std::vector<std::string>& names, std::string_view word) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "one of " : ", ") + name;
    return list + didYouMean(word, names);
}

} // namespace smat
