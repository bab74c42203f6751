#include "SceneTriangles.h"

#include <osg/Billboard>
#include <osg/Camera>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/TriangleIndexFunctor>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

using namespace osgWaterReflect::reference;

namespace
{

struct CornerIndices
{
    std::vector<unsigned int> indices;
    void operator()(unsigned int a, unsigned int b, unsigned int c)
    {
        indices.insert(indices.end(), {a, b, c});
    }
};

// An array's element, (0, 0, 0, 1) where it has fewer components; bytes as shares of 255, as
// colours are given. None where there is no such element, or it is of another type.
std::optional<osg::Vec4d> element(const osg::Array* array, std::size_t index)
{
    if (!array || index >= array->getNumElements()) return std::nullopt;
    osg::Vec4d result(0.0, 0.0, 0.0, 1.0);
    const void* data = array->getDataPointer(static_cast<unsigned int>(index));
    for (GLint i = 0; i < array->getDataSize(); ++i)
        switch (array->getDataType())
        {
        case GL_FLOAT:
            result[i] = static_cast<const GLfloat*>(data)[i];
            break;
        case GL_DOUBLE:
            result[i] = static_cast<const GLdouble*>(data)[i];
            break;
        case GL_UNSIGNED_BYTE:
            result[i] = static_cast<const GLubyte*>(data)[i] / 255.0;
            break;
        default:
            return std::nullopt;
        }
    return result;
}

bool isSwitchedOff(osg::StateAttribute::GLModeValue value)
{
    return !(value & (osg::StateAttribute::ON | osg::StateAttribute::INHERIT));
}

bool writesDepth(const osg::StateSet& state)
{
    // Without the depth test nothing is written, either.
    if (isSwitchedOff(state.getMode(GL_DEPTH_TEST))) return false;
    const auto* depth =
        dynamic_cast<const osg::Depth*>(state.getAttribute(osg::StateAttribute::DEPTH));
    return !depth || depth->getWriteMask();
}

const osg::Texture2D* textureOf(const osg::StateSet& state)
{
    if (!(state.getTextureMode(0, GL_TEXTURE_2D) & osg::StateAttribute::ON)) return nullptr;
    const auto* texture = dynamic_cast<const osg::Texture2D*>(
        state.getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    return texture && texture->getImage() && texture->getImage()->valid() ? texture : nullptr;
}

// A StateSet has no mode for what it does not speak of: inherited, and on where nobody speaks.
osg::ref_ptr<osg::StateSet> drawnByDefault()
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setMode(GL_DEPTH_TEST, osg::StateAttribute::ON);
    return state;
}

class CollectTriangles : public osg::NodeVisitor
{
public:
    explicit CollectTriangles(SceneTriangles& triangles) :
        osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN), _result(triangles)
    {
    }

    void apply(osg::Node& node) override
    {
        // By its name: nothing of the library is needed here.
        if (!std::strcmp(node.libraryName(), "osgWaterReflect") &&
            !std::strcmp(node.className(), "WaterSurface"))
            return;
        const osg::ref_ptr<osg::StateSet> outer = enter(node);
        traverse(node);
        _state = outer;
    }

    void apply(osg::Transform& transform) override
    {
        if (transform.getReferenceFrame() != osg::Transform::RELATIVE_RF) return;
        const osg::Matrixd outer = _worldFromLocal;
        transform.computeLocalToWorldMatrix(_worldFromLocal, this);
        apply(static_cast<osg::Node&>(transform));
        _worldFromLocal = outer;
    }

    void apply(osg::Camera& camera) override
    {
        if (camera.getRenderOrder() == osg::Camera::NESTED_RENDER)
            apply(static_cast<osg::Transform&>(camera));
    }

    void apply(osg::AutoTransform&) override {}
    void apply(osg::Billboard&) override {}

    void apply(osg::Drawable& drawable) override
    {
        const osg::ref_ptr<osg::StateSet> outer = enter(drawable);
        if (const osg::Geometry* geometry = drawable.asGeometry()) add(*geometry);
        _state = outer;
    }

private:
    // Lays a node's own state over the inherited one, which is handed back.
    osg::ref_ptr<osg::StateSet> enter(const osg::Node& node)
    {
        const osg::ref_ptr<osg::StateSet> outer = _state;
        if (node.getStateSet())
        {
            _state = new osg::StateSet(*outer);
            _state->merge(*node.getStateSet());
        }
        return outer;
    }

    void add(const osg::Geometry& geometry)
    {
        const std::size_t surface = _result.surfaces.size();
        _result.surfaces.push_back({writesDepth(*_state), textureOf(*_state)});
        for (unsigned int i = 0; i < geometry.getNumPrimitiveSets(); ++i)
        {
            osg::TriangleIndexFunctor<CornerIndices> corners;
            geometry.getPrimitiveSet(i)->accept(corners);
            for (std::size_t first = 0; first + 2 < corners.indices.size(); first += 3)
                add(geometry, i, &corners.indices[first], surface);
        }
    }

    void add(const osg::Geometry& geometry, unsigned int primitiveSet, const unsigned int* indices,
             std::size_t surface)
    {
        SceneTriangle triangle;
        triangle.surface = surface;
        for (int corner = 0; corner < 3; ++corner)
        {
            const unsigned int index = indices[corner];
            const std::optional<osg::Vec4d> local = element(geometry.getVertexArray(), index);
            if (!local) return;
            triangle.cornersWorld[corner] =
                osg::Vec3d(local->x(), local->y(), local->z()) * _worldFromLocal;

            const osg::Array* colours = geometry.getColorArray();
            const int binding = colours ? colours->getBinding() : osg::Array::BIND_OFF;
            const std::size_t colourIndex = binding == osg::Array::BIND_PER_VERTEX ? index
                                            : binding == osg::Array::BIND_PER_PRIMITIVE_SET
                                                ? primitiveSet
                                                : 0;
            const std::optional<osg::Vec4d> colour =
                binding == osg::Array::BIND_OFF ? std::nullopt : element(colours, colourIndex);
            triangle.colours[corner] = colour.value_or(osg::Vec4d(1, 1, 1, 1));
            const osg::Vec4d uv =
                element(geometry.getTexCoordArray(0), index).value_or(osg::Vec4d());
            triangle.uvs[corner] = osg::Vec2(uv.x(), uv.y());
        }
        const std::array<osg::Vec3d, 3>& c = triangle.cornersWorld;
        // Infinite or NaN where a corner is not finite.
        const double squaredArea = ((c[1] - c[0]) ^ (c[2] - c[0])).length2();
        if (squaredArea > 0.0 && std::isfinite(squaredArea)) _result.triangles.push_back(triangle);
    }

    SceneTriangles& _result;
    osg::Matrixd _worldFromLocal;
    osg::ref_ptr<osg::StateSet> _state = drawnByDefault();
};

// The texel that stands at an index beyond the picture's sides; -1 for the border.
int wrapped(int index, int size, osg::Texture::WrapMode mode)
{
    const auto modulo = [](int a, int b) { return (a % b + b) % b; };
    switch (mode)
    {
    case osg::Texture::REPEAT:
        return modulo(index, size);
    case osg::Texture::MIRROR:
    {
        const int twice = modulo(index, 2 * size);
        return twice < size ? twice : 2 * size - 1 - twice;
    }
    case osg::Texture::CLAMP_TO_BORDER:
        return index < 0 || index >= size ? -1 : index;
    default:
        return std::clamp(index, 0, size - 1);
    }
}

osg::Vec4 texelAt(const osg::Texture2D& texture, int column, int row)
{
    const osg::Image& image = *texture.getImage();
    const int x = wrapped(column, image.s(), texture.getWrap(osg::Texture::WRAP_S));
    const int y = wrapped(row, image.t(), texture.getWrap(osg::Texture::WRAP_T));
    return x < 0 || y < 0 ? osg::Vec4(texture.getBorderColor()) : image.getColor(x, y);
}

} // namespace

SceneTriangles SceneTriangles::collect(osg::Node& scene)
{
    SceneTriangles result;
    CollectTriangles visitor(result);
    scene.accept(visitor);
    return result;
}

osg::Vec4 SceneSurface::texel(const osg::Vec2d& uv) const
{
    const double x = uv.x() * texture->getImage()->s();
    const double y = uv.y() * texture->getImage()->t();
    const double limit = 1e9; // what still is an index
    if (!(std::abs(x) < limit && std::abs(y) < limit)) return osg::Vec4(1, 1, 1, 1);
    if (texture->getFilter(osg::Texture::MAG_FILTER) == osg::Texture::NEAREST)
        return texelAt(*texture, static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));

    // Texel centres lie at halves.
    const int column = static_cast<int>(std::floor(x - 0.5));
    const int row = static_cast<int>(std::floor(y - 0.5));
    const double right = x - 0.5 - column;
    const double upper = y - 0.5 - row;
    const osg::Vec4 below =
        texelAt(*texture, column, row) * (1.0 - right) + texelAt(*texture, column + 1, row) * right;
    const osg::Vec4 above = texelAt(*texture, column, row + 1) * (1.0 - right) +
                            texelAt(*texture, column + 1, row + 1) * right;
    return below * (1.0 - upper) + above * upper;
}
