#include "report/page/glossary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <vector>

#include "report/base/escape.h"
#include "report/page/html_pieces.h"

namespace plumb {
namespace {

constexpr std::string_view own_word = "a word of this program", vv20 = "ASME V&V 20-2009",
                           solving_stiff =
                               "E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, "
                               "Springer 1996";

constexpr std::array all_terms{
    Term{"ancf", "ANCF", "ANCF",
         "The absolute nodal coordinate formulation: an element's unknowns are places and slopes of its "
         "nodes in "
         "space, and no angles. Its mass matrix is constant, and large rotations need no special care.",
         "J. Gerstmayr and A. A. Shabana, Nonlinear Dynamics 45 (2006) 109–130"},
    Term{"certified", "certified reference",
         "certified reference|certified references|reference is certified",
         "A computed motion on which two unlike methods agree, to a bound that is stated. It has the mesh of "
         "the "
         "runs that are held against it, so that what is between them is an error of time integration alone.",
         own_word},
    Term{"E", "E", "E",
         "The comparison error: what the run gives minus what it is held against. It has in it the errors of "
         "the "
         "model, of the computation, of its inputs and of the reference.",
         vv20},
    Term{
        "coverage", "coverage", "coverage",
        "The share of what a case wants compared, times or modes, that could be compared. A verdict over too "
        "little of it is “not run”, never passed.",
        own_word},
    Term{"drift", "drift of the energy", "drift of the energy|energy drift|drift / kinetic",
         "By how much the total energy moves, though nothing adds any or takes any away. It is an error of "
         "the time "
         "integration; that it is small does not show that the motion is right.",
         "E. Hairer, C. Lubich and G. Wanner, Geometric Numerical Integration, Springer 2006"},
    Term{"error-budget", "error budget", "error budget|error budgets",
         "What one change alone moves a result by, change after change, between the run and what was "
         "published. The "
         "parts are not added up, as they may cancel one another.",
         own_word},
    Term{"external-run", "external run", "external run|external runs",
         "A run of another program, read from its file and held against the same references. What cannot be "
         "read "
         "from it, such as its energies, is not guessed.",
         own_word},
    Term{"gci", "grid convergence index", "grid convergence index",
         "An estimate of how far a mesh is from an ever finer one, from runs on three meshes and with a "
         "factor of "
         "safety. It holds as far as the error falls as a power of the size of the elements.",
         "ASME V&V 20-2009, section 2-4; P. J. Roache, J. Fluids Eng. 116 (1994) 405–413"},
    Term{"horizon", "horizon", "horizon|horizons",
         "The time up to which two motions that begin closer than anyone could tell stay together to the "
         "tolerance. "
         "Beyond it a comparison point by point says nothing of a method.",
         "G. Benettin et al., Meccanica 15 (1980) 9–20, for the exponent behind it"},
    Term{"locking", "locking", "locking|axial locking",
         "A coarse mesh that is too stiff, as its elements cannot bend without being stretched. A finer mesh "
         "or fewer "
         "points of quadrature lessen it.",
         "J. Gerstmayr and A. A. Shabana, Nonlinear Dynamics 45 (2006) 109–130"},
    Term{"observed-order", "observed order", "observed order|observed orders|order of convergence",
         "The power of the step, or of the size of the elements, by which the error falls from run to run. "
         "Where it "
         "is that of the theory, the method is likely to be programmed as it is written.",
         "ASME V&V 20-2009, section 2-4"},
    Term{"outcome", "outcome", "outcome|outcomes",
         "In one word how a computation ended: accurate, inaccurate, unstable, diverged and others. Accurate "
         "and "
         "inaccurate are said only where there is something to tell by.",
         own_word},
    Term{"pareto", "Pareto front", "Pareto front|Pareto fronts",
         "The runs that no other run beats in error and cost at once. What lies behind it costs more for the "
         "same "
         "error.",
         "K. Miettinen, Nonlinear Multiobjective Optimization, Kluwer 1999"},
    Term{"richardson", "Richardson's extrapolation",
         "Richardson's extrapolation|Richardson extrapolation|Richardson's "
         "estimate|Richardson&#39;s extrapolation",
         "The limit of ever finer meshes, or steps, from the results of some and the order by which their "
         "error "
         "falls. It is an estimate, and worth no more than that order.",
         "P. J. Roache, J. Fluids Eng. 116 (1994) 405–413"},
    Term{"spectral-radius", "spectral radius", "spectral radius",
         "The greatest size of an eigenvalue of what a step does to a vibration. Above 1 the vibration grows "
         "with "
         "every step; below 1 it is damped.",
         "J. Chung and G. M. Hulbert, J. Appl. Mech. 60 (1993) 371–375"},
    Term{"stiff", "stiff", "stiff problem|stiff problems|stiffer than|stiffly accurate",
         "A problem in which stability, not accuracy, bounds the step of explicit methods. Here fast "
         "vibrations along "
         "the cable, which nobody looks at, do so.",
         solving_stiff},
    Term{"u-d", "u_D", "u_D",
         "Standard uncertainty of the data that a run is held against. It is what the reference states, and "
         "what is "
         "known of the computation behind it.",
         vv20},
    Term{"u-input", "u_input", "u_input",
         "Standard uncertainty of the result from what is not known well of its inputs. Here it is the "
         "scatter of "
         "runs with other inputs.",
         vv20},
    Term{"u-num", "u_num", "u_num",
         "Standard uncertainty of the result from mesh and time steps. Here it is estimated from runs with "
         "finer "
         "ones.",
         vv20},
    Term{"u-val", "u_val", "u_val|validation uncertainty",
         "Standard uncertainty of E, the root of the sum of squares of u_num, u_input and u_D. Where |E| is "
         "at most "
         "twice that, run and reference cannot be told apart.",
         vv20},
    Term{"work-precision", "work-precision", "work-precision|Work-precision",
         "The error of runs over what they cost, a curve for each method and setting. Of two curves the one "
         "to the "
         "lower left is the better one.",
         "E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, Springer 1996, section IV.10"},
};

/// In these nothing is linked.
bool is_closed(const HtmlPiece& piece) {
  static constexpr std::array closed{"a",     "button",  "code",   "pre",    "h1",      "h2",     "h3",
                                     "h4",    "summary", "math",   "svg",    "nav",     "header", "th",
                                     "label", "title",   "select", "script", "caption", "style"};
  return std::find(closed.begin(), closed.end(), piece.name()) != closed.end() ||
         piece.text.starts_with("<span class=\"file\"");
}

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || (c & 0x80) != 0;
}

/// Where a word stands alone in a text, from a place on.
std::size_t find_word(std::string_view text, std::string_view word, std::size_t from) {
  for (std::size_t at = text.find(word, from); at != text.npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if (at > 0 && is_letter(text[at - 1])) continue;
    if (end < text.size() && is_letter(text[end])) continue;
    // A letter alone is the comparison error only where it is a quantity.
    if (word == "E" && !text.substr(end).starts_with(" = ") && !text.substr(end).starts_with(" is the run"))
      continue;
    return at;
  }
  return text.npos;
}

struct Found {
  std::size_t at = std::string_view::npos, length = 0;
  const Term* term = nullptr;
};

/// The first of the terms in a text that are not linked yet, the longer of two at one place.
Found first_term(std::string_view text, std::size_t from, const std::set<const Term*>& linked) {
  Found found;
  for (const Term& term : all_terms) {
    if (linked.contains(&term)) continue;
    for (std::string_view words = term.words; !words.empty();) {
      const std::string_view word = words.substr(0, words.find('|'));
      words.remove_prefix(std::min(words.size(), word.size() + 1));
      const std::size_t at = find_word(text, word, from);
      if (at < found.at || (at == found.at && at != text.npos && word.size() > found.length))
        found = {at, word.size(), &term};
    }
  }
  return found;
}

std::string glossary_html(const std::set<const Term*>& used) {
  std::string html = "<section id=\"glossary\">\n<h2>Glossary</h2>\n<dl class=\"terms\">\n";
  for (const Term& term : all_terms)
    if (used.contains(&term))
      html += fmt::format("<dt id=\"term-{}\">{}</dt><dd>{} <span class=\"note\">{}</span></dd>\n", term.id,
                          escape_xml(std::string(term.name)), escape_xml(std::string(term.text)),
                          escape_xml(std::string(term.source)));
  return html + "</dl>\n</section>\n";
}

void put_before_last(std::string& html, std::string_view place, const std::string& text) {
  if (const std::size_t at = html.rfind(place); at != html.npos) html.insert(at, text);
}

}  // namespace

std::span<const Term> terms() {
  return all_terms;
}

std::string with_glossary(const std::string& body) {
  if (body.find("</main>") == body.npos) return body;
  std::string html;
  html.reserve(body.size());
  std::set<const Term*> used, linked;
  std::vector<std::string_view> closed;  // elements in which nothing is linked, the outermost first
  bool in_main = false;
  for (const HtmlPiece& piece : html_pieces(body)) {
    if (piece.is_tag) {
      const std::string_view name = piece.name();
      if (name == "main" || name == "/main") in_main = name == "main";
      if (name == "section") linked.clear();
      if (!closed.empty() && name.starts_with('/') && name.substr(1) == closed.back())
        closed.pop_back();
      else if (is_closed(piece) || (!closed.empty() && name == closed.back()))
        closed.push_back(name);
      html += piece.text;
      continue;
    }
    std::size_t done = 0;
    while (in_main && closed.empty()) {
      const Found found = first_term(piece.text, done, linked);
      if (found.term == nullptr) break;
      html += piece.text.substr(done, found.at - done);
      html += fmt::format("<a class=\"term\" href=\"#term-{}\">{}</a>", found.term->id,
                          piece.text.substr(found.at, found.length));
      done = found.at + found.length;
      linked.insert(found.term);
      used.insert(found.term);
    }
    html += piece.text.substr(done);
  }
  if (used.empty()) return body;
  put_before_last(html, "</main>", glossary_html(used));
  put_before_last(html, "</nav>", " <a href=\"#glossary\">Glossary</a>\n");
  return html;
}

std::string with_captions(const std::string& body) {
  std::string html, heading;
  html.reserve(body.size());
  bool in_heading = false, in_main = false;
  const std::vector<HtmlPiece> pieces = html_pieces(body);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const HtmlPiece& piece = pieces[k];
    const std::string_view name = piece.name();
    constexpr std::string_view scrolls = "<div class=\"scroll\">";
    const std::size_t end = heading.find_last_not_of(" \n");
    const std::string title = heading.substr(0, end == heading.npos ? 0 : end + 1);
    if (piece.text == scrolls && in_main)
      html += fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{}\">",
                          title.empty() ? "Table" : title);
    else
      html += piece.text;
    if (name == "main") in_main = true;
    if (name == "h2" || name == "h3" || name == "h4") {
      in_heading = true;
      heading.clear();
    } else if (name == "/h2" || name == "/h3" || name == "/h4" || name == "span") {
      // What a heading counts is no part of its name.
      in_heading = false;
    } else if (in_heading && !piece.is_tag) {
      heading += piece.text;
    } else if (name == "table" && in_main && !heading.empty()) {
      const auto next = std::find_if(pieces.begin() + static_cast<std::ptrdiff_t>(k) + 1, pieces.end(),
                                     [](const HtmlPiece& other) { return other.is_tag; });
      if (next != pieces.end() && next->name() == "caption") continue;
      html += "<caption>" + title + "</caption>";
    }
  }
  return html;
}

}  // namespace plumb
