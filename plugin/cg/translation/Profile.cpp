#include "cg/translation/Profile.h"

#include <unordered_map>

namespace Lixel::Cg {

std::optional<Profile> profileOf(std::string_view name) {
    constexpr Profile OldVertex = {Stage::Vertex, true, {}};
    constexpr Profile Vertex = {Stage::Vertex, false, {}};
    constexpr Profile Fragment = {Stage::Fragment, false, {}};
    static const std::unordered_map<std::string_view, Profile> profiles = {
        {"arbvp1", OldVertex},
        {"vp20", OldVertex},
        {"vp30", OldVertex},
        {"vs_1_1", OldVertex},
        {"vs_2_0", OldVertex},
        {"vs_2_x", OldVertex},
        {"vs_2_a", OldVertex},
        {"vs_2_sw", OldVertex},
        {"vp40", Vertex},
        {"gp4vp", Vertex},
        {"gp5vp", Vertex},
        {"glslv", Vertex},
        {"hlslv", Vertex},
        {"vs_3_0", Vertex},
        {"vs_3_sw", Vertex},
        {"vs_4_0", Vertex},
        {"vs_4_0_level_9_1", Vertex},
        {"vs_4_0_level_9_3", Vertex},
        {"vs_4_1", Vertex},
        {"vs_5_0", Vertex},
        {"arbfp1", Fragment},
        // A slip in Chong's article that scripts have copied.
        {"arbf1", Fragment},
        {"fp20", Fragment},
        {"fp30", Fragment},
        {"fp40", Fragment},
        {"gp4fp", Fragment},
        {"gp5fp", Fragment},
        {"glslf", Fragment},
        {"hlslf", Fragment},
        {"ps_1_1", Fragment},
        {"ps_1_2", Fragment},
        {"ps_1_3", Fragment},
        {"ps_1_4", Fragment},
        {"ps_2_0", Fragment},
        {"ps_2_x", Fragment},
        {"ps_2_a", Fragment},
        {"ps_2_b", Fragment},
        {"ps_2_sw", Fragment},
        {"ps_3_0", Fragment},
        {"ps_3_sw", Fragment},
        {"ps_4_0", Fragment},
        {"ps_4_0_level_9_1", Fragment},
        {"ps_4_0_level_9_3", Fragment},
        {"ps_4_1", Fragment},
        {"ps_5_0", Fragment},
    };
    const auto profile = profiles.find(name);
    if (profile == profiles.end()) return {};
    Profile result = profile->second;
    result.name = profile->first;
    return result;
}

} // namespace Lixel::Cg
