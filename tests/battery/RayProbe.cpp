#include "RayProbe.h"

#include "../support/Catch.h"

#include <osgWaterReflect/Transforms.h>
#include <osgWaterReflect/shaders/Bindings.h>
#include <osgWaterReflect/shaders/ShaderSource.h>
#include <osgWaterReflect/water/WaterProgram.h>

#include <osg/Geometry>
#include <osg/Program>
#include <osg/Texture2D>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

using namespace battery;
using namespace osgWaterReflect;

namespace
{

const char* const PIECE = "search_probe.frag";

// Of inputs, behind the two that the search reads itself: windowZ and its cells.
const unsigned int UNIT_INPUTS = 2;
const char* const INPUTS[] = {"probe_originEye",    "probe_dirEye",         "probe_disturbedOrigin",
                              "probe_disturbedDir", "probe_disturbedStart", "probe_disturbedEnd"};

// As in interface.glsl.
const int CELL = 4;
const int CELLS_MERGED = 8;

// What no search answers: a shader that does not compile leaves it.
const float UNTOUCHED = -12345.0f;

std::string probeText()
{
    std::ifstream file(std::string(OSGWATERREFLECT_TEST_DIRECTORY) + "/battery/" + PIECE);
    std::stringstream text;
    text << file.rdbuf();
    REQUIRE(!text.str().empty());
    return text.str();
}

// Behind the interface every number in double precision, but for uniforms, which are what they are.
std::string inDouble(const std::string& text)
{
    const std::size_t first = text.find("// What follows is of single or of double precision");
    REQUIRE(first != std::string::npos);
    std::istringstream body(text.substr(first));
    const std::pair<const char*, const char*> changes[] = {
        {"\\bfloat\\b", "double"},
        {"\\b(vec[234]|mat[34])\\b", "d$1"},
        {"\\bcapture\\.(size|depthScale)\\b", "dvec2(capture.$1)"},
        {"\\bcapture\\.imageFromEye\\b", "dmat4(capture.imageFromEye)"},
        {"\\bcapture\\.pixelExtent\\b", "double(capture.pixelExtent)"},
        {"\\b(hitThickness|osgwr_columnStride)\\b", "double($1)"}};
    std::string result = text.substr(0, first);
    for (std::string line; std::getline(body, line);)
    {
        if (line.compare(0, 7, "uniform") != 0)
            for (const auto& [from, to] : changes)
                line = std::regex_replace(line, std::regex(from), to);
        result += line + "\n";
    }
    return result;
}

// The library's own pieces, whatever stands in for them.
std::string withEmbedded(const std::string& piece, const ShaderSlots& slots)
{
    std::istringstream lines(piece);
    std::string text;
    for (std::string line; std::getline(lines, line);)
    {
        std::smatch name;
        const bool includes = std::regex_match(line, name, std::regex("#include \"(.*)\".*"));
        const std::string included = name.str(1);
        const bool isSlot = includes && included.find('.') == std::string::npos;
        const std::string file = isSlot ? slots.in(included).front()->getName() : included;
        text += includes ? withEmbedded(embeddedShaders.at(file), slots) : line + "\n";
    }
    return text;
}

std::string shaderText(Search search, Precision precision)
{
    ShaderSlots slots;
    slots.search = searchPiece(search);
    const ShaderReplacement piece(PIECE, probeText());
    std::string text = precision == Precision::DOUBLE ? withEmbedded(probeText(), slots)
                                                      : assembleShader(PIECE, slots);
    std::string version = "#version 130\n";
    REQUIRE(text.compare(0, version.size(), version) == 0);
    text.erase(0, version.size());
    if (precision == Precision::DOUBLE)
    {
        text = inDouble(text);
        version = "#version 450 compatibility\n";
    }
    return version + "#define narrow3 vec3\n#define narrow4 vec4\n" + text;
}

osg::ref_ptr<osg::Texture2D> createTexture(int width, int height, GLenum format,
                                           GLint internalFormat, const float* values)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, format, GL_FLOAT);
    image->setInternalTextureFormat(internalFormat);
    std::copy_n(values, static_cast<std::size_t>(width) * height * (format == GL_RGBA ? 4 : 1),
                reinterpret_cast<float*>(image->data()));
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setInternalFormat(internalFormat);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

// Nearest windowZ of each cell of a side, row by row.
class NearestOf
{
public:
    NearestOf(const RayImage& image, int side) :
        _side(side), _columns((image.size.x + side - 1) / side),
        _nearest(static_cast<std::size_t>(_columns) * ((image.size.y + side - 1) / side), 1.0f)
    {
        for (int y = 0; y < image.size.y; ++y)
            for (int x = 0; x < image.size.x; ++x)
            {
                float& nearest = _nearest[indexOf(x, y)];
                nearest = std::min(nearest, image.windowZ[std::size_t(y) * image.size.x + x]);
            }
    }
    float about(int x, int y) const { return _nearest[indexOf(x, y)]; }

private:
    std::size_t indexOf(int x, int y) const
    {
        return std::size_t(y / _side) * _columns + x / _side;
    }

    int _side;
    int _columns;
    std::vector<float> _nearest;
};

// What pyramid_pack.frag writes; tests/gpu/Hierarchical.test.cpp holds that to the same bounds.
osg::ref_ptr<osg::Texture2D> createCells(const RayImage& image)
{
    const NearestOf small(image, CELL);
    const NearestOf middle(image, CELL * CELLS_MERGED);
    const NearestOf large(image, CELL * CELLS_MERGED * CELLS_MERGED);
    RayImage negative = image;
    for (float& windowZ : negative.windowZ)
        windowZ = -windowZ;
    const NearestOf farthest(negative, CELL);

    const glm::ivec2 cells = (image.size + CELL - 1) / CELL;
    std::vector<float> texels;
    for (int y = 0; y < cells.y; ++y)
        for (int x = 0; x < cells.x; ++x)
            for (const float bound :
                 {small.about(CELL * x, CELL * y), middle.about(CELL * x, CELL * y),
                  large.about(CELL * x, CELL * y), -farthest.about(CELL * x, CELL * y)})
                texels.push_back(bound);
    return createTexture(cells.x, cells.y, GL_RGBA, GL_RGBA32F_ARB, texels.data());
}

bool isFinite(const osg::Vec4& value)
{
    return std::isfinite(value.x()) && std::isfinite(value.y()) && std::isfinite(value.z()) &&
           std::isfinite(value.w());
}

glm::dvec3 xyz(const osg::Vec4& v)
{
    return {v.x(), v.y(), v.z()};
}

} // namespace

RayProbe::RayProbe(Search search, Precision precision) :
    _view(SIDE, SIDE, OffscreenView::Format::RGBA32F), _scene(new osg::Group)
{
    const osg::ref_ptr<osg::Geometry> quad = osg::createTexturedQuadGeometry(
        osg::Vec3(-1, -1, 0), osg::Vec3(2, 0, 0), osg::Vec3(0, 2, 0));
    quad->setCullingActive(false);
    _scene->addChild(quad);
    _scene->setCullingActive(false);
    _stateSet = _scene->getOrCreateStateSet();

    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       "#version 130\nvoid main() { gl_Position = gl_Vertex; }\n"));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, shaderText(search, precision)));
    _stateSet->setAttributeAndModes(program);
    setVariant(*_stateSet, Images::ONE, Trace::HERE, WaterSurface::DebugView::HIT);
    for (const GLenum mode : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND})
        _stateSet->setMode(mode, osg::StateAttribute::OFF);
    for (unsigned int i = 0; i < std::size(INPUTS); ++i)
        _stateSet->addUniform(new osg::Uniform(INPUTS[i], static_cast<int>(UNIT_INPUTS + i)));

    _view.camera().setClearColor(osg::Vec4(UNTOUCHED, 0, 0, 0));
    for (int i = 0; i < NUM_VALUES; ++i)
    {
        _values.push_back(new osg::Image);
        _values.back()->allocateImage(SIDE, SIDE, 1, GL_RGBA, GL_FLOAT);
        _values.back()->setInternalTextureFormat(GL_RGBA32F_ARB);
        const auto buffer = osg::Camera::BufferComponent(osg::Camera::COLOR_BUFFER0 + i);
        _view.camera().detach(buffer);
        _view.camera().attach(buffer, _values.back());
    }
}

void RayProbe::setImage(const RayImage& image)
{
    const std::string capture = bindings::EYE_CAPTURE;
    _stateSet->setTextureAttribute(
        0, createTexture(image.size.x, image.size.y, GL_RED, GL_R32F, image.windowZ.data()));
    _stateSet->setTextureAttribute(1, createCells(image));
    for (const auto& member : {std::pair(bindings::WINDOW_Z, 0), std::pair(bindings::CELLS, 1)})
        bindings::set(*_stateSet, capture + member.first, member.second);

    const glm::vec2 depthScale(image.depthScale());
    bindings::set(*_stateSet, capture + bindings::SIZE, osg::Vec2(image.size.x, image.size.y));
    bindings::set(*_stateSet, capture + bindings::IMAGE_FROM_EYE,
                  toOsgFloat(glm::dmat4(image.imageFromEye())));
    bindings::set(*_stateSet, capture + bindings::DEPTH_SCALE,
                  osg::Vec2(depthScale.x, depthScale.y));
    bindings::set(*_stateSet, capture + bindings::PIXEL_EXTENT,
                  static_cast<float>(image.pixelExtent()));
    bindings::set(*_stateSet, capture + bindings::MIRRORED, image.mirrored);
    bindings::set(*_stateSet, bindings::HIT_THICKNESS, static_cast<float>(image.thickness));
    bindings::set(*_stateSet, bindings::COLUMN_STRIDE, static_cast<float>(image.stride));
}

std::vector<RayAnswer> RayProbe::run(const RayImage& image, const std::vector<Ray>& rays,
                                     const std::vector<Disturbance>& disturbances)
{
    REQUIRE((disturbances.empty() || disturbances.size() == rays.size()));
    setImage(image);
    std::vector<RayAnswer> answers;
    for (std::size_t first = 0; first < rays.size(); first += SIDE * SIDE)
    {
        const std::size_t count = std::min<std::size_t>(SIDE * SIDE, rays.size() - first);
        for (unsigned int input = 0; input < std::size(INPUTS); ++input)
        {
            std::vector<osg::Vec4> texels(SIDE * SIDE);
            for (std::size_t i = 0; i < count; ++i)
            {
                const Ray& ray = rays[first + i];
                const Disturbance disturbance =
                    disturbances.empty() ? Disturbance() : disturbances[first + i];
                const glm::vec3 inputs[] = {ray.originEye,           ray.dirEye,
                                            disturbance.originEye,   disturbance.dirEye,
                                            disturbance.startWindow, disturbance.endWindow};
                texels[i] = osg::Vec4(inputs[input].x, inputs[input].y, inputs[input].z, 0.0f);
            }
            _stateSet->setTextureAttribute(
                UNIT_INPUTS + input,
                createTexture(SIDE, SIDE, GL_RGBA, GL_RGBA32F_ARB, texels.front().ptr()));
        }
        _view.render(_scene);

        for (std::size_t i = 0; i < count; ++i)
        {
            osg::Vec4 values[NUM_VALUES];
            RayAnswer answer;
            for (int value = 0; value < NUM_VALUES; ++value)
            {
                values[value] = reinterpret_cast<const osg::Vec4*>(_values[value]->data())[i];
                answer.finite = answer.finite && isFinite(values[value]);
            }
            REQUIRE(values[DECISION].x() != UNTOUCHED);
            answer.reason = static_cast<int>(values[DECISION].x());
            answer.fetches = static_cast<int>(values[DECISION].y());
            answer.readsOutside = static_cast<int>(values[DECISION].z());
            answer.hidden = values[DECISION].w();
            answer.window = xyz(values[PLACE]) + xyz(values[ROUNDED]);
            answer.rayLength = values[PLACE].w();
            answer.skyWindow = {values[BEYOND].x(), values[BEYOND].y()};
            answer.endZ = values[BEYOND].z();
            answer.s = values[BEYOND].w();
            answer.start = xyz(values[START]);
            answer.end = xyz(values[END]);
            answer.inverseDepth = {values[START].w(), values[END].w()};
            answers.push_back(answer);
        }
    }
    return answers;
}
