#include "irsg/render/sampling/DownsamplingPass.h"

#include "irsg/core/Errors.h"

namespace irsg {

DownsamplingPass::DownsamplingPass(int factor) : factor_(factor) {
    if (factor != 2 && factor != 4)
        throw LogicError("a downsampling pass averages 2 x 2 or 4 x 4 texels");
}

ObjectTexture DownsamplingPass::apply(const ObjectTexture& texture) const {
    if (texture.side % factor_ != 0)
        throw LogicError("a texture's side is no multiple of the downsampling factor");
    ObjectTexture result(texture.side / factor_);
    const double share = 1.0 / (factor_ * factor_);
    for (int row = 0; row < texture.side; ++row)
        for (int column = 0; column < texture.side; ++column) {
            const std::size_t from = texture.offset(column, row);
            const std::size_t to = result.offset(column / factor_, row / factor_);
            result.radiance[to] += texture.radiance[from] * share;
            result.opacity[to] += texture.opacity[from] * share;
        }
    return result;
}

} // namespace irsg
