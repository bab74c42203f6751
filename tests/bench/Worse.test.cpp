// Answers and pictures that are made worse on purpose: each measure says so that is meant to, and
// no other.

#include "WallCase.h"
#include "support/Catch.h"

#include <osgwaterbench/measures/Measures.h>

#include <osgwaterbench/measures/PictureError.h>
#include <osgwaterbench/measures/SearchError.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

using namespace osgwaterbench;
using osgWaterReflect::reference::ImageReason;

namespace
{

// What a method gives: its answers, and the picture that it draws by them.
struct Result
{
    Answers answers;
    Picture picture;
};

// The colour of a place of the wall: waves of 1 m, so that every place has its own.
glm::dvec3 pattern(const glm::dvec3& place)
{
    const double turn = 2.0 * std::acos(-1.0);
    return glm::dvec3(0.5 + 0.4 * std::sin(turn * place.x), 0.5 + 0.4 * std::sin(turn * place.z),
                      0.4);
}

Picture pictureOf(const WallCase& wall, const Answers& answers)
{
    Picture picture = {wall.view.width, wall.view.height, {}};
    for (const Answer& answer : answers)
        picture.colours.push_back(answer.sky ? wall.skyColour : pattern(answer.placeWorld));
    return picture;
}

// Each the larger the worse.
std::map<std::string, double> badness(const WallCase& wall, const Result& right,
                                      const Result& result)
{
    const Measures measures = measure(wall.drawn, wall.truth, result.answers, wall.thickness);
    ImageTruth imageTruth;
    for (const TruePixel& own : wall.truth)
    {
        const Answer& answer = right.answers[own.pixel];
        imageTruth.push_back(
            {own.pixel, answer.sky ? ImageReason::SKY : ImageReason::HIT, answer.placeWorld});
    }
    const SearchError search = compareSearch(wall.drawn, imageTruth, result.answers);
    const PictureError error = *comparePictures(right.picture, result.picture, wall.drawn.isWater);
    const Tally& visible = measures.of(TrueClass::VISIBLE);
    const Tally& sky = measures.of(TrueClass::SKY);
    return {{"visible not right", 100.0 - *visible.percent(Outcome::CORRECT)},
            {"misplaced", *visible.percent(Outcome::MISPLACED)},
            {"missed", *visible.percent(Outcome::MISSED)},
            {"false hits", *sky.percent(Outcome::FALSE_HIT)},
            {"sky not right", 100.0 - *sky.percent(Outcome::CORRECT)},
            {"hit error", measures.hitErrorPixels->median},
            {"fetches", *measures.meanFetches},
            {"search disagrees", *search.disagreedPercent()},
            {"search error", search.errorPixels->median},
            {"rmse", error.rmse},
            {"psnr", error.psnr ? -*error.psnr : -1000.0},
            {"ssim", 1.0 - error.ssim}};
}

// Every n-th of the answers that are sky, or are not.
void changeSome(Answers& answers, bool sky, const std::function<void(Answer&)>& change)
{
    int i = 0;
    for (Answer& answer : answers)
        if (answer.sky == sky && answer.fetches > 0.0f && i++ % 3 == 0) change(answer);
}

Picture blurred(const Picture& picture)
{
    Picture result = picture;
    for (int y = 1; y < picture.height - 1; ++y)
        for (int x = 1; x < picture.width - 1; ++x)
        {
            glm::dvec3 sum(0.0);
            for (int i = 0; i < 9; ++i)
                sum += picture.colours[(y + i / 3 - 1) * picture.width + x + i % 3 - 1];
            result.colours[y * picture.width + x] = sum / 9.0;
        }
    return result;
}

} // namespace

TEST_CASE("worse answers and pictures are caught by the measures that are meant to")
{
    const WallCase wall;
    Result right = {wall.rightAnswers(), {}};
    right.picture = pictureOf(wall, right.answers);

    const auto shift = [&](Result& result)
    {
        for (Answer& answer : result.answers)
            if (!answer.sky) answer.placeWorld = wall.beside(answer.placeWorld, {2.0, 0.0});
        result.picture = pictureOf(wall, result.answers);
    };
    const auto dropToSky = [&](Result& result)
    {
        changeSome(result.answers, false, [](Answer& answer) { answer.sky = true; });
        result.picture = pictureOf(wall, result.answers);
    };
    const auto hitFalsely = [&](Result& result)
    {
        changeSome(result.answers, true,
                   [](Answer& answer) {
                       answer = {false, glm::dvec3(0.3, 20.0, 1.2), answer.fetches};
                   });
        result.picture = pictureOf(wall, result.answers);
    };
    const auto offsetColour = [](Result& result)
    {
        for (glm::dvec3& colour : result.picture.colours)
            colour += 8.0 / 255.0;
    };
    const auto blur = [](Result& result) { result.picture = blurred(result.picture); };
    const auto doubleFetches = [](Result& result)
    {
        for (Answer& answer : result.answers)
            answer.fetches *= 2.0f;
    };
    const std::set<std::string> picture = {"rmse", "psnr", "ssim"};
    const auto andPicture = [&picture](std::set<std::string> names)
    {
        names.insert(picture.begin(), picture.end());
        return names;
    };
    const struct
    {
        std::string name;
        std::function<void(Result&)> worsen;
        std::set<std::string> caughtBy;
    } cases[] = {
        {"nothing", [](Result&) {}, {}},
        {"shifted by 2 px", shift,
         andPicture(
             {"visible not right", "misplaced", "hit error", "search disagrees", "search error"})},
        {"some dropped to sky", dropToSky,
         andPicture({"visible not right", "missed", "search disagrees"})},
        {"places in the sky", hitFalsely,
         andPicture({"sky not right", "false hits", "search disagrees"})},
        {"colours lighter", offsetColour, picture},
        {"blurred", blur, picture},
        {"twice the fetches", doubleFetches, {"fetches"}},
    };

    const std::map<std::string, double> before = badness(wall, right, right);
    for (const auto& item : cases)
    {
        Result result = right;
        item.worsen(result);
        const std::map<std::string, double> after = badness(wall, right, result);
        std::set<std::string> caughtBy;
        for (const auto& [name, value] : after)
            // A right answer's place differs from the traced one by roundings: 1e-9 px.
            if (std::abs(value - before.at(name)) > 1e-6)
            {
                caughtBy.insert(name);
                INFO(item.name << ": " << name);
                CHECK(value > before.at(name));
            }
        INFO(item.name);
        CHECK(caughtBy == item.caughtBy);
    }

    // The eye minds a lost structure more than a lighter picture, though it errs by as much.
    Result lighter = right;
    offsetColour(lighter);
    Result soft = right;
    blur(soft);
    const PictureError lighterError =
        *comparePictures(right.picture, lighter.picture, wall.drawn.isWater);
    const PictureError softError =
        *comparePictures(right.picture, soft.picture, wall.drawn.isWater);
    WARN("lighter: " << lighterError.rmse << " steps, SSIM " << lighterError.ssim
                     << "; blurred: " << softError.rmse << ", " << softError.ssim);
    CHECK(std::abs(softError.rmse - lighterError.rmse) < 1.0);
    CHECK(1.0 - softError.ssim > 5.0 * (1.0 - lighterError.ssim));
}
