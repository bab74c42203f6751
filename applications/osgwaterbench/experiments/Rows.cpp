#include "Rows.h"

#include <map>

using namespace osgwaterbench;

namespace
{

const char* const CLASS_NAMES[TRUE_CLASS_COUNT] = {"sky", "visible", "hidden", "outside_top",
                                                   "outside_sides"};

const std::map<osgWaterReflect::CaptureKind, const char*> CAPTURE_NAMES = {
    {osgWaterReflect::CaptureKind::VIEW, "view"},
    {osgWaterReflect::CaptureKind::FRAME, "frame"},
    {osgWaterReflect::CaptureKind::MIRROR, "mirror"},
    {osgWaterReflect::CaptureKind::VIEW_AND_MIRROR, "view and mirror"},
    {osgWaterReflect::CaptureKind::AUTOMATIC, "automatic"}};

Json orNull(const std::optional<double>& value)
{
    return value ? Json(*value) : Json();
}

Json jsonOf(const Tally& tally)
{
    return {{"pixels", tally.total()},
            {"correct", tally.count(Outcome::CORRECT)},
            {"misplaced", tally.count(Outcome::MISPLACED)},
            {"missed", tally.count(Outcome::MISSED)},
            {"false_hit", tally.count(Outcome::FALSE_HIT)}};
}

Json jsonOf(const std::optional<Percentiles>& percentiles)
{
    if (!percentiles) return {};
    return {{"count", percentiles->count},
            {"median", percentiles->median},
            {"p90", percentiles->p90},
            {"p99", percentiles->p99}};
}

Json jsonOf(const std::optional<SearchError>& error)
{
    if (!error) return {};
    return {{"disagreed_percent", orNull(error->disagreedPercent())},
            {"answered_behind", error->answeredBehind},
            {"error_px", jsonOf(error->errorPixels)}};
}

Json jsonOf(const PictureError& error)
{
    return {{"rmse_8bit", error.rmse}, {"psnr_db", orNull(error.psnr)}, {"ssim", error.ssim}};
}

Json jsonOf(const Spread& spread)
{
    return {
        {"median", spread.median}, {"p25", spread.lowerQuartile}, {"p75", spread.upperQuartile}};
}

} // namespace

Json osgwaterbench::toJson(const Measures& measures)
{
    Json json;
    for (int i = 0; i < TRUE_CLASS_COUNT; ++i)
        json["classes"][CLASS_NAMES[i]] = jsonOf(measures.classes[i]);
    json["correct_percent"] = orNull(measures.all().percent(Outcome::CORRECT));
    json["hit_error_px"] = jsonOf(measures.hitErrorPixels);
    json["fetches"] = orNull(measures.meanFetches);
    return json;
}

Json osgwaterbench::toJson(const Accuracy& accuracy)
{
    Json json = toJson(accuracy.measures);
    json["search"] = jsonOf(accuracy.search);
    json["picture"] = jsonOf(accuracy.picture);
    return json;
}

Json osgwaterbench::toJson(const std::optional<TessellationError>& error)
{
    if (!error) return {};
    return {{"height_m", jsonOf(error->height)},
            {"normal_degrees", jsonOf(error->normalDegrees)},
            {"moved_px", jsonOf(error->movedPixels)}};
}

Json osgwaterbench::toJson(const CaseTime& time)
{
    return {{"image_ms", jsonOf(time.image)},
            {"pyramid_ms", jsonOf(time.pyramid)},
            {"trace_ms", jsonOf(time.trace)},
            {"frame_ms", jsonOf(time.frame)}};
}

Json osgwaterbench::toJson(const Method& method)
{
    Json json = {{"method", method.name},
                 {"stride", method.settings.stride},
                 {"thickness", method.settings.thickness},
                 {"capture", CAPTURE_NAMES.at(method.settings.capture)},
                 {"capture_scale", method.settings.captureScale},
                 {"trace_scale", method.settings.traceScale}};
    if (method.mirror) json["distortion"] = method.mirror->distortion;
    return json;
}

double osgwaterbench::correctPercent(const Measures& measures)
{
    return measures.all().percent(Outcome::CORRECT).value_or(0.0);
}
