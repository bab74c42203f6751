#version 130

// A triangle over the whole target.
void main()
{
    gl_Position = gl_Vertex;
}
