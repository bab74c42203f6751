// Waves that are not the library's own: what docs/extending.md shows, and what must not harm.

#include "support/Catch.h"
#include "support/FlatState.h"
#include "support/OffscreenView.h"
#include "support/Refusals.h"
#include "support/Scenes.h"
#include "support/ShaderProbe.h"
#include "support/StandingWave.h"
#include "support/WholeFile.h"

#include <osgWaterReflect/WaterSurface>

#include <random>

using osgWaterReflect::ShaderPiece;
using osgWaterReflect::WaterSurface;
using osgWaterReflect::WaveModel;

namespace
{

// Still water, as far as the CPU can tell, with any piece.
class PieceOnly : public WaveModel
{
public:
    PieceOnly() = default;
    explicit PieceOnly(const ShaderPiece* piece) : _piece(piece) {}
    PieceOnly(const PieceOnly& rhs, const osg::CopyOp& copyop) :
        WaveModel(rhs, copyop), _piece(rhs._piece)
    {
    }
    META_Object(test, PieceOnly)

    osg::ref_ptr<const osgWaterReflect::WaveState> createState(double) const override
    {
        return new FlatState;
    }
    double getAmplitude() const override { return 0.0; }
    double getMaxSlope() const override { return 0.0; }
    double getShortestLength() const override { return 1.0; }
    double getChordError(double) const override { return 0.0; }
    const ShaderPiece* getShaderPiece() const override { return _piece; }

protected:
    ~PieceOnly() override = default;

private:
    osg::ref_ptr<const ShaderPiece> _piece;
};

osg::ref_ptr<osg::Image> pictureWith(WaveModel* waves, double traceScale = 1.0)
{
    const osg::ref_ptr<WaterSurface> lake = scenes::createLake();
    lake->setWaves(waves);
    osgWaterReflect::ViewSettings settings = lake->getViewSettings();
    settings.traceScale = traceScale;
    REQUIRE(lake->setViewSettings(settings));
    OffscreenView view(160, 120);
    view.look(scenes::HARBOUR_EYE, scenes::HARBOUR_CENTRE);
    const osg::ref_ptr<osg::Group> root = scenes::together({scenes::createHarbour(), lake});
    const double time = 0.7; // [s] half a period of a StandingWave, at its highest
    view.render(root, time);
    return copyOf(view.render(root, time));
}

} // namespace

// Falls when StandingWave's piece has cos for sin in its slope.
TEST_CASE("the documented wave model is the same on both sides")
{
    const osg::ref_ptr<StandingWave> waves = new StandingWave;
    osgWaterReflect::ShaderSlots slots;
    slots.waves = waves->getShaderPiece();
    ShaderProbe probe("#include \"waves.glsl\"\n"
                      "vec4 probe(vec4 first, vec4 second)\n"
                      "{\n"
                      "    return vec4(normalOf(waveSlope(first.xy, second.xy, second.zw).mean),\n"
                      "                waveHeight(first.xy));\n"
                      "}\n",
                      slots);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> anywhere(-20.0f, 20.0f);
    std::vector<osg::Vec4> places;
    for (int i = 0; i < 1000; ++i)
        places.push_back(osg::Vec4(anywhere(random), anywhere(random), 0, 0));
    const osg::Vec2d anchor(1234.5, -77.0);
    for (const double time : {0.0, 0.4, 7.0})
    {
        waves->createState(time)->apply(probe.stateSet(), anchor);
        const std::vector<osg::Vec4> answers = probe.run(places);
        double highest = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            const osg::Vec2d place = anchor + osg::Vec2d(places[i].x(), places[i].y());
            const osg::Vec3d normal(answers[i].x(), answers[i].y(), answers[i].z());
            // Single precision of phases of some tens of radians.
            REQUIRE((normal - waves->getNormal(place, time)).length() < 1e-5);
            REQUIRE(std::abs(answers[i].w() - waves->getHeight(place, time)) < 1e-6);
            highest = std::max<double>(highest, std::abs(answers[i].w()));
        }
        CHECK(highest <= waves->getAmplitude());
    }
}

// Falls when its piece is not looked at: the picture is then that of calm water.
TEST_CASE("water has waves of a model from outside the library")
{
    Refusals refusals;
    const osg::ref_ptr<osg::Image> calm = pictureWith(nullptr);
    const osg::ref_ptr<osg::Image> standing = pictureWith(new StandingWave);
    keep(*standing, "standing-wave");
    CHECK(refusals.take().empty());
    CHECK(countDifferent(*calm, *standing, 0.02) > 160 * 120 / 20);
}

// Falls when SharedProgram throws on, or WaveProgram leaves the water to fixed functions.
TEST_CASE("water whose waves give no piece that compiles is drawn calm, and the piece is named")
{
    const osg::ref_ptr<osg::Image> calm = pictureWith(nullptr);
    const osg::ref_ptr<osg::Image> calmTraced = pictureWith(nullptr, 0.5);
    const std::string functions = "float waveHeight(vec2 p) { return 0.2; }\n"
                                  "float highestWave() { return 0.2; }\n";
    const struct
    {
        const char* what;
        const char* name;
        osg::ref_ptr<const ShaderPiece> piece;
    } cases[] = {{"nothing", "test::PieceOnly", nullptr},
                 {"another piece that there is not", "waves_gone.glsl",
                  new ShaderPiece("waves_gone.glsl", functions + "#include \"gone.glsl\"\n")},
                 {"no slope", "waves_without_slope.glsl",
                  new ShaderPiece("waves_without_slope.glsl", functions)},
                 {"what is no GLSL", "waves_of_words.glsl",
                  new ShaderPiece("waves_of_words.glsl", "The waves are high.\n")}};
    for (const auto& broken : cases)
        for (const double traceScale : {1.0, 0.5})
        {
            INFO(broken.what << ", trace scale " << traceScale);
            Refusals refusals;
            const osg::ref_ptr<osg::Image> picture =
                pictureWith(new PieceOnly(broken.piece), traceScale);
            // Its mesh has another anchor than that of calm water, and rounds another way: at an
            // edge of the small image a pixel may be traced otherwise.
            CHECK(countDifferent(traceScale < 1.0 ? *calmTraced : *calm, *picture) <=
                  (traceScale < 1.0 ? 2 : 0));
            // Once; OSG adds what the compiler says.
            const std::string message = refusals.take();
            const std::size_t at = message.find("WaveModel::getShaderPiece: expected ");
            CHECK((at != std::string::npos) == (traceScale == 1.0));
            if (at == std::string::npos) continue;
            CHECK(message.find(broken.name, at) != std::string::npos);
            CHECK(message.find("WaveModel::getShaderPiece", at + 1) == std::string::npos);
        }
}

// Falls when either is changed alone.
TEST_CASE("docs/extending.md has the wave model word for word")
{
    const std::string header = wholeFile("tests/support/StandingWave.h");
    const std::size_t first = header.find("#include <osgWaterReflect/WaveModel>");
    const std::size_t last = header.rfind("};\n") + 3;
    REQUIRE(first < last);
    const std::string quoted = "```cpp\n" + header.substr(first, last - first) + "```\n";
    CHECK(wholeFile("docs/extending.md").find(quoted) != std::string::npos);
}
