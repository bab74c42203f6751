// The table of all settings is complete, and what reads it treats all settings alike. What the
// ranges ought to be, Settings.test.cpp says.

#include "support/AnySettings.h"
#include "support/Catch.h"
#include "support/Refusals.h"
#include "support/WaterAccess.h"

#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

using namespace osgWaterReflect;

namespace
{

using AllSettings = std::tuple<ReflectionSettings, ViewSettings, WaterOptics, SurfaceDetail>;

osg::ref_ptr<WaterSurface> someWater()
{
    return WaterSurface::createRectangle(osg::Vec3(0, 0, 0), osg::Vec3(10, 0, 0),
                                         osg::Vec3(0, 10, 0));
}

template <typename Settings, typename Value>
std::string fullName(const Member<Settings, Value>& member)
{
    return std::string(MEMBERS<Settings>.structName) + "::" + member.name;
}

// A member's value at the edge of what it may be, and just beyond. A colour's is grey.
template <typename Value>
struct Edge
{
    Value inside;
    Value outside;
};

template <typename Value>
Value next(Value value, int direction)
{
    if constexpr (std::is_same_v<Value, osg::Vec3>)
        return osg::Vec3(1, 1, 1) * next(value.x(), direction);
    else if constexpr (std::is_integral_v<Value>)
        return value + direction;
    else
        return std::nextafter(value, direction * std::numeric_limits<Value>::infinity());
}

template <typename Value>
Value of(double number)
{
    if constexpr (std::is_same_v<Value, osg::Vec3>)
        return osg::Vec3(number, number, number);
    else
        return static_cast<Value>(number);
}

template <typename Value>
std::vector<Edge<Value>> edgesOf(const Range& range)
{
    const auto lowest = of<Value>(range.lowest);
    const auto highest = of<Value>(range.highest);
    return {range.lowestIncluded ? Edge<Value>{lowest, next(lowest, -1)}
                                 : Edge<Value>{next(lowest, 1), lowest},
            {highest, next(highest, 1)}};
}

template <typename Value>
std::vector<Edge<Value>> edgesOf(const Enumeration<Value>& choice)
{
    return {{choice.values.begin()->value, static_cast<Value>(0)},
            {(choice.values.end() - 1)->value, static_cast<Value>(choice.values.size() + 1)}};
}

// Independent of what check() asks.
bool mayBe(const Range& range, double value)
{
    const bool lowEnough = std::isfinite(value) && value <= range.highest;
    return lowEnough && (range.lowestIncluded ? value >= range.lowest : value > range.lowest);
}

bool mayBe(const Range& range, const osg::Vec3& colour)
{
    return mayBe(range, colour.x()) && mayBe(range, colour.y()) && mayBe(range, colour.z());
}

template <typename Enum>
bool mayBe(const Enumeration<Enum>& choice, Enum value)
{
    const int number = static_cast<int>(value);
    return number >= 1 && number <= static_cast<int>(choice.values.size());
}

} // namespace

// Falls where a line has another line's member, which a copied line may keep. That no line is
// missing, the compiler sees: forEachMember asserts it.
TEMPLATE_LIST_TEST_CASE("each member of the settings has a line of its own, and says what it is",
                        "", AllSettings)
{
    std::set<std::string> names;
    std::set<const void*> places;
    std::size_t lines = 0;
    const TestType settings;
    forEachMember<TestType>(
        [&](const auto& member)
        {
            INFO(member.name);
            ++lines;
            names.insert(member.name);
            places.insert(&(settings.*member.pointer));
            CHECK(std::strlen(member.unit) > 0);
            const std::string sentence = member.sentence;
            CHECK(std::isupper(static_cast<unsigned char>(sentence.front())));
            CHECK(sentence.back() == '.');
        });
    CHECK(names.size() == lines);
    CHECK(places.size() == lines);
}

TEMPLATE_LIST_TEST_CASE("the default settings are within their ranges", "", AllSettings)
{
    Refusals refusals;
    CHECK(TestType().check());
    CHECK(refusals.take().empty());
}

// Falls when contains() takes NaN or takes a bound for excluded or included that is not.
TEMPLATE_LIST_TEST_CASE(
    "a setting is taken up to the edge of its range, and refused by name beyond", "", AllSettings)
{
    const osg::ref_ptr<WaterSurface> water = someWater();
    Refusals refusals;
    forEachMember<TestType>(
        [&](const auto& member)
        {
            INFO(member.name);
            using Value = std::decay_t<decltype(TestType().*member.pointer)>;
            for (const Edge<Value>& edge : edgesOf<Value>(member.choice))
            {
                TestType settings;
                settings.*member.pointer = edge.inside;
                CHECK(setSettings(*water, settings));
                CHECK(refusals.take().empty());
                CHECK(getSettings<TestType>(*water) == settings);

                TestType beyond = settings;
                beyond.*member.pointer = edge.outside;
                CHECK_FALSE(setSettings(*water, beyond));
                CHECK(isRefusalOf(fullName(member), refusals.take()));
                CHECK(getSettings<TestType>(*water) == settings);
            }
        });
}

// Falls where equalMembers leaves out a member.
TEMPLATE_LIST_TEST_CASE("settings that differ in one member are not equal", "", AllSettings)
{
    Chance chance(1);
    const TestType settings;
    CHECK(settings == TestType());
    CHECK_FALSE(settings != TestType());
    forEachMember<TestType>(
        [&](const auto& member)
        {
            INFO(member.name);
            using Value = std::decay_t<decltype(settings.*member.pointer)>;
            TestType changed;
            while (changed.*member.pointer == settings.*member.pointer)
                changed.*member.pointer = valueWithin<Value>(member.choice, chance);
            CHECK(changed != settings);
            CHECK_FALSE(changed == settings);
        });
}

// Falls where the copy constructor leaves out one of the structs.
TEMPLATE_LIST_TEST_CASE("a copy of a water surface has all its settings", "", AllSettings)
{
    Chance chance(2);
    const osg::ref_ptr<WaterSurface> water = someWater();
    for (int i = 0; i < 20; ++i)
    {
        const auto settings = goodSettings<TestType>(chance);
        REQUIRE(setSettings(*water, settings));
        const osg::ref_ptr<WaterSurface> copy = new WaterSurface(*water);
        CHECK(getSettings<TestType>(*copy) == settings);
    }
}

// Falls where check() lets a member pass, stops before the last, or names another.
TEMPLATE_LIST_TEST_CASE("of random settings each is refused by name, or is within its range", "",
                        AllSettings)
{
    const osg::ref_ptr<WaterSurface> water = someWater();
    Chance chance(3);
    Refusals refusals;
    int taken = 0;
    int otherwise = 0;
    std::set<std::string> refused;
    for (int i = 0; i < 25000; ++i)
    {
        const auto before = getSettings<TestType>(*water);
        const auto settings = anySettings<TestType>(chance);
        std::string wrong; // the first member that is
        forEachMember<TestType>(
            [&](const auto& member)
            {
                if (wrong.empty() && !mayBe(member.choice, settings.*member.pointer))
                    wrong = fullName(member);
            });
        const bool accepted = setSettings(*water, settings);
        const std::string message = refusals.take();
        taken += accepted;
        refused.insert(wrong);
        otherwise += accepted != wrong.empty() ||
                     !(accepted ? message.empty() : isRefusalOf(wrong, message)) ||
                     getSettings<TestType>(*water) != (accepted ? settings : before);
    }
    CHECK(taken > 5000);
    CHECK(taken < 20000);
    CHECK(otherwise == 0);
    forEachMember<TestType>([&](const auto& member)
                            { CHECK(refused.count(fullName(member)) == 1); });
}
