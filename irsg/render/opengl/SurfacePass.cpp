#include "irsg/render/opengl/SurfacePass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Stopwatch.h"
#include "irsg/render/opengl/FloatTarget.h"
#include "irsg/render/opengl/FragmentList.h"
#include "irsg/render/opengl/MeshBuffers.h"
#include "irsg/render/opengl/ReversedDepth.h"
#include "irsg/render/opengl/ShaderProgram.h"
#include "irsg/render/sampling/LayerSort.h"

namespace irsg {

namespace {

enum Product { radianceProduct = 0, factorProduct = 1, factorProductWithDistance = 2 };

/// Vectors of four words that a listed fragment takes.
int vectorsOf(const GeometryFactors& shader) {
    return 1 + static_cast<int>((shader.factorCount + 3) / 4);
}

/// The shader's variant for N.
int angleMode(float nAngleFactor) {
    return nAngleFactor == 0.0f ? 0 : nAngleFactor == 1.0f ? 1 : 2;
}

/// What a tile is of a drawing.
struct Raster {
    int x, y, width, height;
    Matrix4 clipFromEye;
};

Raster rasterOf(const SurfaceScene& scene, const SampleTile& tile) {
    const std::size_t stride = tile.stride();
    Raster raster{static_cast<int>(tile.firstSample % stride),
                  static_cast<int>(tile.firstSample / stride), tile.width(), tile.height(),
                  scene.camera->clipFromEye(tile.renderedRectangle(), scene.depth)};
    if (tile.shearRows) {
        // x_clip + a w - b y moves the sample's row r, counted from the top, by r / shearRows.
        const double perClip = 1.0 / (static_cast<double>(tile.shearRows) * raster.width);
        Matrix4 shear;
        shear(1, 0) = -raster.height * perClip;
        shear(3, 0) = (raster.height - 1) * perClip;
        raster.clipFromEye = raster.clipFromEye * shear;
    }
    if (tile.fall) {
        // y_clip + x / height moves the sample in column c down by (c + 1/2) / width - 1/2.
        Matrix4 tilt;
        tilt(0, 1) = static_cast<double>(tile.fall) / raster.height;
        raster.clipFromEye = raster.clipFromEye * tilt;
    }
    return raster;
}

/// True where nothing of a box comes within the sides of a raster: all its corners are beyond one
/// of them.
bool isOutside(const BoundingBox& box, const Matrix4& clipFromModel) {
    constexpr double rounding = 1e-6; // of what is drawn in float
    std::array<int, 4> beyond{};
    for (unsigned i = 0; i < 8; ++i) {
        const auto [x, y, z, depth] =
            clipFromModel.homogeneous({(i & 1 ? box.max : box.min).x, (i & 2 ? box.max : box.min).y,
                                       (i & 4 ? box.max : box.min).z});
        const double w = depth + rounding * std::abs(depth);
        beyond[0] += x > w;
        beyond[1] += x < -w;
        beyond[2] += y > w;
        beyond[3] += y < -w;
    }
    return std::ranges::find(beyond, 8) != beyond.end();
}

/// The items that a raster can show.
std::vector<SurfaceItem> itemsWithin(const SurfaceScene& scene, const Raster& raster) {
    std::vector<SurfaceItem> items;
    for (const SurfaceItem& item : scene.items)
        if (!isOutside(scene.pieceOf(item).bounds,
                       scene.bodyOf(item).eyeFromModel * raster.clipFromEye))
            items.push_back(item);
    return items;
}

/// One tile of a drawing with what can be seen in it.
struct RasterItems {
    const SurfaceScene& scene;
    Raster raster;
    std::vector<SurfaceItem> items;

    RasterItems(const SurfaceScene& ofTile, const SampleTile& tile)
        : scene(ofTile), raster(rasterOf(ofTile, tile)), items(itemsWithin(scene, raster)) {}
};

std::vector<RasterItems> rastersOf(const SheetScene& sheet) {
    std::vector<RasterItems> rasters;
    for (std::size_t i = 0; i < sheet.scenes.size(); ++i)
        rasters.emplace_back(sheet.scenes[i], sheet.sheet.tiles[i]);
    return rasters;
}

} // namespace

struct SurfacePass::Impl {
    /// What a program was compiled for: product, angle, transparent, and the factors.
    using Variant = std::tuple<int, int, int, std::string>;
    std::map<Variant, ShaderProgram> programs;
    std::optional<ShaderProgram> occluder;
    FloatTarget radiance{{2}};
    /// Of factors: [more than three][with distance].
    std::array<std::array<FloatTarget, 2>, 2> factors{
        {{FloatTarget{{4}}, FloatTarget{{4, 1}}}, {FloatTarget{{4, 4}}, FloatTarget{{4, 4, 1}}}}};
    FragmentList list;
    std::uint32_t roomInList = 1u << 16; // grows to what the largest drawing needed
    double renderSeconds = 0.0, readSeconds = 0.0;

    const ShaderProgram& program(Product product, int angle, bool transparent,
                                 const GeometryFactors& geometryShader) {
        const Variant variant{product, angle, transparent ? 1 : 0, geometryShader.glsl};
        const auto found = programs.find(variant);
        if (found != programs.end())
            return found->second;
        const auto define = [](const char* name, int value) {
            return "#define " + std::string(name) + " " + std::to_string(value) + "\n";
        };
        return programs
            .try_emplace(variant, std::vector<std::string>{"surface.vert.glsl"},
                         std::vector<std::string>{"surface.frag.glsl", "accurate.glsl"},
                         define("PRODUCT", product) + define("ANGLE_MODE", angle) +
                             define("TRANSPARENT", transparent ? 1 : 0) + geometryShader.glsl)
            .first->second;
    }

    /// Draws into what a tile is of the drawing alone. A guard band may let triangles reach over
    /// a viewport.
    static void goTo(const Raster& raster) {
        glViewport(raster.x, raster.y, raster.width, raster.height);
        glScissor(raster.x, raster.y, raster.width, raster.height);
    }

    /// Leaves the depth of what hides surfaces, and no colour. What is nearer than the depth range
    /// is drawn at its near end.
    void renderOccluders(const SurfaceScene& scene, const Raster& raster) {
        if (!scene.terrain.mesh && scene.groundBefore.empty())
            return;
        if (!occluder)
            occluder.emplace(std::vector<std::string>{"terrain.vert.glsl"},
                             std::vector<std::string>{"occluder.frag.glsl"});
        glEnable(GL_DEPTH_CLAMP);
        glDisable(GL_CULL_FACE);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        occluder->use();
        const auto draw = [&](const SurfaceBody& body) {
            occluder->set("clipFromModel", body.eyeFromModel * raster.clipFromEye);
            const MeshBuffers& buffers = MeshBuffers::of(body.mesh);
            buffers.bind();
            for (std::size_t piece = 0; piece < body.mesh->pieces.size(); ++piece)
                buffers.draw(piece);
        };
        if (scene.terrain.mesh)
            draw(scene.terrain);
        for (const SurfaceBody& ground : scene.groundBefore)
            draw(ground);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDisable(GL_DEPTH_CLAMP);
        MeshBuffers::unbind();
    }

    /// Draws the items of one kind with the surface shader into the bound target.
    void renderItems(const RasterItems& tile, bool transparent, Product product, int rasterWidth) {
        const auto& [scene, raster, items] = tile;
        const ShaderProgram* current = nullptr;
        int currentAngle = 0;
        const SurfaceBody* body = nullptr;
        const MeshBuffers* buffers = nullptr;
        for (const SurfaceItem& item : items) {
            if (item.transparent != transparent)
                continue;
            const SurfaceRow& row = scene.rows[static_cast<std::size_t>(item.row)];
            const int angle = angleMode(row.nAngleFactor);
            if (!current || angle != currentAngle) {
                current = &program(product, angle, transparent, scene.factors);
                currentAngle = angle;
                useProgram(*current, scene, rasterWidth);
            }
            const ShaderProgram& shader = *current;
            if (product == radianceProduct)
                shader.set("radiance", std::span(row.radiance.data(), scene.factors.factorCount));
            shader.set("surface", {row.constant, row.opacity, row.nAngleFactor,
                                   static_cast<float>(item.row + 1)});
            if (body != &scene.bodyOf(item)) {
                body = &scene.bodyOf(item);
                buffers = &MeshBuffers::of(body->mesh);
                buffers->bind();
            }
            shader.set("eyeFromModel", body->eyeFromModel);
            shader.set("clipFromModel", body->eyeFromModel * raster.clipFromEye);
            // Both walls of a transparent shell count, whatever its draw type.
            const Mesh::Part& part = scene.partOf(item);
            if (part.culled && !transparent)
                glEnable(GL_CULL_FACE);
            else
                glDisable(GL_CULL_FACE);
            offsetLayer(part.layer);
            buffers->draw(item.piece);
        }
        offsetLayer(0);
        glDisable(GL_CULL_FACE);
        MeshBuffers::unbind();
    }

    /// Lifts a subface over the face in whose plane it lies: by as much as depth changes over a
    /// pixel, and by some steps of the depth buffer where it does not change. Depth grows towards
    /// the eye.
    static void offsetLayer(int layer) {
        constexpr float steps = 16.0f;
        if (layer == 0)
            return glDisable(GL_POLYGON_OFFSET_FILL);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(static_cast<float>(layer), steps * static_cast<float>(layer));
    }

    void useProgram(const ShaderProgram& shader, const SurfaceScene& scene, int rasterWidth) {
        shader.use();
        for (const auto& [name, v] : scene.factors.directionsEye)
            shader.set(name.c_str(), static_cast<float>(v.x), static_cast<float>(v.y),
                       static_cast<float>(v.z));
        shader.set("rasterWidth", rasterWidth);
        shader.set("capacity", static_cast<int>(roomInList));
    }

    /// Draws the tiles of a sheet: the opaque surfaces into `target`, the transparent ones before
    /// them into the list. Returns the length of the list.
    std::uint32_t draw(const SheetScene& sheet, Product product, FloatTarget& target) {
        const int width = sheet.sheet.width, height = sheet.sheet.height;
        const std::vector<RasterItems> tiles = rastersOf(sheet);
        const ReversedDepth reversed;
        target.reserve(width, height);
        target.bind(width, height);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, width, height);
        target.clear();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDisable(GL_BLEND);
        for (const RasterItems& tile : tiles) {
            goTo(tile.raster);
            if (!tile.items.empty())
                renderOccluders(tile.scene, tile.raster);
            renderItems(tile, false, product, width);
        }
        const std::uint32_t listed = renderTransparent(tiles, width, product);
        glDisable(GL_SCISSOR_TEST);
        glFinish();
        return listed;
    }

    std::uint32_t renderTransparent(const std::vector<RasterItems>& tiles, int width,
                                    Product product) {
        const auto isAny = [](const RasterItems& tile) {
            return std::ranges::any_of(tile.items, &SurfaceItem::transparent);
        };
        if (std::ranges::none_of(tiles, isAny))
            return 0;
        // What goes to the list leaves the planes alone; a shader that writes none would fill them
        // with whatever it likes.
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        std::uint32_t listed = 0;
        for (;;) {
            list.begin(roomInList, vectorsOf(tiles.front().scene.factors));
            for (const RasterItems& tile : tiles) {
                goTo(tile.raster);
                renderItems(tile, true, product, width);
            }
            listed = list.count();
            if (listed <= roomInList)
                break;
            roomInList = std::bit_ceil(listed);
        }
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        return listed;
    }
};

SurfacePass::SurfacePass() : impl_(std::make_unique<Impl>()) {}
SurfacePass::~SurfacePass() = default;

void SurfacePass::renderRadiance(const SheetScene& sheet, RadianceSamples& samples) {
    Impl& p = *impl_;
    if (std::ranges::any_of(sheet.scenes, &SurfaceScene::hasTransparent))
        throw LogicError("radiance alone was drawn of what lies behind a transparent surface");
    {
        Stopwatch watch(p.renderSeconds);
        p.draw(sheet, radianceProduct, p.radiance);
    }
    samples.width = sheet.sheet.width;
    samples.height = sheet.sheet.height;
    samples.layersLeftOver = 0;
    Stopwatch watch(p.readSeconds);
    p.radiance.read(0, samples.width, samples.height, samples.planes);
}

void SurfacePass::sampleGeometry(const SheetScene& sheet, bool withDistance,
                                 GeometrySamples& samples) {
    Impl& p = *impl_;
    const int width = sheet.sheet.width, height = sheet.sheet.height;
    const GeometryFactors& factors = sheet.scenes.front().factors;
    const bool manyFactors = factors.factorCount > 3;
    FloatTarget& target = p.factors[manyFactors ? 1 : 0][withDistance ? 1 : 0];
    std::uint32_t listed = 0;
    {
        Stopwatch watch(p.renderSeconds);
        listed = p.draw(sheet, withDistance ? factorProductWithDistance : factorProduct, target);
    }
    samples.width = width;
    samples.height = height;
    samples.factorCount = factors.factorCount;
    samples.wordsPerFragment = static_cast<std::size_t>(4 * vectorsOf(factors));
    samples.forgetLight();
    samples.gasesAboutEye = sheet.gasesAboutEye();
    Stopwatch watch(p.readSeconds);
    const auto read = [&](int plane, bool isThere, std::vector<float>& into) {
        if (isThere)
            target.read(plane, width, height, into);
        else
            into.clear();
    };
    read(0, true, samples.opaque);
    read(1, manyFactors, samples.moreFactors);
    read(manyFactors ? 2 : 1, withDistance, samples.distances_m);
    p.list.read(listed, vectorsOf(factors),
                [&](std::span<const float> list) { gatherFragments(list, samples); });
}

std::size_t SurfacePass::bytes() const {
    std::size_t sum = impl_->radiance.bytes() + impl_->list.bytes();
    for (const auto& targets : impl_->factors)
        for (const FloatTarget& target : targets)
            sum += target.bytes();
    return sum;
}

double SurfacePass::takeRenderSeconds() {
    return std::exchange(impl_->renderSeconds, 0.0);
}
double SurfacePass::takeReadSeconds() {
    return std::exchange(impl_->readSeconds, 0.0);
}

} // namespace irsg
