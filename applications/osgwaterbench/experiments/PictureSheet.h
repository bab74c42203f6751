#ifndef OSGWATERBENCH_PICTURESHEET_H
#define OSGWATERBENCH_PICTURESHEET_H

#include "../measures/PictureError.h"

#include <string>
#include <vector>

namespace osgwaterbench
{

/// Where a picture differs from another, from black over red and yellow to white, which stands for
/// a mean difference of a quarter of the range and more. Outside the water it is grey and dim.
Picture errorMap(const Picture& picture, const Picture& truth,
                 const std::vector<std::uint8_t>& isWater);

/// Writes pictures of one size in rows and columns, the first row on top. False, with a message,
/// where that fails.
bool writeSheet(const std::string& file, const std::vector<std::vector<Picture>>& rows);

} // namespace osgwaterbench

#endif
