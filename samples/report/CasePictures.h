#pragma once

#include "report/CaseStage.h"

#include <memory>

namespace Lixel::Samples {

/// The name of a case's pictures under one setup, without an ending.
std::string pictureName(const TableCase& one, const std::string& setup);

/// Draws single cases of a table again, and keeps pictures of what is wrong with them.
class CasePictures {
public:
    /// @param options the table's, which outlive this
    /// @param folder where pictures go; made where there is none
    /// @exception std::runtime_error where it cannot be made
    CasePictures(const TableOptions& options, std::string folder);

    struct Picture {
        double error = 0.0; ///< percent, as drawn
        std::string file;   ///< the errors, in paintComparison's colours
    };
    /// @param setup index into the table's
    /// @exception std::exception where the scene cannot be shown, or the picture not be written
    Picture draw(const TableCase& one, std::size_t setup);

private:
    const TableOptions& mOptions;
    std::string mFolder;
    // The scene that was drawn last: opening one takes longer than to draw it.
    SampleScene mScene;
    std::unique_ptr<CaseStage> mStage;
};

} // namespace Lixel::Samples
