#include <bit>
#include <cstring>
#include <iterator>

#include <zlib.h>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"

// A .gastable is little-endian: the magic, then text, numbers and arrays, each array after its
// number of elements (64 bit), and at the end the CRC-32 of everything before it.

namespace irsg {

static_assert(std::endian::native == std::endian::little, "tables are read as they lie in memory");

namespace {

constexpr char gasTableMagic[8] = {'S', 'M', 'A', 'T', 'G', 'A', 'S', '1'};

std::uint32_t checksum(const std::string& bytes, std::size_t count) {
    return static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), count));
}

class Writer {
  public:
    Writer() : bytes_(gasTableMagic, sizeof gasTableMagic) {}

    template <typename Number>
    void number(Number value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <typename Range>
    void array(const Range& values) {
        number<std::uint64_t>(std::size(values));
        bytes_.append(reinterpret_cast<const char*>(std::data(values)),
                      std::size(values) * sizeof(*std::data(values)));
    }
    std::string finished() {
        number(checksum(bytes_, bytes_.size()));
        return std::move(bytes_);
    }

  private:
    std::string bytes_;
};

class GasTableReader {
  public:
    GasTableReader(const std::string& bytes, std::string file)
        : bytes_(bytes), file_(std::move(file)) {
        if (bytes.size() < sizeof gasTableMagic + 4 ||
            std::memcmp(bytes.data(), gasTableMagic, sizeof gasTableMagic) != 0)
            refuse("another kind of file", "a table of gases, version 1");
        std::uint32_t stored = 0;
        std::memcpy(&stored, bytes.data() + bytes.size() - sizeof stored, sizeof stored);
        if (stored != checksum(bytes, bytes.size() - sizeof stored))
            refuse("a checksum that does not fit", "a file that was not changed or cut");
        at_ = sizeof gasTableMagic;
    }
    template <typename Number>
    Number number() {
        Number value{};
        take(&value, sizeof value);
        return value;
    }
    template <typename Range>
    void array(Range& values) {
        using Element = std::remove_cvref_t<decltype(*std::data(values))>;
        const auto count = number<std::uint64_t>();
        if (count > (bytes_.size() - at_) / sizeof(Element))
            refuse(std::to_string(count) + " elements", "no more than the file has");
        values.resize(count);
        take(values.data(), count * sizeof(Element));
    }

  private:
    void take(void* to, std::size_t size) {
        if (size > bytes_.size() - at_)
            refuse("the end of the file", "more of the table");
        if (size > 0) // an empty array has no place to copy to
            std::memcpy(to, bytes_.data() + at_, size);
        at_ += size;
    }
    [[noreturn]] void refuse(std::string value, std::string expected) const {
        throw InputError(Diagnostic{file_, "byte " + std::to_string(at_), std::move(value),
                                    std::move(expected)});
    }

    const std::string& bytes_;
    std::string file_;
    std::size_t at_ = 0;
};

} // namespace

void GasTable::write(const std::filesystem::path& file) const {
    Writer writer;
    writer.array(header_);
    writer.array(grid_.pressures_hPa);
    writer.array(grid_.temperatures_K);
    writer.number(grid_.moistFraction);
    writer.number<std::uint64_t>(grid_.moistPressures);
    writer.array(wavenumbers_per_cm_);
    for (const GasNodes& gas : gases_) {
        writer.array(gas.nodes);
        writer.array(gas.values);
    }
    for (const BinSet& set : bins_) {
        writer.number(set.resolution_per_cm);
        writer.array(set.bins);
        writer.array(set.nodes);
        writer.array(set.weights);
    }
    writeFileDurably(file, writer.finished());
}

std::shared_ptr<const GasTable> GasTable::read(const std::filesystem::path& file) {
    const std::string bytes = readFile(file);
    GasTableReader reader(bytes, file.string());
    auto table = std::shared_ptr<GasTable>(new GasTable);
    reader.array(table->header_);
    reader.array(table->grid_.pressures_hPa);
    reader.array(table->grid_.temperatures_K);
    table->grid_.moistFraction = reader.number<double>();
    table->grid_.moistPressures = reader.number<std::uint64_t>();
    reader.array(table->wavenumbers_per_cm_);
    for (GasNodes& gas : table->gases_) {
        reader.array(gas.nodes);
        reader.array(gas.values);
    }
    for (BinSet& set : table->bins_) {
        set.resolution_per_cm = reader.number<double>();
        reader.array(set.bins);
        reader.array(set.nodes);
        reader.array(set.weights);
    }
    try {
        table->index();
    } catch (const LogicError& error) {
        throw InputError(Diagnostic{file.string(), "", error.what(), "a table whose parts fit"});
    }
    return table;
}

} // namespace irsg
