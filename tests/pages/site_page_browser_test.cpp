// A page of the site in a browser: the search, the list of pages, phones, no network requests.
#include <fstream>

#include "demos/site/documents.h"
#include "demos/site/key_reference.h"
#include "demos/site/site_html.h"
#include "demos/site/site_links.h"
#include "tests/pages/driver.h"

namespace {

using namespace demos;
using support::driver;
using support::Opened;
using support::told;

class SiteInBrowser : public testing::Test {
protected:
    SiteInBrowser() {
        SearchIndex index;
        index.add(*pageShowing(kTroubles), content(kTroubles));
        for (const SitePage& page : sitePages())
            if (page.file == std::string(kKeysPage)) index.add(page, keyReference());
        std::ofstream(folder_ / "search.js") << index.text();
    }

    static DocumentHtml content(const char* source) {
        return documentHtml(documentAt(source)->text, linksOf(*pageShowing(source), {}));
    }

    Opened open(const char* source, const std::string& steps,
                std::optional<support::Window> window = {}) const {
        return browser_.open(sitePageHtml(pageShowing(source), content(source)), "", driver(steps),
                             window);
    }

    static constexpr const char* kTroubles = "demos/scenes/what-went-wrong.md";
    support::TemporaryFolder folder_;
    support::Browser browser_{folder_};
};

TEST(Browser, ShowsNothingOfThePageBefore) {
    const support::TemporaryFolder folder;
    const support::Browser browser(folder);
    const std::string script = R"js(
  document.title = `was ${[localStorage.a, sessionStorage.a, window.name, innerWidth]}`;
  localStorage.a = sessionStorage.a = window.name = "b";
  console.log("c");
)js";
    const std::optional<support::Window> small = support::Window{500, 400}, usual;
    for (const auto& window : {usual, small, usual}) {
        const Opened opened = browser.open("<title></title><body></body>", "", script, window);
        EXPECT_NE(opened.dom.find(window ? "was ,,,500<" : "was ,,,1400<"), std::string::npos)
            << opened.dom;
        EXPECT_EQ(opened.console.size(), 1u);
    }
}

const std::string kAsk = R"js(
  const shown = () => [...byId("found").querySelectorAll("a")];
  const ask = async (text) => {
    byId("search").value = text;
    byId("search").dispatchEvent(new Event("input"));
    await comes(() => !byId("found").hidden && byId("found").dataset.asked === text);
  };
)js";

TEST_F(SiteInBrowser, TheSearchFindsTextsAndKeys) {
    const Opened opened = open(kTroubles, kAsk + R"js(
  await key("/");
  tell(document.activeElement.id);
  await ask("explodes");
  tell(shown()[0].getAttribute("href"));
  tell(shown()[0].querySelector("mark").textContent);
  await ask("sweeps");
  tell(shown()[0].getAttribute("href"));
  const press = (name) => byId("search").dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));
  press("ArrowDown");
  tell(shown().findIndex((link) => link.classList.contains("chosen")));
  await ask("<b>nothing</b>");
  tell(byId("found").textContent);
  press("Escape");
  tell(byId("found").hidden);
)js");
    EXPECT_EQ(told(opened),
              "[search][what-went-wrong.html][explodes][keys.html#solver.sweeps][1]"
              "[Nothing has \u201c&lt;b&gt;nothing&lt;/b&gt;\u201d.][true]");
    EXPECT_TRUE(opened.console.empty()) << opened.console.front();
    EXPECT_TRUE(opened.requests.empty()) << opened.requests.front();
}

TEST_F(SiteInBrowser, TextsStandOutFromWhatIsUnderThem) {
    EXPECT_EQ(told(open(kTroubles, kAsk + "await ask('explodes');" + support::kTellFaintTexts)),
              "[][][true]");
}

/// On a phone nothing is wider than the page, and the list of pages opens on demand.
TEST_F(SiteInBrowser, APhoneShowsAllOfIt) {
    const Opened opened = open("demos/scenes/recipes.md", R"js(
  const shows = () => byId("pages").checkVisibility();
  tell(document.documentElement.scrollWidth <= 390);
  tell(shows());
  byId("menu").click();
  tell(shows());
  tell(byId("pages").querySelector("[aria-current]").textContent);
  tell(document.querySelectorAll(".copy").length > 12);
)js",
                               support::Window{390, 844});
    EXPECT_EQ(told(opened), "[true][false][true][Recipes][true]");
}

}  // namespace
