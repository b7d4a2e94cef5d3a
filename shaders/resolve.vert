#version 330 core
// One triangle that covers the picture, made from the vertex number.
void main()
{
    gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);
}
