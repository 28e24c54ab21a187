#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "render/gl/gl.h"
#include "render/gl/gl_context.h"
#include "render/image/color.h"

namespace plumb {

/// An OpenGL object that deletes itself. `Generate` and `Delete` are members of Gl.
template <auto Generate, auto Delete>
class GlObject {
 public:
  explicit GlObject(const GlContext& context) : context_(&context) { (context.gl().*Generate)(1, &id_); }
  ~GlObject() {
    if (id_ != 0 && context_->try_current()) (context_->gl().*Delete)(1, &id_);
  }
  GlObject(GlObject&& other) noexcept : context_(other.context_), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(context_, other.context_);
    std::swap(id_, other.id_);
    return *this;
  }

  GLuint id() const { return id_; }

 private:
  const GlContext* context_;
  GLuint id_ = 0;
};

using GlBuffer = GlObject<&Gl::GenBuffers, &Gl::DeleteBuffers>;
using GlTexture = GlObject<&Gl::GenTextures, &Gl::DeleteTextures>;
using GlFramebuffer = GlObject<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>;
using GlVertexArray = GlObject<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>;

/// A linked vertex and fragment shader.
class GlProgram {
 public:
  /// Throws OutputError with the compiler's message.
  GlProgram(const GlContext& context, std::string_view vertex_source, std::string_view fragment_source);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;

  /// Values for the program in use. Names that the shader does not use are ignored, as OpenGL does.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, float x, float y) const;
  void set(const char* name, float x, float y, float z) const;
  void set(const char* name, Color value) const;
  void set_matrix(const char* name, const float* column_major_16) const;

 private:
  GLint location(const char* name) const { return context_.gl().GetUniformLocation(id_, name); }

  const GlContext& context_;
  GLuint id_ = 0;
};

/// A vertex array over one buffer of floats; attribute i has `components[i]` floats, interleaved in order.
class VertexBuffer {
 public:
  enum class Step { vertex, instance };

  VertexBuffer(const GlContext& context, std::span<const int> components, Step step = Step::vertex);

  /// Replaces the content and binds the vertex array.
  void upload(std::span<const float> data);
  /// Replaces the triangle list for DrawElements.
  void upload_indices(std::span<const unsigned> indices);
  void bind() const;

  /// Vertices or instances uploaded.
  int count() const { return count_; }
  /// Indices uploaded.
  int index_count() const { return index_count_; }

 private:
  const GlContext* context_;
  GlVertexArray array_;
  GlBuffer data_;
  GlBuffer indices_;
  int floats_each_ = 0;
  int count_ = 0;
  int index_count_ = 0;
};

}  // namespace plumb
