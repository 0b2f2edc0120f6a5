#include "gui/workbench/ModelStore.h"

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
        CacheEntry& kept = cache_[key];
        const auto on = painted_.find(key.file);
        const long painting = on == painted_.end() ? 0 : on->second.painting;
        if (!kept.answer.valid() || kept.stamp != stamp || kept.painting != painting) {
            mine = ++asked_;
            kept = {stamp, painting, mine, promise.get_future().share()};
        }
        answer = kept.answer;
    }
    if (mine > 0) {
        try {
            promise.set_value(made(key));
        } catch (...) {
            // Those who wait hear of it, too.
            promise.set_exception(std::current_exception());
            const std::scoped_lock lock(mutex_);
            if (const auto kept = cache_.find(key);
                kept != cache_.end() && kept->second.reading == mine)
                cache_.erase(kept);
        }
    }
    return answer.get();
}

bool ModelStore::isThere(const ModelKey& key) const {
    const auto stamp = irsg::modelStampOf(key.file);
    const std::scoped_lock lock(mutex_);
    const auto kept = cache_.find(key);
    const auto on = painted_.find(key.file);
    return kept != cache_.end() && kept->second.stamp == stamp &&
           kept->second.painting == (on == painted_.end() ? 0 : on->second.painting) &&
           kept->second.answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::shared_ptr<const irsg::Model> ModelStore::made(const ModelKey& key) {
    std::shared_ptr<AsRead> asRead;
    Painted painted;
    {
        const std::scoped_lock lock(mutex_);
        if (const auto known = asRead_.find(key.file); known != asRead_.end())
            asRead = known->second;
        if (const auto on = painted_.find(key.file); on != painted_.end())
            painted = on->second.surfaces;
        if (!asRead && painted)
            asRead = asRead_[key.file] = std::make_shared<AsRead>();
        if (!asRead)
            ++readings_;
    }
    if (!asRead)
        return read_(key);
    const std::scoped_lock lock(asRead->mutex);
    bringUpToDate(*asRead, key.file, irsg::purposeOf(key.options));
    irsg::ModelCodes codes = irsg::readModelCodes(key.file);
    if (painted)
        codes.painted = *painted;
    return irsg::Model::ofGraph(*asRead->graph, codes, key.file, key.options);
}

void ModelStore::bringUpToDate(AsRead& asRead, const std::filesystem::path& file,
                               irsg::LoadPurpose purpose) {
    const auto stamp = irsg::stampOf(file);
    // What is read with its textures serves for everything.
    if (asRead.graph && asRead.stamp == stamp &&
        (asRead.purpose == purpose || asRead.purpose == irsg::LoadPurpose::visible))
        return;
    {
        const std::scoped_lock lock(mutex_);
        ++readings_;
    }
    asRead.mesh.reset();
    asRead.graph = irsg::loadGraphAsIs(file, purpose);
    asRead.purpose = purpose;
    asRead.stamp = stamp;
}

void ModelStore::setPainted(const std::filesystem::path& file, Painted painted) {
    const std::scoped_lock lock(mutex_);
    OnModel& on = painted_[file];
    on.surfaces = std::move(painted);
    ++on.painting;
}

std::shared_ptr<const irsg::FaceMesh> ModelStore::mesh(const std::filesystem::path& file) {
    std::shared_ptr<AsRead> asRead;
    {
        const std::scoped_lock lock(mutex_);
        auto& known = asRead_[file];
        if (!known)
            known = std::make_shared<AsRead>();
        asRead = known;
    }
    const std::scoped_lock lock(asRead->mutex);
    bringUpToDate(*asRead, file, irsg::LoadPurpose::infrared);
    auto rules = irsg::readModelCodes(file).rules;
    if (!asRead->mesh || asRead->rules != rules) {
        asRead->mesh = std::make_shared<const irsg::FaceMesh>(*asRead->graph, rules, file.string());
        asRead->rules = std::move(rules);
    }
    return asRead->mesh;
}

SceneBuilder::ModelLoader ModelStore::loader(std::shared_ptr<ModelStore> store) {
    return [store = std::move(store)](const std::filesystem::path& file,
                                      const irsg::ModelOptions& options) {
        return store->model({file, options});
    };
}

void ModelStore::keepOnly(const std::vector<ModelKey>& keys) {
    const std::scoped_lock lock(mutex_);
    std::erase_if(cache_, [&](const auto& kept) {
        return std::find(keys.begin(), keys.end(), kept.first) == keys.end();
    });
    const auto isOfOthers = [&](const auto& one) {
        return std::ranges::none_of(keys,
                                    [&](const ModelKey& key) { return key.file == one.first; });
    };
    std::erase_if(asRead_, isOfOthers);
}

long ModelStore::readings() const {
    const std::scoped_lock lock(mutex_);
    return readings_;
}

} // namespace smat::gui
