#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"

#include <osgWaterReflect/CompileShaders>
#include <osgWaterReflect/TrochoidalWaves>

#include <osg/Notify>
#include <osg/Program>

#include <mutex>
#include <sstream>
#include <vector>

using osgWaterReflect::CaptureKind;
using osgWaterReflect::CompileShaders;
using osgWaterReflect::TrochoidalWaves;
using osgWaterReflect::WaterSurface;

namespace
{

// Counts the programs that OSG says it links, while it exists.
class CountLinks : public osg::NotifyHandler
{
public:
    void notify(osg::NotifySeverity, const char* message) override
    {
        count += std::string(message).find("Linking osg::Program") != std::string::npos;
    }
    int count = 0;
};

class ListenToLinks
{
public:
    ListenToLinks() : _level(osg::getNotifyLevel()), _handler(osg::getNotifyHandler())
    {
        osg::setNotifyHandler(_counter);
        osg::setNotifyLevel(osg::INFO);
    }
    ~ListenToLinks()
    {
        osg::setNotifyLevel(_level);
        osg::setNotifyHandler(_handler);
    }
    int count() const { return _counter->count; }

private:
    osg::ref_ptr<CountLinks> _counter = new CountLinks;
    osg::NotifySeverity _level;
    osg::ref_ptr<osg::NotifyHandler> _handler;
};

osg::ref_ptr<osg::TextureCubeMap> createSky()
{
    osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    for (unsigned int face = 0; face < 6; ++face)
    {
        osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(1, 1, 1, GL_RGB, GL_UNSIGNED_BYTE);
        sky->setImage(face, image);
    }
    return sky;
}

// Draws two frames with each variant of the water's usual search, calm and without a sky, and of
// others as far as they are asked for.
void drawVariants(OffscreenView& view, bool others)
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    const osg::ref_ptr<osg::Group> root = scenes::together({lake});
    const std::vector<bool> alternatives =
        others ? std::vector<bool>{false, true} : std::vector<bool>{false};
    for (bool wavy : alternatives)
        for (bool sky : alternatives)
            for (auto capture : {CaptureKind::VIEW, CaptureKind::FRAME, CaptureKind::MIRROR,
                                 CaptureKind::VIEW_AND_MIRROR})
                for (double traceScale : {1.0, 0.5})
                {
                    lake->setWaves(wavy ? new TrochoidalWaves : nullptr);
                    lake->setSky(sky ? createSky().get() : nullptr);
                    auto settings = lake->getReflection();
                    settings.capture = capture;
                    settings.traceScale = traceScale;
                    REQUIRE(lake->setReflection(settings));
                    view.render(root);
                    view.render(root);
                }
}

} // namespace

// Breaks where CompileShaders leaves a value of an axis out, or does not keep the programs.
TEST_CASE("after CompileShaders no variant of the water is compiled at its first draw")
{
    OffscreenView view(32, 24);
    const osg::ref_ptr<CompileShaders> compile = new CompileShaders;
    view.viewer().setRealizeOperation(compile);
    {
        const ListenToLinks links;
        view.viewer().realize();
        // 2 waves, 1 or 2 captures, and of these 2 skies of the water, 2 of what samples the small
        // image, 1 for that; 3 of the pyramid, 1 of a mirrored capture, 1 of a copied frame.
        CHECK(links.count() == 25);
    }
    CHECK(compile->getNumCompiled() == 20);
    CHECK(compile->getNumFailed() == 0);
    {
        const ListenToLinks links;
        drawVariants(view, true);
        CHECK(links.count() == 0);
    }
}

// Breaks where SheetPass::setWater sets a new program in each frame.
TEST_CASE("without CompileShaders a variant is compiled at its first draw, and once")
{
    OffscreenView view(32, 24);
    {
        const ListenToLinks links;
        drawVariants(view, false);
        // 1 or 2 captures, and of these the water, what samples the small image and what is for
        // that; 5 more as above.
        CHECK(links.count() == 11);
    }
}

// As a core profile asks for. The scene has a program of its own: fixed functions know nothing of
// generic attributes. A compatibility context keeps GLSL's own names alive beside OSG's, so this
// shows only that OSG's rewriting of them does no harm.
// Breaks where water.vert has a global variable osg_Vertex.
TEST_CASE("water is the same where OSG hands attributes and matrices to shaders by its own names")
{
    const auto createScene = []
    {
        osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(new osg::Shader(osg::Shader::VERTEX, R"glsl(#version 130
            varying vec4 colour;
            void main()
            {
                colour = gl_Color;
                gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);
            })glsl"));
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT, R"glsl(#version 130
            varying vec4 colour;
            out vec4 fragmentColour;
            void main() { fragmentColour = colour; })glsl"));
        const osg::ref_ptr<osg::Group> scene = scenes::together(
            {scenes::createQuad(osg::Vec3(-3, 4, -0.5), osg::Vec3(4, 1, 0), osg::Vec3(0, 0, 3),
                                osg::Vec4(1, 0.3, 0.1, 1)),
             scenes::createQuad(osg::Vec3(2, 3, -0.5), osg::Vec3(3, 0, 0), osg::Vec3(0, 0.5, 4),
                                osg::Vec4(0.1, 0.7, 0.4, 1))});
        scene->getOrCreateStateSet()->setAttribute(program);
        const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
        lake->setWaves(new TrochoidalWaves);
        return scenes::together({scene, lake});
    };
    OffscreenView compatible(160, 120);
    const osg::ref_ptr<osg::Image> expected = copyOf(compatible.render(createScene(), 2.0));

    OffscreenView view(160, 120);
    osg::State& state = *view.camera().getGraphicsContext()->getState();
    state.setUseVertexAttributeAliasing(true);
    state.setUseModelViewAndProjectionUniforms(true);
    state.resetVertexAttributeAlias(true);
    const osg::Image& picture = view.render(createScene(), 2.0);
    keep(picture, "core");
    CHECK(countDifferent(*expected, picture, 1.01 / 255.0) == 0);
}
