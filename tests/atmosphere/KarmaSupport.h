#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "irsg/radiometry/Errors.h"

namespace irsg {

/// The folder of this process, removed at its end.
class ProcessFolder {
  public:
    ProcessFolder()
        : path_(std::filesystem::path(testing::TempDir()) / ("karma_" + std::to_string(getpid()))) {
    }
    ~ProcessFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ProcessFolder(const ProcessFolder&) = delete;
    ProcessFolder& operator=(const ProcessFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// A folder of the running test alone, empty when it is first asked for.
inline std::filesystem::path ownFolder() {
    static const ProcessFolder process;
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "_" + test->name();
    for (char& c : name)
        c = c == '/' ? '_' : c;
    std::filesystem::create_directories(process.path() / name);
    return process.path() / name;
}

inline std::filesystem::path writtenFile(const std::filesystem::path& file,
                                         const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

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
        if (!isBlank || !(isBetween || isBeforeEnd || next == std::string::npos))
            text += xml[i];
    }
    return text;
}

/// What an InputError says; "accepted" where none was thrown.
template <typename Act>
std::string refusalOf(Act&& act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
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
