#pragma once

#include <osg/Array>

namespace waterdata
{

// An array of one value, for binding it to a whole geometry.
template <typename ArrayType>
osg::ref_ptr<ArrayType> only(const typename ArrayType::ElementDataType& value)
{
    osg::ref_ptr<ArrayType> array = new ArrayType;
    array->push_back(value);
    return array;
}

}
