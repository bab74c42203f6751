#include "Drawn.h"

std::vector<std::size_t> osgwaterbench::waterPixels(const DrawnWater& drawn, int everyNth)
{
    std::vector<std::size_t> pixels;
    for (int y = 0; y < drawn.height(); y += everyNth)
        for (int x = 0; x < drawn.width(); x += everyNth)
        {
            const std::size_t pixel = static_cast<std::size_t>(y) * drawn.width() + x;
            if (drawn.isWater[pixel]) pixels.push_back(pixel);
        }
    return pixels;
}
