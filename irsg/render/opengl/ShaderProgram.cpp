#include "irsg/render/opengl/ShaderProgram.h"

#include "irsg/core/Errors.h"
#include "irsg/render/opengl/ShaderSource.h"

namespace irsg {

namespace {

GLuint compile(GLenum stage, const std::string& file, const std::string& defines) {
    std::string source = shaderSource(file);
    source.insert(source.find('\n') + 1, defines);
    const char* text = source.c_str();
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);

    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        glDeleteShader(shader);
        throw LogicError("shader " + file + " does not compile: " + log);
    }
    return shader;
}

} // namespace

ShaderProgram::ShaderProgram(const std::vector<std::string>& vertexFiles,
                             const std::vector<std::string>& fragmentFiles,
                             const std::string& defines) {
    program_ = glCreateProgram();
    auto attach = [&](GLenum stage, const std::string& file) {
        const GLuint shader = compile(stage, file, defines);
        glAttachShader(program_, shader);
        glDeleteShader(shader);
    };
    for (const std::string& file : vertexFiles)
        attach(GL_VERTEX_SHADER, file);
    for (const std::string& file : fragmentFiles)
        attach(GL_FRAGMENT_SHADER, file);
    glLinkProgram(program_);

    GLint linked = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw LogicError("shader program with " + fragmentFiles.front() + " does not link: " + log);
    }
}

ShaderProgram::~ShaderProgram() {
    glDeleteProgram(program_);
}

void ShaderProgram::use() const {
    glUseProgram(program_);
}

GLint ShaderProgram::location(const char* name) const {
    auto [place, isNew] = locations_.try_emplace(name, -1);
    if (isNew)
        place->second = glGetUniformLocation(program_, name);
    return place->second;
}

void ShaderProgram::set(const char* name, int value) const {
    glUniform1i(location(name), value);
}

void ShaderProgram::set(const char* name, float x, float y, float z) const {
    glUniform3f(location(name), x, y, z);
}

void ShaderProgram::set(const char* name, const float (&value)[4]) const {
    glUniform4fv(location(name), 1, value);
}

void ShaderProgram::set(const char* name, std::span<const float> values) const {
    glUniform1fv(location(name), static_cast<GLsizei>(values.size()), values.data());
}

void ShaderProgram::set(const char* name, const Matrix4& matrix) const {
    float values[16];
    for (std::size_t i = 0; i < 16; ++i)
        values[i] = static_cast<float>(matrix(i / 4, i % 4));
    glUniformMatrix4fv(location(name), 1, GL_FALSE, values);
}

} // namespace irsg
