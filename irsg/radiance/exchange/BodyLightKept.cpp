#include <utility>

#include "irsg/core/BinaryArchive.h"
#include "irsg/radiance/exchange/BodyLight.h"

namespace irsg {

template <typename Nodes, typename Archive>
void ExchangeNodes::visitKept(Nodes& nodes, Archive& archive) {
    archive(nodes.fineness_);
    archive(nodes.coarseness_);
    archive(nodes.pieceOf_);
    archive(nodes.senderOf_);
    archive(nodes.senders_);
    archive(nodes.area_m2_);
    archive(nodes.firstShare_);
    archive(nodes.shares_);
    archive(nodes.first_);
    archive(nodes.cells_);
    archive(nodes.areaUpTo_m2_);
    archive(nodes.firstNear_);
    archive(nodes.near_);
    LightPairs::visitKept(nodes.smoothing_, archive);
    LightPairs::visitKept(nodes.smoothingOfSenders_, archive);
}

std::shared_ptr<const ExchangeNodes> ExchangeNodes::read(std::shared_ptr<const ExchangeMesh> mesh,
                                                         BinaryReader& reader) {
    std::shared_ptr<ExchangeNodes> made(new ExchangeNodes);
    made->mesh_ = std::move(mesh);
    visitKept(*made, reader);
    return made;
}

void ExchangeNodes::write(BinaryWriter& writer) const {
    visitKept(*this, writer);
}

template <typename Light, typename Archive>
void BodyLight::visitKept(Light& light, Archive& archive) {
    archive(light.sent_);
    archive(light.first_);
    archive(light.rays_);
    archive(light.firstScale_);
    archive(light.scales_);
    archive(light.raysFrom_);
    archive(light.allSent_);
    archive(light.error_);
    archive(light.isLimited_);
}

std::string BodyLight::written() const {
    BinaryWriter writer;
    mesh().write(writer);
    nodes_->write(writer);
    visitKept(*this, writer);
    writer(passages_.size());
    for (std::size_t stack = 0; stack < passages_.size(); ++stack) {
        std::vector<int> materials;
        for (const OccluderMaterial& material : passages_.materials(static_cast<int>(stack)))
            materials.insert(materials.end(), {material.first, material.second});
        writer(materials);
    }
    writer(balances_.size());
    for (const LightBalance& balance : balances_) {
        LightPairs::visitKept(*balance.pairs, writer);
        LightPairs::visitKept(*balance.between, writer);
    }
    return writer.take();
}

std::shared_ptr<const BodyLight> BodyLight::read(std::shared_ptr<const RayMesh> mesh,
                                                 std::string_view bytes) {
    try {
        BinaryReader reader(bytes);
        std::shared_ptr<const ExchangeMesh> cells = ExchangeMesh::read(std::move(mesh), reader);
        if (!cells)
            return nullptr;
        std::shared_ptr<BodyLight> made(new BodyLight);
        made->nodes_ = ExchangeNodes::read(std::move(cells), reader);
        visitKept(*made, reader);
        std::size_t count = 0;
        reader(count);
        for (std::size_t stack = 0; stack < count; ++stack) {
            std::vector<int> numbers;
            reader(numbers);
            std::vector<OccluderMaterial> materials;
            for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
                materials.emplace_back(numbers[i], numbers[i + 1]);
            made->passages_.numberOf(materials); // in the order of their numbers
        }
        reader(count);
        for (std::size_t passage = 0; passage < count; ++passage) {
            auto pairs = std::make_shared<LightPairs>(), between = std::make_shared<LightPairs>();
            LightPairs::visitKept(*pairs, reader);
            LightPairs::visitKept(*between, reader);
            made->balances_.push_back({std::move(pairs), std::move(between)});
        }
        return reader.atEnd() && !made->balances_.empty() ? made : nullptr;
    } catch (const DamagedBytes&) {
        return nullptr;
    }
}

} // namespace irsg
