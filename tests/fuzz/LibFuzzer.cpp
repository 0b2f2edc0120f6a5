#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "tests/fuzz/Readers.h"

// SMAT_FUZZED_READER=NAME fuzz-readers [options of libFuzzer] CORPUS: gives what it makes up to a
// reader. fuzz-readers --list names the readers, each with the most bytes that are made up for it;
// fuzz-readers --seeds READER FOLDER writes its seeds.

namespace {

const smat::test::FuzzedReader* chosen = nullptr;

const smat::test::FuzzedReader* readerOf(const char* name) {
    for (const auto& reader : smat::test::fuzzedReaders()) {
        if (std::strcmp(reader.name, name) == 0) {
            return &reader;
        }
    }
    std::fprintf(stderr, "there is no reader %s; --list names them\n", name);
    std::exit(2);
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    char** const words = *argv;
    if (*argc == 2 && std::strcmp(words[1], "--list") == 0) {
        for (const auto& reader : smat::test::fuzzedReaders()) {
            std::printf("%s %zu\n", reader.name, reader.longest_B);
        }
        std::exit(0);
    }
    if (*argc == 4 && std::strcmp(words[1], "--seeds") == 0) {
        int number = 0;
        for (const std::string& seed : smat::test::seedsOf(*readerOf(words[2]))) {
            std::ofstream(std::filesystem::path(words[3]) / ("seed" + std::to_string(number++)),
                          std::ios::binary)
                << seed;
        }
        std::exit(0);
    }
    const char* name = std::getenv("SMAT_FUZZED_READER");
    if (!name) {
        std::fputs("SMAT_FUZZED_READER names no reader (--list names them)\n", stderr);
        std::exit(2);
    }
    chosen = readerOf(name);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    smat::test::readBytes(*chosen, {reinterpret_cast<const char*>(bytes), size});
    return 0;
}
