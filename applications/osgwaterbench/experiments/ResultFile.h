#ifndef OSGWATERBENCH_RESULTFILE_H
#define OSGWATERBENCH_RESULTFILE_H

#include <nlohmann/json.hpp>

#include <string>

namespace osgwaterbench
{

using Json = nlohmann::ordered_json;

/// The results of one experiment: where and when they were found, and a row for each measurement.
class ResultFile
{
public:
    /// experiment  names the file, EXPERIMENT.json
    ///   conditions  what holds for all rows: the sizes, frames and so on
    ResultFile(const std::string& experiment, const Json& conditions);

    void add(const Json& row) { _content["rows"].push_back(row); }
    const Json& rows() const { return _content["rows"]; }

    /// Into a directory, which is made where it is missing. False, with a message, where it cannot
    /// be written.
    bool write(const std::string& directory) const;

private:
    std::string _experiment;
    Json _content;
};

/// What renders, asked of a context of its own: renderer, version, and the way that time is taken.
Json describeMachine();

} // namespace osgwaterbench

#endif
