// A program that is linked to libX11 before libLixelHeadless: its render systems would not see the
// stand-ins, and it must be told so instead of failing later.

#include <Lixel/headless/Headless.h>

#include <gtest/gtest.h>

namespace {

TEST(LinkedTooLate, IsAClearError) {
    const std::string error = Lixel::Headless::enable();
    EXPECT_NE(error.find("XOpenDisplay is found in another library"), std::string::npos) << error;
    EXPECT_NE(error.find("before libX11"), std::string::npos) << error;
    EXPECT_FALSE(Lixel::Headless::isEnabled());
}

} // namespace
