#include "cli/command_tree.hpp"
#include "cli/commands.hpp"
#include "cli/first_hour.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"
#include "core/markup.hpp"
#include "core/output.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sr::cli {
namespace {

/// A part of a section: a paragraph, lines that keep their form, or a term with its meaning.
struct Block {
    enum class Kind { paragraph, verbatim, definition };
    Kind kind = Kind::paragraph;
    std::string text;
    std::string term{}; // of a definition
    std::string link{}; // of a definition: the name of the page about its term
};

struct Section {
    std::string heading;
    std::vector<Block> blocks;
};

/// The page of a command.
struct Page {
    std::string name;  // "steradian-golden-run"
    std::string title; // "steradian golden run"
    std::string summary;
    std::vector<Section> sections;
};

std::string hyphened(std::string title) {
    std::ranges::replace(title, ' ', '-');
    return title;
}

/// Returns "steradian render [OPTIONS] SCENE".
std::string synopsis_of(const CLI::App& command, const std::string& title) {
    const std::string usage = CLI::Formatter().make_usage(&command, title);
    const std::size_t start = usage.find(title);
    return CLI::detail::trim_copy(start == std::string::npos ? title : usage.substr(start));
}

Block definition_of(const CLI::Option& option, bool is_positional) {
    const CLI::Formatter formatter;
    return {Block::Kind::definition, option.get_description(),
            formatter.make_option_name(&option, is_positional) + formatter.make_option_opts(&option)};
}

/// Appends the options of a command, a section for each group of --help.
void append_options(const CLI::App& command, std::vector<Section>& sections) {
    Section arguments{"Arguments", {}};
    for (const CLI::Option* option : command.get_options())
        if (option->get_positional()) arguments.blocks.push_back(definition_of(*option, true));
    if (!arguments.blocks.empty()) sections.push_back(std::move(arguments));
    for (const std::string& group : command.get_groups()) {
        Section section{group, {}};
        for (const CLI::Option* option : listed_options(command))
            if (option->get_group() == group) section.blocks.push_back(definition_of(*option, false));
        if (!section.blocks.empty()) sections.push_back(std::move(section));
    }
}

/// Appends the text below the options of --help. A paragraph that begins with "Examples:" or "Exit status:"
/// becomes a section of that name, all others become notes.
void append_footer(const std::string& footer, std::vector<Section>& sections) {
    Section notes{"Notes", {}};
    std::vector<Section> named;
    std::string rest = footer + "\n\n";
    if (const std::size_t line = rest.find("\nExamples:\n"); line != std::string::npos)
        rest.insert(line, "\n");
    for (std::size_t end = 0; (end = rest.find("\n\n")) != std::string::npos; rest.erase(0, end + 2)) {
        std::string text = rest.substr(0, end);
        Section* section = &notes;
        for (const std::string_view heading : {"Examples", "Example", "Exit status"}) {
            if (!text.starts_with(std::string(heading) + ":")) continue;
            section = &named.emplace_back(Section{std::string(heading), {}});
            text.erase(0, std::min(text.size(), text.find_first_not_of(" \n", heading.size() + 1)));
            if (heading != "Exit status") text.insert(0, "  ");
        }
        if (text.empty()) continue;
        const bool is_verbatim = text.starts_with(' ') || text.find("\n ") != std::string::npos;
        section->blocks.push_back({is_verbatim ? Block::Kind::verbatim : Block::Kind::paragraph, text});
    }
    if (!notes.blocks.empty()) sections.push_back(std::move(notes));
    std::ranges::move(named, std::back_inserter(sections));
}

/// Appends the page of a command and those of its subcommands.
void append_pages(const CLI::App& command, const std::string& title, std::vector<Page>& pages) {
    Page page{hyphened(title), title, command.get_description(), {}};
    constexpr std::string_view program = "Steradian: ";
    if (page.summary.starts_with(program)) page.summary.erase(0, program.size());
    std::string description;
    if (const std::size_t end = page.summary.find('\n'); end != std::string::npos) {
        description = page.summary.substr(end + 1);
        page.summary.resize(end);
    }
    page.sections.push_back({"Synopsis", {{Block::Kind::verbatim, synopsis_of(command, title)}}});
    if (!description.empty())
        page.sections.push_back({"Description", {{Block::Kind::paragraph, description}}});
    Section commands{"Commands", {}};
    for (const CLI::App* sub : listed_subcommands(command)) {
        const std::string sub_title = title + " " + sub->get_name();
        commands.blocks.push_back(
            {Block::Kind::definition, sub->get_description(), sub_title, hyphened(sub_title)});
    }
    if (!commands.blocks.empty()) page.sections.push_back(std::move(commands));
    append_options(command, page.sections);
    // CLI11 gives a command without a footer that of its parent.
    if (!command.get_parent() || command.get_footer() != command.get_parent()->get_footer())
        append_footer(command.get_footer(), page.sections);
    pages.push_back(std::move(page));
    for (const CLI::App* sub : listed_subcommands(command))
        append_pages(*sub, title + " " + sub->get_name(), pages);
}

std::vector<Page> pages_of(const CLI::App& app) {
    std::vector<Page> pages;
    append_pages(app, "steradian", pages);
    return pages;
}

// Pages for man: roff with the macros of man(7).

/// Escapes a text: backslashes, hyphens that stay hyphens, and dots and quotes that would start a macro.
std::string roff_text(std::string_view text) {
    std::string result;
    bool is_line_start = true;
    for (const char c : text) {
        if (is_line_start && (c == '.' || c == '\'')) result += "\\&";
        is_line_start = c == '\n';
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result;
}

std::string roff_block(const Block& block) {
    const std::string text = roff_text(block.text);
    switch (block.kind) {
    case Block::Kind::paragraph: return fmt::format(".PP\n{}\n", text);
    case Block::Kind::verbatim: return fmt::format(".PP\n.nf\n{}\n.fi\n", text);
    case Block::Kind::definition:
        return fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff_text(block.term), text.empty() ? "\\&" : text);
    }
    return {};
}

std::string roff_page(const Page& page) {
    const auto upper = [](std::string text) {
        for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        return text;
    };
    std::string text =
        fmt::format(".TH {} 1 \"\" \"Steradian " STERADIAN_VERSION "\" \"Steradian\"\n"
                    ".SH NAME\n{} \\- {}\n",
                    roff_text(upper(page.name)), roff_text(page.name), roff_text(page.summary));
    std::string related = page.name == "steradian" ? "" : "steradian(1)";
    for (const Section& section : page.sections) {
        text += fmt::format(".SH {}\n", roff_text(upper(section.heading)));
        for (const Block& block : section.blocks) {
            text += roff_block(block);
            if (!block.link.empty()) related += (related.empty() ? "" : ", ") + block.link + "(1)";
        }
    }
    return text + fmt::format(".SH SEE ALSO\n{}\n", roff_text(related));
}

/// Writes NAME.1 of each command into a folder, which is made if it is not there. @throws Error
void write_man_pages(const CLI::App& app, const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    for (const Page& page : pages_of(app)) {
        const std::filesystem::path file = folder / (page.name + ".1");
        std::ofstream stream(file);
        stream << roff_page(page);
        stream.close();
        if (!stream) throw Error({file.string()}, "cannot be written", "choose a folder that can be");
    }
}

// One page for browsers.

constexpr std::string_view style =
    ":root { color-scheme: light dark }\n"
    "body { font: 16px/1.5 system-ui, sans-serif; max-width: 50rem; margin: 2rem auto; padding: 0 1rem }\n"
    "code, pre, dt { font-family: ui-monospace, monospace; font-size: 0.9em }\n"
    "pre { overflow-x: auto; padding: 0.5rem; border: 1px solid #8884; border-radius: 4px }\n"
    "dd { margin: 0 0 0.5rem 2rem }\n"
    "section { border-top: 1px solid #8884; margin-top: 2rem }\n";

std::string html_block(const Block& block) {
    const std::string text = escape_markup(block.text), term = escape_markup(block.term);
    switch (block.kind) {
    case Block::Kind::paragraph: return fmt::format("<p>{}</p>\n", text);
    case Block::Kind::verbatim: return fmt::format("<pre>{}</pre>\n", text);
    case Block::Kind::definition:
        return block.link.empty() ? fmt::format("<dl><dt>{}</dt><dd>{}</dd></dl>\n", term, text)
                                  : fmt::format("<dl><dt><a href=\"#{}\">{}</a></dt><dd>{}</dd></dl>\n",
                                                block.link, term, text);
    }
    return {};
}

std::string html_manual(const CLI::App& app) {
    std::string text =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width\">\n"
                    "<title>Steradian: the manual</title>\n<style>\n{}</style>\n</head>\n<body>\n"
                    "<h1>{}</h1>\n",
                    style, escape_markup(name_and_version()));
    text += fmt::format("<section id=\"first-hour\">\n{}</section>\n", first_hour_html());
    for (const Page& page : pages_of(app)) {
        text += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n", page.name,
                            escape_markup(page.title), escape_markup(page.summary));
        for (const Section& section : page.sections) {
            text += fmt::format("<h3>{}</h3>\n", escape_markup(section.heading));
            for (const Block& block : section.blocks) text += html_block(block);
        }
        text += "</section>\n";
    }
    return text + "</body>\n</html>\n";
}

} // namespace

void add_manual_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("manual", "write these help texts as man pages or as one page");
    const auto folder = std::make_shared<std::string>();
    CLI::App* man = command->add_subcommand("man", "write a man page for each command");
    man->add_option("FOLDER", *folder, "where steradian.1, steradian-render.1, … are written")->required();
    man->callback([&app, folder] { write_man_pages(app, *folder); });
    command->add_subcommand("html", "print one HTML page: a first hour, and all commands")->callback([&app] {
        write_output(html_manual(app));
    });
    command->require_subcommand(1);
    command->footer("Examples:\n"
                    "  steradian manual man ~/.local/share/man/man1\n"
                    "  steradian manual html > manual.html");
}

} // namespace sr::cli
