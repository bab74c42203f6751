// The bindings of the water's program: what the C++ side sets and what the stages hand on. What only
// a piece in a slot asks for is declared there.
// The library's prefix is written in pieces, here and in shaders/Bindings.h only; all other pieces use the
// short names below, which rename whatever else is called so: they are no words for a local.
#pragma import_defines(OSGWR_IMAGES, OSGWR_OUTPUT, OSGWR_TRACE)

// The axes of variation, one enumerated define each.
#define IMAGES_ONE 1
#define IMAGES_TWO 2
#define OUTPUT_WATER 1
#define OUTPUT_REASON 2
#define OUTPUT_REFLECTION 3
#define OUTPUT_POINT 4
#define OUTPUT_NORMAL 5
#define OUTPUT_HIT 6
#define TRACE_HERE 1
#define TRACE_SAMPLED 2

// A capture: an image of the scene without water, and the matrix it was taken with.
struct Capture
{
    sampler2D colour;     // the frame's colour, any format
    sampler2D windowZ;    // in [0, 1]; 1 where nothing was drawn
    sampler2D cells;      // its nearest depths in cells (images/DepthCells.h)
    sampler2D sky;        // what it shows of the sky, above things (images/SkyImage.h)
    vec2 size;            // [pixels]
    mat4 imageFromEye;    // from the view's eye space, wherever the capture's own eye is, to clip w
                          // times (x, y, 1 - windowZ, 1): from the far plane windowZ keeps its digits
    vec2 depthScale;      // (|C_zw|, |C_zz|) / 2 of its own projection; the one not in use is 0
    float pixelExtent;    // side of a pixel: at unit depth in perspective, else itself
    bool mirrored;        // taken from the eye mirrored in the water, which sees the world upside
                          // down: the pixel that a ray starts in shows what it may meet, not what
                          // lies under the water
};
uniform Capture osgwr_eyeCapture;
uniform Capture osgwr_mirrorCapture;     // with IMAGES_TWO
#define eyeCapture osgwr_eyeCapture
#define mirrorCapture osgwr_mirrorCapture

// The frame as drawn so far, and how it becomes a capture (capture/FrameCopy.h).
uniform sampler2D osgwr_frameColour;
uniform sampler2D osgwr_frameWindowZ;
uniform vec4 osgwr_frameFromCapture;     // [pixels] the frame's are xy + zw times the capture's
uniform vec2 osgwr_captureFarGap;        // 1 - windowZ in the capture is x + y (1 - windowZ in the frame)
#define frameColour osgwr_frameColour
#define frameWindowZ osgwr_frameWindowZ
#define frameFromCapture osgwr_frameFromCapture
#define captureFarGap osgwr_captureFarGap

// A capture's cells, and what the passes read that compute them (images/DepthCells.h).
#define CELL 4          // [pixels] side of the smallest cells
#define CELLS_MERGED 8  // side of a larger cell, in cells of the level below
uniform sampler2D osgwr_pyramidSource;
uniform vec2 osgwr_pyramidSourceSize;    // [texels] of its lower left part that is in use
uniform sampler2D osgwr_pyramidMiddle;
uniform sampler2D osgwr_pyramidLarge;
#define pyramidSource osgwr_pyramidSource
#define pyramidSourceSize osgwr_pyramidSourceSize
#define pyramidMiddle osgwr_pyramidMiddle
#define pyramidLarge osgwr_pyramidLarge

// A capture whose sky is looked for, and the way up in it: the clip x, y and w of that direction.
#define SKY_BLOCK 16.0  // [pixels] side of what a texel of the sky stands for
uniform sampler2D osgwr_skySourceColour;
uniform sampler2D osgwr_skySourceWindowZ;
uniform vec2 osgwr_skySourceSize;        // [texels] of their lower left part that is in use
uniform vec3 osgwr_skyUp;
#define skySourceColour osgwr_skySourceColour
#define skySourceWindowZ osgwr_skySourceWindowZ
#define skySourceSize osgwr_skySourceSize
#define skyUp osgwr_skyUp

// What straightens the depths of a capture that an oblique plane cuts off (capture/MirroredEye.h).
uniform sampler2D osgwr_obliqueWindowZ;
uniform vec4 osgwr_windowZFromOblique;   // times (x, y [pixels], oblique windowZ, 1)
#define obliqueWindowZ osgwr_obliqueWindowZ
#define windowZFromOblique osgwr_windowZFromOblique

// The rays traced in an image smaller than the view (water/LowResTrace.h), with TRACE_SAMPLED.
uniform sampler2D osgwr_tracedRays;      // each texel a TracedRay, coded (trace_texel.glsl)
uniform vec4 osgwr_tracedFromWindow;     // its texels = xy * gl_FragCoord.xy + zw
uniform float osgwr_sheetNumber;         // tells the view's sheets of water apart, from 1
#define tracedRays osgwr_tracedRays
#define tracedFromWindow osgwr_tracedFromWindow
#define sheetNumber osgwr_sheetNumber

// The view.
uniform vec4 osgwr_eyePointEye;          // centre of projection, homogeneous: (0, 0, 0, 1) or (direction, 0)
#define eyePointEye osgwr_eyePointEye

// The water.
uniform mat3 osgwr_normalEyeFromSurface; // inverse transpose, so that normals stay normals
uniform mat4 osgwr_surfaceFromEye;       // to the wave model's plane coordinates and the height over the still water
uniform float osgwr_eyeSide;             // +1: the eye is above the water; -1: below
uniform float osgwr_waterRefractiveIndex; // n(water) / n(air)
uniform float osgwr_hitThickness;        // [world units] how far behind a surface still counts as inside it
#define normalEyeFromSurface osgwr_normalEyeFromSurface
#define surfaceFromEye osgwr_surfaceFromEye
#define eyeSide osgwr_eyeSide
#define waterRefractiveIndex osgwr_waterRefractiveIndex
#define hitThickness osgwr_hitThickness

// From the vertex to the fragment stage.
varying vec3 osgwr_pointEye;             // the displaced water point
varying vec2 osgwr_placeSurface;         // its place in the wave model's plane coordinates [m]
#define pointEye osgwr_pointEye
#define placeSurface osgwr_placeSurface
