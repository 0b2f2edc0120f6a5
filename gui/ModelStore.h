#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "irsg/scene/model/Model.h"
#include "irsg/scene/model/ModelCodes.h"
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
    /// Lets go of all others: those of a project that was closed.
    void keepOnly(const std::vector<ModelKey>& keys);
    /// How often a file was read so far.
    long readings() const;

  private:
    using Answer = std::shared_future<std::shared_ptr<const irsg::Model>>;
    struct Kept {
        irsg::ModelStamp stamp;
        long reading = 0; ///< the number of
        Answer answer;
    };

    Reader read_;
    mutable std::mutex mutex_;
    std::map<ModelKey, Kept> kept_;
    long readings_ = 0;
};

} // namespace smat::gui
