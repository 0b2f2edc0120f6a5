#include "irsg/core/BuildId.h"

#include <cstring>
#include <filesystem>
#include <set>
#include <span>
#include <string_view>

#include <elf.h>
#include <link.h>

#include "irsg/core/CacheStore.h"

namespace irsg {
namespace {

constexpr std::size_t aligned(std::size_t size_B) {
    return (size_B + 3U) & ~std::size_t{3};
}

/// The bytes of the note in a segment of notes; empty where it holds none.
std::string_view buildIdIn(const char* notes, std::size_t size_B) {
    while (size_B >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) head{};
        std::memcpy(&head, notes, sizeof(head));
        const std::size_t name_B = aligned(head.n_namesz), value_B = aligned(head.n_descsz);
        const std::size_t whole_B = sizeof(head) + name_B + value_B;
        if (whole_B > size_B)
            break;
        const char* const name = notes + sizeof(head);
        if (head.n_type == NT_GNU_BUILD_ID &&
            std::string_view(name, head.n_namesz) == std::string_view("GNU", 4))
            return {name + name_B, head.n_descsz};
        notes += whole_B;
        size_B -= whole_B;
    }
    return {};
}

/// The libraries that numbers come from: any program which computes has them loaded. Those of the
/// self-test, whose own solvers are held against them, are not among them, nor is the one that
/// hands transforms on to FFTW, which is loaded when haze is asked for.
bool computes(const std::string& file) {
    return file.starts_with("libsmatcore.") ||
           (file.starts_with("libirsg_") && !file.starts_with("libirsg_reference.") &&
            !file.starts_with("libirsg_fftw."));
}

int addBuildId(dl_phdr_info* library, std::size_t, void* found) {
    const std::string file = std::filesystem::path(library->dlpi_name).filename().string();
    if (!computes(file))
        return 0;
    for (int i = 0; i < library->dlpi_phnum; ++i) {
        const auto& segment = library->dlpi_phdr[i];
        if (segment.p_type != PT_NOTE)
            continue;
        const auto* const notes =
            // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives addresses as numbers.
            reinterpret_cast<const char*>(library->dlpi_addr + segment.p_vaddr);
        const std::string_view id = buildIdIn(notes, segment.p_memsz);
        if (!id.empty())
            static_cast<std::set<std::string>*>(found)->insert(file + " " + std::string(id));
    }
    return 0;
}

} // namespace

const std::string& buildId() {
    static const std::string id = [] {
        std::set<std::string> libraries;
        dl_iterate_phdr(addBuildId, &libraries);
        std::string all;
        for (const std::string& each : libraries)
            all += each;
        return all.empty()
                   ? all
                   : ContentDigest().add(std::as_bytes(std::span(all))).text().substr(0, 16);
    }();
    return id;
}

} // namespace irsg
