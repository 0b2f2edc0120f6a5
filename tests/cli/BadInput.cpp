#include "tests/cli/BadInput.h"

#include "tests/support/TemporaryFolder.h"

namespace smat::test {

void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}

std::string nameOf(const testing::TestParamInfo<BadRow>& row) {
    return row.param.name;
}

void nothing(const Folder&) {}

std::function<void(const Folder&)> project(const std::string& json) {
    return [json](const Folder& folder) { write(folder / "p.smat", json); };
}

std::string good(const std::string& more) {
    return R"({"version": 1, "models": [{"file": ")" + sample("sphere/sphere.flt").string() +
           R"(", "database": ")" + sample("sphere/sphere.sigdb").string() + R"("}])" +
           (more.empty() ? "" : ",\n" + more) + "}";
}

std::function<void(const Folder&)> file(const std::string& name, const std::string& content) {
    return [name, content](const Folder& folder) {
        write(folder / name, content);
        write(folder / "p.smat", good());
    };
}

std::function<void(const Folder&)> cut(const std::string& from, std::size_t bytes,
                                       const std::string& name) {
    return [=](const Folder& folder) {
        write(folder / name, contentOf(sample(from)).substr(0, bytes));
        write(folder / "p.smat", good());
    };
}

std::function<void(const Folder&)> patched(const std::string& from, std::size_t at,
                                           const std::string& bytes, const std::string& name) {
    return [=](const Folder& folder) {
        write(folder / name, contentOf(sample(from)).replace(at, bytes.size(), bytes));
    };
}

Words with(Words first, const Words& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

Words imageWith(const Words& more) {
    return with({"image", "p.smat", "--out", "o.exr"}, more);
}

TEST_P(BadInput, IsRefusedWithPlaceValueAndExpectation) {
    const TemporaryFolder folder;
    GetParam().prepare(folder.path());
    const Ran ran = smatBatch(GetParam().arguments, folder.path());
    EXPECT_EQ(ran.exitCode, 2) << ran.out << ran.err;
    // What a reader takes a file for may be remarked before.
    EXPECT_THAT(ran.err, testing::ContainsRegex("(^|\n)error: "));
    EXPECT_THAT(ran.err, testing::HasSubstr("expected"));
    for (const std::string& named : GetParam().named) {
        EXPECT_THAT(ran.err, testing::HasSubstr(named));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "o.exr"));
    EXPECT_FALSE(std::filesystem::exists(folder / "o.csv"));
}

} // namespace smat::test
