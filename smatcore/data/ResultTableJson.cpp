#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "irsg/radiometry/Errors.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/support/JsonText.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

using Json = nlohmann::ordered_json;

} // namespace

std::string ResultTable::toJson() const {
    Json provenanceJson = Json::array();
    for (const auto& [key, value] : provenance.entries) {
        provenanceJson.push_back({{"key", key}, {"value", value}});
    }
    Json columnsJson = Json::array();
    for (const ResultColumn& column : columns_) {
        Json values = Json::array();
        for (const double value : column.values) {
            values.push_back(std::isfinite(value) ? Json(value) : Json(nullptr));
        }
        columnsJson.push_back({{"name", column.key}, {"unit", column.unit}, {"values", values}});
    }
    return Json{{"provenance", provenanceJson}, {"columns", columnsJson}}.dump(
               1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

ResultTable ResultTable::fromJson(const std::filesystem::path& file) {
    const std::string name = file.string();
    const Json json =
        parseJsonText<Json>(readTextFile(file), name, "the JSON form of a result table");
    try {
        ResultTable table;
        for (const Json& entry : json.at("provenance")) {
            table.provenance.add(entry.at("key").get<std::string>(),
                                 entry.at("value").get<std::string>());
        }
        for (const Json& entry : json.at("columns")) {
            ResultColumn column{
                entry.at("name").get<std::string>(), entry.at("unit").get<std::string>(), {}};
            for (const Json& value : entry.at("values")) {
                column.values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                                        : value.get<double>());
            }
            if (!table.columns_.empty() && column.values.size() != table.rowCount()) {
                throw irsg::InputError({.file = name,
                                        .position = "columns." + column.key,
                                        .value = std::to_string(column.values.size()) + " values",
                                        .expected = std::to_string(table.rowCount()) + " values"});
            }
            table.columns_.push_back(std::move(column));
        }
        return table;
    } catch (const Json::exception& error) {
        throw irsg::InputError({.file = name,
                                .position = "",
                                .value = "JSON of another form (" + std::string(error.what()) + ")",
                                .expected = "a result table: provenance and columns"});
    }
}

} // namespace smat
