// Flips every bit of every byte of a signature database, one at a time, and inverts every byte:
// each damage must be refused, or leave the content as it was saved. Exit code 1 where one is
// neither.

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/signature/SignatureFile.h"

namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

struct Counts {
    std::atomic<long> refused{0}, harmless{0}, wrong{0}, other{0};
};

/// The damages of bytes `first`, `first + step`, ... on a copy of its own.
void sweep(const fs::path& file, const std::string& good, const irsg::SignatureDatabase& saved,
           std::size_t first, std::size_t step, Counts& counts) {
    std::ofstream(file, std::ios::binary) << good;
    std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
    const auto put = [&](std::size_t at, int byte) {
        bytes.seekp(static_cast<std::streamoff>(at));
        bytes.put(static_cast<char>(byte)).flush();
    };
    for (std::size_t at = first; at < good.size(); at += step) {
        for (const int bits : {1, 2, 4, 8, 16, 32, 64, 128, 255}) {
            put(at, good[at] ^ bits);
            try {
                const bool same = irsg::loadSignatureFile(file).database == saved;
                ++(same ? counts.harmless : counts.wrong);
                if (!same)
                    std::printf("NOT DETECTED: byte %zu xor %d\n", at, bits);
            } catch (const irsg::InputError&) {
                ++counts.refused;
            } catch (const std::exception& error) {
                ++counts.other;
                std::printf("OTHER ERROR: byte %zu xor %d: %s\n", at, bits, error.what());
            }
        }
        put(at, good[at]);
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 2) {
        std::fprintf(stderr, "usage: damage-sweep [DATABASE.sigdb]\n");
        return 2;
    }
    const fs::path source = argc > 1 ? argv[1] : SMAT_SOURCE_DIR "/samples/box/box.sigdb";
    const auto saved = irsg::loadSignatureFile(source).database;
    const fs::path folder =
        fs::temp_directory_path() / ("damage-sweep-" + std::to_string(std::random_device()()));
    fs::create_directories(folder);
    // Saved anew: with the small pages that a new file has.
    irsg::saveSignatureFile(saved, folder / "good.sigdb");
    const std::string good = bytesOf(folder / "good.sigdb");
    const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
    Counts counts;
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < workers; ++i)
            threads.emplace_back([&, i] {
                sweep(folder / (std::to_string(i) + ".sigdb"), good, saved, i, workers, counts);
            });
    }
    fs::remove_all(folder);
    const long all = counts.refused + counts.harmless + counts.wrong + counts.other;
    std::printf(
        "%s: %zu bytes, %ld damages: %ld refused, %ld harmless, %ld not detected, %ld other "
        "errors\n",
        source.filename().string().c_str(), good.size(), all, counts.refused.load(),
        counts.harmless.load(), counts.wrong.load(), counts.other.load());
    return counts.wrong + counts.other == 0 ? 0 : 1;
}
