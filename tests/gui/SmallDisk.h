#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <sys/mount.h>

#include "tests/gui/GuiEnvironment.h"

namespace smat::gui::test {

/// A disk of 1 MiB in memory that can be filled; only root may have one.
class SmallDisk {
  public:
    explicit SmallDisk(const std::string& name)
        : place_(freshFolder(name)),
          isMounted_(::mount("tmpfs", place_.c_str(), "tmpfs", 0, "size=1m") == 0) {}
    ~SmallDisk() {
        if (isMounted_) {
            ::umount2(place_.c_str(), MNT_DETACH);
        }
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool isThere() const { return isMounted_; }
    std::filesystem::path operator/(const std::filesystem::path& name) const {
        return place_ / name;
    }
    const std::filesystem::path& place() const { return place_; }
    void fill() const {
        std::ofstream filler(place_ / "filler", std::ios::binary);
        for (int i = 0; i < 1200 && filler; ++i) {
            filler << std::string(1024, 'x') << std::flush;
        }
    }
    void empty() const { std::filesystem::remove(place_ / "filler"); }

  private:
    std::filesystem::path place_;
    bool isMounted_;
};

} // namespace smat::gui::test
