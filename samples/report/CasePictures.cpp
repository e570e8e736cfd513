#include "report/CasePictures.h"

#include "common/PictureFile.h"

#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace Lixel::Samples {

std::string pictureName(const TableCase& one, const std::string& setup) {
    return fmt::format("{}-{}-{}-{}", one.scene, one.view, one.light, setup);
}

CasePictures::CasePictures(const TableOptions& options, std::string folder)
    : mOptions(options), mFolder(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(mFolder, error);
    if (error)
        throw std::runtime_error("the folder '" + mFolder +
                                 "' could not be made: " + error.message());
}

CasePictures::Picture CasePictures::draw(const TableCase& one, std::size_t setup) {
    if (!mStage || mScene.name != one.scene) {
        mStage.reset(); // there is one stage at a time
        const SampleScene* const sample = findSampleScene(one.scene);
        mScene = sample != nullptr ? *sample : modelScene(mOptions.modelFile);
        mStage = std::make_unique<CaseStage>(mScene, mOptions);
    }
    const SampleView& view = mScene.views.at(one.viewNumber - 1);
    mStage->setView(view);
    mStage->setLight(findLight(mScene, view, one.light).value());
    const NamedSetup& named = mOptions.setups.at(setup);
    const std::vector<std::uint8_t> visibility = mStage->draw(named);
    Picture picture;
    picture.error = compareWithTruth(mStage->truth(), visibility).error;
    picture.file = mFolder + "/" + pictureName(one, named.name) + "-errors.png";
    savePicture(paintComparison(mStage->truth(), visibility), mOptions.width, mOptions.height,
                picture.file);
    return picture;
}

} // namespace Lixel::Samples
