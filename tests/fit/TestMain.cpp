#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
    // RapidCheck reads its parameters once, at the first property. What the environment says wins.
    constexpr int KeepExisting = 0;
    setenv("RC_PARAMS", "seed=42 max_success=1000", KeepExisting);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
