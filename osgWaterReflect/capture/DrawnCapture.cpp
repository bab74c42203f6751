#include "DrawnCapture.h"

using namespace osgWaterReflect;

void DrawnCapture::draw(const CulledView& view, const CaptureSize& size)
{
    const glm::dmat4 clipFromEye = _scene.fitTo(size);
    _scene.finish();
    allocate(view, size);
    setMatrices(view.eyeFromWorld, glm::dmat4(1.0), _scene.projection(), clipFromEye);
    drawBefore(view);
}
