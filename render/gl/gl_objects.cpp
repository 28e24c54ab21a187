#include "render/gl/gl_objects.h"

#include <fmt/format.h>

#include "engine/base/errors.h"

namespace plumb {

namespace {

GLuint compile(const GlContext& context, GLenum kind, std::string_view source) {
  const Gl& gl = context.gl();
  const GLuint shader = gl.CreateShader(kind);
  const char* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader, 1, &text, &length);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  char log[1024] = "";
  gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
  gl.DeleteShader(shader);
  throw OutputError(fmt::format("OpenGL: a shader does not compile: {}", log));
}

}  // namespace

GlProgram::GlProgram(const GlContext& context, std::string_view vertex_source,
                     std::string_view fragment_source)
    : context_(context) {
  const Gl& gl = context.gl();
  id_ = gl.CreateProgram();
  for (const auto& [kind, source] : {std::pair(GLenum{GL_VERTEX_SHADER}, vertex_source),
                                     std::pair(GLenum{GL_FRAGMENT_SHADER}, fragment_source)}) {
    const GLuint shader = compile(context, kind, source);
    gl.AttachShader(id_, shader);
    gl.DeleteShader(shader);  // lives on as long as the program does
  }
  gl.LinkProgram(id_);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  char log[1024] = "";
  gl.GetProgramInfoLog(id_, sizeof log, nullptr, log);
  throw OutputError(fmt::format("OpenGL: a shader does not link: {}", log));
}

GlProgram::~GlProgram() {
  if (context_.try_current()) context_.gl().DeleteProgram(id_);
}

void GlProgram::use() const {
  context_.gl().UseProgram(id_);
}

void GlProgram::set(const char* name, int value) const {
  context_.gl().Uniform1i(location(name), value);
}

void GlProgram::set(const char* name, float value) const {
  context_.gl().Uniform1f(location(name), value);
}

void GlProgram::set(const char* name, float x, float y) const {
  context_.gl().Uniform2f(location(name), x, y);
}

void GlProgram::set(const char* name, float x, float y, float z) const {
  context_.gl().Uniform3f(location(name), x, y, z);
}

void GlProgram::set(const char* name, Color value) const {
  context_.gl().Uniform4f(location(name), value.r, value.g, value.b, value.a);
}

void GlProgram::set_matrix(const char* name, const float* column_major_16) const {
  context_.gl().UniformMatrix4fv(location(name), 1, GL_FALSE, column_major_16);
}

VertexBuffer::VertexBuffer(const GlContext& context, std::span<const int> components, Step step)
    : context_(&context), array_(context), data_(context), indices_(context) {
  const Gl& gl = context.gl();
  for (const int n : components) floats_each_ += n;
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, data_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  GLuint attribute = 0;
  std::size_t offset = 0;
  for (const int n : components) {
    gl.VertexAttribPointer(attribute, n, GL_FLOAT, GL_FALSE, floats_each_ * static_cast<int>(sizeof(float)),
                           reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribDivisor(attribute, step == Step::instance ? 1 : 0);
    offset += static_cast<std::size_t>(n) * sizeof(float);
    ++attribute;
  }
}

void VertexBuffer::upload(std::span<const float> data) {
  const Gl& gl = context_->gl();
  bind();
  gl.BindBuffer(GL_ARRAY_BUFFER, data_.id());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
  count_ = static_cast<int>(data.size()) / floats_each_;
}

void VertexBuffer::upload_indices(std::span<const unsigned> indices) {
  bind();
  context_->gl().BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()),
                            indices.data(), GL_STATIC_DRAW);
  index_count_ = static_cast<int>(indices.size());
}

void VertexBuffer::bind() const {
  context_->gl().BindVertexArray(array_.id());
}

}  // namespace plumb
