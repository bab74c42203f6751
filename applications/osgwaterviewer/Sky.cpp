#include "Sky.h"

#include "Complain.h"

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <iterator>

using namespace osgwaterviewer;

namespace
{

// In the order of osg::TextureCubeMap::Face.
const char* const FACES[] = {"posx", "negx", "posy", "negy", "posz", "negz"};

// Null where there is no such picture.
osg::ref_ptr<osg::Image> readFace(const std::string& directory, const std::string& face)
{
    for (const std::string& file : osgDB::getDirectoryContents(directory))
    {
        if (osgDB::getNameLessExtension(file) != face) continue;
        osgDB::ReaderWriter::ReadResult result =
            osgDB::Registry::instance()->readImage(osgDB::concatPaths(directory, file), nullptr);
        if (result.validImage()) return result.getImage();
    }
    return nullptr;
}

} // namespace

osg::ref_ptr<osg::TextureCubeMap> osgwaterviewer::readSky(const std::string& directory)
{
    osg::ref_ptr<osg::TextureCubeMap> sky = new osg::TextureCubeMap;
    int side = 0;
    for (unsigned int face = 0; face < std::size(FACES); ++face)
    {
        const osg::ref_ptr<osg::Image> image = readFace(directory, FACES[face]);
        if (!image)
        {
            complain("sky: expected a picture " + osgDB::concatPaths(directory, FACES[face]) +
                     ".*, got none that can be read");
            return nullptr;
        }
        if (side == 0) side = image->s();
        if (image->s() != side || image->t() != side)
        {
            complain("sky: expected square pictures of one size, got another one from " +
                     image->getFileName());
            return nullptr;
        }
        sky->setImage(face, image);
    }
    sky->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    sky->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    for (osg::Texture::WrapParameter wrap :
         {osg::Texture::WRAP_S, osg::Texture::WRAP_T, osg::Texture::WRAP_R})
        sky->setWrap(wrap, osg::Texture::CLAMP_TO_EDGE);
    return sky;
}
