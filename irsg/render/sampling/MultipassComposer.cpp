#include "irsg/render/sampling/MultipassComposer.h"

#include <bit>

#include "irsg/core/Errors.h"

namespace irsg {

MultipassComposer::MultipassComposer(int from, int to) {
    const auto isPowerOfTwo = [](int side) {
        return side > 0 && std::has_single_bit(static_cast<unsigned>(side));
    };
    if (!isPowerOfTwo(from) || !isPowerOfTwo(to) || to > from)
        throw LogicError("a chain of averages leads from a power of two to a smaller one");
    for (int side = from; side > to; side /= passes_.back().factor())
        passes_.emplace_back(side / to >= 4 ? 4 : 2);
}

ObjectTexture MultipassComposer::apply(ObjectTexture texture) const {
    for (const DownsamplingPass& pass : passes_)
        texture = pass.apply(texture);
    return texture;
}

} // namespace irsg
