#version 330 core
// Lines and faces come projected, as src/render/mesh.h says.
in vec4 vertex;

out float across;
out float nearness; // 1 / distance, or the distance

void main()
{
    across = vertex.w;
    nearness = vertex.z;
    gl_Position = vec4(vertex.xy, 0.0, 1.0); // w = 1: interpolation is linear in the picture
}
