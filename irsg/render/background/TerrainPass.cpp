#include "irsg/render/background/TerrainPass.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/render/opengl/FloatTarget.h"
#include "irsg/render/opengl/MeshBuffers.h"
#include "irsg/render/opengl/OffscreenContext.h"
#include "irsg/render/opengl/ReversedDepth.h"
#include "irsg/render/opengl/ShaderProgram.h"

namespace irsg {

namespace {

/// Pixels a side of one piece of the frame: bounds the memory of the target.
constexpr int pieceSide_px = 2048 / TerrainPass::samplesPerAxis;

GLint wrapOf(TextureWrap wrap) {
    return wrap == TextureWrap::repeat   ? GL_REPEAT
           : wrap == TextureWrap::mirror ? GL_MIRRORED_REPEAT
                                         : GL_CLAMP_TO_EDGE;
}

/// Textures of one terrain in GL's memory.
class UploadedTextures {
  public:
    explicit UploadedTextures(const std::vector<TexturedMesh::Texture>& textures)
        : names_(textures.size()) {
        GLint largest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
        glGenTextures(static_cast<GLsizei>(names_.size()), names_.data());
        for (std::size_t i = 0; i < textures.size(); ++i) {
            const TextureImage& image = textures[i].image;
            if (image.width_px > largest || image.height_px > largest)
                throw InputError({"terrain", "texture",
                                  std::to_string(image.width_px) + " x " +
                                      std::to_string(image.height_px) + " texels",
                                  "at most " + std::to_string(largest) + " a side"});
            // GL's first row is the lowest.
            std::vector<float> rows;
            const auto width = static_cast<std::size_t>(image.width_px);
            for (auto y = static_cast<std::size_t>(image.height_px); y-- > 0;)
                rows.insert(rows.end(),
                            image.values.begin() + static_cast<std::ptrdiff_t>(y * width),
                            image.values.begin() + static_cast<std::ptrdiff_t>((y + 1) * width));
            glBindTexture(GL_TEXTURE_2D, names_[i]);
            glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, image.width_px, image.height_px, 0, GL_RED,
                         GL_FLOAT, rows.data());
            glGenerateMipmap(GL_TEXTURE_2D);
            const auto set = [](GLenum what, GLint value) {
                glTexParameteri(GL_TEXTURE_2D, what, value);
            };
            set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
            set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            set(GL_TEXTURE_WRAP_S, wrapOf(textures[i].wrapS));
            set(GL_TEXTURE_WRAP_T, wrapOf(textures[i].wrapT));
        }
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    ~UploadedTextures() { glDeleteTextures(static_cast<GLsizei>(names_.size()), names_.data()); }
    UploadedTextures(const UploadedTextures&) = delete;
    UploadedTextures& operator=(const UploadedTextures&) = delete;

    GLuint operator[](int texture) const { return names_[static_cast<std::size_t>(texture)]; }

  private:
    std::vector<GLuint> names_;
};

} // namespace

struct TerrainPass::Impl {
    ShaderProgram program{{"terrain.vert.glsl"}, {"terrain.frag.glsl"}};
    FloatTarget target{{2, 1}};
    std::shared_ptr<const Terrain> terrain; // whose textures are uploaded
    std::unique_ptr<UploadedTextures> textures;
    std::vector<float> samples, nearness;

    void renderPiece(const CameraFrame& camera, const PixelRegion& piece, const DepthRange& depth,
                     double offset) {
        const ReversedDepth reversed;
        const int width = piece.width * samplesPerAxis, height = piece.height * samplesPerAxis;
        target.reserve(width, height);
        target.bind(width, height);
        target.clear();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDisable(GL_BLEND);
        glDisable(GL_CULL_FACE);
        program.use();
        const Matrix4 eyeFromModel = camera.eyeFromModel(terrain->pose());
        program.set("clipFromModel", eyeFromModel * camera.clipFromEye(piece.rectangle(), depth));
        program.set("eyeFromModel", eyeFromModel);
        program.set("texels", 0);
        glActiveTexture(GL_TEXTURE0);
        const TexturedMesh& shown = terrain->shown();
        const MeshBuffers& buffers = MeshBuffers::of(shown.mesh);
        buffers.bind();
        for (std::size_t part = 0; part < shown.textureOf.size(); ++part) {
            const int texture = shown.textureOf[part];
            const bool textured = texture >= 0;
            glBindTexture(GL_TEXTURE_2D, textured ? (*textures)[texture] : 0);
            program.set("weightAndOffset", textured ? 1.0f : 0.0f, static_cast<float>(offset),
                        0.0f);
            buffers.draw(part);
        }
        MeshBuffers::unbind();
        glBindTexture(GL_TEXTURE_2D, 0);
        glFinish();
        target.read(0, width, height, samples);
        target.read(1, width, height, nearness);
    }

    void reduce(const PixelRegion& piece, int frameWidth, TerrainImage& image) const {
        constexpr int n = samplesPerAxis;
        constexpr double share = 1.0 / (n * n);
        const auto stride = static_cast<std::size_t>(piece.width) * n;
        for (int y = 0; y < piece.height; ++y)
            for (int x = 0; x < piece.width; ++x) {
                double texel = 0.0, coverage = 0.0, near_1_m = 0.0;
                for (int sy = 0; sy < n; ++sy) {
                    // GL's rows run from the bottom up.
                    const auto row = static_cast<std::size_t>((piece.height - 1 - y) * n + sy);
                    const std::size_t first = row * stride + static_cast<std::size_t>(x) * n;
                    for (std::size_t sample = first; sample < first + n; ++sample) {
                        texel += static_cast<double>(samples[2 * sample]);
                        coverage += static_cast<double>(samples[2 * sample + 1]);
                        near_1_m += static_cast<double>(nearness[sample]);
                    }
                }
                const auto pixel =
                    static_cast<std::size_t>(piece.y + y) * static_cast<std::size_t>(frameWidth) +
                    static_cast<std::size_t>(piece.x + x);
                image.texel[pixel] = texel * share;
                image.coverage[pixel] = coverage * share;
                image.nearness_1_m[pixel] = near_1_m * share;
            }
    }
};

TerrainPass::TerrainPass() : impl_(std::make_unique<Impl>()) {}
TerrainPass::~TerrainPass() = default;

TerrainImage TerrainPass::draw(const std::shared_ptr<const Terrain>& terrain,
                               const CameraFrame& camera, double offset) {
    Impl& p = *impl_;
    const Sensor& sensor = camera.sensor();
    TerrainImage image;
    image.texel.resize(static_cast<std::size_t>(sensor.width_px) *
                       static_cast<std::size_t>(sensor.height_px));
    image.coverage.resize(image.texel.size());
    image.nearness_1_m.resize(image.texel.size());
    const auto depth = camera.depthOf(terrain->bounds(), terrain->pose());
    if (!depth)
        return image;

    if (p.terrain != terrain) {
        p.textures.reset();
        p.terrain = terrain;
        p.textures = std::make_unique<UploadedTextures>(terrain->shown().textures);
    }
    for (int y = 0; y < sensor.height_px; y += pieceSide_px)
        for (int x = 0; x < sensor.width_px; x += pieceSide_px) {
            const PixelRegion piece{x, y, std::min(pieceSide_px, sensor.width_px - x),
                                    std::min(pieceSide_px, sensor.height_px - y)};
            p.renderPiece(camera, piece, *depth, offset);
            p.reduce(piece, sensor.width_px, image);
        }
    return image;
}

GlTerrain::~GlTerrain() {
    if (pass_)
        OffscreenContext::shared().run([&] { pass_.reset(); });
}

TerrainImage GlTerrain::paint(const std::shared_ptr<const Terrain>& terrain,
                              const CameraFrame& camera, double offset) {
    TerrainImage image;
    OffscreenContext::shared().run([&] {
        MeshBuffers::forgetGone();
        if (!pass_)
            pass_ = std::make_unique<TerrainPass>();
        image = pass_->draw(terrain, camera, offset);
    });
    return image;
}

} // namespace irsg
