#include "irsg/geometry/reading/sandbox/FbxRecords.h"

#include <algorithm>

#include "irsg/core/CsvTable.h"

namespace irsg {

namespace {

/// The last text in quotation marks of a line; empty where it has none.
std::string_view lastTextOf(std::string_view line) {
    const std::size_t end = line.rfind('"');
    if (end == line.npos || end == 0)
        return {};
    const std::size_t begin = line.rfind('"', end - 1);
    return begin == line.npos ? std::string_view() : line.substr(begin + 1, end - begin - 1);
}

/// Brackets outside of texts.
int levelsOf(std::string_view line) {
    int levels = 0;
    bool isQuoted = false;
    for (const char c : line) {
        if (c == ';' && !isQuoted)
            break;
        isQuoted = isQuoted != (c == '"');
        levels += isQuoted ? 0 : c == '{' ? 1 : c == '}' ? -1 : 0;
    }
    return levels;
}

} // namespace

void FbxRecords::addObject(std::string_view kind, std::string_view ofClass) {
    const std::string name(kind), its(ofClass);
    if (kind == "Deformer")
        ++counts_["Deformer records are not followed: skins and shapes stay as their mesh is"];
    else if (kind == "AnimationCurve")
        ++counts_["AnimationCurve records are not played: parts are where the file puts them"];
    else if (kind == "Constraint")
        ++counts_["Constraint records are not followed: parts are where the file puts them"];
    else if (kind == "Geometry" && ofClass != "Mesh" && ofClass != "Shape")
        ++counts_["geometries of class " + its + " have no polygons and are left out"];
    else if (kind == "NodeAttribute" && (ofClass == "Light" || ofClass == "Camera"))
        ++counts_[its + " records are left out"];
}

void FbxRecords::addOfGeometry(std::string_view name) {
    if (name == "LayerElementHole" || name == "LayerElementVisibility")
        ++counts_[std::string(name) + " records are not followed: all polygons are read"];
    else if (name == "LayerElementEdgeCrease" || name == "LayerElementVertexCrease")
        ++counts_[std::string(name) + " records are not followed: nothing is subdivided"];
}

void FbxRecords::addZero(std::string_view property) {
    if (property == "Visibility" || property == "Show")
        ++counts_["models are hidden (" + std::string(property) + ") and are read nevertheless"];
}

std::vector<std::string> FbxRecords::remarks() const {
    std::vector<std::string> remarks;
    for (const auto& [sentence, count] : counts_)
        remarks.push_back(std::to_string(count) + " " + sentence);
    return remarks;
}

FbxRecords fbxRecordsOfText(std::string_view text) {
    FbxRecords records;
    int level = 0;
    std::string_view section, object;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = trimmed(text.substr(at, end - at));
        at = end + 1;
        const std::string_view key = line.substr(0, std::min(line.find(':'), line.size()));
        if (level == 0) {
            section = key;
        } else if (section == "Objects" && level == 1) {
            object = key;
            records.addObject(key, lastTextOf(line));
        } else if (section == "Objects" && level == 2 && object == "Geometry") {
            records.addOfGeometry(key);
        } else if (section == "Objects" && level == 3 && object == "Model" && key == "P") {
            const std::size_t begin = line.find('"'), comma = line.rfind(',');
            const std::size_t close = begin == line.npos ? line.npos : line.find('"', begin + 1);
            if (close != line.npos && comma != line.npos &&
                parseNumber(trimmed(line.substr(comma + 1))) == 0.0)
                records.addZero(line.substr(begin + 1, close - begin - 1));
        }
        level += levelsOf(line);
    }
    return records;
}

} // namespace irsg
