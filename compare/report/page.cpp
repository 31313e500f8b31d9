#include "compare/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <set>

#include "compare/study/errors.hpp"

namespace fiberchain::compare {
namespace {

using Data = kainjow::mustache::data;

template <class Items, class Convert>
Data list_of(const Items& items, const Convert& convert) {
  Data list{Data::type::list};
  for (const auto& item : items) list << convert(item);
  return list;
}

/// The verdict as the page's styles name it: "holds-only-if".
std::string style_of(const MatrixEntry& entry) {
  if (!entry.as_expected) return "fails";
  std::string style = entry.verdict;
  std::ranges::replace(style, ' ', '-');
  return style;
}

Data entry_data(const MatrixEntry& entry) {
  Data data;
  for (const auto& [key, text] :
       std::initializer_list<std::pair<const char*, const std::string&>>{{"id", entry.id},
                                                                         {"subject", entry.subject},
                                                                         {"feature", entry.feature},
                                                                         {"kind", entry.kind},
                                                                         {"quantity", entry.quantity},
                                                                         {"claim", entry.claim},
                                                                         {"expected", entry.expected},
                                                                         {"measured", entry.measured},
                                                                         {"tolerance", entry.tolerance},
                                                                         {"unit", entry.unit},
                                                                         {"verdict", entry.verdict},
                                                                         {"condition", entry.condition},
                                                                         {"otherwise", entry.otherwise},
                                                                         {"reading", entry.reading},
                                                                         {"basis", entry.basis},
                                                                         {"source", entry.source},
                                                                         {"place", entry.place},
                                                                         {"statement", entry.statement},
                                                                         {"evidence", entry.evidence}}) {
    if (!text.empty()) data.set(key, text);
  }
  data.set("style", style_of(entry));
  data.set("unexpected", !entry.as_expected);
  return data;
}

Data figure_data(const ReportFigure& figure) {
  Data data;
  data.set("caption", figure.caption);
  data.set("uri", figure.data_uri);
  data.set("file", figure.origin.file);
  return data;
}

Data missing_data(const std::string& caption) {
  Data data;
  data.set("caption", caption);
  return data;
}

/// Statements of the paper on this figure; on none of those shown for 0.
std::vector<MatrixEntry> statements_on(const Report& report, int number) {
  std::set<int> shown;
  for (const PaperFigure& figure : report.paper) shown.insert(figure.number);
  std::vector<MatrixEntry> found;
  for (const MatrixEntry& entry : report.matrix) {
    if (!entry.of_paper) continue;
    if ((number == 0 && !shown.contains(entry.figure)) || (number != 0 && entry.figure == number))
      found.push_back(entry);
  }
  return found;
}

/// The words that several rows may be about, once, with these rows.
struct Statement {
  std::vector<MatrixEntry> rows;
};

std::vector<Statement> by_words(const std::vector<MatrixEntry>& entries) {
  std::vector<Statement> all;
  for (const MatrixEntry& entry : entries) {
    const auto same = std::ranges::find_if(
        all, [&](const Statement& one) { return one.rows.front().statement == entry.statement; });
    if (same == all.end())
      all.push_back({{entry}});
    else
      same->rows.push_back(entry);
  }
  return all;
}

Data statement_data(const Statement& statement) {
  Data data;
  data.set("words", statement.rows.front().statement);
  data.set("at", statement.rows.front().place);
  data.set("about", list_of(statement.rows, entry_data));
  return data;
}

Data paper_data(const Report& report, const PaperFigure& figure) {
  const std::vector<MatrixEntry> statements = statements_on(report, figure.number);
  Data data;
  data.set("number", std::to_string(figure.number));
  data.set("heading", figure.heading);
  data.set("figures", list_of(figure.figures, figure_data));
  data.set("missing", list_of(figure.missing, missing_data));
  data.set("statements", list_of(by_words(statements), statement_data));
  data.set("no_statement", statements.empty());
  return data;
}

Data section_data(const ReportSection& section) {
  Data data;
  data.set("id", section.id);
  data.set("heading", section.heading);
  data.set("text", section.text);
  data.set("figures", list_of(section.figures, figure_data));
  data.set("missing", list_of(section.missing, missing_data));
  return data;
}

Data packing_data(const ReportPacking& packing) {
  const PackingView& view = packing.view;
  Data data;
  data.set("json", view.json);
  data.set("name", packing.name);
  data.set("file", packing.origin.file);
  data.set("spheres", std::to_string(view.spheres));
  data.set("last_frame", std::to_string(view.frames - 1));
  data.set("several", view.frames > 1);
  data.set("time", fmt::format("{:.4g}", view.last));
  if (view.shown < view.spheres) data.set("shown", std::to_string(view.shown));
  return data;
}

/// Ten digits of it tell it from all others.
std::string short_commit(const std::string& commit) {
  return commit.substr(0, 10) + (commit.ends_with("-dirty") ? "-dirty" : "");
}

Data origin_data(const Origin& origin) {
  Data data;
  data.set("file", origin.file);
  data.set("version", origin.version);
  data.set("commit", short_commit(origin.commit));
  data.set("date", origin.date);
  data.set("command", origin.command);
  return data;
}

/// Of all that the page shows, each file once, in the order of the page.
std::vector<Origin> origins_of(const Report& report) {
  std::vector<Origin> all = report.tables;
  const auto add = [&](const std::vector<ReportFigure>& figures) {
    for (const ReportFigure& figure : figures) all.push_back(figure.origin);
  };
  for (const PaperFigure& figure : report.paper) add(figure.figures);
  for (const ReportSection& section : report.sections) add(section.figures);
  if (report.packing) all.push_back(report.packing->origin);
  return all;
}

void set_counts(Data& data, const MatrixCounts& counts) {
  data.set("count_all", std::to_string(counts.all));
  data.set("count_measured", std::to_string(counts.all - counts.not_measured));
  data.set("count_holds", std::to_string(counts.holds));
  data.set("count_holds_only_if", std::to_string(counts.holds_only_if));
  data.set("count_disputed", std::to_string(counts.disputed));
  data.set("count_failed", std::to_string(counts.failed));
  data.set("some_failed", counts.failed > 0);
  if (counts.not_measured > 0) data.set("count_not_measured", std::to_string(counts.not_measured));
}

Data page_data(const Report& report) {
  Data data;
  set_counts(data, counts_of(report.matrix));
  data.set("version", report.provenance.version);
  data.set("commit", short_commit(report.provenance.commit));
  data.set("date", report.provenance.date);
  data.set("notes", list_of(report.notes, [](const std::string& text) {
             Data note;
             note.set("text", text);
             return note;
           }));
  data.set("paper",
           list_of(report.paper, [&](const PaperFigure& figure) { return paper_data(report, figure); }));
  data.set("elsewhere", list_of(by_words(statements_on(report, 0)), statement_data));
  data.set("sections", list_of(report.sections, section_data));
  if (report.packing) data.set("packing", packing_data(*report.packing));
  data.set("rows", list_of(report.matrix, entry_data));
  data.set("origins", list_of(origins_of(report), origin_data));
  data.set("provenance", list_of(dem::entries(report.provenance), [](const auto& entry) {
             Data pair;
             pair.set("key", entry.first);
             pair.set("value", entry.second);
             return pair;
           }));
  return data;
}

}  // namespace

std::string to_html(const Report& report, const std::filesystem::path& templates) {
  kainjow::mustache::mustache page(read_source(templates / "page.mustache"));
  if (!page.is_valid())
    throw InputError((templates / "page.mustache").string() + ": " + page.error_message());
  Data data = page_data(report);
  data.set("style_sheet", read_source(templates / "page.css"));
  data.set("script", read_source(templates / "page.js"));
  return page.render(data);
}

}  // namespace fiberchain::compare
