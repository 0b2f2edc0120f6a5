// Times of reading models: 100,000 facets through the reading process beside the same in this
// process, and .stl and .obj of up to 5 million triangles by our own readers.
//
//     bench_model_reading FOLDER [make]        "make" writes the files alone (about 1.5 GB)

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <osgDB/WriteFile>
#include <sys/resource.h>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/reading/sandbox/PluginReading.h"
#include "irsg/geometry/reading/text/OurModels.h"

namespace {

namespace fs = std::filesystem;

double secondsOf(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Of this process and those that it started and that have ended.
double processorSeconds() {
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    double sum = 0.0;
    for (const auto whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage used{};
        getrusage(whose, &used);
        sum += seconds(used.ru_utime) + seconds(used.ru_stime);
    }
    return sum;
}

double height(int x, int y) {
    return 0.01 * ((x * 7 + y * 13) % 100);
}

/// A field of 2 `columns` by `rows` triangles.
struct Field {
    int columns, rows;
    long triangles() const { return 2L * columns * rows; }
};

Field fieldOf(long triangles) {
    return {500, static_cast<int>(triangles / 1000)};
}

class Output {
  public:
    explicit Output(const fs::path& file) : file_(std::fopen(file.c_str(), "wb")) {}
    ~Output() { std::fclose(file_); }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    std::FILE* get() const { return file_; }

  private:
    std::FILE* file_;
};

void writeCorners(const Output& out, const Field& field, const char* word) {
    for (int y = 0; y <= field.rows; ++y)
        for (int x = 0; x <= field.columns; ++x)
            std::fprintf(out.get(), "%s%d %d %.2f\n", word, x, y, height(x, y));
}

void writeFaces(const Output& out, const Field& field, const char* word, long first) {
    const long width = field.columns + 1;
    for (int y = 0; y < field.rows; ++y)
        for (int x = 0; x < field.columns; ++x) {
            const long a = first + y * width + x;
            std::fprintf(out.get(), "%s %ld %ld %ld\n%s %ld %ld %ld\n", word, a, a + 1,
                         a + width + 1, word, a, a + width + 1, a + width);
        }
}

void writeObj(const fs::path& file, const Field& field) {
    const Output out(file);
    writeCorners(out, field, "v ");
    writeFaces(out, field, "f", 1);
}

void writePly(const fs::path& file, const Field& field) {
    const Output out(file);
    std::fprintf(out.get(),
                 "ply\nformat ascii 1.0\nelement vertex %ld\nproperty float x\nproperty float y\n"
                 "property float z\nelement face %ld\nproperty list uchar int vertex_indices\n"
                 "end_header\n",
                 (field.columns + 1L) * (field.rows + 1L), field.triangles());
    writeCorners(out, field, "");
    writeFaces(out, field, "3", 0);
}

void writeStl(const fs::path& file, const Field& field) {
    const Output out(file);
    char head[84] = "field";
    const auto count = static_cast<std::uint32_t>(field.triangles());
    std::memcpy(head + 80, &count, sizeof count);
    std::fwrite(head, sizeof head, 1, out.get());
    const auto facet = [&](std::initializer_list<std::pair<int, int>> corners) {
        char record[50] = {};
        float numbers[12] = {0.0f, 0.0f, 1.0f};
        int at = 3;
        for (const auto& [x, y] : corners) {
            numbers[at++] = static_cast<float>(x);
            numbers[at++] = static_cast<float>(y);
            numbers[at++] = static_cast<float>(height(x, y));
        }
        std::memcpy(record, numbers, sizeof numbers);
        std::fwrite(record, sizeof record, 1, out.get());
    };
    for (int y = 0; y < field.rows; ++y)
        for (int x = 0; x < field.columns; ++x) {
            facet({{x, y}, {x + 1, y}, {x + 1, y + 1}});
            facet({{x, y}, {x + 1, y + 1}, {x, y + 1}});
        }
}

const long sizes[] = {250000, 500000, 1000000, 2000000, 5000000};
const char* const apart[] = {"osgb", "ive", "osgt"};

fs::path named(const fs::path& folder, long triangles, const std::string& kind) {
    return folder / (std::to_string(triangles) + "." + kind);
}

void make(const fs::path& folder) {
    for (const long size : sizes) {
        writeObj(named(folder, size, "obj"), fieldOf(size));
        writeStl(named(folder, size, "stl"), fieldOf(size));
    }
    const fs::path ply = named(folder, 100000, "ply");
    writePly(ply, fieldOf(100000));
    const auto graph = irsg::readOurModel(ply, {});
    for (const char* const kind : {"osgb", "ive", "osgt"})
        osgDB::writeNodeFile(*graph.node, named(folder, 100000, kind).string());
}

void besideEachOther(const fs::path& folder) {
    std::printf("100,000 facets, the fastest and the middle of 9, ms\n%-6s %8s %8s %8s %8s %18s\n",
                "kind", "here", "", "apart", "", "more (fastest)");
    for (const char* const kind : apart) {
        const fs::path file = named(folder, 100000, kind);
        std::vector<double> here, there;
        for (int i = 0; i < 9; ++i) {
            here.push_back(secondsOf([&] { irsg::readModelHere(file, file); }));
            there.push_back(secondsOf([&] { irsg::loadGraph(file, irsg::LoadPurpose::visible); }));
        }
        std::ranges::sort(here);
        std::ranges::sort(there);
        const double more = there[0] - here[0];
        std::printf("%-6s %8.1f %8.1f %8.1f %8.1f %8.1f ms %5.1f %%\n", kind, 1e3 * here[0],
                    1e3 * here[4], 1e3 * there[0], 1e3 * there[4], 1e3 * more,
                    100.0 * more / here[0]);
    }
}

void ownReaders(const fs::path& folder) {
    std::printf("%9s %6s %18s %18s\n%9s %6s %8s %9s %8s %9s\n", "", "", "here, s", "apart, s",
                "triangles", "kind", "", "processor", "", "processor");
    for (const char* const kind : {"stl", "obj"})
        for (const long size : sizes) {
            const fs::path file = named(folder, size, kind);
            const double begin = processorSeconds();
            const double here = secondsOf([&] { irsg::readOurModel(file, {}); });
            const double between = processorSeconds();
            const double apart =
                secondsOf([&] { irsg::loadGraph(file, irsg::LoadPurpose::visible); });
            std::printf("%9ld %6s %8.2f %9.2f %8.2f %9.2f\n", size, kind, here, between - begin,
                        apart, processorSeconds() - between);
        }
}

} // namespace

int main(int count, char** words) {
    if (count < 2 || count > 3 || (count == 3 && std::string(words[2]) != "make")) {
        std::fputs("usage: bench_model_reading FOLDER [make]\n", stderr);
        return 2;
    }
    const fs::path folder = words[1];
    if (count == 3 || !fs::exists(named(folder, 100000, "osgt")))
        make(folder);
    if (count == 3)
        return 0;
    besideEachOther(folder);
    ownReaders(folder);
    return 0;
}
