#include "gui/ModelStore.h"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace smat::gui {

ModelStore::ModelStore(Reader read) : read_(std::move(read)) {
    if (!read_)
        read_ = [](const ModelKey& key) {
            return std::shared_ptr<const irsg::Model>(irsg::Model::load(key.file, key.options));
        };
}

std::shared_ptr<const irsg::Model> ModelStore::model(const ModelKey& key) {
    const auto stamp = irsg::modelStampOf(key.file);
    std::promise<std::shared_ptr<const irsg::Model>> promise;
    Answer answer;
    long mine = 0;
    {
        const std::scoped_lock lock(mutex_);
        Kept& kept = kept_[key];
        if (!kept.answer.valid() || kept.stamp != stamp) {
            mine = ++readings_;
            kept = {stamp, mine, promise.get_future().share()};
        }
        answer = kept.answer;
    }
    if (mine > 0) {
        try {
            promise.set_value(read_(key));
        } catch (...) {
            // Those who wait hear of it, too.
            promise.set_exception(std::current_exception());
            const std::scoped_lock lock(mutex_);
            if (const auto kept = kept_.find(key);
                kept != kept_.end() && kept->second.reading == mine)
                kept_.erase(kept);
        }
    }
    return answer.get();
}

bool ModelStore::isThere(const ModelKey& key) const {
    const auto stamp = irsg::modelStampOf(key.file);
    const std::scoped_lock lock(mutex_);
    const auto kept = kept_.find(key);
    return kept != kept_.end() && kept->second.stamp == stamp &&
           kept->second.answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

SceneBuilder::ModelLoader ModelStore::loader(std::shared_ptr<ModelStore> store) {
    return [store = std::move(store)](const std::filesystem::path& file,
                                      const irsg::ModelOptions& options) {
        return store->model({file, options});
    };
}

void ModelStore::keepOnly(const std::vector<ModelKey>& keys) {
    const std::scoped_lock lock(mutex_);
    std::erase_if(kept_, [&](const auto& kept) {
        return std::find(keys.begin(), keys.end(), kept.first) == keys.end();
    });
}

long ModelStore::readings() const {
    const std::scoped_lock lock(mutex_);
    return readings_;
}

} // namespace smat::gui
