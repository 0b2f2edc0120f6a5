#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/model/FaceMesh.h"
#include "irsg/geometry/model/Model.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {

using LoadedModels = std::map<ModelKey, std::shared_ptr<const irsg::Model>>;

/// The infrared models of the project that is open, each read once however many parts of the
/// window ask for it: view, scene tree, database editor and tools. May be used from any thread.
class ModelStore {
  public:
    using Reader = std::function<std::shared_ptr<const irsg::Model>(const ModelKey&)>;

    /// `read` stands in for irsg::Model::load in tests.
    explicit ModelStore(Reader read = {});

    /// The model as its file is now. Reads it where nobody has since the file was last written, and
    /// waits where another thread is reading it: takes its time, and is not for the thread of the
    /// window unless isThere(). Throws what reading throws; the next one who asks reads anew.
    std::shared_ptr<const irsg::Model> model(const ModelKey& key);
    /// Whether model() answers at once.
    bool isThere(const ModelKey& key) const;
    /// The same for what builds scenes; shares ownership of the store.
    static SceneBuilder::ModelLoader loader(std::shared_ptr<ModelStore> store);

    using Painted = std::shared_ptr<const std::vector<irsg::PaintedSurface>>;
    /// What is painted on a model from now on, in place of what the file beside it says; null for
    /// that again. Its models are made anew without their file being read again once mesh() was
    /// asked for.
    void setPainted(const std::filesystem::path& file, Painted painted);
    /// The faces of a file, to be chosen and painted; kept as long as the file and the rules beside
    /// it stay. Takes its time, and throws as reading does.
    std::shared_ptr<const irsg::FaceMesh> mesh(const std::filesystem::path& file);

    /// Lets go of all others: those of a project that was closed.
    void keepOnly(const std::vector<ModelKey>& keys);
    /// How often a file was read so far.
    long readings() const;

  private:
    using Answer = std::shared_future<std::shared_ptr<const irsg::Model>>;
    /// What a file holds, without the codes beside it, of a model that is painted.
    struct AsRead {
        std::mutex mutex; ///< of all that works on the graph
        std::optional<irsg::FileStamp> stamp;
        std::optional<irsg::LoadedGraph> graph;
        irsg::LoadPurpose purpose = irsg::LoadPurpose::infrared; ///< of the graph
        std::vector<irsg::CodeRule> rules;                       ///< of the mesh
        std::shared_ptr<const irsg::FaceMesh> mesh;
    };
    std::shared_ptr<const irsg::Model> made(const ModelKey& key);
    /// Reads where nobody has for this purpose since the file was last written; with the mutex
    /// held.
    void bringUpToDate(AsRead& asRead, const std::filesystem::path& file,
                       irsg::LoadPurpose purpose);
    struct CacheEntry {
        irsg::ModelStamp stamp;
        long painting = 0; ///< the last one when it was made
        long reading = 0;  ///< the number of
        Answer answer;
    };

    Reader read_;
    mutable std::mutex mutex_;
    std::map<ModelKey, CacheEntry> cache_;
    std::map<std::filesystem::path, std::shared_ptr<AsRead>> asRead_;
    struct OnModel {
        Painted surfaces; ///< null for those of the file beside the model
        long painting = 0;
    };
    std::map<std::filesystem::path, OnModel> painted_;
    long asked_ = 0, readings_ = 0;
};

} // namespace smat::gui
