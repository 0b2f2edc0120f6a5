#include "irsg/geometry/reading/sandbox/SandboxedPictures.h"

#include "irsg/core/Bytes.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/sandbox/StateCoding.h"

namespace irsg {

osg::ref_ptr<osg::Image> readPictureSandboxed(ReaderProcess& process,
                                              const std::filesystem::path& file) {
    try {
        const ReaderAnswer answer = process.read(FileKind::picture, file);
        ByteSource source(answer.bytes());
        return getImage(source);
    } catch (const DamagedBytes& damage) {
        throw InputError(
            {file.string(), "",
             "a file at which the reader of OpenSceneGraph gives " + std::string(damage.what()),
             "a whole picture"});
    }
}

} // namespace irsg
