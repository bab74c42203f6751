#ifndef OSGWATERREFLECT_TESTS_BATTERY_EXAMINATION_H
#define OSGWATERREFLECT_TESTS_BATTERY_EXAMINATION_H

#include "RayProbe.h"
#include "RaySet.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace battery
{

/// One step of single precision below 1: errors are given in these, of numbers as large as those
/// that they are errors of.
constexpr double STEP = 5.9604644775390625e-8; // 2^-24

/// By how much each number of a ray is changed to see whether it lies beside a decision [STEP].
constexpr std::array<int, 6> NUDGES = {1, 4, 16, 64, 256, 1024};

/// What single precision has made of many rays.
struct Examination
{
    std::int64_t rays = 0;
    std::int64_t hits = 0;
    std::int64_t fetches = 0;         ///< for rays that are decided alike in both precisions:
    std::int64_t fetchesInDouble = 0; ///< in single, and in double

    // None of these may be.
    std::int64_t notFinite = 0;
    std::int64_t readOutside = 0;
    std::int64_t withoutReason = 0; ///< or with a place that is not on the segment
    std::int64_t tooLong = 0;       ///< looked at more places than the search has columns
    std::int64_t hitNothing = 0;    ///< hits off every surface that the image shows about them
    std::int64_t offTheRay = 0;     ///< hits that plane Q of the paper, in double precision, has
                                    ///< elsewhere
    std::int64_t wrong = 0;         ///< decided otherwise, though far from any other decision

    /// Decided otherwise than in double precision, and so are rays beside them: by how far.
    std::array<std::int64_t, NUDGES.size()> beside{};

    /// Of hits that both decide alike: how far each is off the ray in windowZ, of rays longer than
    /// 16 pixels [STEP]; and the greatest distance in the image [pixels].
    std::vector<double> windowZOff;
    double worstPixels = 0.0;

    /// Of hits in double precision: how far plane Q has them elsewhere [pixels].
    double offPlaneQPixels = 0.0;

    /// The first ray of each kind that may not be, for a person to read.
    std::map<std::string, std::string> faults;
    std::string firstWrong;

    void add(const Examination& rhs);
};

/// A search in single precision and the same in double, held to each other ray by ray.
class Examiner
{
public:
    explicit Examiner(osgWaterReflect::Search search);

    Examination examine(const RayImage& image, const std::vector<Ray>& rays);

private:
    /// Of the rays asked for, those beside which double precision decides nothing otherwise, nor
    /// as single precision does.
    ///   answers     of single precision, for each ray
    ///   references  of double precision
    ///   steps       by how much the numbers of a ray are changed [STEP]
    ///   number      of rays beside each
    std::vector<std::size_t> alikeBeside(const RayImage& image, const std::vector<Ray>& rays,
                                         const std::vector<RayAnswer>& answers,
                                         const std::vector<RayAnswer>& references,
                                         const std::vector<std::size_t>& asked, double steps,
                                         int number);

    osgWaterReflect::Search _search;
    RayProbe _single;
    RayProbe _double;
    std::mt19937_64 _random{20};
};

} // namespace battery

#endif
