#pragma once

#include <filesystem>
#include <vector>

#include "irsg/core/Bytes.h"
#include "irsg/core/FoundNames.h"

namespace irsg {

/// The files of a model whose format we read ourselves, so that they are known before its reader
/// runs: it opens these, and looks into no folder.
struct OwnFiles {
    std::vector<std::filesystem::path> opened;   ///< by the reader
    std::vector<std::filesystem::path> pictures; ///< handed to it when it asks for them
    bool wantsPictures = true;                   ///< false: they are not even looked for
    std::vector<FoundName> names;                ///< what names in the model stand for
    /// Of the model, where its reader gets them in place of a file. They go on their own.
    ByteSink contents;
};

/// All but the contents.
void putOwnFiles(ByteSink& sink, const OwnFiles& files);
/// Throws DamagedBytes.
OwnFiles getOwnFiles(ByteSource& source);

} // namespace irsg
