#include "support/Catch.h"

#include <osgwaterbench/experiments/ResultFile.h>
#include <osgwaterbench/experiments/Table.h>

#include <fstream>
#include <sstream>

using namespace osgwaterbench;

// Falls when a condition or a row is left out.
TEST_CASE("a result file says what was found, where and when")
{
    ResultFile results("tested", {{"frames", 5}});
    results.add({{"scene", "lake"}, {"trace_ms", 1.5}});
    const std::string directory = OSGWATERREFLECT_TEST_OUTPUT_DIRECTORY "/results";
    REQUIRE(results.write(directory));

    std::ifstream stream(directory + "/tested.json");
    const Json json = Json::parse(stream);
    CHECK(json["experiment"] == "tested");
    CHECK(json["date"].get<std::string>().size() == 10);
    CHECK(!json["commit"].get<std::string>().empty());
    for (const char* key : {"processor", "cores", "renderer", "driver", "clock"})
        CHECK(json["machine"].contains(key));
    CHECK(json["conditions"]["frames"] == 5);
    REQUIRE(json["rows"].size() == 1);
    CHECK(json["rows"][0]["trace_ms"] == 1.5);
}

// Falls when the stream's state is not asked.
TEST_CASE("a result file that cannot be written is told")
{
    CHECK(!ResultFile("tested", {}).write("/proc/no/such/directory"));
}

// Falls when columns are not as wide as their widest cell.
TEST_CASE("a table's columns are aligned")
{
    Table table({"method", "ms"});
    table.add({"a", fixed(1.26, 1)});
    table.add({"longer name", fixed(100.0, 1)});
    std::ostringstream stream;
    stream << table;
    CHECK(stream.str() == "method          ms\n"
                          "a              1.3\n"
                          "longer name  100.0\n");
}
