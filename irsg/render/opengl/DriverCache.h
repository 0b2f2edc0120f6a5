#pragma once

namespace irsg {

/// To be called before an OpenGL context is made. Mesa maps the index of its cache of shaders into
/// memory, and a page of it that a full disk cannot take ends the process without a word (SIGBUS).
/// Where the disk of the cache has less than 64 MiB of room, the cache is switched off for this
/// process (MESA_SHADER_CACHE_DISABLE), unless the user has said what to do; shaders are compiled
/// anew then.
void keepOffFullShaderCache();

} // namespace irsg
