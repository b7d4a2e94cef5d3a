#version 330 core
// Lines and faces come projected: picture coordinates, 1 / distance, and the pixels from the line.
in vec4 vertex;  // x, y in -1..1; 1 / distance; signed pixels across the line

out float across;
out float inverse_distance;

void main()
{
    across = vertex.w;
    inverse_distance = vertex.z;
    gl_Position = vec4(vertex.xy, 0.0, 1.0); // w = 1: interpolation is linear in the picture
}
