/* The part of OpenGL 3.3 core that drawing uses, loaded by name from whichever context is open. */
#ifndef RENDER_GL_H
#define RENDER_GL_H

#include "base/error.h"

#include <stddef.h>

/* Own declarations, so that a build without GL headers compiles the same files. */
typedef unsigned int GLenum, GLuint, GLbitfield;
typedef int GLint, GLsizei;
typedef unsigned char GLboolean, GLubyte;
typedef float GLfloat;
typedef char GLchar;
typedef ptrdiff_t GLsizeiptr, GLintptr;

enum {
    GL_NO_ERROR = 0, GL_FALSE = 0, GL_OUT_OF_MEMORY = 0x0505,
    GL_POINTS = 0x0000, GL_TRIANGLES = 0x0004, GL_TRIANGLE_STRIP = 0x0005,
    GL_DEPTH_BUFFER_BIT = 0x0100, GL_COLOR_BUFFER_BIT = 0x4000,
    GL_LESS = 0x0201, GL_GEQUAL = 0x0206,
    GL_SRC_ALPHA = 0x0302, GL_ONE_MINUS_SRC_ALPHA = 0x0303, GL_ONE = 1,
    GL_DEPTH_TEST = 0x0B71, GL_DITHER = 0x0BD0, GL_BLEND = 0x0BE2,
    GL_PACK_ALIGNMENT = 0x0D05, GL_UNPACK_ALIGNMENT = 0x0CF5,
    GL_MAX_TEXTURE_SIZE = 0x0D33, GL_MAX_VIEWPORT_DIMS = 0x0D3A,
    GL_MAX_RENDERBUFFER_SIZE = 0x84E8, GL_MAX_TEXTURE_BUFFER_SIZE = 0x8C2B,
    GL_TEXTURE_1D = 0x0DE0, GL_TEXTURE_2D = 0x0DE1, GL_TEXTURE_BUFFER = 0x8C2A,
    GL_UNSIGNED_BYTE = 0x1401, GL_FLOAT = 0x1406,
    GL_RGB = 0x1907, GL_RGBA = 0x1908, GL_RGB8 = 0x8051, GL_RGBA8 = 0x8058, GL_RGBA16 = 0x805B,
    GL_RGBA32F = 0x8814, GL_RGBA32UI = 0x8D70, GL_RGBA8UI = 0x8D7C, GL_RGBA_INTEGER = 0x8D99,
    GL_RENDERER = 0x1F01, GL_VERSION = 0x1F02,
    GL_NEAREST = 0x2600, GL_LINEAR = 0x2601, GL_CLAMP_TO_EDGE = 0x812F,
    GL_TEXTURE_MAG_FILTER = 0x2800, GL_TEXTURE_MIN_FILTER = 0x2801, GL_TEXTURE_WRAP_S = 0x2802,
    GL_TEXTURE0 = 0x84C0,
    GL_ARRAY_BUFFER = 0x8892, GL_COPY_WRITE_BUFFER = 0x8F37, GL_STREAM_DRAW = 0x88E0,
    GL_MAP_WRITE_BIT = 0x0002, GL_MAP_INVALIDATE_BUFFER_BIT = 0x0008,
    GL_FRAGMENT_SHADER = 0x8B30, GL_VERTEX_SHADER = 0x8B31,
    GL_COMPILE_STATUS = 0x8B81, GL_LINK_STATUS = 0x8B82,
    GL_FRAMEBUFFER = 0x8D40, GL_RENDERBUFFER = 0x8D41,
    GL_COLOR_ATTACHMENT0 = 0x8CE0, GL_DEPTH_ATTACHMENT = 0x8D00,
    GL_DEPTH_COMPONENT32F = 0x8CAC, GL_FRAMEBUFFER_COMPLETE = 0x8CD5
};

/* X(result, name without gl, arguments) */
#define GL_FUNCTIONS(X)                                                                            \
    X(void, ActiveTexture, (GLenum unit))                                                          \
    X(void, AttachShader, (GLuint program, GLuint shader))                                         \
    X(void, BindAttribLocation, (GLuint program, GLuint index, const GLchar *name))                \
    X(void, BindBuffer, (GLenum target, GLuint buffer))                                            \
    X(void, BindFramebuffer, (GLenum target, GLuint framebuffer))                                  \
    X(void, BindRenderbuffer, (GLenum target, GLuint renderbuffer))                                \
    X(void, BindTexture, (GLenum target, GLuint texture))                                          \
    X(void, BindVertexArray, (GLuint array))                                                       \
    X(void, BlendFuncSeparate, (GLenum sc, GLenum dc, GLenum sa, GLenum da))                       \
    X(void, BufferData, (GLenum target, GLsizeiptr size, const void *data, GLenum usage))          \
    X(GLenum, CheckFramebufferStatus, (GLenum target))                                             \
    X(void, Clear, (GLbitfield mask))                                                              \
    X(void, ClearColor, (GLfloat r, GLfloat g, GLfloat b, GLfloat a))                              \
    X(void, CompileShader, (GLuint shader))                                                        \
    X(GLuint, CreateProgram, (void))                                                               \
    X(GLuint, CreateShader, (GLenum type))                                                         \
    X(void, DeleteBuffers, (GLsizei n, const GLuint *buffers))                                     \
    X(void, DeleteFramebuffers, (GLsizei n, const GLuint *framebuffers))                           \
    X(void, DeleteProgram, (GLuint program))                                                       \
    X(void, DeleteRenderbuffers, (GLsizei n, const GLuint *renderbuffers))                         \
    X(void, DeleteShader, (GLuint shader))                                                         \
    X(void, DeleteTextures, (GLsizei n, const GLuint *textures))                                   \
    X(void, DeleteVertexArrays, (GLsizei n, const GLuint *arrays))                                 \
    X(void, DepthFunc, (GLenum func))                                                              \
    X(void, DepthMask, (GLboolean flag))                                                           \
    X(void, Disable, (GLenum cap))                                                                 \
    X(void, DrawArrays, (GLenum mode, GLint first, GLsizei count))                                 \
    X(void, Enable, (GLenum cap))                                                                  \
    X(void, EnableVertexAttribArray, (GLuint index))                                               \
    X(void, FramebufferRenderbuffer, (GLenum target, GLenum at, GLenum rbt, GLuint rb))            \
    X(void, FramebufferTexture2D, (GLenum target, GLenum at, GLenum tt, GLuint texture, GLint level)) \
    X(void, GenBuffers, (GLsizei n, GLuint *buffers))                                              \
    X(void, GenFramebuffers, (GLsizei n, GLuint *framebuffers))                                    \
    X(void, GenRenderbuffers, (GLsizei n, GLuint *renderbuffers))                                  \
    X(void, GenTextures, (GLsizei n, GLuint *textures))                                            \
    X(void, GenVertexArrays, (GLsizei n, GLuint *arrays))                                          \
    X(GLenum, GetError, (void))                                                                    \
    X(void, GetIntegerv, (GLenum name, GLint *data))                                               \
    X(void, GetProgramInfoLog, (GLuint program, GLsizei size, GLsizei *length, GLchar *log))       \
    X(void, GetProgramiv, (GLuint program, GLenum name, GLint *params))                            \
    X(void, GetShaderInfoLog, (GLuint shader, GLsizei size, GLsizei *length, GLchar *log))         \
    X(void, GetShaderiv, (GLuint shader, GLenum name, GLint *params))                              \
    X(const GLubyte *, GetString, (GLenum name))                                                   \
    X(GLint, GetUniformLocation, (GLuint program, const GLchar *name))                             \
    X(void, LinkProgram, (GLuint program))                                                         \
    X(void *, MapBufferRange, (GLenum target, GLintptr offset, GLsizeiptr size, GLbitfield access)) \
    X(void, PixelStorei, (GLenum name, GLint param))                                               \
    X(void, ReadPixels, (GLint x, GLint y, GLsizei w, GLsizei h, GLenum f, GLenum t, void *data))  \
    X(void, RenderbufferStorage, (GLenum target, GLenum format, GLsizei w, GLsizei h))             \
    X(void, ShaderSource, (GLuint shader, GLsizei n, const GLchar *const *text, const GLint *len)) \
    X(void, TexBuffer, (GLenum target, GLenum format, GLuint buffer))                              \
    X(void, TexImage1D, (GLenum target, GLint level, GLint internal, GLsizei width, GLint border,  \
                         GLenum format, GLenum type, const void *data))                            \
    X(void, TexImage2D, (GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, \
                         GLint border, GLenum format, GLenum type, const void *data))              \
    X(void, TexParameteri, (GLenum target, GLenum name, GLint param))                              \
    X(void, Uniform1f, (GLint location, GLfloat x))                                                \
    X(void, Uniform1i, (GLint location, GLint x))                                                  \
    X(void, Uniform2f, (GLint location, GLfloat x, GLfloat y))                                     \
    X(void, Uniform3f, (GLint location, GLfloat x, GLfloat y, GLfloat z))                          \
    X(void, Uniform4f, (GLint location, GLfloat x, GLfloat y, GLfloat z, GLfloat w))               \
    X(void, UniformMatrix4fv, (GLint location, GLsizei n, GLboolean transpose, const GLfloat *m))  \
    X(GLboolean, UnmapBuffer, (GLenum target))                                                     \
    X(void, UseProgram, (GLuint program))                                                          \
    X(void, VertexAttribPointer, (GLuint index, GLint size, GLenum type, GLboolean normalized,     \
                                  GLsizei stride, const void *offset))                             \
    X(void, Viewport, (GLint x, GLint y, GLsizei w, GLsizei h))

struct gl {
#define X(result, name, args) result(*name) args;
    GL_FUNCTIONS(X)
#undef X
};

/* Fills the table through getproc(state, "glName"); STATUS_BACKEND names what is missing. */
enum status gl_load(struct gl *gl, void *(*getproc)(void *state, const char *name), void *state,
                    struct error *e);

/* STATUS_BACKEND when GL recorded an error since the last check; `where` says during what. */
enum status gl_check(const struct gl *gl, const char *where, struct error *e);

/* Compiles and links; attributes are bound to 0, 1, ... in the order of the NULL-ended list. */
enum status gl_program(const struct gl *gl, GLuint *program, const char *name,
                       const char *vertex, const char *fragment, const char *const *attributes,
                       struct error *e);

#endif
