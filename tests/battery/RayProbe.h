#ifndef OSGWATERREFLECT_TESTS_BATTERY_RAYPROBE_H
#define OSGWATERREFLECT_TESTS_BATTERY_RAYPROBE_H

#include "RayImage.h"

#include "../support/OffscreenView.h"

#include <osgWaterReflect/ReflectionSettings>

#include <vector>

namespace battery
{

struct Ray
{
    glm::vec3 originEye; ///< [world units]
    glm::vec3 dirEye;    ///< of unit length, rounded
};

/// What is added to a ray before it is looked for: to see what a small error does.
struct Disturbance
{
    glm::vec3 originEye{0.0f};
    glm::vec3 dirEye{0.0f};
    glm::vec3 startWindow{0.0f}; ///< [pixels, pixels, windowZ] to the segment's ends
    glm::vec3 endWindow{0.0f};
};

/// What the shader has found for a ray, and everything on the way that is worth watching.
struct RayAnswer
{
    bool finite = true; ///< neither NaN nor infinite, in anything below
    int reason = 0;     ///< REASON_…
    double s = 0.0;     ///< along the segment, [0, 1]
    glm::dvec3 window{0.0};
    double rayLength = 0.0; ///< [world units] to that place
    double hidden = 0.0;
    double endZ = 0.0;
    int fetches = 0;
    int readsOutside = 0; ///< of these, texels that no image has
    glm::dvec2 skyWindow{0.0};
    glm::dvec3 start{0.0};
    glm::dvec3 end{0.0};
    glm::dvec2 inverseDepth{0.0};

    bool isHit() const { return reason == 0; }
};

enum class Precision
{
    SINGLE, ///< the pieces of shaders/, as water is drawn with them
    DOUBLE  ///< the same text with every number of it in double precision
};

/// Runs the library's own search, projectRay and searchImage, on the rays that it is given.
class RayProbe
{
public:
    RayProbe(osgWaterReflect::Search search, Precision precision);

    /// The answers, in the order of the rays. Disturbances may be left out: none then.
    std::vector<RayAnswer> run(const RayImage& image, const std::vector<Ray>& rays,
                               const std::vector<Disturbance>& disturbances = {});

    /// [pixels] Side of the picture that holds the answers; as many rays as its pixels are
    /// looked for at once.
    static constexpr int SIDE = 64;

private:
    enum Value
    {
        DECISION,
        PLACE,
        BEYOND,
        START,
        END,
        ROUNDED, // what single precision loses of the place
        NUM_VALUES
    };

    void setImage(const RayImage& image);
    OffscreenView _view;
    osg::ref_ptr<osg::Group> _scene;
    osg::ref_ptr<osg::StateSet> _stateSet;
    std::vector<osg::ref_ptr<osg::Image>> _values; // by Value
};

} // namespace battery

#endif
