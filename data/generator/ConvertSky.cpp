#include "Daylight.h"
#include "Noise.h"

#include <ImfArray.h>
#include <ImfRgbaFile.h>
#include <osg/Image>
#include <osg/Math>
#include <osgDB/FileNameUtils>
#include <osgDB/WriteFile>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>

namespace waterdata
{

namespace
{

const int faceSize = 512;
const float exposure = 2.25f;
const float brightest = 2.0f;
const float vividness = 1.22f;
const Colour tint(0.92f, 1.05f, 1.0f);

// A picture of all directions: columns are azimuths, rows are elevations from the zenith down.
class Panorama
{
public:
    explicit Panorama(const std::string& file) : _input(file.c_str())
    {
        const Imath::Box2i window = _input.dataWindow();
        _width = window.max.x - window.min.x + 1;
        _height = window.max.y - window.min.y + 1;
        _pixels.resizeErase(_height, _width);
        _input.setFrameBuffer(&_pixels[0][0] - window.min.x - window.min.y * _width, 1, _width);
        _input.readPixels(window.min.y, window.max.y);
        findSun();
    }

    // Turns from zero at the sun, elevation in radians.
    Colour light(float fromSun, float elevation) const
    {
        const float column = _sunColumn - fromSun / (2.0f * osg::PIf) * _width;
        const float row = (0.5f - elevation / osg::PIf) * _height - 0.5f;
        return cubic(column, row);
    }

    float sunElevation() const { return (0.5f - (_sunRow + 0.5f) / _height) * osg::PIf; }

private:
    Imf::RgbaInputFile _input;
    Imf::Array2D<Imf::Rgba> _pixels;
    int _width = 0;
    int _height = 0;
    float _sunColumn = 0.0f;
    float _sunRow = 0.0f;

    // The sun is far brighter than what a picture can hold; a soft knee keeps its surroundings.
    Colour pixel(int column, int row) const
    {
        const int x = ((column % _width) + _width) % _width;
        const Imf::Rgba& value = _pixels[std::clamp(row, 0, _height - 1)][x];
        Colour light(value.r, value.g, value.b);
        for (int channel = 0; channel < 3; ++channel)
            light[channel] =
                std::isfinite(light[channel]) ? std::min(light[channel], brightest) : 0.0f;
        // The panorama's compression has torn holes around its sun.
        const float fromSun = osg::Vec2(x - _sunColumn, row - _sunRow).length();
        const Colour disc(brightest, brightest, brightest);
        return mix(disc, light, smoothStep(6.0f, 11.0f, fromSun));
    }

    void findSun()
    {
        float most = 0.0f;
        for (int row = 0; row < _height / 2; ++row)
        {
            for (int column = 0; column < _width; ++column)
            {
                const Imf::Rgba& value = _pixels[row][column];
                const float sum = static_cast<float>(value.r) + value.g + value.b;
                if (std::isfinite(sum) && sum > most)
                {
                    most = sum;
                    _sunColumn = static_cast<float>(column);
                    _sunRow = static_cast<float>(row);
                }
            }
        }
    }

    // Catmull-Rom between the pixels: the panorama is coarser than the faces.
    Colour cubic(float column, float row) const
    {
        const int x = static_cast<int>(std::floor(column));
        const int y = static_cast<int>(std::floor(row));
        Colour sum;
        for (int dy = -1; dy <= 2; ++dy)
        {
            for (int dx = -1; dx <= 2; ++dx)
                sum += pixel(x + dx, y + dy) * (weight(column - x - dx) * weight(row - y - dy));
        }
        return sum;
    }

    static float weight(float distance)
    {
        const float t = std::fabs(distance);
        if (t < 1.0f)
            return 1.5f * t * t * t - 2.5f * t * t + 1.0f;
        return -0.5f * t * t * t + 2.5f * t * t - 4.0f * t + 2.0f;
    }
};

// The direction of a texel of a GL cube map face, the image's first row being t = 0.
osg::Vec3 faceDirection(int face, float s, float t)
{
    const float u = 2.0f * s - 1.0f;
    const float v = 2.0f * t - 1.0f;
    osg::Vec3 direction;
    switch (face)
    {
        case 0: direction.set(1.0f, -v, -u); break;
        case 1: direction.set(-1.0f, -v, u); break;
        case 2: direction.set(u, 1.0f, v); break;
        case 3: direction.set(u, -1.0f, -v); break;
        case 4: direction.set(u, -v, 1.0f); break;
        default: direction.set(-u, -v, -1.0f); break;
    }
    direction.normalize();
    return direction;
}

class SkyPainter
{
public:
    SkyPainter(const Panorama& panorama, const Daylight& daylight)
        : _panorama(panorama), _daylight(daylight)
    {
        _sunAzimuth = std::atan2(daylight.towardsSun.y(), daylight.towardsSun.x());
        const float wanted = std::asin(daylight.towardsSun.z());
        _lift = (panorama.sunElevation() - wanted) / std::sin(2.0f * wanted);
    }

    Colour paint(const osg::Vec3& direction) const
    {
        const float elevation = std::asin(osg::clampBetween(direction.z(), -1.0f, 1.0f));
        const float azimuth = std::atan2(direction.y(), direction.x());
        const float above = std::max(elevation, 0.012f);
        const Colour light = detailed(direction, azimuth - _sunAzimuth, above);
        const Colour sky = toPainted(softened(vivid(light * exposure)));
        return mix(_daylight.haze, sky, 0.12f + 0.88f * smoothStep(-0.02f, 0.16f, elevation));
    }

private:
    const Panorama& _panorama;
    const Daylight& _daylight;
    float _sunAzimuth;
    float _lift;

    // Lowers the panorama's sun to the baked one's height, leaving horizon and zenith in place.
    float sourceElevation(float elevation) const
    {
        return elevation + _lift * std::sin(2.0f * elevation);
    }

    // Ruffles the lookup, so that the enlarged clouds keep a fine structure.
    Colour detailed(const osg::Vec3& direction, float fromSun, float elevation) const
    {
        const osg::Vec3 fine = direction * 46.0f;
        const float across = 0.012f * fractalNoise(fine, 4);
        const float along = 0.012f * fractalNoise(fine + osg::Vec3(31.0f, 17.0f, 5.0f), 4);
        const float lean = std::max(0.2f, std::cos(elevation));
        return _panorama.light(fromSun + across / lean, sourceElevation(elevation) + along);
    }

    // Film's answer to light: bright clouds keep their shape.
    static Colour softened(const Colour& light)
    {
        const auto film = [](float value) { return 1.0f - std::exp(-1.1f * value); };
        return Colour(film(light.x()), film(light.y()), film(light.z()));
    }

    static Colour vivid(const Colour& light)
    {
        const float grey = light * Colour(0.3f, 0.59f, 0.11f);
        return osg::componentMultiply(mix(Colour(grey, grey, grey), light, vividness), tint);
    }
};

void writeFaces(const SkyPainter& painter, const std::string& directory)
{
    const char* const names[6] = {"posx", "negx", "posy", "negy", "posz", "negz"};
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options("JPEG_QUALITY 97");
    for (int face = 0; face < 6; ++face)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(faceSize, faceSize, 1, GL_RGB, GL_UNSIGNED_BYTE);
        for (int y = 0; y < faceSize; ++y)
        {
            for (int x = 0; x < faceSize; ++x)
            {
                const osg::Vec3 direction =
                    faceDirection(face, (x + 0.5f) / faceSize, (y + 0.5f) / faceSize);
                image->setColor(osg::Vec4(painter.paint(direction), 1.0f), x, y);
            }
        }
        const std::string file = osgDB::concatPaths(directory, std::string(names[face]) + ".jpg");
        if (!osgDB::writeImageFile(*image, file, options))
            throw std::runtime_error("cannot write " + file);
    }
}

}

}

int main(int argc, char** argv)
{
    if (argc != 3)
    {
        std::cerr << "usage: osgwatersky PANORAMA.exr OUTPUT_DIRECTORY" << std::endl;
        return 1;
    }
    try
    {
        const waterdata::Panorama panorama(argv[1]);
        const waterdata::Daylight daylight = waterdata::afternoon();
        waterdata::writeFaces(waterdata::SkyPainter(panorama, daylight), argv[2]);
    }
    catch (const std::exception& problem)
    {
        std::cerr << "osgwatersky: " << problem.what() << std::endl;
        return 1;
    }
    return 0;
}
