#include "Options.h"

#include "Complain.h"
#include "SettingsReader.h"

#include <osg/ApplicationUsage>

using namespace osgwaterviewer;

namespace
{

unsigned int readHelp(OptionReader& reader)
{
    unsigned int help = 0;
    if (reader.readFlag("--help", "List the options, with their defaults in brackets.") |
        reader.readFlag("-h", "The same as --help."))
        help |= osg::ApplicationUsage::COMMAND_LINE_OPTION;
    if (reader.readFlag("--help-env", "List the environment variables."))
        help |= osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE;
    if (reader.readFlag("--help-keys", "List the keys."))
        help |= osg::ApplicationUsage::KEYBOARD_MOUSE_BINDING;
    if (reader.readFlag("--help-all", "List all of these."))
        help |= osg::ApplicationUsage::COMMAND_LINE_OPTION |
                osg::ApplicationUsage::ENVIRONMENTAL_VARIABLE |
                osg::ApplicationUsage::KEYBOARD_MOUSE_BINDING;
    return help;
}

std::optional<WaterLevel> readWaterLevel(OptionReader& reader)
{
    std::string text;
    if (!reader.read("--water", "LEVEL|auto",
                     "Lay water through the models at this world z, or at a tenth of their height. "
                     "Where there is no other, --thickness and --wave-length are scaled to the "
                     "models unless they are given.",
                     "none", text))
        return std::nullopt;
    WaterLevel level;
    double z = 0.0;
    if (parseNumber(text, z))
        level.z = z;
    else if (text != "auto")
        reader.refuse("--water", "a finite number or auto", text);
    return level;
}

std::optional<std::string> readSky(OptionReader& reader)
{
    std::optional<std::string> directory;
    std::string text;
    if (reader.read("--sky", "DIRECTORY",
                    "What the water reflects where there is nothing else: the cube map of the "
                    "pictures posx, negx, posy, negy, posz (overhead) and negz.",
                    "the lake's and the street's own, none for other models", text))
    {
        if (text.empty()) reader.refuse("--sky", "DIRECTORY", "an empty name");
        directory = text;
    }
    if (reader.readFlag("--no-sky", "Let the water reflect the background that is drawn."))
    {
        if (directory) reader.refuse("--no-sky", "no --sky beside it", "both");
        directory = "";
    }
    return directory;
}

std::optional<HomeView> readCamera(OptionReader& reader)
{
    std::string text;
    if (!reader.read("--camera", "ex,ey,ez,cx,cy,cz",
                     "Put the eye at e and look at c, in world units.", "all is seen", text))
        return std::nullopt;
    std::vector<double> values(6);
    if (!parseNumbers(text, ',', values))
        reader.refuse("--camera", "six finite numbers with commas between", text);
    const HomeView view{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
    if (view.eye == view.centre) reader.refuse("--camera", "an eye apart from the centre", text);
    return view;
}

std::optional<double> readFovy(OptionReader& reader)
{
    double fovyDegrees = 0.0;
    std::string text;
    if (!reader.read("--fovy", "DEGREES", "Vertical field of view.", "the scene's own", text))
        return std::nullopt;
    if (!parseNumber(text, fovyDegrees) || fovyDegrees <= 0.0 || fovyDegrees >= 180.0)
        reader.refuse("--fovy", "a number above 0 and below 180", text);
    return fovyDegrees;
}

void readLook(OptionReader& reader, WaterLook& look)
{
    readSettings(reader, look.reflection);
    readSettings(reader, look.viewSettings);
    readSettings(reader, look.optics);
    readSettings(reader, look.detail);
    look.thicknessGiven = reader.isGiven("--thickness");
    reader.readName("--debug-view", "What is shown in place of the water.", DEBUG_VIEWS,
                    look.debugView);
}

void readBreeze(OptionReader& reader, WaterLook& look)
{
    Breeze& breeze = look.breeze;
    look.moving = reader.readNumber("--waves", "STEEPNESS",
                                    "Begin with moving water: sum of wave number times amplitude, "
                                    "above 0 and below 1. The default is that of the waves' key.",
                                    breeze.steepness);
    look.waveLengthGiven =
        reader.readNumber("--wave-length", "METRES", "Length of the longest wave.", breeze.length);
    reader.readNumber("--wave-direction", "DEGREES", "Where the waves travel, from x toward y.",
                      breeze.directionDegrees);
}

void readPicture(OptionReader& reader, Picture& picture)
{
    const bool wanted =
        reader.read("--offscreen", "FILE.png",
                    "Render a picture without any display, in place of opening a window.", "none",
                    picture.file);
    if (wanted && picture.file.empty()) reader.refuse("--offscreen", "FILE.png", "an empty name");
    const auto needsPicture = [&](const std::string& name, bool given)
    {
        if (given && !wanted) reader.refuse(name, "--offscreen FILE.png beside it", "none");
    };

    std::string text;
    const bool sizeGiven =
        reader.read("--size", "WxH", "Size of the picture in pixels.",
                    std::to_string(picture.width) + "x" + std::to_string(picture.height), text);
    needsPicture("--size", sizeGiven);
    std::vector<int> size = {picture.width, picture.height};
    if (sizeGiven && (!parseNumbers(text, 'x', size) || size[0] < 1 || size[1] < 1))
        reader.refuse("--size", "two whole numbers above 0 with an x between", text);
    picture.width = size[0];
    picture.height = size[1];

    needsPicture("--time", reader.readNumber("--time", "SECONDS", "Simulation time of the picture.",
                                             picture.time));
    needsPicture("--frames",
                 reader.readNumber("--frames", "COUNT", "Frames whose median time is reported.",
                                   picture.frames));
    if (picture.frames < 1)
        reader.refuse("--frames", "a number above 0", std::to_string(picture.frames));
}

} // namespace

std::optional<Options> osgwaterviewer::readOptions(osg::ArgumentParser& arguments)
{
    OptionReader reader(arguments);
    Options options;
    options.help = readHelp(reader);
    options.waterLevel = readWaterLevel(reader);
    options.skyDirectory = readSky(reader);
    options.camera = readCamera(reader);
    options.fovyDegrees = readFovy(reader);
    reader.read("-p", "FILE", "Follow the camera path that was recorded with the z key.", "none",
                options.pathFile);
    readLook(reader, options.look);
    readPicture(reader, options.picture);
    readBreeze(reader, options.look);
    options.models = reader.takeFiles();

    if (options.help) return options;
    if (!reader.getMistake().empty())
    {
        complain(reader.getMistake());
        return std::nullopt;
    }
    if (!options.look.check()) return std::nullopt;
    return options;
}
