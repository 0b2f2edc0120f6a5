#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "irsg/scattering/PhotonTracer.h"

namespace irsg {

/// Batches of photons that a build has finished, in a text file from which the same build goes on:
/// a line of the recipe, then one for each batch. A line that a kill cut short, and any that is
/// damaged, is no batch.
class FinishedBatches {
  public:
    /// Number of the optical depth, number of the batch.
    using Key = std::pair<std::size_t, std::uint64_t>;
    /// What the line of a recipe begins with.
    static constexpr std::string_view firstWords = "smat mtf batches 1";

    /// Takes over what was finished of this recipe. Throws InputError where the file is something
    /// else, or cannot be read or written.
    FinishedBatches(const std::filesystem::path& file, const std::string& recipe,
                    std::size_t frequencies);

    /// What is finished of a recipe in a file: nothing where there is none.
    static std::map<Key, PhotonSums> read(const std::filesystem::path& file,
                                          const std::string& recipe, std::size_t frequencies);

    /// Null where it is to be traced.
    const PhotonSums* find(const Key& key) const;
    /// May be called from several threads.
    void keep(const Key& key, const PhotonSums& sums);

  private:
    std::map<Key, PhotonSums> done_;
    std::ofstream out_;
    std::mutex mutex_;
};

} // namespace irsg
