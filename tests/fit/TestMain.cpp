#include <gtest/gtest.h>

#include <cstdlib>

// Under the sanitizers a case takes ten times as long, and any case reads the same memory.
#ifdef __SANITIZE_ADDRESS__
constexpr const char* Parameters = "seed=42 max_success=200";
#else
constexpr const char* Parameters = "seed=42 max_success=400";
#endif

int main(int argc, char** argv) {
    // RapidCheck reads its parameters once, at the first property. What the environment says wins.
    constexpr int KeepExisting = 0;
    setenv("RC_PARAMS", Parameters, KeepExisting);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
