//! What a page has to be like in a browser.

use std::collections::BTreeSet;

use resvg::tiny_skia::Pixmap;
use serde_json::Value;

use super::driver::Browser;
use super::error::BrowserError;
use super::pages::{Made, Page};

/// A picture of a part has at least so many colors: its faces or its inside, lines and letters.
const COLORS: usize = 12;

/// Tables have six digits.
const DIGITS: f64 = 1e-5;

/// The numbers of a report that its tables repeat.
const NUMBERS: [&str; 9] = [
    "/quality",
    "/sigma_min",
    "/mu_eq",
    "/worst_point_stiffness",
    "/contacts/0/point/0",
    "/contacts/1/point/1",
    "/contacts/2/stiffness",
    "/load_cases/0/largest/distance",
    "/load_cases/0/contact_forces/1/force",
];

/// What the browser says of itself where a graphics card is missing: taking a picture is slow then.
const SLOW: &str = "GPU stall due to ReadPixels";

/// Keys of the protocol.
const ARROW_LEFT: &str = "\u{e012}";

/// Opens the page and checks all of it.
pub(super) fn all(browser: &Browser, page: &Page, made: &Made) -> Result<(), BrowserError> {
    let check = Check { browser, page };
    browser.resize(1100, 1400)?;
    browser.open(&made.url)?;
    check.numbers(&made.report)?;
    check.markup()?;
    let picture = if page.turns { "#solid canvas" } else { "figure svg" };
    check.picture("the picture", picture)?;
    if page.turns {
        check.turning(picture)?;
    }
    browser.resize(420, 900)?;
    check.picture("the picture in a narrow window", picture)?;
    check.is(
        "the page in a narrow window",
        "return document.documentElement.scrollWidth <= window.innerWidth ? 'fits' : 'is wider'",
        "fits",
    )?;
    check.silence(&made.url)
}

#[derive(Debug)]
struct Check<'a> {
    browser: &'a Browser,
    page: &'a Page,
}

impl Check<'_> {
    /// The tables have what the report has.
    fn numbers(&self, report: &Value) -> Result<(), BrowserError> {
        let script =
            "return [...document.querySelectorAll('table')].map(t => t.innerText).join(' ')";
        let text = self.browser.run(script)?;
        let text = text.as_str().unwrap_or_default();
        let shown = text.split(|c: char| c.is_whitespace() || "(),".contains(c));
        let shown: Vec<f64> = shown.filter_map(|word| word.parse().ok()).collect();
        let mut found = 0;
        for key in NUMBERS {
            let Some(number) = report.pointer(key).and_then(Value::as_f64) else { continue };
            found += 1;
            if !shown.iter().any(|s| (s - number).abs() <= DIGITS * number.abs()) {
                let (what, expected) = (format!("tables, for {key}"), number.to_string());
                return Err(self.differs(&what, "no such number", &expected));
            }
        }
        if found < 6 {
            return Err(self.differs("report", &format!("{found} numbers"), "6 or more"));
        }
        Ok(())
    }

    /// No element or script that is not ours.
    fn markup(&self) -> Result<(), BrowserError> {
        let scripts = if self.page.turns { 3 } else { 0 };
        self.is(
            "scripts",
            "return String(document.querySelectorAll('script').length)",
            &scripts.to_string(),
        )?;
        self.is(
            "foreign elements",
            "return String(document.querySelectorAll('img, iframe, object, embed, link').length)",
            "0",
        )
    }

    /// The view follows the mouse and the keys, and shows load cases.
    fn turning(&self, canvas: &'static str) -> Result<(), BrowserError> {
        let mut seen = vec![self.browser.screenshot(canvas)?];
        self.browser.drag(canvas, [160, 60])?;
        self.turned("a drag of the mouse", canvas, &mut seen)?;
        self.browser.press(canvas, ARROW_LEFT)?;
        self.turned("an arrow key", canvas, &mut seen)?;
        self.browser.run("document.querySelector('button[data-view=top]').click()")?;
        self.turned("the button for the top", canvas, &mut seen)?;
        let case = "const c = document.querySelector('input[value=\"0\"]'); if (c) c.click(); \
                    return String(Boolean(c))";
        if self.browser.run(case)? == "true" {
            self.turned("the choice of a load case", canvas, &mut seen)?;
        }
        Ok(())
    }

    /// The view is none of those before.
    fn turned(
        &self,
        what: &str,
        canvas: &'static str,
        seen: &mut Vec<Vec<u8>>,
    ) -> Result<(), BrowserError> {
        let now = self.browser.screenshot(canvas)?;
        if seen.contains(&now) {
            return Err(self.differs(what, "the view of before", "another view"));
        }
        seen.push(now);
        self.picture(what, canvas)
    }

    /// An element is a picture of something.
    fn picture(&self, what: &str, selector: &'static str) -> Result<(), BrowserError> {
        let png = self.browser.screenshot(selector)?;
        let unreadable = BrowserError::Screenshot { page: self.page.name, what: selector };
        let Ok(pixels) = Pixmap::decode_png(&png) else { return Err(unreadable) };
        let colors = pixels.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]);
        let colors = colors.collect::<BTreeSet<_>>().len();
        if colors < COLORS {
            let found = format!("{colors} colors");
            return Err(self.differs(what, &found, &format!("{COLORS} or more")));
        }
        Ok(())
    }

    /// A function body returns this text.
    fn is(&self, what: &str, script: &str, expected: &str) -> Result<(), BrowserError> {
        let found = self.browser.run(script)?;
        if found == expected {
            return Ok(());
        }
        Err(self.differs(what, &found.to_string(), expected))
    }

    /// The browser had nothing to complain of, and nothing was asked of anybody.
    fn silence(&self, url: &str) -> Result<(), BrowserError> {
        let page = self.page.name;
        let said = self.browser.log("browser")?;
        let is_ours = |entry: &&Value| !entry["message"].to_string().contains(SLOW);
        if let Some(entry) = said.iter().find(is_ours) {
            let message = format!("{}: {}", entry["level"], entry["message"]);
            return Err(BrowserError::Complaint { page, message });
        }
        for entry in self.browser.log("performance")? {
            let message = entry["message"].as_str().unwrap_or_default();
            let event: Value = serde_json::from_str(message).unwrap_or_default();
            let event = &event["message"];
            if event["method"] != "Network.requestWillBeSent" {
                continue;
            }
            let asked = event["params"]["request"]["url"].as_str().unwrap_or_default();
            if asked != url {
                return Err(BrowserError::Request { page, url: asked.to_owned() });
            }
        }
        Ok(())
    }

    fn differs(&self, what: &str, found: &str, expected: &str) -> BrowserError {
        BrowserError::Differs {
            page: self.page.name,
            what: what.to_owned(),
            found: found.to_owned(),
            expected: expected.to_owned(),
        }
    }
}
