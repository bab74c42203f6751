#include "ShaderSlots.h"

#include "ShaderSource.h"

#include <stdexcept>

using namespace osgWaterReflect;

std::vector<ShaderSlots::Piece> ShaderSlots::in(const std::string& slot) const
{
    const auto oneOf = [](const Piece& given, const char* file)
    { return std::vector<Piece>{given ? given : Piece(libraryPiece(file))}; };
    if (slot == "waves") return oneOf(waves, "waves_calm.glsl");
    if (slot == "search") return oneOf(search, "search_hierarchical.glsl");
    if (slot == "sky") return oneOf(sky, "sky_captured.glsl");
    if (slot == "body") return oneOf(body, "water_colour.glsl");
    if (slot == "over") return over;
    throw std::runtime_error("shader slot " + slot + ": expected a slot of ShaderSlots, got none");
}
