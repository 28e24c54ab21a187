#include "report/page/glossary.h"

#include <gtest/gtest.h>

#include <set>

#include "report/page/html_pieces.h"

namespace plumb {
namespace glossary_test {

long count(const std::string& text, const std::string& what) {
  long n = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

std::string page(const std::string& content) {
  return "<header><h1>horizon</h1></header>\n<nav></nav>\n<main>\n" + content + "</main>\n";
}

TEST(Glossary, HasTheTermsThatThePageUsesAndEachLinkLeadsThere) {
  const std::string html =
      with_glossary(page("<section><p>Up to the horizon; the Pareto front.</p></section>"
                         "<section><p>Beyond the horizon, E = 3 with u_val 1.</p></section>"));
  for (const char* id : {"horizon", "pareto", "E", "u-val"}) {
    EXPECT_EQ(count(html, std::string("<dt id=\"term-") + id + "\">"), 1) << id << "\n" << html;
    EXPECT_GE(count(html, std::string("href=\"#term-") + id + "\""), 1) << id << "\n" << html;
  }
  EXPECT_EQ(count(html, "<dt id=\"term-"), 4) << "no term that the page does not use\n" << html;
  EXPECT_EQ(count(html, "href=\"#term-horizon\""), 2) << "once a section\n" << html;
  EXPECT_EQ(count(html, "href=\"#glossary\""), 1) << html;
  EXPECT_LT(html.find("id=\"glossary\""), html.find("</main>"));
}

TEST(Glossary, LinksNothingInHeadingsLinksCodeFilesAndParts) {
  const std::string untouched = page(
      "<section><h2>The horizon</h2><a href=\"#x\">the horizon</a><code>horizon</code><pre>E = horizon</pre>"
      "<svg><text>outcome</text></svg><span class=\"file\">outcome/outcome.csv</span><th>coverage</th>"
      "<button>outcome</button><p>horizontal, non-horizon, outcome_of, E and EA, ENERGY</p></section>");
  EXPECT_EQ(with_glossary(untouched), untouched);
  EXPECT_EQ(with_glossary("<p>no main: outcome</p>"), "<p>no main: outcome</p>");
}

TEST(Glossary, TakesTheLongerOfTwoTermsAtOnePlace) {
  const std::string html = with_glossary(page("<p>The certified references of validation uncertainty</p>"));
  EXPECT_EQ(count(html, ">certified references</a>"), 1) << html;
  EXPECT_EQ(count(html, ">validation uncertainty</a>"), 1) << html;
}

TEST(Glossary, LosesNoTextOfThePage) {
  const std::string body = page("<section><p>a &lt; b, outcome, the outcome &amp; coverage</p><br>tail");
  const std::string html = with_glossary(body);
  const auto text_of = [](const std::string& piece_of_page) {
    std::string text;
    for (const HtmlPiece& piece : html_pieces(piece_of_page))
      if (!piece.is_tag) text += piece.text;
    return text;
  };
  const auto main_of = [](const std::string& whole, const char* end) {
    const std::size_t begin = whole.find("<main>");
    return whole.substr(begin, whole.find(end) - begin);
  };
  EXPECT_NE(html, body);
  EXPECT_EQ(text_of(main_of(html, "<section id=\"glossary\"")), text_of(main_of(body, "</main>")));
}

TEST(Glossary, SaysOfEachTermTwoSentencesAndWhereTheyAreFrom) {
  std::set<std::string_view> ids;
  for (const Term& term : terms()) {
    EXPECT_TRUE(ids.insert(term.id).second) << term.id << " is there twice";
    EXPECT_GE(count(std::string(term.text), ". "), 1) << term.id << ": " << term.text;
    EXPECT_TRUE(term.text.ends_with('.')) << term.id;
    EXPECT_FALSE(term.source.empty()) << term.id;
    EXPECT_FALSE(term.words.empty()) << term.id;
  }
}

TEST(Captions, AreTheHeadingsAboveTables) {
  const std::string html = with_captions(
      "<main><h2>Errors <span class=\"count\">3</span></h2><table><tr></tr></table>"
      "<h3>Parts</h3><table><caption>own</caption></table></main>");
  EXPECT_EQ(count(html, "<caption>Errors</caption>"), 1) << html;
  EXPECT_EQ(count(html, "<caption>"), 2) << html;
}

}  // namespace glossary_test
}  // namespace plumb
