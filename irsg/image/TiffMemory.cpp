#include "irsg/image/TiffMemory.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace irsg {

namespace {

tmsize_t readBytes(thandle_t handle, void* into, tmsize_t count) {
    auto& memory = *static_cast<TiffMemory*>(handle);
    const std::size_t left = memory.bytes.size() - std::min(memory.position, memory.bytes.size());
    const std::size_t taken =
        std::min(left, static_cast<std::size_t>(std::max<tmsize_t>(count, 0)));
    std::memcpy(into, memory.bytes.data() + std::min(memory.position, memory.bytes.size()), taken);
    memory.position += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t writeBytes(thandle_t handle, void* from, tmsize_t count) {
    auto& memory = *static_cast<TiffMemory*>(handle);
    const auto size = static_cast<std::size_t>(count);
    if (memory.bytes.size() < memory.position + size)
        memory.bytes.resize(memory.position + size);
    std::memcpy(memory.bytes.data() + memory.position, from, size);
    memory.position += size;
    return count;
}

toff_t seekTo(thandle_t handle, toff_t offset, int whence) {
    auto& memory = *static_cast<TiffMemory*>(handle);
    const std::size_t base = whence == SEEK_SET   ? 0
                             : whence == SEEK_CUR ? memory.position
                                                  : memory.bytes.size();
    memory.position = base + static_cast<std::size_t>(offset);
    return memory.position;
}

toff_t sizeOf(thandle_t handle) {
    return static_cast<TiffMemory*>(handle)->bytes.size();
}

int keepComplaint(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    auto& memory = *static_cast<TiffMemory*>(user);
    if (memory.complaint.empty()) {
        char text[256];
        std::vsnprintf(text, sizeof text, format, arguments);
        memory.complaint = text;
    }
    return 1;
}

int sayNothing(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

} // namespace

OpenTiff openTiff(TiffMemory& memory, const char* mode) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, mostTiffMemory_B);
    TIFFOpenOptionsSetErrorHandlerExtR(options, keepComplaint, &memory);
    TIFFOpenOptionsSetWarningHandlerExtR(options, sayNothing, &memory);
    OpenTiff tiff(TIFFClientOpenExt(
        "image", mode, &memory, readBytes, writeBytes, seekTo, [](thandle_t) { return 0; }, sizeOf,
        [](thandle_t, void**, toff_t*) { return 0; }, [](thandle_t, void*, toff_t) {}, options));
    TIFFOpenOptionsFree(options);
    return tiff;
}

} // namespace irsg
