#include "smatcore/data/ColumnName.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <utility>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Quantity.h"
#include "smatcore/data/ResultDifference.h"
#include "smatcore/data/ResultTable.h"

namespace smat {

namespace {

constexpr std::array prefixes{"error_sampling_",     "error_air_", "error_background_",
                              "error_exchange_",     "error_",     "difference_",
                              "relative_difference_"};

bool isQuantity(std::string_view key) {
    for (int i = 0; i < static_cast<int>(irsg::Quantity::dimensionless); ++i)
        if (irsg::info(static_cast<irsg::Quantity>(i)).key == key)
            return true;
    return false;
}

/// The same with -2, -3, ... behind names that occur before.
std::vector<std::string> distinct(std::vector<std::string> names) {
    // A name that is given stays with the first that has it, before any that is made up.
    const std::set<std::string> given(names.begin(), names.end());
    std::set<std::string> taken;
    for (std::string& name : names) {
        std::string label = name;
        for (int number = 2; taken.contains(label) || (label != name && given.contains(label));
             ++number) {
            label = name + "-" + std::to_string(number);
        }
        taken.insert(label);
        name = label;
    }
    return names;
}

/// Where a known quantity stands in a key: behind a point or at its beginning, before an at sign or
/// at its end. Names before and behind may have points and at signs of their own.
struct QuantityPlace {
    std::size_t begin, end;
};
std::optional<QuantityPlace> quantityIn(std::string_view key) {
    for (std::size_t at = key.find('@');; at = key.find('@', at + 1)) {
        const std::size_t end = std::min(at, key.size());
        const std::size_t point = key.substr(0, end).rfind('.');
        const std::size_t begin = point == key.npos ? 0 : point + 1;
        if (begin != 1 && isQuantity(key.substr(begin, end - begin)))
            return QuantityPlace{begin, end};
        if (at == key.npos)
            return std::nullopt;
    }
}

} // namespace

ColumnName ColumnName::of(std::string_view key) {
    ColumnName name;
    for (const std::string_view prefix : prefixes) {
        if (key.starts_with(prefix)) {
            name.prefix = prefix;
            key.remove_prefix(prefix.size());
            break;
        }
    }
    std::size_t begin = 0, end = key.size();
    if (const auto place = quantityIn(key)) {
        begin = place->begin;
        end = place->end;
    } else if (const std::size_t at = key.rfind('@'); at != key.npos && at > 0) {
        end = at;
    }
    if (end + 1 >= key.size())
        end = key.size();
    else
        name.band = key.substr(end + 1);
    if (begin > 0)
        name.object = key.substr(0, begin - 1);
    name.quantity = key.substr(begin, end - begin);
    return name;
}

std::string ColumnName::key() const {
    return prefix + (object.empty() ? "" : object + ".") + quantity +
           (band.empty() ? "" : "@" + band);
}

std::string ColumnName::ofPart(std::string_view object, std::string_view part) {
    return std::string(object) + '/' + std::string(part);
}

std::string ColumnName::part() const {
    const std::size_t at = object.find('/'); // which no label has
    return at == object.npos ? std::string() : object.substr(at + 1);
}

std::string ColumnName::which() const {
    std::string shown = band;
    // "3-5um" is the label of a band without a response.
    if (shown.size() > 2 && shown.ends_with("um") &&
        std::isdigit(static_cast<unsigned char>(shown[shown.size() - 3])) != 0) {
        shown.insert(shown.size() - 2, " ");
    }
    return object + (object.empty() || shown.empty() ? "" : ", ") + shown;
}

std::vector<const ResultColumn*> columnsOf(const ResultTable& table, std::string_view series) {
    std::vector<const ResultColumn*> columns;
    for (const ResultColumn& column : table.columns())
        if (!isAbscissa(table, column) && ColumnName::of(column.key).series() == series)
            columns.push_back(&column);
    if (const ResultColumn* one = table.find(series); columns.empty() && one != nullptr)
        columns.push_back(one);
    return columns;
}

std::vector<std::string> distinctLabels(std::vector<std::string> names) {
    for (std::string& name : names) {
        std::string label;
        for (const char letter : name)
            if (letter == '/')
                label += "\u2215";
            else
                label += std::iscntrl(static_cast<unsigned char>(letter)) != 0 ? ' ' : letter;
        name = std::string(irsg::trimmed(label));
        if (name.empty())
            name = "object";
    }
    return distinct(std::move(names));
}

std::vector<std::string> distinctFileLabels(std::vector<std::string> names) {
    for (std::string& name : names) {
        std::replace_if(
            name.begin(), name.end(),
            [](unsigned char c) {
                return std::iscntrl(c) != 0 ||
                       std::string_view(",:;\"'[]@#/\\*?<>|").find(static_cast<char>(c)) !=
                           std::string_view::npos;
            },
            '_');
        if (name.empty())
            name = "object";
    }
    return distinct(std::move(names));
}

} // namespace smat
