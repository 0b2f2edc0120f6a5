#include <algorithm>
#include <cmath>
#include <set>

#include <nlohmann/json.hpp>

#include "irsg/core/JsonReader.h"
#include "smatcore/data/ResultTable.h"

namespace smat {

namespace {

using irsg::JsonReader;
using OrderedJson = nlohmann::ordered_json;

} // namespace

std::string ResultTable::toJson() const {
    OrderedJson provenanceJson = OrderedJson::array();
    for (const auto& [key, value] : provenance.entries)
        provenanceJson.push_back({{"key", key}, {"value", value}});
    OrderedJson columnsJson = OrderedJson::array();
    for (const ResultColumn& column : columns_) {
        OrderedJson values = OrderedJson::array();
        for (const double value : column.values)
            values.push_back(std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr));
        columnsJson.push_back({{"name", column.key}, {"unit", column.unit}, {"values", values}});
    }
    OrderedJson json{{"provenance", provenanceJson}, {"columns", columnsJson}};
    if (!warnings_.empty())
        json["warnings"] = warnings_;
    return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

ResultTable ResultTable::fromJson(const JsonReader& json) {
    ResultTable table;
    for (const JsonReader& entry : json.at("provenance").list()) {
        const std::string key = entry.at("key").text();
        table.provenance.add(key, entry.at("value").text());
    }
    std::set<std::string> names;
    for (const JsonReader& entry : json.at("columns").list()) {
        const JsonReader name = entry.at("name"), values = entry.at("values");
        ResultColumn column{name.text(), entry.at("unit").text(), values.numbersOrNull()};
        if (column.key.empty() || !names.insert(column.key).second)
            name.refuse("a name, another for each column");
        if (!table.columns_.empty() && column.values.size() != table.rowCount())
            values.refuse(std::to_string(column.values.size()) + " values",
                          std::to_string(table.rowCount()) + " values");
        table.columns_.push_back(std::move(column));
    }
    if (const JsonReader warnings = json.at("warnings"); warnings.exists()) {
        const std::vector<std::string> texts = warnings.texts("a list of texts");
        if (texts.size() != table.rowCount())
            warnings.refuse(std::to_string(texts.size()) + " texts",
                            std::to_string(table.rowCount()) + " texts, one for each row");
        for (std::size_t row = 0; row < std::min(texts.size(), table.rowCount()); ++row)
            table.setWarning(row, texts[row]);
    }
    return table;
}

} // namespace smat
