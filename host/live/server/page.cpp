#include "live/server/page.h"

#include "live/messages/setting_rows.h"

namespace hyalite::live {

extern const std::string_view kPageHtml;
extern const std::string_view kPageCss;
extern const std::string_view kPageJs;
extern const std::string_view kPathJs;
extern const std::string_view kCameraJs;
extern const std::string_view kEditorJs;
extern const std::string_view kCodeMirrorJs;
extern const std::string_view kCodeMirrorCss;

const std::vector<Asset>& pageAssets() {
    static const std::vector<Asset> assets{
        {"/", "text/html; charset=utf-8", kPageHtml},
        {"/live.css", "text/css; charset=utf-8", kPageCss},
        {"/settings.js", "text/javascript; charset=utf-8", settingsScript()},
        {"/live.js", "text/javascript; charset=utf-8", kPageJs},
        {"/path.js", "text/javascript; charset=utf-8", kPathJs},
        {"/camera.js", "text/javascript; charset=utf-8", kCameraJs},
        {"/editor.js", "text/javascript; charset=utf-8", kEditorJs},
        {"/codemirror.js", "text/javascript; charset=utf-8", kCodeMirrorJs},
        {"/codemirror.css", "text/css; charset=utf-8", kCodeMirrorCss},
    };
    return assets;
}

} // namespace hyalite::live
