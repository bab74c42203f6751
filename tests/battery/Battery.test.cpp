// Rays by the hundred thousand on the very functions that draw: what must hold for each of them,
// and how far single precision leads astray.

#include "../support/Catch.h"
#include "Examination.h"
#include "RecordedView.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>

using namespace battery;
using osgWaterReflect::Search;

namespace
{

// [pixels] From one to long, odd and prime, and both ways.
const glm::ivec2 SIZES[] = {{1, 1},     {1, 7},   {64, 48}, {7, 1},    {127, 101}, {31, 17}, {2, 2},
                            {640, 480}, {509, 3}, {3, 509}, {257, 33}, {4096, 5},  {5, 4096}};

const int WIDEST = 4096;

// The name of the set of rays that views of scenes have reflected.
const std::string RECORDED = "recorded";

struct Searched
{
    Search search;
    double stride;
    const char* name;
};

const Searched SEARCHES[] = {{Search::HIERARCHICAL, 1.0, "hierarchical"},
                             {Search::SEQUENTIAL, 1.0, "sequential"},
                             {Search::SEQUENTIAL, 7.0, "sequential, stride 7"},
                             {Search::BINARY, 1.0, "binary"}};

std::vector<Ray> someOf(const std::vector<Ray>& rays, std::size_t count, std::mt19937_64& random)
{
    std::vector<Ray> some;
    std::sample(rays.begin(), rays.end(), std::back_inserter(some), count, random);
    return some;
}

// Images of every kind in turn, with rays of every set for each; and about as many rays of views.
std::map<std::string, Examination> examineAll(const Searched& searched,
                                              const std::vector<RecordedView>& views, int images,
                                              int raysEach)
{
    std::map<std::string, Examination> bySet;
    std::mt19937_64 random(20);
    Examiner examiner(searched.search);
    for (int i = 0; i < images; ++i)
    {
        const auto shown = static_cast<Shown>(i % static_cast<int>(Shown::NUM));
        const auto lens = static_cast<Lens>(i / 3 % static_cast<int>(Lens::NUM));
        const int bits[] = {32, 24, 16};
        RayImage image = createImage(shown, lens, bits[i % 3], SIZES[i % std::size(SIZES)], random);
        image.stride = searched.stride;
        for (int set = 0; set < static_cast<int>(RaySet::NUM); ++set)
        {
            const auto raySet = static_cast<RaySet>(set);
            bySet[nameOf(raySet)].add(
                examiner.examine(image, createRays(raySet, image, raysEach, random)));
        }
    }
    for (const RecordedView& view : views)
    {
        RayImage image = view.image;
        image.stride = searched.stride;
        bySet[RECORDED].add(
            examiner.examine(image, someOf(view.rays, images * raysEach / views.size(), random)));
    }
    return bySet;
}

double quantile(std::vector<double> values, double share)
{
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * (values.size() - 1))];
}

void check(const Searched& searched, const std::string& set, const Examination& result)
{
    std::string faults;
    for (const auto& [name, ray] : result.faults)
        faults += "\n" + name + ": " + ray;
    INFO(searched.name << ", " << set << faults << "\nwrong: " << result.firstWrong);
    CHECK(result.rays > 1000);
    CHECK(result.hits > 0.01 * result.rays);
    CHECK(result.fetches < 1.05 * result.fetchesInDouble);
    CHECK(result.faults.empty());
    CHECK(result.wrong == 0);
    // All but the worst conditioned are decided as a ray beside them, at four steps, is.
    CHECK(std::accumulate(result.beside.begin() + 2, result.beside.end(), std::int64_t(0)) <=
          1 + 2e-4 * result.rays);
    // Of scenes: as far as the four roundings of a place go.
    if (set == RECORDED) CHECK(quantile(result.windowZOff, 0.5) < 2.0);
}

} // namespace

// Falls with each of the faults of tests/mutants that names it.
TEST_CASE("every ray ends, for a reason, within the image, and as double precision has it")
{
    const std::vector<RecordedView> views = recordViews();
    for (const Searched& searched : SEARCHES)
        for (const auto& [set, result] : examineAll(searched, views, 39, 64))
            check(searched, set, result);
}

// For docs/stability.md: ten million rays.
TEST_CASE("the full battery, written to test-output/battery.json", "[.full]")
{
    nlohmann::json rows;
    const std::vector<RecordedView> views = recordViews();
    for (const Searched& searched : SEARCHES)
        for (const auto& [set, result] : examineAll(searched, views, 65, 4096))
        {
            check(searched, set, result);
            rows.push_back({{"search", searched.name},
                            {"set", set},
                            {"rays", result.rays},
                            {"hits", result.hits},
                            {"beside", result.beside},
                            {"wrong", result.wrong},
                            {"window_z_median", quantile(result.windowZOff, 0.5)},
                            {"window_z_p999", quantile(result.windowZOff, 0.999)},
                            {"window_z_worst", quantile(result.windowZOff, 1.0)},
                            {"worst_pixels", result.worstPixels},
                            {"off_plane_q_pixels", result.offPlaneQPixels}});
        }
    const nlohmann::json all = {{"nudges", NUDGES}, {"widest", WIDEST}, {"rows", rows}};
    std::ofstream file(OSGWATERREFLECT_TEST_OUTPUT_DIRECTORY "/battery.json");
    file << all.dump(1) << "\n";
    CHECK(file.good());
}
