#include "Examination.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

using namespace battery;
using osgWaterReflect::Search;

namespace
{

// Rays beside one, at each distance, that are asked whether all are decided as it is.
const int RAYS_BESIDE = 32;

// Hits closer than this are of one place [pixels], and on one ray [windowZ].
const double SAME_PIXEL = 0.5;
const double SAME_WINDOW_Z = 1e-4;

// As in shaders/ray.glsl.
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

// Whether the image shows something about a hit: no farther off than a surface is followed on from
// the column that it was reached at, two steps.
bool hitsSomething(const RayImage& image, const RayAnswer& hit)
{
    const glm::ivec2 pixel(hit.window);
    const int reach = 1 + 2 * static_cast<int>(image.stride);
    for (int y = pixel.y - reach; y <= pixel.y + reach; ++y)
        for (int x = pixel.x - reach; x <= pixel.x + reach; ++x)
        {
            if (x < 0 || y < 0 || x >= image.size.x || y >= image.size.y) continue;
            if (image.windowZ[std::size_t(y) * image.size.x + x] < 1.0f) return true;
        }
    return false;
}

glm::vec3 someVector(std::mt19937_64& random)
{
    std::uniform_real_distribution<float> side(-1.0f, 1.0f);
    return {side(random), side(random), side(random)};
}

// At random, but of a ray nearly through the eye the first exactly so: that is a decision of its
// own, and no random ray would make it.
Disturbance nudge(const RayImage& image, const Ray& ray, double steps, bool isFirst,
                  std::mt19937_64& random)
{
    const float by = static_cast<float>(steps * STEP);
    const glm::dvec3 dir(ray.dirEye);
    const glm::dvec3 sight = image.isOrthographic() ? glm::dvec3(0.0, 0.0, 1.0)
                                                    : glm::normalize(glm::dvec3(ray.originEye));
    const glm::dvec3 toSight = (glm::dot(dir, sight) < 0.0 ? -sight : sight) - dir;
    if (isFirst && glm::length(toSight) < by)
        return {glm::vec3(0.0f), glm::vec3(toSight), glm::vec3(0.0f), glm::vec3(0.0f)};
    const glm::vec3 window(image.size, 1.0f);
    return {by * ray.originEye * someVector(random), by * ray.dirEye * someVector(random),
            by * window * someVector(random), by * window * someVector(random)};
}

std::string describe(const RayImage& image, const Ray& ray, const RayAnswer& single,
                     const RayAnswer& reference)
{
    std::ostringstream text;
    text << std::setprecision(9) << nameOf(image.shown) << ", " << nameOf(image.lens) << ", "
         << image.size.x << " x " << image.size.y << ", " << image.bits << " bits, thickness "
         << image.thickness << ", stride " << image.stride;
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
    wrong += rhs.wrong;
    for (std::size_t i = 0; i < beside.size(); ++i)
        beside[i] += rhs.beside[i];
    worstWindowZ = std::max(worstWindowZ, rhs.worstWindowZ);
    worstPixels = std::max(worstPixels, rhs.worstPixels);
    faults.insert(rhs.faults.begin(), rhs.faults.end());
    if (firstWrong.empty()) firstWrong = rhs.firstWrong;
}

Examiner::Examiner(Search search) :
    _search(search), _single(search, Precision::SINGLE), _double(search, Precision::DOUBLE)
{
}

Examination Examiner::examine(const RayImage& image, const std::vector<Ray>& rays,
                              std::mt19937_64& random)
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
        if (!decidedAlike(answer, reference))
        {
            apart.push_back(i);
            continue;
        }
        result.fetches += answer.fetches;
        result.fetchesInDouble += reference.fetches;
        if (!answer.isHit()) continue;
        if (columnsOf(reference) > 1.0)
            result.worstWindowZ =
                std::max(result.worstWindowZ, windowZApart(answer, reference) / STEP);
        result.worstPixels =
            std::max(result.worstPixels,
                     glm::distance(glm::dvec2(answer.window), glm::dvec2(reference.window)));
    }

    for (std::size_t step = 0; step < NUDGES.size() && !apart.empty(); ++step)
    {
        std::vector<Ray> asked;
        std::vector<Disturbance> nudges;
        for (const std::size_t i : apart)
            for (int j = 0; j < RAYS_BESIDE; ++j)
            {
                asked.push_back(rays[i]);
                nudges.push_back(nudge(image, rays[i], NUDGES[step], j == 0, random));
            }
        const std::vector<RayAnswer> besides = _double.run(image, asked, nudges);
        std::vector<std::size_t> left;
        for (std::size_t k = 0; k < apart.size(); ++k)
        {
            const auto first = besides.begin() + k * RAYS_BESIDE;
            const bool isBeside =
                std::any_of(first, first + RAYS_BESIDE,
                            [&](const RayAnswer& answer)
                            { return !decidedAlike(references[apart[k]], answer); });
            if (isBeside)
                ++result.beside[step];
            else
                left.push_back(apart[k]);
        }
        apart = left;
    }
    result.wrong = apart.size();
    if (!apart.empty())
        result.firstWrong =
            describe(image, rays[apart[0]], answers[apart[0]], references[apart[0]]);
    return result;
}
