#include "ImageTracer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace osgWaterReflect::reference;

namespace
{

// The steepest surface that is still one from pixel to pixel, against the image plane.
const double STEEPEST_DEGREES = 76.0;

// [pixels] A ray whose image is shorter stays in one place: it runs toward the eye or away from it.
const double POINT_LENGTH = 1e-6;

// The part of a ray that the image can show.
struct Segment
{
    glm::dvec3 start; // window space
    glm::dvec3 end;
    glm::dvec2 t;     // at start and end
    glm::dvec2 clipW; // at start and end
    ImageReason endReason;

    // t / w and 1 / w are linear in the image.
    double tAt(double s) const
    {
        return glm::mix(t[0] / clipW[0], t[1] / clipW[1], s) /
               glm::mix(1.0 / clipW[0], 1.0 / clipW[1], s);
    }
    glm::dvec3 windowAt(double s) const { return glm::mix(start, end, s); }
};

// Where two bounds end the ray at once, the first in this list gives the reason.
Segment segmentOf(const ImageGeometry& image, const glm::dvec3& originEye, const glm::dvec3& dirEye)
{
    const glm::dvec4 a = image.clipFromEye * glm::dvec4(originEye, 1.0);
    const glm::dvec4 b = image.clipFromEye * glm::dvec4(dirEye, 0.0);
    // Between pixel centres only is there something to read.
    const glm::dvec2 border = 1.0 - 1.0 / image.size;
    const struct
    {
        double inside; // of the ray's origin: not negative within the bound
        double slope;  // per t
        ImageReason reason;
    } bounds[] = {
        {border.x * a.w + a.x, border.x * b.w + b.x, ImageReason::LEFT},
        {border.x * a.w - a.x, border.x * b.w - b.x, ImageReason::RIGHT},
        {border.y * a.w + a.y, border.y * b.w + b.y, ImageReason::BOTTOM},
        {border.y * a.w - a.y, border.y * b.w - b.y, ImageReason::TOP},
        {a.w + a.z, b.w + b.z, ImageReason::TOWARD_EYE},
        {a.w - a.z, b.w - b.z, ImageReason::SKY},
    };

    double first = 0.0;
    double last = std::numeric_limits<double>::infinity();
    ImageReason reason = ImageReason::SKY;
    for (const auto& bound : bounds)
    {
        const double t = -bound.inside / bound.slope;
        if (bound.slope > 0.0) first = std::max(first, t);
        if (bound.slope < 0.0 && t < last)
        {
            last = t;
            reason = bound.reason;
        }
    }
    // A ray that starts on a border (rounded: beyond it) and leads out ends where it starts.
    last = std::max(last, 0.0);
    first = std::min(first, last);

    const glm::dvec2 w(a.w + first * b.w, a.w + last * b.w);
    return {image.windowFromEye(originEye + first * dirEye),
            image.windowFromEye(originEye + last * dirEye), glm::dvec2(first, last), w, reason};
}

} // namespace

// One ray's way along its segment, from piece to piece of the surface that the image shows.
class ImageTracer::Walk
{
public:
    Walk(const ImageTracer& tracer, const Segment& segment) : _tracer(tracer), _segment(segment) {}

    // A place on the segment: of the ray, or of the surface.
    struct Place
    {
        double s;
        double windowZ;
    };

    // Passes a straight piece of surface, of which only the part within the segment counts.
    //   rayA, rayB          two places of the ray, between which it is straight
    //   surfaceA, surfaceB  the piece's ends
    // Returns whether the ray hits it.
    bool pass(const Place& rayA, const Place& rayB, const Place& surfaceA, const Place& surfaceB)
    {
        const double first = std::max(surfaceA.s, 0.0);
        const double last = std::min(surfaceB.s, 1.0);
        if (first >= last) return false;

        const double surfaceFirst = at(surfaceA, surfaceB, first);
        const double behindFirst = at(rayA, rayB, first) - surfaceFirst;
        const double behindLast = at(rayA, rayB, last) - at(surfaceA, surfaceB, last);
        if (behindFirst <= 0.0) _inFront = true;
        if (_inFront && behindFirst > 0.0)
        {
            const glm::dvec2 window(_segment.windowAt(first));
            const double depthBehind =
                _tracer.depthOf(glm::dvec3(window, surfaceFirst + behindFirst)) -
                _tracer.depthOf(glm::dvec3(window, surfaceFirst));
            _inFront = false;
            _s = first;
            _atEdge = depthBehind <= _tracer._thickness;
            return _atEdge;
        }
        if (_inFront && behindLast > 0.0)
        {
            _s = glm::mix(first, last, -behindFirst / (behindLast - behindFirst));
            return true;
        }
        _inFront = behindLast <= 0.0;
        return false;
    }

    // The same where nothing was drawn.
    void passBackground(double first, double last)
    {
        if (std::max(first, 0.0) < std::min(last, 1.0)) _inFront = true;
    }

    ImageHit result(bool hit) const
    {
        const bool behind = !hit && !_inFront;
        const double s = hit || behind ? _s : 1.0;
        const glm::dvec3 window = _segment.windowAt(s);
        return {hit      ? ImageReason::HIT
                : behind ? ImageReason::BEHIND
                         : _segment.endReason,
                glm::dvec2(window), window.z, _segment.tAt(s), hit && _atEdge};
    }

private:
    static double at(const Place& a, const Place& b, double s)
    {
        return glm::mix(a.windowZ, b.windowZ, (s - a.s) / (b.s - a.s));
    }

    const ImageTracer& _tracer;
    const Segment& _segment;
    bool _inFront = true;
    bool _atEdge = false;
    double _s = 0.0; // where the ray hit, or last went behind something
};

ImageTracer::ImageTracer(CapturedImage image, double thickness) :
    _image(std::move(image)), _thickness(thickness),
    _eyeFromClip(glm::inverse(_image.geometry.clipFromEye))
{
}

glm::dvec3 ImageTracer::eyeFromWindow(const glm::dvec3& window) const
{
    const glm::dvec3 ndc = window / glm::dvec3(_image.geometry.size, 1.0) * 2.0 - 1.0;
    const glm::dvec4 eye = _eyeFromClip * glm::dvec4(ndc, 1.0);
    return glm::dvec3(eye) / eye.w;
}

double ImageTracer::depthOf(const glm::dvec3& window) const
{
    return -eyeFromWindow(window).z;
}

ImageTracer::Shown ImageTracer::pixel(int x, int y) const
{
    const glm::ivec2 size(_image.geometry.size);
    x = std::clamp(x, 0, size.x - 1);
    y = std::clamp(y, 0, size.y - 1);
    const double windowZ = _image.windowZ[static_cast<std::size_t>(y) * size.x + x];
    return {windowZ, depthOf(glm::dvec3(x + 0.5, y + 0.5, windowZ))};
}

bool ImageTracer::belongTogether(const Shown& a, const Shown& b) const
{
    if (a.isBackground() || b.isBackground()) return false;
    const double jump = std::abs(a.depth - b.depth);
    if (jump <= _thickness) return true;
    // The side of a pixel at the nearer one, in the middle of the image.
    const glm::dvec3 place(0.5 * _image.geometry.size, std::min(a.windowZ, b.windowZ));
    const double side =
        glm::length(eyeFromWindow(place + glm::dvec3(1.0, 0.0, 0.0)) - eyeFromWindow(place));
    return jump <= side * std::tan(glm::radians(STEEPEST_DEGREES));
}

ImageTracer::Pair ImageTracer::pairOn(ImageLines lines, double line, double crossing) const
{
    // Pixel centres lie at halves.
    const int own = static_cast<int>(std::floor(line));
    const int first = static_cast<int>(std::floor(crossing - 0.5));
    if (lines == ImageLines::COLUMNS) return {pixel(own, first), pixel(own, first + 1)};
    return {pixel(first, own), pixel(first + 1, own)};
}

ImageTracer::Shown ImageTracer::between(const Pair& pair, ImageLines lines, double line,
                                        double crossing) const
{
    const double share = crossing - 0.5 - std::floor(crossing - 0.5);
    if (!belongTogether(pair.first, pair.second)) return share < 0.5 ? pair.first : pair.second;

    const double windowZ = glm::mix(pair.first.windowZ, pair.second.windowZ, share);
    return {windowZ, depthOf(lines == ImageLines::COLUMNS ? glm::dvec3(line, crossing, windowZ)
                                                          : glm::dvec3(crossing, line, windowZ))};
}

ImageHit ImageTracer::trace(const glm::dvec3& originEye, const glm::dvec3& dirEye) const
{
    const ImageGeometry& image = _image.geometry;
    const Segment segment = segmentOf(image, originEye, dirEye);
    const glm::dvec3 extent = segment.end - segment.start;
    const ImageLines lines =
        std::abs(extent.x) >= std::abs(extent.y) ? ImageLines::COLUMNS : ImageLines::ROWS;
    const int along = static_cast<int>(lines);

    Walk walk(*this, segment);
    const Walk::Place rayStart = {0.0, segment.start.z};
    const Walk::Place rayEnd = {1.0, segment.end.z};
    if (std::abs(extent[along]) < POINT_LENGTH)
    {
        const double line = std::floor(segment.start[along]) + 0.5;
        const double crossing = segment.start[1 - along];
        const Shown shown = between(pairOn(lines, line, crossing), lines, line, crossing);
        return walk.result(!shown.isBackground() &&
                           walk.pass(rayStart, rayEnd, {0.0, shown.windowZ}, {1.0, shown.windowZ}));
    }

    // From the last line (of pixel centres) not after the start to the first not before the end.
    const double sign = extent[along] > 0.0 ? 1.0 : -1.0;
    const double firstLine = sign * std::floor(sign * (segment.start[along] - 0.5)) + 0.5;
    const double lastLine = sign * std::ceil(sign * (segment.end[along] - 0.5)) + 0.5;
    const int count = static_cast<int>(std::lround(std::abs(lastLine - firstLine)));

    Walk::Place ray{};     // at the line before; where that is not on the segment, the start
    Walk::Place surface{}; // at the line before
    Shown shown{};
    for (int i = 0; i <= count; ++i)
    {
        const Walk::Place rayBefore = ray;
        const Walk::Place surfaceBefore = surface;
        const Shown shownBefore = shown;

        const double line = firstLine + i * sign;
        const double s = (line - segment.start[along]) / extent[along];
        const double crossing = crossingOnLine(image, originEye, dirEye, lines, line);
        const Pair pair = pairOn(lines, line, crossing);
        shown = between(pair, lines, line, crossing);
        surface = {s, shown.windowZ};
        if (s <= 0.0)
            ray = rayStart;
        else if (s >= 1.0)
            ray = rayEnd;
        else
        {
            const PlaneQ q = planeOnLine(image, lines, line, crossing,
                                         glm::dvec2(pair.first.windowZ, pair.second.windowZ));
            ray = {s, image.windowFromEye(originEye + q.intersect(originEye, dirEye) * dirEye).z};
        }
        if (i == 0) continue;

        if (belongTogether(shownBefore, shown))
        {
            if (walk.pass(rayBefore, ray, surfaceBefore, surface)) return walk.result(true);
            continue;
        }
        const double middle = 0.5 * (surfaceBefore.s + s);
        const struct
        {
            const Shown& shown;
            Walk::Place first;
            Walk::Place last;
        } halves[] = {{shownBefore, surfaceBefore, {middle, surfaceBefore.windowZ}},
                      {shown, {middle, surface.windowZ}, surface}};
        for (const auto& half : halves)
            if (half.shown.isBackground())
                walk.passBackground(half.first.s, half.last.s);
            else if (walk.pass(rayBefore, ray, half.first, half.last))
                return walk.result(true);
    }
    return walk.result(false);
}
