//! A browser without a screen, asked over the protocol of its driver.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use base64::Engine;
use serde_json::{Value, json};

use super::error::BrowserError;

/// Nothing that is asked here takes longer.
const PATIENCE: Duration = Duration::from_secs(40);

/// What the browser is started with: no screen, nothing of its own from the network, WebGL without
/// a graphics card. Without a sandbox it runs as root too; it opens nothing but our own files.
const ARGUMENTS: [&str; 13] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-dev-shm-usage",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--window-size=1100,1400",
];

/// The driver; it ends when this is dropped.
#[derive(Debug)]
pub(super) struct Driver {
    child: Child,
    port: u16,
}

/// A browser.
#[derive(Debug)]
pub(super) struct Browser {
    agent: ureq::Agent,
    /// The address of the session.
    session: String,
}

impl Driver {
    /// Starts the driver on a port that is free.
    pub(super) fn start() -> Result<Self, BrowserError> {
        // Its profile is fresh each time: the driver makes one and removes it.
        let mut child = Command::new("chromedriver")
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|source| BrowserError::Missing { program: "chromedriver", source })?;
        let out = child.stdout.take().map(BufReader::new);
        let lines = out.into_iter().flat_map(BufRead::lines).map_while(Result::ok);
        let port = lines.filter_map(|line| {
            let (_, port) = line.split_once("started successfully on port ")?;
            port.trim_end_matches('.').parse().ok()
        });
        let port = port.take(1).last().unwrap_or(0);
        let driver = Self { child, port };
        if port == 0 { Err(BrowserError::NoPort) } else { Ok(driver) }
    }

    /// Starts a browser.
    pub(super) fn browser(&self) -> Result<Browser, BrowserError> {
        let config = ureq::Agent::config_builder().http_status_as_error(false);
        let agent = config.timeout_global(Some(PATIENCE)).build().new_agent();
        let driver = format!("http://127.0.0.1:{}", self.port);
        let browser = Browser { agent, session: driver };
        let options = json!({ "capabilities": { "alwaysMatch": {
            "goog:chromeOptions": { "args": ARGUMENTS },
            "goog:loggingPrefs": { "browser": "ALL", "performance": "ALL" },
        } } });
        let answer = browser.post("session", &options)?;
        let id = answer["sessionId"].as_str().unwrap_or_default();
        let session = format!("{}/session/{id}", browser.session);
        Ok(Browser { session, ..browser })
    }
}

impl Drop for Driver {
    fn drop(&mut self) {
        // What is gone already need not be ended.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Browser {
    /// Opens an address.
    pub(super) fn open(&self, url: &str) -> Result<(), BrowserError> {
        self.post("url", &json!({ "url": url })).map(|_| ())
    }

    /// Makes the window so wide.
    pub(super) fn resize(&self, width: u32, height: u32) -> Result<(), BrowserError> {
        self.post("window/rect", &json!({ "width": width, "height": height })).map(|_| ())
    }

    /// What a function body returns on the page.
    pub(super) fn run(&self, script: &str) -> Result<Value, BrowserError> {
        self.post("execute/sync", &json!({ "script": script, "args": [] }))
    }

    /// A picture of the first element that a selector finds, as PNG.
    pub(super) fn screenshot(&self, selector: &str) -> Result<Vec<u8>, BrowserError> {
        let shot = self.get(&format!("element/{}/screenshot", self.element(selector)?))?;
        let decoded = base64::engine::general_purpose::STANDARD
            .decode(shot.as_str().unwrap_or_default().as_bytes());
        Ok(decoded.unwrap_or_default())
    }

    /// Drags the mouse from the middle of an element by so many pixels.
    pub(super) fn drag(&self, selector: &str, by: [i32; 2]) -> Result<(), BrowserError> {
        let element = json!({ ELEMENT: self.element(selector)? });
        let to = |x: i32, y: i32| {
            let duration = 60;
            json!({
                "type": "pointerMove", "duration": duration, "origin": element, "x": x, "y": y,
            })
        };
        let press = |kind: &str| json!({ "type": kind, "button": 0 });
        let actions = json!({ "actions": [{
            "type": "pointer", "id": "mouse", "parameters": { "pointerType": "mouse" },
            "actions": [
                to(0, 0), press("pointerDown"), to(by[0] / 2, by[1] / 2), to(by[0], by[1]),
                press("pointerUp"),
            ],
        }] });
        self.post("actions", &actions).map(|_| ())
    }

    /// Types into an element.
    pub(super) fn press(&self, selector: &str, keys: &str) -> Result<(), BrowserError> {
        let element = self.element(selector)?;
        self.post(&format!("element/{element}/value"), &json!({ "text": keys })).map(|_| ())
    }

    /// What came to a log of the browser since it was last asked.
    pub(super) fn log(&self, kind: &str) -> Result<Vec<Value>, BrowserError> {
        let log = self.post("se/log", &json!({ "type": kind }))?;
        Ok(log.as_array().cloned().unwrap_or_default())
    }

    /// Ends the browser.
    pub(super) fn close(self) -> Result<(), BrowserError> {
        let mut answer = self.agent.delete(&self.session).call()?;
        value("the end", answer.body_mut().read_json()?).map(|_| ())
    }

    fn element(&self, selector: &str) -> Result<String, BrowserError> {
        let found = self.post("element", &json!({ "using": "css selector", "value": selector }))?;
        Ok(found[ELEMENT].as_str().unwrap_or_default().to_owned())
    }

    fn post(&self, command: &str, body: &Value) -> Result<Value, BrowserError> {
        let mut answer = self.agent.post(format!("{}/{command}", self.session)).send_json(body)?;
        value(command, answer.body_mut().read_json()?)
    }

    fn get(&self, command: &str) -> Result<Value, BrowserError> {
        let mut answer = self.agent.get(format!("{}/{command}", self.session)).call()?;
        value(command, answer.body_mut().read_json()?)
    }
}

/// The key by which the protocol names elements.
const ELEMENT: &str = "element-6066-11e4-a52e-4f735466cecf";

/// What the driver answers, unless that is an error.
fn value(command: &str, mut answer: Value) -> Result<Value, BrowserError> {
    let value = answer["value"].take();
    match value["error"].as_str() {
        Some(error) => Err(BrowserError::Refused {
            command: command.to_owned(),
            message: format!("{error}: {}", value["message"].as_str().unwrap_or_default()),
        }),
        None => Ok(value),
    }
}
