//! Files that are damaged, odd or hostile: the command ends soon, with an answer or one clear
//! error, never in a panic, and writes nothing unless it has an answer.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

use std::fmt::Write as _;
use std::process::Stdio;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use clench_testkit::Random;
use clench_testkit::drawings::with_tables;

use crate::hand_made_files::{Ending, HandMade, hand_made};
use crate::run::{Folder, command};

/// No file may keep the command longer, however busy the machine is.
const LONGEST: Duration = Duration::from_secs(20);

/// Files that are run at least.
const FEWEST: usize = 200;

/// Damaged copies of each good file.
const CUTS: usize = 14;
const CHANGES: usize = 26;

/// What stands where a number was.
const ODD: [&str; 10] =
    ["nan", "inf", "-inf", "1e999", "-1e308", "1e-320", "", "0x1F", "1,5", "999999999999999999999"];

/// A file, and how the command has to end on it, if that is known.
struct Case {
    name: String,
    content: Vec<u8>,
    ending: Option<Ending>,
}

#[test]
fn damaged_files_end_in_one_clear_error() {
    let by_hand = |HandMade { name, content, ending }: HandMade| Case {
        name: name.to_owned(),
        content,
        ending: Some(ending),
    };
    let mut cases: Vec<Case> = hand_made().into_iter().map(by_hand).collect();
    for (name, good) in good_files() {
        cases.extend(damaged(&name, &good));
    }
    assert!(cases.len() >= FEWEST, "only {} files", cases.len());
    let next = AtomicUsize::new(0);
    let run_all = || {
        let mut refused = 0;
        while let Some(case) = cases.get(next.fetch_add(1, Ordering::Relaxed)) {
            refused += usize::from(run(case));
        }
        refused
    };
    let refused: usize = thread::scope(|scope| {
        let workers = [(); 4].map(|()| scope.spawn(run_all));
        workers.into_iter().map(|worker| worker.join().unwrap()).sum()
    });
    // Most damage is such that there is no part left.
    assert!(refused * 2 > cases.len(), "{refused} of {} refused", cases.len());
}

/// Runs the command on a file, and says whether it was refused.
fn run(Case { name, content, ending }: &Case) -> bool {
    let folder = Folder::new(&format!("damaged-{name}"));
    folder.write(name, content);
    let alone = if name.ends_with("toml") { "" } else { " --stiffness 5 --units mm" };
    let line = format!("optimize {name} --fingers 7 --nodes 3 --svg out.svg{alone}");
    // Seven fingers hold a solid without others; on an outline they are as good as four.
    let start = Instant::now();
    let mut child = command(line.split(' '))
        .current_dir(folder.path(""))
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > LONGEST {
            child.kill().unwrap();
            panic!("{name}: still runs after {LONGEST:?}");
        }
        thread::sleep(Duration::from_millis(2));
    }
    let output = child.wait_with_output().unwrap();
    let code = output.status.code();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(matches!(code, Some(0..=3)), "{name}: {code:?}: {message}");
    assert!(!message.contains("panicked"), "{name}: {message}");
    let refused = matches!(code, Some(1 | 2));
    if refused {
        assert_eq!(message.matches("  × ").count(), 1, "{name}: {message}");
        assert!(output.stdout.is_empty(), "{name}");
        assert_eq!(folder.names(), [name.as_str()], "{name}");
    }
    if let Some(Ending { code: expected, says }) = ending {
        assert_eq!(code, Some(*expected), "{name}: {message}");
        let said = message + &String::from_utf8(output.stdout).unwrap();
        assert!(said.contains(says), "{name}: `{says}` is missing in: {said}");
    }
    std::fs::remove_dir_all(folder.path("")).unwrap();
    refused
}

/// A good file of each kind.
fn good_files() -> Vec<(String, Vec<u8>)> {
    let plate = include_bytes!("../../../../parts/plate.dxf").to_vec();
    let block = "BLOCK - 2 B 10 0 20 0\nCIRCLE 0 10 4 20 4 40 1\nENDBLK -";
    let curves = "LWPOLYLINE A 90 4 70 1 10 0 20 0 10 40 20 0 42 1 10 40 20 10 10 0 20 10\n\
                  INSERT A 2 B 10 5 20 1\nELLIPSE A 10 20 20 5 11 4 21 0 40 0.5 41 0 42 6.2831853\n\
                  SPLINE A 70 11 71 3 74 4 11 30 21 3 11 33 21 5 11 30 21 7 11 27 21 5";
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"60mm\" height=\"40mm\" \
               viewBox=\"0 0 60 40\"><g id=\"a\" transform=\"translate(2 3) rotate(10 5 5)\">\
               <path d=\"M0 0 H50 C55 0 55 10 50 10 L10 12 A5 5 0 0 1 0 10 Z\"/></g>\
               <use href=\"#c\" x=\"20\" y=\"10\"/><defs><circle id=\"c\" r=\"2\"/></defs>\
               <rect x=\"30\" y=\"9\" width=\"6\" height=\"3\" rx=\"1\"/></svg>";
    let outline = "units = { length = \"mm\", force = \"N\" }\n[part.planar]\n\
                   outline = [[0, 0], [13, 0], [9, 8], [2, 6]]\nstiffness = [1, 2, 3, 4]\n\
                   holes = [[[5, 2], [6, 2], [6, 3]]]\nmargin = 0.25\nforbidden = [0]\n";
    let obj = "v 0 0 0\nv 9 0 0\nv 9 8 0\nv 0 8 0\nv 0 0 7\nv 9 0 7\nv 9 8 7\nv 0 8 7\n\
               f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    vec![
        ("plate.dxf".to_owned(), plate),
        ("curves.dxf".to_owned(), with_tables(Some(4), "", block, curves).into_bytes()),
        ("page.svg".to_owned(), svg.as_bytes().to_vec()),
        ("part.toml".to_owned(), outline.as_bytes().to_vec()),
        ("box.obj".to_owned(), obj.as_bytes().to_vec()),
        ("text.stl".to_owned(), text_stl().into_bytes()),
        ("binary.stl".to_owned(), binary_stl()),
    ]
}

const TETRAHEDRON: [[[f32; 3]; 3]; 4] = [
    [[0.0, 0.0, 0.0], [0.0, 9.0, 0.0], [9.0, 0.0, 0.0]],
    [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 0.0, 9.0]],
    [[0.0, 0.0, 0.0], [0.0, 0.0, 9.0], [0.0, 9.0, 0.0]],
    [[9.0, 0.0, 0.0], [0.0, 9.0, 0.0], [0.0, 0.0, 9.0]],
];

fn text_stl() -> String {
    let mut text = "solid part\n".to_owned();
    for triangle in TETRAHEDRON {
        text += "facet normal 0 0 0\nouter loop\n";
        for [x, y, z] in triangle {
            writeln!(text, "vertex {x} {y} {z}").unwrap();
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid part\n"
}

fn binary_stl() -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes.extend(4_u32.to_le_bytes());
    for triangle in TETRAHEDRON {
        bytes.extend([0; 12]);
        for number in triangle.into_iter().flatten() {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Cut off, and changed in single bytes, words and lines; always in the same way.
fn damaged(name: &str, good: &[u8]) -> Vec<Case> {
    let mut random = Random::new(good.len() as u64);
    let mut cases = Vec::new();
    let mut keep = |kind: &str, i: usize, content: Vec<u8>| {
        cases.push(Case { name: format!("{kind}{i}-{name}"), content, ending: None });
    };
    for i in 0..CUTS {
        keep("cut", i, good[..random.below(good.len())].to_vec());
    }
    for i in 0..CHANGES {
        let mut content = good.to_vec();
        match i % 4 {
            0 => {
                for _ in 0..=random.below(4) {
                    let at = random.below(content.len());
                    content[at] = u8::try_from(random.below(256)).unwrap();
                }
            }
            1 => {
                let (at, length) = (random.below(content.len()), 1 + random.below(12));
                content.drain(at..(at + length).min(good.len()));
            }
            2 => {
                let at = random.below(content.len());
                let piece = content[at..(at + 40).min(good.len())].to_vec();
                let to = random.below(content.len());
                content.splice(to..to, piece);
            }
            _ => content = odd_number(&content, ODD[random.below(ODD.len())], &mut random),
        }
        keep("changed", i, content);
    }
    cases
}

/// The file with `odd` in place of one of its numbers.
fn odd_number(content: &[u8], odd: &str, random: &mut Random) -> Vec<u8> {
    let digit = |i: usize| content[i].is_ascii_digit();
    let starts: Vec<usize> = (1..content.len()).filter(|&i| digit(i) && !digit(i - 1)).collect();
    let start = starts.get(random.below(starts.len().max(1))).copied().unwrap_or(0);
    let mut end = start;
    while end < content.len() && (digit(end) || content[end] == b'.') {
        end += 1;
    }
    [&content[..start], odd.as_bytes(), &content[end..]].concat()
}
