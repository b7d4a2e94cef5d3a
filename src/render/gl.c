/* Loads GL functions and builds programs from shader text. */
#include "render/gl.h"

#include <string.h>

enum status gl_load(struct gl *gl, void *(*getproc)(void *state, const char *name), void *state,
                    struct error *e)
{
    void *address;
/* A function pointer comes as void *: copied, since C has no cast between the two. */
#define X(result, name, args)                                                                      \
    address = getproc(state, "gl" #name);                                                          \
    if (!address)                                                                                  \
        return error_set(e, STATUS_BACKEND, "the OpenGL library has no gl" #name                   \
                                            "; OpenGL 3.3 core is needed");                        \
    memcpy(&gl->name, &address, sizeof address);
    GL_FUNCTIONS(X)
#undef X
    return STATUS_OK;
}

enum status gl_check(const struct gl *gl, const char *where, struct error *e)
{
    GLenum first = gl->GetError();
    if (first == GL_NO_ERROR)
        return STATUS_OK;
    for (int i = 0; i < 16 && gl->GetError() != GL_NO_ERROR; i++)
        ; /* drain, bounded because a lost context reports for ever */
    if (first == GL_OUT_OF_MEMORY)
        return error_set(e, STATUS_BACKEND, "OpenGL is out of memory %s; use a smaller --size",
                         where);
    return error_set(e, STATUS_BACKEND, "OpenGL error 0x%04x %s", first, where);
}

static enum status shader_create(const struct gl *gl, GLuint *shader, GLenum type,
                                 const char *name, const char *text, struct error *e)
{
    GLint ok = 0;
    char log[1000] = "";
    *shader = gl->CreateShader(type);
    gl->ShaderSource(*shader, 1, &text, NULL);
    gl->CompileShader(*shader);
    gl->GetShaderiv(*shader, GL_COMPILE_STATUS, &ok);
    if (ok)
        return STATUS_OK;
    gl->GetShaderInfoLog(*shader, sizeof log, NULL, log);
    return error_set(e, STATUS_BACKEND, "%s shader of %s does not compile: %s",
                     type == GL_VERTEX_SHADER ? "vertex" : "fragment", name, log);
}

static enum status program_link(const struct gl *gl, GLuint program, const char *name,
                                struct error *e)
{
    GLint ok = 0;
    char log[1000] = "";
    gl->LinkProgram(program);
    gl->GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok)
        return STATUS_OK;
    gl->GetProgramInfoLog(program, sizeof log, NULL, log);
    return error_set(e, STATUS_BACKEND, "program %s does not link: %s", name, log);
}

enum status gl_program(const struct gl *gl, GLuint *program, const char *name,
                       const char *vertex, const char *fragment, const char *const *attributes,
                       struct error *e)
{
    GLuint vs = 0, fs = 0;
    enum status status = shader_create(gl, &vs, GL_VERTEX_SHADER, name, vertex, e);
    if (status == STATUS_OK)
        status = shader_create(gl, &fs, GL_FRAGMENT_SHADER, name, fragment, e);
    if (status == STATUS_OK) {
        *program = gl->CreateProgram();
        gl->AttachShader(*program, vs);
        gl->AttachShader(*program, fs);
        for (GLuint i = 0; attributes && attributes[i]; i++)
            gl->BindAttribLocation(*program, i, attributes[i]);
        status = program_link(gl, *program, name, e);
    }
    gl->DeleteShader(vs); /* freed with the program; 0 is ignored */
    gl->DeleteShader(fs);
    return status;
}
