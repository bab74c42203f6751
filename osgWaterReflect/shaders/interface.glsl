// Every binding of the water's program: what the C++ side sets and what the stages hand on.
// The library's prefix is written here and in trace/Bindings.h only; all other pieces use the
// short names below.
#pragma import_defines(OSGWR_SEARCH, OSGWR_IMAGES, OSGWR_SKY, OSGWR_OUTPUT, OSGWR_TRACE)

// The axes of variation, one enumerated define each.
#define SEARCH_SEQUENTIAL 1
#define SEARCH_BINARY 2
#define SEARCH_HIERARCHICAL 3
#define IMAGES_ONE 1
#define IMAGES_TWO 2
#define SKY_CAPTURED 1
#define SKY_CUBE_MAP 2
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
    sampler2D cells;      // its pyramid (pyramid/Pyramid.h)
    vec2 size;            // [pixels]
    mat4 imageFromEye;    // from the view's eye space, wherever the capture's own eye is, to clip w
                          // times (x, y, 1 - windowZ, 1): from the far plane windowZ keeps its digits
    vec2 depthScale;      // (|C_zw|, |C_zz|) / 2 of its own projection; the one not in use is 0
    float pixelExtent;    // side of a pixel: at unit depth in perspective, else itself
    float firstColumn;    // 1 where a ray's own pixel shows what lies under the water: nothing to
                          // meet; 0 where it may be met there
};
uniform Capture osgwr_eyeCapture;
uniform Capture osgwr_mirrorCapture;     // with IMAGES_TWO
uniform vec3 osgwr_clearColour;
#define eyeCapture osgwr_eyeCapture
#define mirrorCapture osgwr_mirrorCapture
#define clearColour osgwr_clearColour

// The frame as drawn so far, and how it becomes a capture (capture/FrameCopy.h).
uniform sampler2D osgwr_frameColour;
uniform sampler2D osgwr_frameWindowZ;
uniform vec4 osgwr_frameFromCapture;     // [pixels] the frame's are xy + zw times the capture's
uniform vec2 osgwr_captureFarGap;        // 1 - windowZ in the capture is x + y (1 - windowZ in the frame)
#define frameColour osgwr_frameColour
#define frameWindowZ osgwr_frameWindowZ
#define frameFromCapture osgwr_frameFromCapture
#define captureFarGap osgwr_captureFarGap

// A capture's pyramid, and what the passes read that build it (pyramid/Pyramid.h).
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

// What straightens the depths of a capture that an oblique plane cuts off (capture/MirroredEye.h).
uniform sampler2D osgwr_obliqueWindowZ;
uniform vec4 osgwr_straightened;         // of (x, y [pixels], oblique windowZ, 1)
#define obliqueWindowZ osgwr_obliqueWindowZ
#define straightened osgwr_straightened

// What the rays of an image smaller than the view have found (trace/TracePass.h), with
// TRACE_SAMPLED.
uniform sampler2D osgwr_found;
uniform vec4 osgwr_foundFromWindow;      // its texels = xy * gl_FragCoord.xy + zw
uniform float osgwr_sheet;               // tells the view's sheets of water apart, from 1
#define foundTexels osgwr_found
#define foundFromWindow osgwr_foundFromWindow
#define sheet osgwr_sheet

// The view.
uniform vec4 osgwr_eyePointEye;          // centre of projection, homogeneous: (0, 0, 0, 1) or (direction, 0)
uniform mat3 osgwr_worldFromEye;         // rotation
#define eyePointEye osgwr_eyePointEye
#define worldFromEye osgwr_worldFromEye

// The water.
uniform mat3 osgwr_normalEyeFromSurface; // inverse transpose, so that normals stay normals
uniform mat4 osgwr_surfaceFromEye;       // to the wave model's plane coordinates and the height over the still water
uniform float osgwr_side;                // +1: the eye is above the water; -1: below
uniform float osgwr_refractiveIndex;     // n(water) / n(air)
uniform vec3 osgwr_waterColour;          // what the water sends back where it does not reflect
uniform float osgwr_thickness;           // [world units]
uniform float osgwr_stride;              // [pixels]
#define normalEyeFromSurface osgwr_normalEyeFromSurface
#define surfaceFromEye osgwr_surfaceFromEye
#define side osgwr_side
#define refractiveIndex osgwr_refractiveIndex
#define waterColour osgwr_waterColour
#define thickness osgwr_thickness
#define stride osgwr_stride

uniform samplerCube osgwr_sky;           // looked up with a direction in world space
#define skyCubeMap osgwr_sky

// Trochoidal waves.
#define MAX_WAVES 32
uniform vec4 osgwr_waves[MAX_WAVES];     // wave vector [rad/m], amplitude over wave number [m^2], phase now at place (0, 0) [rad]
uniform int osgwr_waveCount;
uniform int osgwr_waveIterations;        // Newton steps to the rest place
uniform float osgwr_waveReach;           // [m] sum of the amplitudes: no particle strays further
uniform float osgwr_waveRise;            // [m] lifts the mean height to 0
#define waves osgwr_waves
#define waveCount osgwr_waveCount
#define waveIterations osgwr_waveIterations
#define waveReach osgwr_waveReach
#define waveRise osgwr_waveRise

// From the vertex to the fragment stage.
varying vec3 osgwr_pointEye;             // the displaced water point
varying vec2 osgwr_place;                // its place in the wave model's plane coordinates [m]
#define pointEye osgwr_pointEye
#define place osgwr_place
