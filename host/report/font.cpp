// SPDX-License-Identifier: Apache-2.0
#include "report/font.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

namespace lobe {
namespace {

namespace fs = std::filesystem;

// Best first.
const std::vector<std::string> known = {"DejaVuSans.ttf",
                                        "NotoSans-Regular.ttf",
                                        "LiberationSans-Regular.ttf",
                                        "FreeSans.ttf",
                                        "Arial.ttf",
                                        "arial.ttf"};

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders;
    const char* const own = std::getenv("XDG_DATA_HOME");
    const char* const home = std::getenv("HOME");
    if (own && *own)
        folders.push_back(fs::path(own) / "fonts");
    else if (home && *home)
        folders.push_back(fs::path(home) / ".local/share/fonts");
    const char* const shared = std::getenv("XDG_DATA_DIRS");
    std::istringstream list(shared && *shared ? shared : "/usr/local/share:/usr/share");
    for (std::string folder; std::getline(list, folder, ':');)
        folders.push_back(fs::path(folder) / "fonts");
    return folders;
}

}  // namespace

std::string find_font() {
    std::size_t best = known.size();
    std::string path;
    for (const fs::path& folder : font_folders()) {
        std::error_code error;  // a folder that cannot be read has no fonts for us
        const auto options = fs::directory_options::skip_permission_denied |
                             fs::directory_options::follow_directory_symlink;
        for (auto at = fs::recursive_directory_iterator(folder, options, error);
             !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
            const auto place = static_cast<std::size_t>(
                std::find(known.begin(), known.end(), at->path().filename()) - known.begin());
            if (place >= best) continue;
            best = place;
            path = at->path().string();
        }
    }
    return path;
}

}  // namespace lobe
