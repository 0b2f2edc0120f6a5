#include "smatcore/project/ShippedFiles.h"

#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

namespace smat {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> dataRoots() {
    std::vector<fs::path> roots;
    if (const char* given = std::getenv("SMAT_DATA"); given != nullptr && *given != '\0')
        roots.emplace_back(given);
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) {
        roots.push_back(program.parent_path() / "../share/smat");
        roots.push_back(program.parent_path() / "../../.."); // build/PRESET/bin
    }
    return roots;
}

/// Below a folder of the program; empty where the path says too little.
fs::path tailOf(const fs::path& written) {
    std::vector<std::string> names;
    for (const fs::path& name : written.lexically_normal())
        names.push_back(name.string());
    auto begin = names.begin();
    while (begin != names.end() && (*begin == ".." || *begin == "/"))
        ++begin;
    bool isBelow = !written.is_absolute() && begin != names.begin();
    for (auto name = begin; name != names.end(); ++name)
        if (*name == "resources" || *name == "samples") {
            begin = name;
            isBelow = true;
        }
    if (!isBelow || std::distance(begin, names.end()) < 2)
        return {};
    fs::path tail;
    for (; begin != names.end(); ++begin)
        tail /= *begin;
    return tail;
}

} // namespace

std::filesystem::path shippedFile(const std::filesystem::path& written) {
    const fs::path tail = tailOf(written);
    if (tail.empty())
        return {};
    std::error_code ignored;
    for (const fs::path& root : dataRoots())
        for (const fs::path& file : {root / tail, root / "samples" / tail})
            if (fs::is_regular_file(file, ignored))
                return file.lexically_normal();
    return {};
}

} // namespace smat
