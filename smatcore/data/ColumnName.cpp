#include "smatcore/data/ColumnName.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

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
    // A band has points in it, "3.4-4.1um", an object's name may have some.
    if (const std::size_t at = key.rfind('@'); at != key.npos && at > 0 && at + 1 < key.size()) {
        name.band = key.substr(at + 1);
        key = key.substr(0, at);
    }
    const std::size_t point = key.rfind('.');
    if (point != key.npos && point > 0 && isQuantity(key.substr(point + 1))) {
        name.object = key.substr(0, point);
        key.remove_prefix(point + 1);
    }
    name.quantity = key;
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
        std::replace_if(
            name.begin(), name.end(),
            [](unsigned char c) {
                return std::iscntrl(c) != 0 ||
                       std::string_view(",\"[]@#/\\").find(static_cast<char>(c)) !=
                           std::string_view::npos;
            },
            '_');
        if (name.empty())
            name = "object";
    }
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

} // namespace smat
