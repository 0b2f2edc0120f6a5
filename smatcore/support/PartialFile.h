#pragma once

#include <filesystem>

namespace smat {

/// "table.partial.csv": beside "table.csv".
std::filesystem::path partialFileBeside(const std::filesystem::path& file);

/// True for a result (.csv, .json, .nc) that says of itself that its run was stopped. Throws
/// nothing: what cannot be read, or says nothing, is whole.
bool isPartialResult(const std::filesystem::path& file);

/// Where the result of a run that was stopped goes, so that it replaces no whole one: to `file`
/// where nothing or another such result is, else beside it.
std::filesystem::path placeOfPartial(const std::filesystem::path& file);

/// Takes the partial result of an earlier run away from beside one that was written whole.
void removePartialBeside(const std::filesystem::path& file);

/// Saves a result by `save(place)` where it belongs and gives its place: a whole one in `file`, and
/// no partial one of an earlier run beside it; a partial one see placeOfPartial.
template <typename Save>
std::filesystem::path savedResult(const std::filesystem::path& file, bool isComplete,
                                  const Save& save) {
    std::filesystem::path place = isComplete ? file : placeOfPartial(file);
    save(place);
    if (isComplete)
        removePartialBeside(file);
    return place;
}

} // namespace smat
