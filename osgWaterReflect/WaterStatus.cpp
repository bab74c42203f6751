#include <osgWaterReflect/WaterStatus>

#include <ostream>

using namespace osgWaterReflect;

namespace
{

const char* nameOf(CaptureKind kind)
{
    switch (kind)
    {
    case CaptureKind::VIEW:
        return "drawn from the eye";
    case CaptureKind::FRAME:
        return "copied from the frame";
    case CaptureKind::MIRROR:
        return "drawn from the mirrored eye";
    default:
        return "?";
    }
}

const char* nameOf(Search search)
{
    switch (search)
    {
    case Search::SEQUENTIAL:
        return "sequential";
    case Search::BINARY:
        return "binary";
    case Search::HIERARCHICAL:
        return "hierarchical";
    default:
        return "?";
    }
}

} // namespace

std::ostream& osgWaterReflect::operator<<(std::ostream& out, const WaterStatus& status)
{
    out << "frame " << status.frameNumber << ", sheet " << status.sheet << ": "
        << nameOf(status.search) << " search, capture scale " << status.captureScale
        << ", trace scale " << status.traceScale << ", accuracy step " << status.accuracyStep
        << ", " << status.passes << " passes\n";
    for (const WaterStatus::Image& image : status.images)
        out << "  image " << nameOf(image.kind) << ", " << image.width << " x " << image.height
            << " pixels, band " << image.bandLeft << " " << image.bandRight << " "
            << image.bandBottom << " " << image.bandTop
            << (image.depthCells ? ", with depth cells\n" : "\n");
    out << "  program " << status.program << "\n";
    for (const WaterStatus::Decision& decision : status.decisions)
        out << "  " << decision.subject << (decision.done ? ": yes, " : ": no, ") << decision.reason
            << "\n";
    return out;
}
