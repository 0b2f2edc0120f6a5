#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <osg/Image>

#include "irsg/geometry/reading/sandbox/ReaderMessages.h"

namespace irsg {

/// What a reading process has of the program that asks it.

/// True in a process that serves: there OpenSceneGraph reads, and nowhere else.
bool isReader();
/// From here on this process is one.
void beginToServe();

/// The model that is asked for has OwnFiles: who asks for it, and what came with the question.
void setAsked(int socket, bool wantsPictures, std::string contents);
/// Whether there is such a model: its pictures are read apart from it.
bool arePicturesApart();
/// Whether pictures are read at all.
bool arePicturesWanted();
/// One of those, handed over by who asked for the model. Throws InputError as its reader does.
osg::ref_ptr<osg::Image> pictureFromApart(const std::filesystem::path& file);
/// The bytes of the model, where they came with the question.
std::string takeContents();

/// All bytes through a socket; false where the other side is gone.
bool readFrom(int socket, void* into, std::size_t size);
bool writeAnswerTo(int socket, AnswerKind kind, const ByteSink& bytes);

} // namespace irsg
