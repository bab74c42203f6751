#ifndef OSGWATERREFLECT_TESTS_BATTERY_EXAMINATION_H
#define OSGWATERREFLECT_TESTS_BATTERY_EXAMINATION_H

#include "RayProbe.h"
#include "RaySet.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>

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
    std::int64_t hitNothing = 0;    ///< hits of which the image shows nothing
    std::int64_t wrong = 0;         ///< decided otherwise, though far from any other decision

    /// Decided otherwise than in double precision, and so are rays beside them: by how far.
    std::array<std::int64_t, NUDGES.size()> beside{};

    /// Of hits that both decide alike: how far they are off one ray in windowZ, where that is
    /// longer than a pixel [STEP], and apart in the image [pixels].
    double worstWindowZ = 0.0;
    double worstPixels = 0.0;

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

    Examination examine(const RayImage& image, const std::vector<Ray>& rays,
                        std::mt19937_64& random);

private:
    osgWaterReflect::Search _search;
    RayProbe _single;
    RayProbe _double;
};

} // namespace battery

#endif
