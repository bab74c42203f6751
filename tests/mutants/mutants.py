"""The faults that run.py tries: at least one for each hard case of docs/stability.md."""

from dataclasses import dataclass

SHADERS = "osgWaterReflect/shaders/"
RAYS = ("test_battery", "every ray ends*")


@dataclass
class Mutant:
    row: int      # of the table of hard cases
    fault: str    # in words
    file: str
    was: str      # once in the file
    becomes: str
    program: str
    test: str     # a Catch2 filter


def shader(row, fault, file, was, becomes, test=RAYS):
    return Mutant(row, fault, SHADERS + file, was, becomes, *test)


def gpu(name):
    return ("test_gpu", name)


def unit(name):
    return ("test_unit", name)


def cpp(row, fault, file, was, becomes, test):
    return Mutant(row, fault, "osgWaterReflect/" + file, was, becomes, *test)


MUTANTS = [
    shader(1, "pixels a column are inverted though they may be 0", "search/search_hierarchical.glsl",
           "vec2 moved = mix(perColumn.xy, vec2(1e-6), lessThan(abs(perColumn.xy), vec2(1e-6)));",
           "vec2 moved = perColumn.xy;"),
    shader(1, "a bound that the ray runs along counts as left", "shared/ray.glsl",
           "if (slope >= 0.0)", "if (slope > 0.0)"),
    shader(2, "a ray that stays in one place is divided by its length", "search/search.glsl",
           "float length = max(abs(signedLength), 0.01);", "float length = abs(signedLength);"),
    shader(3, "the near plane bounds nothing", "shared/ray.glsl",
           "    clipRay(1.0 - origin.z, -slope.z, REASON_TOWARD_EYE, uFirst, inverseLast, endReason);\n",
           ""),
    shader(4, "the far plane bounds nothing", "shared/ray.glsl",
           "    clipRay(origin.z, slope.z, REASON_SKY, uFirst, inverseLast, endReason);\n", ""),
    shader(4, "a ray goes on beyond infinity", "shared/ray.glsl",
           "float inverseLast = max(b.w, 1e-30);", "float inverseLast = 1e-30;"),
    shader(5, "a ray may meet what lies under its own pixel", "search/search.glsl",
           "if (startsAtWater && ownAhead && length > 1.0 && !capture.mirrored) toCentre += 1.0;", ""),
    shader(6, "a ray ends after a distance", "shared/ray.glsl",
           "float inverseLast = max(b.w, 1e-30);", "float inverseLast = max(b.w, 0.2);"),
    shader(7, "a ray that a wave sends down goes down", "shared/reflected_ray.glsl",
           "return reflected - 2.0 * min(dot(reflected, still), 0.0) * still;", "return reflected;",
           gpu("a ray that a wave sends down*")),
    shader(8, "whatever the ray is behind is hit", "search/search.glsl",
           "meeting.hit = behind <= (meeting.jump > meeting.thick ? edge + stepZ\n"
           "                                                          : meeting.thick + 0.5 * stepZ);",
           "meeting.hit = true;", gpu("what hangs in front of the water*")),
    shader(9, "the ray's own advance is forgotten", "search/search.glsl",
           ": meeting.thick + 0.5 * stepZ);", ": meeting.thick);"),
    shader(10, "the binary search takes what hides a ray for a hit", "search/search_binary.glsl",
           "bool hit = found && behind <= thick + step * abs(extent.z);", "bool hit = found;"),
    shader(10, "what a ray ends in front of is found by the binary search", "search/search_binary.glsl",
           "bool found = behind >= 0.0 && surfaceBehind < 1.0;", "bool found = surfaceBehind < 1.0;"),
    shader(11, "a ray behind something looks at each column", "search/search_hierarchical.glsl",
           "bool staysBehind = !trail.inFront && cell.a < 1.0 && leastZ >= cell.a;",
           "bool staysBehind = false;"),
    shader(12, "windowZ is some steps of single precision too small", "shared/ray.glsl",
           "1.0 - image.z);", "0.999999 - image.z);"),
    shader(13, "a cell takes in a column of the next", "search/search_hierarchical.glsl",
           "+ 0.999), 1.0);", "+ 1.999), 1.0);"),
    shader(13, "the pixel beside is rounded to the one after it", "search/search.glsl",
           "clamp(floor(window) + beside + 0.5, vec2(0.5)", "clamp(window + beside, vec2(0.5)",
           ("test_battery", "the full battery*")),
    shader(14, "a cell leaves out its last row", "passes/pyramid_cells.frag",
           "for (int y = 0; y < CELL; ++y)", "for (int y = 0; y < CELL - 1; ++y)",
           gpu("a pyramid bounds*")),
    shader(14, "a larger cell leaves out its last column", "passes/pyramid_merge.frag",
           "for (int x = 0; x < CELLS_MERGED; ++x)", "for (int x = 0; x < CELLS_MERGED - 1; ++x)",
           gpu("a pyramid bounds*")),
    shader(15, "a length is divided by the depth of what is at infinity", "shared/ray.glsl",
           "max(mix(ray.inverseDepth.x, ray.inverseDepth.y, s), 1e-30);",
           "mix(ray.inverseDepth.x, ray.inverseDepth.y, s);"),
    shader(16, "a thickness may be less than a depth buffer's step", "search/search.glsl",
           "return max(given, pixelsWindowZ(capture, STEEPEST_SLOPE, inverseDepth)) + 1.2e-7;",
           "return given;"),
    shader(17, "background can be hit", "search/search.glsl",
           "trail.at.behind + trail.lookAheadZ >= 0.0 && surfaceZ < 1.0;",
           "trail.at.behind + trail.lookAheadZ >= 0.0;"),
    shader(18, "rounding may lead out of the image", "shared/ray.glsl",
           "return clamp(window, vec3(vec2(BORDER_WIDTH), 0.0), vec3(capture.size - BORDER_WIDTH, 1.0));",
           "return window;"),
    shader(19, "columns are looked at on their borders", "search/search.glsl",
           "(floor(start) + 0.5 - start)", "(floor(start) - start)"),
    shader(20, "a search gives up after 64 columns", "search/search.glsl",
           "columns.count = int(max(length - toCentre, 0.0) / pixelsPerStep) + 2;",
           "columns.count = min(int(max(length - toCentre, 0.0) / pixelsPerStep) + 2, 64);"),
    shader(21, "NaN and infinity of the scene's colours are read as they are", "shared/sky.glsl",
           "vec3 finiteColour(vec3 colour)\n{\n", "vec3 finiteColour(vec3 colour)\n{\n    return colour;\n",
           gpu("NaN and infinity*")),
    shader(22, "a piece samples with an implicit level of detail", "shared/reflection.glsl",
           "return finiteColour(textureLod(capture.colour, uv, 0.0).rgb);",
           "return finiteColour(texture(capture.colour, uv).rgb);", unit("no piece samples*")),
    cpp(23, "a place far away is multiplied in single precision", "waves/TrochoidalState.cpp",
        "std::fmod(number * (direction * place), TURN)",
        "std::fmod(static_cast<float>(number * (direction * place)), TURN)",
        gpu("far from the origin and very late*")),
    cpp(24, "a late time is multiplied in single precision", "waves/TrochoidalState.cpp",
        "std::fmod(frequency * time, TURN)", "std::fmod(static_cast<float>(frequency * time), TURN)",
        gpu("waves come back after whole periods")),
    cpp(25, "normals turn as points do", "Transforms.h",
        "return glm::transpose(glm::inverse(glm::dmat3(m)));", "return glm::dmat3(m);",
        gpu("unevenly scaled water*")),
    cpp(26, "every view is taken for a perspective one", "Transforms.h",
        "if (!orthographic) return glm::dvec4(0.0, 0.0, 0.0, 1.0);",
        "return glm::dvec4(0.0, 0.0, 0.0, 1.0);", gpu("calm water shows what the mirrored eye sees")),
    cpp(27, "an empty view is served", "view/ViewRecord.cpp",
        "if (!camera || !viewport || viewport->width() < 1.0 || viewport->height() < 1.0) return false;",
        "if (!camera || !viewport) return false;", gpu("an empty viewport*")),
    cpp(27, "what is traced in a smaller image keeps the state of sheets that are gone",
        "water/LowResTrace.cpp", "_stateGraph->reset();", "_stateGraph->clean();",
        gpu("water traced in a smaller image*")),
    cpp(28, "any number is taken as a setting", "settings/MemberChecks.h",
        "return range.contains(value) ||", "return true ||", unit("of random settings*")),
    shader(27, "a colour is divided by a sum of weights that may be 0", "shared/reflection.glsl",
           "return sum.a > 0.0 ? sum.rgb / sum.a : closest;", "return sum.rgb / sum.a;",
           gpu("frames under abuse*")),
    shader(29, "water is as dense as air from below", "shared/shade.glsl",
           "float eta = eyeSide > 0.0 ? waterRefractiveIndex : 1.0 / waterRefractiveIndex;",
           "float eta = waterRefractiveIndex;", gpu("an eye under the water sees*")),
    cpp(30, "waves may fold over", "TrochoidalWaves.cpp",
        "if (!(steepness < 1.0))\n        return refuse", "if (!(steepness < 2.0))\n        return refuse",
        unit("waves of any value*")),
    shader(31, "what is under the water is met through a crest", "shared/sighting.glsl",
           "            sighting.result.reason = REASON_BELOW_WATER;", "            sighting.result.s += 0.0;",
           gpu("what stands under the water*")),
    cpp(32, "whether a band serves is asked of what is given up for time", "view/ViewPlan.cpp",
        "beforeSaving.add(settled(i), rays);", "beforeSaving.add(settings, rays);",
        unit("what is given up for time*")),
    cpp(32, "a band that is closed is said to serve", "band/GuardBandRequest.cpp",
        "return reaches(band(scene, viewSize), needed(rays, scene), viewSize);",
        "return _maxExtraPixels == 0.0 ||\n           reaches(band(scene, viewSize), needed(rays, scene), viewSize);",
        unit("no band, a closed one*")),
    cpp(32, "the first water's scale is all waters'", "view/ViewPlan.cpp",
        "            scale = std::max(scale, sheet.settings.captureScale);",
        "            scale = scale > 0.0 ? scale : sheet.settings.captureScale;",
        unit("the largest scale wins*")),
    cpp(32, "the frame of another view is copied", "view/ViewPlan.cpp",
        "return _facts.nested ? EyeImage::DRAWN : EyeImage::COPIED;", "return EyeImage::COPIED;",
        unit("a nested view draws its image*")),
    cpp(32, "every plane is mirrored anew", "view/ViewPlan.cpp",
        "{ return serveTogether(other.eye, eye); });", "{ return &other.eye == &eye; });",
        gpu("each plane of water has one mirrored capture*")),
    cpp(33, "a band reaches one pixel less than it should", "band/GuardBand.cpp",
        "return glm::max(glm::ceil(0.5 * beyond * sizes - ROUNDING), 0.0);",
        "return glm::max(glm::ceil(0.5 * beyond * sizes - ROUNDING) - 1.0, 0.0);",
        unit("a band has the pixels*")),
    cpp(33, "the steepest waves lean as the others do", "band/ReflectedExtent.cpp",
        "const double slope = maxSlope / std::pow(std::cos(0.5 * step), 2.0);",
        "const double slope = 0.9 * maxSlope;", unit("no reflected ray leaves*")),
    cpp(33, "a sphere around a leaf is half as large", "capture/SeenPyramid.cpp",
        "radius = radiusLocal * std::sqrt(squaredStretch) * (1.0 + 1e-6);",
        "radius = 0.5 * radiusLocal * std::sqrt(squaredStretch);",
        gpu("a copied frame is reflected*")),
    cpp(34, "captures go with the frame that has no use for them", "view/WaterView.cpp",
        "if (held.released || now - held.lastUsed <= HOLD_TIME) return;",
        "if (held.released || now == held.lastUsed) return;",
        gpu("a choice that comes and goes*")),
    cpp(34, "captures are never let go", "view/WaterView.cpp",
        "if (held.released || now - held.lastUsed <= HOLD_TIME) return;",
        "return;", gpu("a choice that comes and goes*")),
    cpp(34, "one view is made for all nested cameras", "capture/CulledView.cpp",
        "if (hasMatricesOfItsOwn(*camera)) return *camera;", "if (false) return *camera;",
        gpu("water below a nested camera reflects*")),
    cpp(35, "a mesh is kept though its waves have grown", "surface/WaveMesh.cpp",
        "return a.amplitude == b.amplitude && a.shortestEdge == b.shortestEdge &&",
        "return a.shortestEdge == b.shortestEdge &&", unit("the mesh is divided anew*")),
    cpp(35, "the frame's depths are not carried over", "Transforms.h",
        "return glm::dvec2(0.5 * (1.0 - ndcZOfMiddle - slope), slope);",
        "return glm::dvec2(0.0, 1.0);", gpu("a copied frame is reflected*")),
    cpp(36, "each view makes its own waves", "dynamics/WaterDynamics.cpp",
        "if (!_waves || (_state && _frameNumber == number && _time == time)) return _state;",
        "if (!_waves) return _state;", gpu("waves advance once*")),
    cpp(36, "waves wait for the first cull", "WaterSurface.cpp",
        "if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR)", "if (false)",
        gpu("waves advance once*")),
]
