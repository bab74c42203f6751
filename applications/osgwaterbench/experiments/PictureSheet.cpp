#include "PictureSheet.h"

#include <osg/Image>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <iostream>

using namespace osgwaterbench;

namespace
{

// The mean difference of the channels that is shown white.
const double WHITE = 0.25;

const double DIMMED = 0.3; // brightness of what is no water

const char* const JPEG_OPTIONS = "JPEG_QUALITY 90";

// Black, red, yellow, white.
glm::dvec3 heat(double share)
{
    return glm::clamp(3.0 * share - glm::dvec3(0.0, 1.0, 2.0), 0.0, 1.0);
}

} // namespace

Picture osgwaterbench::errorMap(const Picture& picture, const Picture& truth,
                                const std::vector<std::uint8_t>& isWater)
{
    Picture map = truth;
    for (std::size_t i = 0; i < map.colours.size(); ++i)
    {
        const glm::dvec3 difference = glm::abs(picture.colours[i] - truth.colours[i]);
        const double mean = (difference.r + difference.g + difference.b) / 3.0;
        const glm::dvec3& seen = truth.colours[i];
        map.colours[i] =
            isWater[i] ? heat(mean / WHITE) : glm::dvec3(DIMMED * (seen.r + seen.g + seen.b) / 3.0);
    }
    return map;
}

bool osgwaterbench::writeSheet(const std::string& file,
                               const std::vector<std::vector<Picture>>& rows)
{
    const int width = rows[0][0].width;
    const int height = rows[0][0].height;
    const osg::ref_ptr<osg::Image> sheet = new osg::Image;
    sheet->allocateImage(width * static_cast<int>(rows[0].size()),
                         height * static_cast<int>(rows.size()), 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (std::size_t column = 0; column < rows[row].size(); ++column)
        {
            const Picture& picture = rows[row][column];
            const int left = width * static_cast<int>(column);
            const int lowest = height * static_cast<int>(rows.size() - 1 - row);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                {
                    const glm::vec3 colour(
                        picture.colours[static_cast<std::size_t>(y) * width + x]);
                    sheet->setColor(osg::Vec4(colour.r, colour.g, colour.b, 1.0f), left + x,
                                    lowest + y);
                }
        }

    osgDB::makeDirectory(osgDB::getFilePath(file));
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options(JPEG_OPTIONS);
    const auto result = osgDB::Registry::instance()->writeImage(*sheet, file, options);
    if (!result.success())
    {
        std::cerr << "osgwaterbench: " << file
                  << ": expected a picture to be written, got: " << result.statusMessage() << "\n";
        return false;
    }
    std::cout << "written: " << file << std::endl;
    return true;
}
