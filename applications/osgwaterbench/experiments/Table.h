#ifndef OSGWATERBENCH_TABLE_H
#define OSGWATERBENCH_TABLE_H

#include <iosfwd>
#include <string>
#include <vector>

namespace osgwaterbench
{

/// A table for a person to read, its columns as wide as they need to be.
class Table
{
public:
    explicit Table(const std::vector<std::string>& header) : _rows{header} {}

    void add(const std::vector<std::string>& row) { _rows.push_back(row); }

    friend std::ostream& operator<<(std::ostream& stream, const Table& table);

private:
    std::vector<std::vector<std::string>> _rows;
};

std::ostream& operator<<(std::ostream& stream, const Table& table);

/// A number with so many decimals.
std::string fixed(double value, int decimals);

} // namespace osgwaterbench

#endif
