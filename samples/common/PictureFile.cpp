#include "common/PictureFile.h"

#include <OgreException.h>
#include <OgreImage.h>

#include <stdexcept>

namespace Lixel::Samples {

void savePicture(const std::vector<std::uint8_t>& rgb, int width, int height,
                 const std::string& file) {
    // OGRE wants mutable bytes and does not write to them.
    std::vector<std::uint8_t> bytes = rgb;
    Ogre::Image image;
    image.loadDynamicImage(bytes.data(), static_cast<Ogre::uint32>(width),
                           static_cast<Ogre::uint32>(height), 1, Ogre::PF_BYTE_RGB);
    try {
        image.save(file);
    } catch (const Ogre::Exception& error) {
        throw std::runtime_error("the picture '" + file +
                                 "' could not be written: " + error.getDescription());
    }
}

} // namespace Lixel::Samples
