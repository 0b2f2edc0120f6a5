#include "irsg/geometry/reading/sandbox/OwnFiles.h"

namespace irsg {

namespace {

using Paths = std::vector<std::filesystem::path>;

void putPaths(ByteSink& sink, const Paths& paths) {
    sink.putCount(paths.size());
    for (const auto& path : paths)
        sink.putText(path.native());
}

Paths getPaths(ByteSource& source) {
    Paths paths(source.getCount(8));
    for (auto& path : paths)
        path = source.getText();
    return paths;
}

} // namespace

void putOwnFiles(ByteSink& sink, const OwnFiles& files) {
    putPaths(sink, files.opened);
    putPaths(sink, files.pictures);
    sink.put(static_cast<std::uint8_t>(files.wantsPictures));
    sink.putCount(files.names.size());
    for (const FoundName& name : files.names) {
        sink.putText(name.folder.native());
        sink.putText(name.written);
        sink.putText(name.found.file.native());
        sink.putText(name.found.remark);
    }
}

OwnFiles getOwnFiles(ByteSource& source) {
    OwnFiles files;
    files.opened = getPaths(source);
    files.pictures = getPaths(source);
    files.wantsPictures = source.getFlag();
    files.names.resize(source.getCount(32));
    for (FoundName& name : files.names) {
        name.folder = source.getText();
        name.written = source.getText();
        name.found.file = source.getText();
        name.found.remark = source.getText();
    }
    return files;
}

} // namespace irsg
