// measure_picture FILE [OTHER]
// Prints the picture's width, height and number of colours and, with another of its size, in how
// many pixels they differ.

#include <osgDB/ReadFile>

#include <iostream>
#include <set>

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 3)
    {
        std::cerr << "usage: measure_picture FILE [OTHER]" << std::endl;
        return 1;
    }
    const osg::ref_ptr<osg::Image> picture = osgDB::readRefImageFile(argv[1]);
    const osg::ref_ptr<osg::Image> other = osgDB::readRefImageFile(argv[argc - 1]);
    if (!picture || !other || picture->s() != other->s() || picture->t() != other->t()) return 1;

    std::set<osg::Vec4> colours;
    unsigned int differences = 0;
    for (int y = 0; y < picture->t(); ++y)
        for (int x = 0; x < picture->s(); ++x)
        {
            const osg::Vec4 colour = picture->getColor(x, y);
            colours.insert(colour);
            if (colour != other->getColor(x, y)) ++differences;
        }
    std::cout << picture->s() << " " << picture->t() << " " << colours.size();
    if (argc == 3) std::cout << " " << differences;
    std::cout << std::endl;
}
