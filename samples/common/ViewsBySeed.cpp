#include "common/ViewsBySeed.h"

namespace Lixel::Samples {

using Ogre::Vector3;

Vector3 pointIn(const Ogre::AxisAlignedBox& box, Random& random) {
    const Vector3& low = box.getMinimum();
    const Vector3& high = box.getMaximum();
    Vector3 point;
    for (std::size_t i = 0; i < 3; ++i)
        point[i] = random.between(low[i], high[i]);
    return point;
}

void addViews(std::vector<SampleView>& views, const ViewRange& range, int count, Random& random,
              const HeightFunction& ground) {
    const auto onGround = [&](Vector3 point) {
        if (ground) point.y += ground(point.x, point.z);
        return point;
    };
    for (int i = 1; i <= count; ++i) {
        SampleView view;
        view.name = range.name + "-" + std::to_string(i);
        do {
            view.position = onGround(pointIn(range.eyes, random));
            view.target = onGround(pointIn(range.targets, random));
        } while (view.position.distance(view.target) < range.leastDistance);
        view.fovYDegrees = random.between(range.fovYLow, range.fovYHigh);
        view.nearDistance = range.nearDistance;
        view.farDistance = range.farDistance;
        views.push_back(view);
    }
}

std::vector<SampleLight> sunsBySeed(Random& random) {
    // One after the other: the order in which a list's elements take random numbers would matter.
    const auto sun = [&](const std::string& name, float azimuth, float spread, float low,
                         float high) {
        const float turned = azimuth + random.between(-spread, spread);
        return sunlight(name, turned, random.between(low, high));
    };
    std::vector<SampleLight> suns;
    suns.push_back(sun("high", 0.0F, 180.0F, 45.0F, 75.0F));
    suns.push_back(sun("low", 0.0F, 180.0F, 7.0F, 18.0F));
    suns.push_back(sun("from-behind", 0.0F, 12.0F, 15.0F, 40.0F));
    suns.push_back(sun("against", 180.0F, 12.0F, 10.0F, 35.0F));
    suns[2].turnsWithView = suns[3].turnsWithView = true;
    return suns;
}

} // namespace Lixel::Samples
