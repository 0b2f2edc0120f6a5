#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/OwnFiles.h"
#include "irsg/geometry/reading/sandbox/ReadingLimits.h"

namespace irsg {

/// The bytes that a process handed over.
class ReaderAnswer {
  public:
    explicit ReaderAnswer(std::size_t size)
        : bytes_(std::make_unique_for_overwrite<char[]>(size)), size_(size) {}
    char* data() { return bytes_.get(); }
    std::string_view bytes() const { return {bytes_.get(), size_}; }

  private:
    std::unique_ptr<char[]> bytes_;
    std::size_t size_;
};

/// A process of its own in which OpenSceneGraph reads what others made: with little memory and
/// time, and without the means to write a file, to open a connection, to start a program, to signal
/// another, or to read a file that does not belong to the first question: of a model its OwnFiles
/// where they are known, else those in and below its folder and those that it names
/// (filesNamedOutside); of a picture those of its folder.
/// It is started by the first question and ends with this object; one that crashes or takes too
/// long is ended, and the next question, or one about another folder, starts another.
class ReaderProcess {
  public:
    ReaderProcess();
    ~ReaderProcess();
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;

    /// What the process makes of a model or a picture, as ReaderService writes it. With `name` the
    /// bytes of `file` are read as those of a file of that name. With `own` its pictures are read
    /// in another such process when it asks for them. Throws InputError, naming it, where the
    /// process refuses, crashes, needs more than ReadingLimits, or asks for other pictures.
    ReaderAnswer read(FileKind kind, const std::filesystem::path& file,
                      const std::filesystem::path& name = {}, const OwnFiles* own = nullptr);
    /// Nothing more will be asked: it ends while its answer is made use of.
    void dismiss();

  private:
    class Child;
    /// The answer to the question whose head is sent, and what came in the end.
    ReaderAnswer receive(const std::filesystem::path& file, FileKind kind,
                         const ReadingLimits& limits, const OwnFiles* own);
    /// Answers the wish of a process for a picture; the bytes that it got.
    std::uint64_t handOver(const ReaderAnswer& wish, const std::filesystem::path& model,
                           const ReadingLimits& limits, const OwnFiles* own);

    std::unique_ptr<Child> child_;
    /// Of the files that it opens; none where they are OwnFiles.
    std::optional<std::filesystem::path> folder_;
    std::unique_ptr<ReaderProcess> pictures_; ///< of models with OwnFiles
};

} // namespace irsg
