#pragma once

#include <osg/Vec3>

namespace waterdata
{

// Smooth value noise in -1..1, one feature per unit of length.
float noise(const osg::Vec3& point);

// Octaves of noise, each of half the size and strength; about -1..1.
float fractalNoise(const osg::Vec3& point, int octaves);

// Sharp crests, like mountain ridges; 0..1.
float ridgeNoise(const osg::Vec3& point, int octaves);

float smoothStep(float low, float high, float value);
float mix(float a, float b, float share);
osg::Vec3 mix(const osg::Vec3& a, const osg::Vec3& b, float share);

}
