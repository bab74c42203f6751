#include "Table.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

using namespace osgwaterbench;

std::ostream& osgwaterbench::operator<<(std::ostream& stream, const Table& table)
{
    std::vector<std::size_t> widths;
    for (const auto& row : table._rows)
    {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    }
    // The first column names the row, the others are numbers.
    for (const auto& row : table._rows)
    {
        for (std::size_t i = 0; i < row.size(); ++i)
            stream << (i == 0 ? std::left : std::right)
                   << std::setw(static_cast<int>(widths[i]) + (i == 0 ? 0 : 2)) << row[i];
        stream << "\n";
    }
    return stream << std::flush;
}

std::string osgwaterbench::fixed(double value, int decimals)
{
    std::ostringstream stream;
    stream << std::fixed << std::setprecision(decimals) << value;
    return stream.str();
}
