#ifndef OSGWATERREFLECT_TESTS_SUPPORT_LISTEDEFFECT_H
#define OSGWATERREFLECT_TESTS_SUPPORT_LISTEDEFFECT_H

#include <osgWaterReflect/effects/EffectList.h>

/// The library with one effect more, while it lives: its line at the list's end.
template <typename MoreEffect>
class ListedEffect
{
public:
    ListedEffect() { osgWaterReflect::effectList().push_back(std::make_shared<MoreEffect>()); }
    ~ListedEffect() { osgWaterReflect::effectList().pop_back(); }
    ListedEffect(const ListedEffect&) = delete;
    ListedEffect& operator=(const ListedEffect&) = delete;
};

#endif
