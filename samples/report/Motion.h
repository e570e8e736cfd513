#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace Lixel::Samples {

/// What the maps of a moving viewer are measured with.
struct MotionOptions {
    std::string modelFile; ///< one more scene; empty for none
    std::string scene;     ///< one scene alone, by its name; empty for all
    int frames = 240;      ///< of each motion, at 60 frames a second
    int judged = 6;        ///< of so many frames, one and its successor are compared
    int mapSize = 512;     ///< texels; several maps of a light share as many
    int width = 320;       ///< pixels
    int height = 240;      ///< pixels
};

/// One setup in one scene and motion.
struct MotionRow {
    std::string scene;
    std::string view;
    std::string motion;
    std::string setup;
    double bound = 0.0; ///< of the option lasting_maps
    double drawn = 0.0; ///< percentage of maps that were drawn, over all frames
    // Percentages, over the judged frames.
    double meanError = 0.0;  ///< against the truth
    double worstError = 0.0; ///< the same, of the worst frame
    double flicker = 0.0;    ///< of points that are seen in two successive frames
    double worstFlicker = 0.0;
    /// Mean error relative to that of the same setup fitted in each frame, and that of the worst
    /// frame; 1 with such a fit.
    double meanRatio = 1.0;
    double worstRatio = 1.0;
    // Milliseconds a frame.
    double fitting = 0.0; ///< survey and fit, as the setup itself measures them
    double drawing = 0.0; ///< of maps, on RenderClock; frames without count as 0
};

/** Measures setups while the viewer walks, turns, and does both, on the frames of one film each.

    Lixel's setups have the option lasting_maps at several bounds; OGRE's own are drawn in each
    frame.
    @exception std::exception where a scene cannot be shown
*/
std::vector<MotionRow> measureMotion(const MotionOptions& options);

void printMotion(const MotionOptions& options, const std::vector<MotionRow>& rows);

/// @exception std::runtime_error where the file cannot be written
void writeMotion(const MotionOptions& options, const std::vector<MotionRow>& rows,
                 const std::string& file);

} // namespace Lixel::Samples
