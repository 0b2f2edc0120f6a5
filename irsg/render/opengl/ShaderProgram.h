#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "irsg/geometry/view/Matrix4.h"
#include "irsg/render/opengl/GlFunctions.h"

namespace irsg {

/// A linked GL program made of files of shaders/. Lives and dies on the context's thread.
class ShaderProgram {
  public:
    /// `defines` are lines put after the version of every file: "#define SUN_MODE 2\n". Throws
    /// LogicError with the driver's log when a shader does not compile.
    ShaderProgram(const std::vector<std::string>& vertexFiles,
                  const std::vector<std::string>& fragmentFiles, const std::string& defines = "");
    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void use() const;
    void set(const char* name, int value) const;
    void set(const char* name, float x, float y, float z) const;
    void set(const char* name, const float (&value)[4]) const;
    /// An array of floats.
    void set(const char* name, std::span<const float> values) const;
    void set(const char* name, const Matrix4& matrix) const;

  private:
    GLint location(const char* name) const;

    GLuint program_ = 0;
    mutable std::unordered_map<std::string, GLint> locations_;
};

} // namespace irsg
