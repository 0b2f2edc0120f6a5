#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {

using smat::test::ownFolder;
using smat::test::refusalOf;
using smat::test::writtenFile;

inline std::string contentOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// XML without what makes no difference: line ends and indentation between elements, the blank
/// before the end of an empty element and of the declaration.
inline std::string significant(const std::string& xml) {
    std::string text;
    for (std::size_t i = 0; i < xml.size(); ++i) {
        const bool isBlank = std::string(" \t\r\n").find(xml[i]) != std::string::npos;
        const auto next = xml.find_first_not_of(" \t\r\n", i);
        const bool isBetween =
            !text.empty() && text.back() == '>' && next != std::string::npos && xml[next] == '<';
        const bool isBeforeEnd = next != std::string::npos && (xml.compare(next, 2, "/>") == 0 ||
                                                               xml.compare(next, 2, "?>") == 0);
        if (!isBlank || !(isBetween || isBeforeEnd || next == std::string::npos)) {
            text += xml[i];
        }
    }
    return text;
}

/// A parameter file of AtmosphereSmart that holds `inside` beside what every file needs.
inline std::string smartXml(const std::string& inside) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<data>\n<fileType>Parameters</fileType>\n"
           "<type>/AtmosphereSmart/Root/Atmosphere/AtmosphereSmart</type>\n" +
           inside + "\n</data>\n";
}
/// The same of an Environment.
inline std::string environmentXml(const std::string& inside) {
    std::string text = smartXml(inside);
    const std::string type = "/AtmosphereSmart/Root/Atmosphere/AtmosphereSmart";
    return text.replace(text.find(type), type.size(), "/Environment/Root/Environment");
}

/// An entry of a composition.
inline std::string compositeXml(const std::string& name, const std::string& file, int priority,
                                const std::string& composition = "none") {
    return "<composite name=\"" + name + "\"><component>Air</component><parameters>" + file +
           "</parameters><composition>" + composition + "</composition><priority>" +
           std::to_string(priority) + "</priority></composite>\n";
}
/// <parameter> with a <double>.
inline std::string numberXml(const std::string& name, const std::string& value) {
    return "<parameter name=\"" + name + "\"><double>" + value + "</double></parameter>\n";
}
inline std::string vectorXml(const std::string& name, const std::string& values) {
    std::string text = "<parameter name=\"" + name + "\"><vector>";
    for (std::size_t at = 0; at < values.size();) {
        const std::size_t end = std::min(values.find(' ', at), values.size());
        text += "<double>" + values.substr(at, end - at) + "</double>";
        at = end + 1;
    }
    return text + "</vector></parameter>\n";
}

} // namespace irsg
