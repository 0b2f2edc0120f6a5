#include "irsg/geometry/reading/assimp/AssimpFiles.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include <assimp/IOStream.hpp>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/GltfFile.h"
#include "irsg/geometry/reading/sandbox/ReadingLimits.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

/// A whole file in memory.
class Bytes : public Assimp::IOStream {
  public:
    explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}

    std::size_t Read(void* into, std::size_t size, std::size_t count) override {
        if (size == 0)
            return 0;
        const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
        std::memcpy(into, bytes_.data() + at_, whole * size);
        at_ += whole * size;
        return whole;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        // Backwards from the place and forwards to it look alike in a number without a sign.
        const std::size_t base = origin == aiOrigin_SET   ? 0
                                 : origin == aiOrigin_CUR ? at_
                                                          : bytes_.size();
        const std::size_t place = base + offset;
        if (place > bytes_.size())
            return aiReturn_FAILURE;
        at_ = place;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

} // namespace

WrittenPath AssimpFiles::find(const std::string& name) const {
    std::error_code ignored;
    for (const std::string& written : {name, decodedUri(name)})
        if (WrittenPath found = findWritten({}, written); fs::is_regular_file(found.file, ignored))
            return found;
    return {};
}

bool AssimpFiles::Exists(const char* name) const {
    return name == file_.string() ||
           (!refusalOf(decodedUri(name), FileKind::buffers) && !find(name).file.empty());
}

Assimp::IOStream* AssimpFiles::Open(const char* name, const char* mode) {
    if (!name || !mode || mode[0] != 'r' || std::strchr(mode, '+'))
        return nullptr;
    try {
        if (name == file_.string())
            return new Bytes(bytes_);
        if (const auto refusal = refusalOf(decodedUri(name), FileKind::buffers)) {
            appendUnique(remarks_, "refers to " + std::string(name) + ", which is not opened: " +
                                       *refusal + ", expected " + expectationOf(FileKind::buffers));
            return nullptr;
        }
        const auto [found, remark] = find(name);
        if (!remark.empty())
            appendUnique(remarks_, remark);
        if (found.empty()) {
            appendUnique(remarks_, "refers to " + std::string(name) + ", which is missing");
            return nullptr;
        }
        std::error_code failure;
        if (const auto size = fs::file_size(found, failure); !failure)
            allowMore(size);
        return new Bytes(readFile(found, largestModel_B));
    } catch (const InputError& error) {
        appendUnique(remarks_, error.what());
        return nullptr;
    }
}

void AssimpFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

} // namespace irsg
