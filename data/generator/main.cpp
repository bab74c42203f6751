#include "LakeScene.h"
#include "StreetScene.h"

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>
#include <osgDB/WriteFile>

#include <exception>
#include <iostream>
#include <stdexcept>

namespace
{

void write(const osg::Node& scene, const std::string& file)
{
    osg::ref_ptr<osgDB::Options> options =
        new osgDB::Options("Compressor=zlib WriteImageHint=IncludeFile");
    if (!osgDB::writeNodeFile(scene, file, options))
        throw std::runtime_error("cannot write " + file);
    std::cout << "wrote " << file << std::endl;
}

}

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        std::cerr << "usage: osgwaterdata OUTPUT_DIRECTORY" << std::endl;
        return 1;
    }
    const std::string directory = argv[1];
    try
    {
        if (osgDB::fileType(directory) != osgDB::DIRECTORY)
            throw std::runtime_error(directory + " is not a directory");
        // The writer looks there for the sky pictures, to put their files' bytes into the scenes.
        osgDB::getDataFilePathList().push_front(directory);
        write(*waterdata::lakeScene(directory), osgDB::concatPaths(directory, "lake.osgb"));
        write(*waterdata::streetScene(directory), osgDB::concatPaths(directory, "street.osgb"));
    }
    catch (const std::exception& problem)
    {
        std::cerr << "osgwaterdata: " << problem.what() << std::endl;
        return 1;
    }
    return 0;
}
