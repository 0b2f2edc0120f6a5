#pragma once

namespace smat::test {

/// Whether this is a sanitized build, which takes some times the memory and the time of others.
constexpr bool isSanitized() {
#if defined(__SANITIZE_ADDRESS__)
    return true;
#elif defined(__has_feature)
    return __has_feature(address_sanitizer);
#else
    return false;
#endif
}

} // namespace smat::test
