#include "support/Catch.h"
#include "support/OffscreenView.h"
#include "support/Scenes.h"
#include "support/StandingWave.h"

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
using osgWaterReflect::WaveModel;

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
                    REQUIRE(lake->setReflection(settings));
                    auto viewSettings = lake->getViewSettings();
                    viewSettings.traceScale = traceScale;
                    REQUIRE(lake->setViewSettings(viewSettings));
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
        // image, 1 for that; 3 of the pyramid, 1 of the sky, 1 of a mirrored capture, 1 of a
        // copied frame.
        CHECK(links.count() == 26);
    }
    CHECK(compile->getNumCompiled() == 20);
    CHECK(compile->getNumFailed() == 0);
    {
        const ListenToLinks links;
        drawVariants(view, true);
        CHECK(links.count() == 0);
    }
}

// Breaks where KeptProgram::set sets a new program in each frame.
TEST_CASE("without CompileShaders a variant is compiled at its first draw, and once")
{
    OffscreenView view(32, 24);
    {
        const ListenToLinks links;
        drawVariants(view, false);
        // 1 or 2 captures, and of these the water, what samples the small image and what is for
        // that; 6 more as above.
        CHECK(links.count() == 12);
    }
}

namespace
{

// Number of programs that are linked in two frames of a scene.
int countLinks(OffscreenView& view, osg::Node* scene)
{
    const ListenToLinks links;
    view.render(scene);
    view.render(scene);
    return links.count();
}

osg::ref_ptr<WaterSurface> createLakeWith(CaptureKind capture, double traceScale, WaveModel* waves,
                                          osg::TextureCubeMap* sky)
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    auto settings = lake->getReflection();
    settings.capture = capture;
    REQUIRE(lake->setReflection(settings));
    auto viewSettings = lake->getViewSettings();
    viewSettings.traceScale = traceScale;
    REQUIRE(lake->setViewSettings(viewSettings));
    lake->setWaves(waves);
    lake->setSky(sky);
    return lake;
}

} // namespace

// Breaks where CompileShaders leaves one of them out, compiles for a cube map that no water has, or
// counts a water twice.
TEST_CASE("for a scene CompileShaders compiles what drawing it would, and no more")
{
    const osg::ref_ptr<TrochoidalWaves> breeze = TrochoidalWaves::createBreeze(2.0, 0.1);
    const osg::ref_ptr<osg::TextureCubeMap> sky = createSky();
    const osg::ref_ptr<WaterSurface> debugged =
        createLakeWith(CaptureKind::VIEW, 1.0, nullptr, nullptr);
    debugged->setDebugView(WaterSurface::DebugView::REASON);
    const osg::ref_ptr<osg::Group> scenesOf[] = {
        scenes::together({createLakeWith(CaptureKind::VIEW, 1.0, nullptr, nullptr)}),
        scenes::together({createLakeWith(CaptureKind::VIEW, 0.5, breeze, sky)}),
        scenes::together({createLakeWith(CaptureKind::FRAME, 1.0, new StandingWave, nullptr)}),
        scenes::together({createLakeWith(CaptureKind::MIRROR, 1.0, nullptr, sky)}),
        scenes::together({createLakeWith(CaptureKind::VIEW_AND_MIRROR, 0.5, breeze, nullptr),
                          createLakeWith(CaptureKind::VIEW, 1.0, nullptr, sky),
                          createLakeWith(CaptureKind::VIEW, 1.0, nullptr, sky)}),
        scenes::together({debugged}),
        scenes::together({scenes::createHarbour()})};
    for (const osg::ref_ptr<osg::Group>& scene : scenesOf)
    {
        INFO("scene " << &scene - scenesOf);
        int needed = 0;
        {
            OffscreenView view(32, 24);
            needed = countLinks(view, scene);
        }
        OffscreenView view(32, 24);
        const osg::ref_ptr<CompileShaders> compile = new CompileShaders(scene);
        view.viewer().setRealizeOperation(compile);
        {
            const ListenToLinks links;
            view.viewer().realize();
            CHECK(links.count() == needed);
        }
        CHECK(compile->getNumFailed() == 0);
        CHECK(countLinks(view, scene) == 0);
    }
}

// Breaks where CompileShaders takes AUTOMATIC for one of its outcomes, or leaves out the steps that
// a frame time leads to.
TEST_CASE("for a scene that leaves its settings open CompileShaders compiles each outcome")
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    REQUIRE(lake->setReflection(osgWaterReflect::ReflectionSettings()));
    osgWaterReflect::ViewSettings settings;
    settings.frameTimeTarget = 1e-3; // never met
    REQUIRE(lake->setViewSettings(settings));
    lake->setWaves(TrochoidalWaves::createBreeze(2.0, 0.1));
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});

    OffscreenView view(32, 24);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<CompileShaders> compile = new CompileShaders(root);
    view.viewer().setRealizeOperation(compile);
    view.viewer().realize();
    // Two captures and one; and of one, for there is no time for two by then, what samples the
    // small image and what is for that.
    CHECK(compile->getNumCompiled() == 4);
    CHECK(compile->getNumFailed() == 0);
    int links = 0;
    for (int frame = 0; frame < 60; ++frame)
        links += countLinks(view, root);
    CHECK(links == 0);
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
