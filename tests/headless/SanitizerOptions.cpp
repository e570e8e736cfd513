// Leaks of the libraries under test, which are not ours to mend. Read by the leak sanitizer's
// runtime in a build with LIXEL_SANITIZE, and by nobody otherwise.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
    // Mesa 22.3: about 300 bytes once and 160 for each context. OGRE 1.12: a window not made,
    // the bones of a skeleton made by hand, which only unloading a file's skeleton frees, and the
    // vertices of instances' batches.
    return "leak:libOSMesa.so\n"
           "leak:RenderSystem_GL\n"
           "leak:Ogre::Skeleton::createBone\n"
           "leak:Ogre::InstanceManager::createInstancedEntity\n";
}
