#include "raylab/report/page/html.h"

#include "catch.h"

using namespace raylab;

TEST_CASE("HTML's five characters are escaped") {
    CHECK(escape_html("<a href=\"x\">'&'</a>") == "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
}

TEST_CASE("no HTML passes through Markdown") {
    for (const std::string text : {"<script>alert(1)</script>", "`<b>`", "*<b>*", "- <b>", "[<b>](x.html)",
                                   "```\n<b>\n```", "[x](\"><script>)", "**<b>**", "1. <b>"}) {
        const auto html = html_from_markdown(text);
        CHECK(html.find("<b>") == std::string::npos);
        CHECK(html.find("<script") == std::string::npos);
    }
}

TEST_CASE("a link goes to a page beside, a place or the web, and nowhere else") {
    CHECK(html_from_markdown("[a](b.html#c)") == "<p><a href=\"b.html#c\">a</a></p>\n");
    CHECK(html_from_markdown("[a](https://example.org/)") == "<p><a href=\"https://example.org/\">a</a></p>\n");
    for (const std::string link : {"javascript:alert(1)", "data:text/html,x", "//example.org", "JavaScript:x"})
        CHECK(html_from_markdown("[a](" + link + ")").find("<a ") == std::string::npos);
}

TEST_CASE("emphasis, strong and code nest as they read, and a free asterisk is a sign") {
    CHECK(html_from_markdown_line("*a* **b** `c*d*`") == "<em>a</em> <strong>b</strong> <code>c*d*</code>");
    CHECK(html_from_markdown_line("2 * 3 * 4") == "2 * 3 * 4");
    CHECK(html_from_markdown_line("**a *b* c**") == "<strong>a <em>b</em> c</strong>");
    CHECK(html_from_markdown_line("open *and `never closed") == "open *and `never closed");
}

TEST_CASE("a line is a line: no list, no heading, no quotation") {
    for (const std::string text : {"-", "- a", "# a", "1. a", "    a", ""}) {
        INFO(text);
        const auto html = html_from_markdown_line(text);
        CHECK(html.find('<') == std::string::npos);
        CHECK(html.size() <= text.size());
    }
    CHECK(html_from_markdown_line("-") == "-");
    CHECK(html_from_markdown_line("1. a") == "1. a");
    CHECK(html_from_markdown_line("$a$").starts_with("<math>"));
}

TEST_CASE("paragraphs, lists and code become blocks") {
    CHECK(html_from_markdown("one\ntwo\n\nthree") == "<p>one two</p>\n<p>three</p>\n");
    CHECK(html_from_markdown("- a\n- b\n  more\n\nafter") ==
          "<ul>\n<li>a</li>\n<li>b more</li>\n</ul>\n<p>after</p>\n");
    CHECK(html_from_markdown("1. a\n2. b") == "<ol>\n<li>a</li>\n<li>b</li>\n</ol>\n");
    CHECK(html_from_markdown("```\na < b\n\n- c\n```\nd") == "<pre><code>a &lt; b\n\n- c\n</code></pre>\n<p>d</p>\n");
    CHECK(html_from_markdown("") == "");
}

TEST_CASE("an anchor holds letters, digits and single hyphens") {
    CHECK(anchor_name("Speed & accuracy!") == "speed-accuracy");
    CHECK(anchor_name("<\">") == "part");
}
