#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "irsg/geometry/flight/FlightRecords.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg::test {

/// Bytes of OpenFlight records, big endian, for files that are wrong on purpose.
std::string u8(int value);
std::string i16(int value);
std::string i32(std::int64_t value);
std::string f32(float value);
std::string f64(double value);
std::string zeros(std::size_t count);
/// A whole record around a payload.
std::string record(int opcode, const std::string& payload = {});

/// A file of one unit square in the xy plane, each record apart so that a test can replace it.
struct SquareFile {
    int version = 1610;
    int unit = 0;
    int temperature = 1, material = 2;
    int drawType = 0, lightMode = 2;
    std::uint32_t flags = 0x10000000; ///< packed colour
    double size = 1.0;
    std::string header, colours, palette, vertices, push, group, pushGroup, object, pushObject;
    std::string face, pushFace, list, popFace, popObject, popGroup, pop;
    std::string trailer;

    SquareFile();
    /// Makes header, face and vertices anew from the numbers above.
    void remake();
    std::string bytes() const;
    /// Where a record begins in bytes(): &SquareFile::face.
    std::size_t offsetOf(std::string SquareFile::*part) const;
    std::string positionOf(std::string SquareFile::*part, std::size_t within = 0) const;
};

/// A mesh of one square with its pool and primitive, to stand in for a face.
std::string meshRecords(std::uint32_t count = 4, std::uint32_t mask = 0x90000000,
                        const std::string& primitive = {});
/// Type, index size, count and two-byte indices of a mesh primitive.
std::string primitiveRecord(int type, int indexSize, std::uint32_t count,
                            const std::vector<int>& indices);

/// A folder that files can be put into.
class TemporaryFolder : public smat::test::TemporaryFolder {
  public:
    std::filesystem::path write(const std::string& name, const std::string& bytes) const;
};

std::string readBytes(const std::filesystem::path& file);

/// The folder of models and tools beside the checkout; empty where it is absent.
std::filesystem::path sharedModels();

} // namespace irsg::test
