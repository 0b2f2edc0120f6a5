#include "irsg/geometry/reading/sandbox/FileConfinement.h"

#include <cstdint>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>

#include <fcntl.h>
#include <link.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace irsg {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t listing = LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | listing;
/// All that the first version of Landlock knows.
constexpr std::uint64_t handled =
    reading | LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE |
    LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
    LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK |
    LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

/// Folders and files that the loader of plug-ins and the C library read.
std::set<fs::path> placesOfLibraries() {
    std::set<fs::path> places = {"/usr",      "/lib",        "/lib64", "/etc/ld.so.cache",
                                 "/dev/null", "/dev/urandom"};
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* into) {
            if (info->dlpi_name != nullptr && *info->dlpi_name == '/')
                static_cast<std::set<fs::path>*>(into)->insert(
                    fs::path(info->dlpi_name).parent_path());
            return 0;
        },
        &places);
    if (const char* const listed = std::getenv("LD_LIBRARY_PATH")) {
        std::istringstream text(listed);
        for (std::string folder; std::getline(text, folder, ':');)
            if (!folder.empty())
                places.insert(folder);
    }
    return places;
}

/// Of a folder with all below it. A place that is not there needs no leave.
void allowAccess(int rules, const fs::path& place, std::uint64_t access) {
    const int descriptor = open(place.c_str(), O_PATH | O_CLOEXEC);
    struct stat status {};
    if (descriptor < 0)
        return;
    if (fstat(descriptor, &status) == 0) {
        landlock_path_beneath_attr rule{};
        // A file has nothing to be listed.
        rule.allowed_access = S_ISDIR(status.st_mode) ? access : access & ~listing;
        rule.parent_fd = descriptor;
        static_cast<void>(
            syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0));
    }
    close(descriptor);
}

} // namespace

bool confineFiles(const ReadablePlaces& places) {
    landlock_ruleset_attr all{};
    all.handled_access_fs = handled;
    const int rules = static_cast<int>(syscall(SYS_landlock_create_ruleset, &all, sizeof all, 0));
    if (rules < 0)
        return false;
    for (const fs::path& place : placesOfLibraries())
        allowAccess(rules, place, reading);
    for (const fs::path& place : places.read)
        allowAccess(rules, place.empty() ? fs::path(".") : place, reading);
    for (const fs::path& folder : places.listed)
        allowAccess(rules, folder, listing);
    const bool isConfined = prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                            syscall(SYS_landlock_restrict_self, rules, 0) == 0;
    close(rules);
    return isConfined;
}

} // namespace irsg
