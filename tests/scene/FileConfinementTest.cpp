#include "irsg/geometry/reading/sandbox/FileConfinement.h"

#include <fstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using smat::test::TemporaryFolder;

bool opens(const fs::path& file, int flags = O_RDONLY) {
    const int descriptor = open(file.c_str(), flags, 0600);
    if (descriptor >= 0) {
        close(descriptor);
    }
    return descriptor >= 0;
}

TEST(FileConfinement, LeavesTheFilesOfAModelAndLibrariesAlone) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "model/below");
    fs::create_directories(folder / "beside");
    for (const char* name :
         {"model/m.obj", "model/below/x.png", "named.png", "secret.txt", "beside/a.png"}) {
        std::ofstream(folder / name) << name;
    }
    const pid_t child = fork();
    if (child == 0) {
        // Bits of what went wrong; 64: there is no Landlock.
        if (!confineFiles({{folder / "model", folder / "named.png"}, {folder / "beside"}})) {
            _exit(64);
        }
        const bool reads = opens(folder / "model/m.obj") && opens(folder / "model/below/x.png") &&
                           opens(folder / "named.png");
        const bool libraries = opens("/usr/lib", O_RDONLY | O_DIRECTORY);
        const bool isConfined = !opens(folder / "secret.txt") && !opens("/etc/passwd") &&
                                !opens(folder.path().parent_path(), O_RDONLY | O_DIRECTORY) &&
                                opens(folder / "beside", O_RDONLY | O_DIRECTORY) &&
                                !opens(folder / "beside/a.png") &&
                                !opens(folder / "model/m.obj", O_WRONLY) &&
                                !opens(folder / "model/new", O_WRONLY | O_CREAT);
        _exit((reads ? 0 : 1) | (libraries ? 0 : 2) | (isConfined ? 0 : 4));
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 64) {
        GTEST_SKIP() << "this kernel has no Landlock";
    }
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

} // namespace
} // namespace irsg
