#include "golden/report_page.hpp"

#include "golden/escape.hpp"
#include "golden/report_pixels.hpp"
#include "golden/sha256.hpp"

#include <fmt/format.h>

namespace sr::golden {
namespace {

std::string csp_hash(std::string_view text) {
    const Digest digest = sha256({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return "'sha256-" + base64({reinterpret_cast<const char*>(digest.data()), digest.size()}) + "'";
}

} // namespace

std::string offline_page(const std::string& title, const std::string& plain, const std::string& data,
                         const ReportPage& page) {
    const ReportPage base = report_base();
    const std::string style = base.style + page.style, script = base.script + page.script;
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    html += fmt::format(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src {}; script-src {}; base-uri 'none'; form-action 'none'\">\n",
        csp_hash(style), csp_hash(script));
    html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" "
            "href=\"data:,\">\n";
    html +=
        fmt::format("<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n", escaped_markup(title), style);
    html += fmt::format("<main id=\"page\">\n<h1>{}</h1>\n{}</main>\n", escaped_markup(title), plain);
    html += fmt::format(
        "<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n</body>\n</html>\n",
        escaped_script_json(data), script);
    return html;
}

} // namespace sr::golden
