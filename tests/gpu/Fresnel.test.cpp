// Falls when fresnel.glsl's `perpendicular` loses its eta, or the last line its total reflection.

#include "support/Catch.h"
#include "support/ShaderProbe.h"

#include <cmath>

namespace
{

const double PI = 3.14159265358979323846;

// From Snell's law and the tangent and sine forms of Fresnel's equations: other formulas than
// the shader's.
double exactReflectance(double incident, double eta)
{
    const double sinRefracted = std::sin(incident) / eta;
    if (sinRefracted >= 1.0) return 1.0;
    if (incident < 1e-4) return std::pow((1.0 - eta) / (1.0 + eta), 2.0);
    const double refracted = std::asin(sinRefracted);
    const double perpendicular = std::sin(incident - refracted) / std::sin(incident + refracted);
    const double parallel = std::tan(incident - refracted) / std::tan(incident + refracted);
    return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

// 0 at 90 degrees, where the library's is not.
double cosineOf(double degrees)
{
    return degrees == 90.0 ? 0.0 : std::cos(degrees * PI / 180.0);
}

std::vector<double> reflectances(const std::vector<double>& degrees, double eta)
{
    static ShaderProbe probe("#include \"fresnel.glsl\"\n"
                             "vec4 probe(vec4 first, vec4 second)\n"
                             "{\n"
                             "    return vec4(fresnelReflectance(first.x, first.y));\n"
                             "}\n");
    std::vector<osg::Vec4> inputs;
    for (double angle : degrees)
        inputs.push_back(osg::Vec4(cosineOf(angle), eta, 0, 0));
    std::vector<double> result;
    for (const osg::Vec4& answer : probe.run(inputs))
        result.push_back(answer.x());
    return result;
}

} // namespace

TEST_CASE("water reflects what the tables say, at every angle from 0 to 90 degrees")
{
    // Reflectance of a smooth water surface in percent [Kirk11 table 2.1], for n = 1.33.
    const std::vector<double> angles = {0, 30, 45, 50, 55, 60, 65, 70, 75, 80, 85, 89, 90};
    const std::vector<double> published = {2.0,  2.1,  2.8,  3.3,  4.3,  5.9,  8.6,
                                           13.3, 21.1, 34.7, 58.3, 89.6, 100.0};
    const std::vector<double> shown = reflectances(angles, 1.33);
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
        INFO(angles[i] << " degrees");
        // Half of the last digit that the table gives, and a little for its own rounding.
        CHECK(100.0 * shown[i] == Approx(published[i]).margin(0.06));
    }

    // At n = 1.333: ((n - 1) / (n + 1))^2 straight down; at Brewster's angle, where what is
    // refracted runs at a right angle to what is reflected, half of ((n^2 - 1) / (n^2 + 1))^2.
    // Single precision leaves a millionth.
    const double n = 1.333;
    const double brewster = std::atan(n) * 180.0 / PI;
    CHECK(brewster == Approx(53.1).margin(0.05));
    const std::vector<double> closed = reflectances({0.0, brewster}, n);
    CHECK(closed[0] == Approx(std::pow((n - 1) / (n + 1), 2.0)).margin(1e-6));
    CHECK(closed[1] == Approx(0.5 * std::pow((n * n - 1) / (n * n + 1), 2.0)).margin(1e-6));
}

TEST_CASE("the share reflected is Fresnel's from above and from below, within [0, 1]")
{
    std::vector<double> angles;
    for (int i = 0; i <= 9000; ++i)
        angles.push_back(0.01 * i);
    for (double eta : {1.333, 1.0 / 1.333, 1.0001, 4.0, 0.25})
    {
        const std::vector<double> shown = reflectances(angles, eta);
        double worst = 0.0;
        for (std::size_t i = 0; i < angles.size(); ++i)
        {
            // The shader is given the cosine, in single precision: so is the expectation.
            const double cosine = static_cast<float>(cosineOf(angles[i]));
            const double singleEta = static_cast<float>(eta);
            const double incident = std::acos(cosine);
            // Rounding leaves four units of the last place in sin^2 of the refracted angle, and
            // through the root more in its cosine, the closer to the critical angle; the two
            // quotients hand that on by (2 eta + 2 / eta) / cosine at most.
            const double rounding = 4.0 * 6e-8 / std::min(1.0, eta * eta);
            const double sinRefracted = std::sin(incident) / singleEta;
            const double cosRefracted = std::sqrt(std::abs(1.0 - sinRefracted * sinRefracted));
            const double tolerance = 1e-6 + (2.0 * eta + 2.0 / eta) / std::max(cosine, 0.1) *
                                                rounding / (cosRefracted + std::sqrt(rounding));
            const bool finite = std::isfinite(shown[i]);
            if (!finite || shown[i] < 0.0 || shown[i] > 1.0 + 1e-6)
                FAIL("eta " << eta << ", " << angles[i] << " degrees: " << shown[i]);
            worst = std::max(worst, std::abs(shown[i] - exactReflectance(incident, singleEta)) /
                                        tolerance);
        }
        INFO("eta " << eta);
        CHECK(worst < 1.0);
    }
}

TEST_CASE("from below, water reflects everything beyond 48.6 degrees")
{
    // asin(1 / 1.333) = 48.607 degrees.
    const std::vector<double> shown = reflectances({48.5, 48.62, 50, 70, 89.999, 90}, 1.0 / 1.333);
    CHECK(shown[0] < 0.8);
    for (std::size_t i = 1; i < shown.size(); ++i)
        CHECK(shown[i] == 1.0);
}
