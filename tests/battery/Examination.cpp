#include "Examination.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/reference/PlaneQ.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

using namespace battery;
using osgWaterReflect::Search;
namespace reference = osgWaterReflect::reference;

namespace
{

// Rays beside one, at each distance, that are asked whether all are decided as it is; and, where
// all at every distance are, at each once more, unless of so many rays that something is wrong.
const int RAYS_BESIDE = 32;
const int MANY_RAYS_BESIDE = 4096;
const std::size_t FEW_RAYS = 8;

// Hits closer than this are of one place [pixels], and on one ray [windowZ].
const double SAME_PIXEL = 0.5;
const double SAME_WINDOW_Z = 1e-4;

// [pixels] From this on a ray is not said to run along the line of sight, where half a pixel may be
// all of its depth.
const double LONG_RAY = 16.0;

// As in ray.glsl.
const int REASON_SKY = 1;
const int LAST_REASON = 7;

double columnsOf(const RayAnswer& ray)
{
    const glm::dvec2 extent = glm::abs(glm::dvec2(ray.end - ray.start));
    return std::max(extent.x, extent.y);
}

// Change of windowZ along a ray, from column to column.
double windowZPerColumn(const RayAnswer& ray)
{
    return std::abs(ray.end.z - ray.start.z) / std::max(columnsOf(ray), 1.0);
}

// How much of a difference in windowZ the way between two hits along a ray does not account for.
double windowZApart(const RayAnswer& a, const RayAnswer& b)
{
    const glm::dvec3 apart = glm::abs(a.window - b.window);
    return std::max(apart.z - std::max(apart.x, apart.y) * windowZPerColumn(b), 0.0);
}

// How far a hit is off a ray in windowZ, at the column that it was found in.
double windowZOff(const RayAnswer& hit, const RayAnswer& ray)
{
    const glm::dvec3 extent = ray.end - ray.start;
    const int along = std::abs(extent.x) >= std::abs(extent.y) ? 0 : 1;
    const double s = (hit.window[along] - ray.start[along]) / extent[along];
    return std::abs(hit.window.z - (ray.start.z + s * extent.z));
}

bool decidedAlike(const RayAnswer& a, const RayAnswer& b)
{
    if (a.reason != b.reason) return false;
    if (a.reason == REASON_SKY) return glm::distance(a.skyWindow, b.skyWindow) < SAME_PIXEL;
    return !a.isHit() || (glm::distance(glm::dvec2(a.window), glm::dvec2(b.window)) < SAME_PIXEL &&
                          windowZApart(a, b) < SAME_WINDOW_Z + SAME_PIXEL * windowZPerColumn(b));
}

bool hasReason(const RayAnswer& answer)
{
    return answer.reason >= 0 && answer.reason <= LAST_REASON && answer.s >= 0.0 && answer.s <= 1.0;
}

// Fetches that a search may make at most.
int longest(Search search, const RayImage& image, const RayAnswer& answer)
{
    const glm::dvec2 extent = glm::abs(glm::dvec2(answer.end - answer.start));
    const double columns = std::max(extent.x, extent.y) + 3.0;
    const int about = 6; // a hit, and what is looked at beside it
    if (search == Search::BINARY) return static_cast<int>(std::log2(columns)) + about;
    // Each place once, and where one is met what was seen before it; a cell before each.
    const double each = search == Search::HIERARCHICAL ? 3.0 : 2.0;
    return static_cast<int>(
               each * std::ceil(columns / (search == Search::HIERARCHICAL ? 1.0 : image.stride))) +
           about;
}

double inverseDepthOf(const RayAnswer& hit)
{
    return glm::mix(hit.inverseDepth.x, hit.inverseDepth.y, hit.s);
}

// Depth behind a surface that still counts as inside it [windowZ], as docs/how-it-works.md has it;
// the greatest within a number of columns from a hit.
double thicknessAbout(const RayImage& image, const RayAnswer& hit, double columns)
{
    const double reach = columns / std::max(columnsOf(hit), 1.0);
    const auto inverseDepthAt = [&](double s)
    { return glm::mix(hit.inverseDepth.x, hit.inverseDepth.y, glm::clamp(s, 0.0, 1.0)); };
    const double inverseDepth =
        std::max(inverseDepthAt(hit.s - reach), inverseDepthAt(hit.s + reach));
    const glm::dvec2 scale = image.depthScale();
    const double given = scale.x * image.thickness * inverseDepth * inverseDepth /
                             (1.0 + image.thickness * inverseDepth) +
                         scale.y * image.thickness;
    const double steep = 4.0 * image.pixelExtent() * (scale.x * inverseDepth + scale.y);
    return std::max(given, steep) + 2.0 * STEP;
}

// Whether a hit lies on what the image shows about it, or inside: no farther off than a surface is
// followed on, at the slope that it has there, by two steps from the column that it was reached at
// or from the next.
bool hitsSomething(const RayImage& image, const RayAnswer& hit)
{
    const glm::ivec2 pixel(hit.window);
    const int reach = 1 + 3 * static_cast<int>(image.stride);
    double nearest = 2.0;
    double farthest = -1.0;
    for (int y = std::max(pixel.y - reach, 0); y <= std::min(pixel.y + reach, image.size.y - 1);
         ++y)
        for (int x = std::max(pixel.x - reach, 0); x <= std::min(pixel.x + reach, image.size.x - 1);
             ++x)
        {
            const double windowZ = image.windowZ[std::size_t(y) * image.size.x + x];
            if (windowZ >= 1.0) continue;
            nearest = std::min(nearest, windowZ);
            farthest = std::max(farthest, windowZ);
        }
    const double slack = farthest - nearest + (reach + 1) * windowZPerColumn(hit) + STEP;
    return nearest < 1.0 && hit.window.z >= nearest - slack &&
           hit.window.z <= farthest + thicknessAbout(image, hit, reach + 1) + slack;
}

// How far a hit is off the ray, as the plane Q of the paper has it: laid through the eye and the
// column of the image that the hit was found in, whatever windowZ that shows.
glm::dvec2 offPlaneQ(const RayImage& image, const Ray& ray, const RayAnswer& hit)
{
    const reference::ImageGeometry geometry = {glm::inverse(osgWaterReflect::imageFromClip()) *
                                                   glm::dmat4(image.imageFromEye()),
                                               glm::dvec2(image.size)};
    const glm::dvec3 origin(ray.originEye);
    const glm::dvec3 dir(ray.dirEye);
    const glm::dvec3 extent = glm::abs(hit.end - hit.start);
    const auto lines =
        extent.x >= extent.y ? reference::ImageLines::COLUMNS : reference::ImageLines::ROWS;
    const int along = static_cast<int>(lines);
    const double line = hit.window[along];
    const double crossing = reference::crossingOnLine(geometry, origin, dir, lines, line);
    const reference::PlaneQ q =
        reference::planeOnLine(geometry, lines, line, crossing, glm::dvec2(0.25, 0.5));
    const glm::dvec3 window = geometry.windowFromEye(origin + q.intersect(origin, dir) * dir);
    return {std::abs(window[1 - along] - hit.window[1 - along]), std::abs(window.z - hit.window.z)};
}

glm::vec3 someVector(std::mt19937_64& random)
{
    std::uniform_real_distribution<float> side(-1.0f, 1.0f);
    return {side(random), side(random), side(random)};
}

// What double precision may be off by [pixels]: at the hit's depth the ray's origin has few digits.
double roundingOf(const RayImage& image, const Ray& ray, const RayAnswer& hit)
{
    const double digitsLost = glm::length(glm::dvec3(ray.originEye)) * inverseDepthOf(hit);
    return 1e-7 + 1e-15 * digitsLost * std::max(image.size.x, image.size.y);
}

// At random, but the first two as no random ray would be, where the ray is so nearly: through the
// eye, and along axes of the image. These are decisions of their own.
Disturbance nudge(const RayImage& image, const Ray& ray, double steps, int number,
                  std::mt19937_64& random)
{
    const float by = static_cast<float>(steps * STEP);
    const glm::dvec3 dir(ray.dirEye);
    const glm::dvec3 sight = image.isOrthographic() ? glm::dvec3(0.0, 0.0, 1.0)
                                                    : glm::normalize(glm::dvec3(ray.originEye));
    const glm::dvec3 toSight = (glm::dot(dir, sight) < 0.0 ? -sight : sight) - dir;
    Disturbance disturbance;
    if (number == 0 && glm::length(toSight) < by)
    {
        disturbance.dirEye = glm::vec3(toSight);
        return disturbance;
    }
    if (number == 1)
    {
        disturbance.dirEye = -glm::mix(glm::vec3(0.0f), ray.dirEye,
                                       glm::lessThan(glm::abs(ray.dirEye), glm::vec3(by)));
        return disturbance;
    }
    const glm::vec3 window(image.size, 1.0f);
    return {by * ray.originEye * someVector(random), by * ray.dirEye * someVector(random),
            by * window * someVector(random), by * window * someVector(random)};
}

std::string describe(const RayImage& image, const Ray& ray, const RayAnswer& single,
                     const RayAnswer& reference)
{
    std::ostringstream text;
    text << std::setprecision(9) << image.name << ", " << image.size.x << " x " << image.size.y
         << ", thickness " << image.thickness << ", stride " << image.stride;
    const auto write = [&](const char* name, const auto& v)
    { text << ", " << name << " (" << v.x << ", " << v.y << ", " << v.z << ")"; };
    write("origin", ray.originEye);
    write("dir", ray.dirEye);
    for (const RayAnswer* answer : {&single, &reference})
    {
        text << (answer == &single ? "\n  single: " : "\n  double: ") << "reason " << answer->reason
             << ", s " << answer->s << ", fetches " << answer->fetches << ", length "
             << answer->rayLength << ", hidden " << answer->hidden << ", end sees " << answer->endZ
             << ", 1/depth " << answer->inverseDepth.x << " " << answer->inverseDepth.y << ", sky "
             << answer->skyWindow.x << " " << answer->skyWindow.y;
        write("window", answer->window);
        write("start", answer->start);
        write("end", answer->end);
    }
    return text.str();
}

} // namespace

void Examination::add(const Examination& rhs)
{
    rays += rhs.rays;
    hits += rhs.hits;
    fetches += rhs.fetches;
    fetchesInDouble += rhs.fetchesInDouble;
    notFinite += rhs.notFinite;
    readOutside += rhs.readOutside;
    withoutReason += rhs.withoutReason;
    tooLong += rhs.tooLong;
    hitNothing += rhs.hitNothing;
    offTheRay += rhs.offTheRay;
    wrong += rhs.wrong;
    for (std::size_t i = 0; i < beside.size(); ++i)
        beside[i] += rhs.beside[i];
    windowZOff.insert(windowZOff.end(), rhs.windowZOff.begin(), rhs.windowZOff.end());
    worstPixels = std::max(worstPixels, rhs.worstPixels);
    offPlaneQPixels = std::max(offPlaneQPixels, rhs.offPlaneQPixels);
    faults.insert(rhs.faults.begin(), rhs.faults.end());
    if (firstWrong.empty()) firstWrong = rhs.firstWrong;
}

Examiner::Examiner(Search search) :
    _search(search), _single(search, Precision::SINGLE), _double(search, Precision::DOUBLE)
{
}

Examination Examiner::examine(const RayImage& image, const std::vector<Ray>& rays)
{
    const std::vector<RayAnswer> answers = _single.run(image, rays);
    const std::vector<RayAnswer> references = _double.run(image, rays);
    Examination result;
    std::vector<std::size_t> apart;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
        const RayAnswer& answer = answers[i];
        const RayAnswer& reference = references[i];
        const auto forbid = [&](bool fault, std::int64_t& count, const char* name)
        {
            if (!fault) return;
            ++count;
            result.faults.emplace(name, describe(image, rays[i], answer, reference));
        };
        ++result.rays;
        result.hits += answer.isHit();
        forbid(!answer.finite, result.notFinite, "not finite");
        forbid(answer.readsOutside > 0, result.readOutside, "read outside");
        forbid(!hasReason(answer), result.withoutReason, "without a reason");
        forbid(answer.fetches > longest(_search, image, answer), result.tooLong, "too long");
        forbid(answer.isHit() && !hitsSomething(image, answer), result.hitNothing, "hit nothing");
        const bool atInfinity = inverseDepthOf(reference) < 1e-12 * reference.inverseDepth.x;
        if (reference.isHit() && columnsOf(reference) > 1.0 && !atInfinity)
        {
            const glm::dvec2 off = offPlaneQ(image, rays[i], reference);
            result.offPlaneQPixels = std::max(result.offPlaneQPixels, off.x);
            const double mayBeOff = roundingOf(image, rays[i], reference);
            forbid(!(off.x < mayBeOff && off.y < STEP + mayBeOff * windowZPerColumn(reference)),
                   result.offTheRay, "off the ray");
        }
        if (!decidedAlike(answer, reference))
        {
            apart.push_back(i);
            continue;
        }
        result.fetches += answer.fetches;
        result.fetchesInDouble += reference.fetches;
        if (!answer.isHit()) continue;
        if (columnsOf(reference) > LONG_RAY)
            result.windowZOff.push_back(windowZOff(answer, reference) / STEP);
        result.worstPixels =
            std::max(result.worstPixels,
                     glm::distance(glm::dvec2(answer.window), glm::dvec2(reference.window)));
    }

    for (const int number : {RAYS_BESIDE, MANY_RAYS_BESIDE})
    {
        if (number == MANY_RAYS_BESIDE && apart.size() > FEW_RAYS) break;
        for (std::size_t step = 0; step < NUDGES.size() && !apart.empty(); ++step)
        {
            const std::size_t before = apart.size();
            apart = alikeBeside(image, rays, answers, references, apart, NUDGES[step], number);
            result.beside[step] += before - apart.size();
        }
    }
    result.wrong = apart.size();
    if (!apart.empty())
        result.firstWrong =
            describe(image, rays[apart[0]], answers[apart[0]], references[apart[0]]);
    return result;
}

std::vector<std::size_t> Examiner::alikeBeside(const RayImage& image, const std::vector<Ray>& rays,
                                               const std::vector<RayAnswer>& answers,
                                               const std::vector<RayAnswer>& references,
                                               const std::vector<std::size_t>& asked, double steps,
                                               int number)
{
    std::vector<Ray> copies;
    std::vector<Disturbance> nudges;
    for (const std::size_t i : asked)
        for (int j = 0; j < number; ++j)
        {
            copies.push_back(rays[i]);
            nudges.push_back(nudge(image, rays[i], steps, j, _random));
        }
    const std::vector<RayAnswer> besides = _double.run(image, copies, nudges);
    std::vector<std::size_t> alike;
    for (std::size_t k = 0; k < asked.size(); ++k)
    {
        const auto first = besides.begin() + k * number;
        const std::size_t i = asked[k];
        if (std::all_of(first, first + number,
                        [&](const RayAnswer& beside) {
                            return decidedAlike(beside, references[i]) &&
                                   !decidedAlike(beside, answers[i]);
                        }))
            alike.push_back(i);
    }
    return alike;
}
