#include "core/scene/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/transfer_function.h"

namespace vvr {
namespace {

/// What a kind of eyes sees of linear RGB, row by row (Machado, Oliveira, Fernandes 2009, severity 1).
struct Eyes {
    const char* name;
    std::array<glm::dvec3, 3> rows;
};

constexpr std::array eyes{
    Eyes{"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    Eyes{"protan",
         {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    Eyes{"deutan",
         {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    Eyes{"tritan",
         {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
};

double linear(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

glm::dvec3 linear(const glm::vec3& colour) {
    return {linear(static_cast<double>(colour.r)), linear(static_cast<double>(colour.g)),
            linear(static_cast<double>(colour.b))};
}

double luminance(const glm::vec3& colour) {
    return glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), linear(colour));
}

/// CIE L*a*b* under D65.
glm::dvec3 lab(const glm::vec3& colour, const Eyes& seen_by) {
    const glm::dvec3 from = linear(colour);
    const auto [r, g, b] = seen_by.rows;
    const glm::dvec3 rgb =
        glm::clamp(glm::dvec3(glm::dot(r, from), glm::dot(g, from), glm::dot(b, from)), glm::dvec3(0), glm::dvec3(1));
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f(glm::dot(glm::dvec3(0.4124564, 0.3575761, 0.1804375), rgb) / 0.95047);
    const double y = f(glm::dot(glm::dvec3(0.2126729, 0.7151522, 0.0721750), rgb));
    const double z = f(glm::dot(glm::dvec3(0.0193339, 0.1191920, 0.9503041), rgb) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double contrast(const glm::vec3& a, const glm::vec3& b) {
    const auto [less, more] = std::minmax({luminance(a), luminance(b)});
    return (more + 0.05) / (less + 0.05);
}

TEST(Themes, AreReadable) {
    for (const scene::Theme& theme : scene::themes()) {
        EXPECT_GT(contrast(theme.ink, theme.background), 7) << theme.name;
        EXPECT_GT(contrast(theme.pale_ink, theme.background), 4.5) << theme.name;
        EXPECT_NO_THROW(scene::find_transfer(std::string(theme.transfer)));
    }
}

TEST(ObjectColours, AllEyesTellThemApart) {
    constexpr double least = 20;  // CIE76; two patches side by side are told apart from 2.3 on
    for (const scene::Theme& theme : scene::themes()) {
        for (const Eyes& by : eyes) {
            for (std::size_t a = 0; a < theme.objects.size(); ++a) {
                for (std::size_t b = 0; b < a; ++b) {
                    EXPECT_GT(glm::distance(lab(theme.objects[a], by), lab(theme.objects[b], by)), least)
                        << theme.name << ", " << by.name << ": " << a << " and " << b;
                }
            }
        }
    }
}

TEST(ObjectColours, AreToldApartInAGreyCopy) {
    constexpr double least = 5;  // of L*
    for (const scene::Theme& theme : scene::themes()) {
        std::array<double, 8> lightness{};
        std::ranges::transform(theme.objects, lightness.begin(),
                               [](const glm::vec3& colour) { return lab(colour, eyes[0]).x; });
        std::ranges::sort(lightness);
        for (std::size_t i = 1; i < lightness.size(); ++i) EXPECT_GT(lightness[i] - lightness[i - 1], least);
        // Few objects take the first colours: those are farther apart.
        const double first = lab(theme.objects[0], eyes[0]).x;
        EXPECT_GT(std::abs(lab(theme.objects[1], eyes[0]).x - first), 4 * least) << theme.name;
    }
}

TEST(ObjectColours, StandOutFromTheBackgroundAndFromWhatIsNobodys) {
    for (const scene::Theme& theme : scene::themes()) {
        const auto chroma = [](const glm::vec3& colour) {
            const glm::dvec3 at = lab(colour, eyes[0]);
            return std::hypot(at.y, at.z);
        };
        for (const glm::vec3& colour : theme.objects) {
            EXPECT_GE(contrast(colour, theme.background), 3) << theme.name;
            EXPECT_GT(chroma(colour), 30) << "grey is for what belongs to no object";
            for (const Eyes& by : eyes) {
                EXPECT_GT(glm::distance(lab(colour, by), lab(theme.unowned, by)), 12) << theme.name << ", " << by.name;
            }
        }
        EXPECT_LT(chroma(theme.unowned), 6) << theme.name;
        EXPECT_LT(contrast(theme.unowned, theme.background), 5) << theme.name;
    }
}

}  // namespace
}  // namespace vvr
