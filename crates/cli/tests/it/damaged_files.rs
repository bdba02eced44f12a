//! Files that are damaged, odd or hostile: the command ends soon, with an answer or one clear
//! error, never in a panic, and writes nothing unless it has an answer.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

use std::fmt::Write as _;
use std::process::Stdio;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use clench_testkit::Random;
use clench_testkit::drawings::{dxf, loop_of, with_tables};

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

type Case = (String, Vec<u8>);

#[test]
fn damaged_files_end_in_one_clear_error() {
    let mut cases = hand_made();
    for (name, good) in good_files() {
        cases.extend(damaged(&name, &good));
    }
    assert!(cases.len() >= FEWEST, "only {} files", cases.len());
    let next = AtomicUsize::new(0);
    let run_all = || {
        let mut refused = 0;
        while let Some((name, content)) = cases.get(next.fetch_add(1, Ordering::Relaxed)) {
            refused += usize::from(run(name, content));
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
fn run(name: &str, content: &[u8]) -> bool {
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
        assert_eq!(folder.names(), [name], "{name}");
    }
    std::fs::remove_dir_all(folder.path("")).unwrap();
    refused
}

/// A good file of each kind.
fn good_files() -> Vec<Case> {
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
        cases.push((format!("{kind}{i}-{name}"), content));
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

fn hand_made() -> Vec<Case> {
    let square = |size: f64, at: f64| {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.6]];
        loop_of("A", &corners.map(|p| p.map(|x| x * size + at)))
    };
    let many = |count: usize, line: &str| line.repeat(count);
    let svg = |content: &str| {
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\">{content}</svg>")
    };
    let mut laughs = "<g id=\"l0\"><circle r=\"1\"/></g>".to_owned();
    for i in 1..20 {
        let below = many(10, &format!("<use href=\"#l{}\"/>", i - 1));
        write!(laughs, "<g id=\"l{i}\">{below}</g>").unwrap();
    }
    let mut entities = "<!DOCTYPE svg [<!ENTITY a \"lol\">".to_owned();
    let mut blocks = "BLOCK - 2 B0\nCIRCLE 0 10 0 20 0 40 1\nENDBLK -\n".to_owned();
    for i in 1..14 {
        let (letter, before) = (char::from(b'a' + i), char::from(b'a' + i - 1));
        let below = many(10, &format!("&{before};"));
        write!(entities, "<!ENTITY {letter} \"{below}\">").unwrap();
        let inserts = many(10, &format!("INSERT 0 2 B{} 10 1 20 1\n", i - 1));
        write!(blocks, "BLOCK - 2 B{i}\n{inserts}ENDBLK -\n").unwrap();
    }
    let entities = format!("{entities}]><svg><text>&j;</text></svg>");
    let deep = format!("{}{}", many(100_000, "<g>"), many(100_000, "</g>"));
    let zigzag = numbered(0..3000, |i| format!("L{} {} ", i, i % 2));
    let bomb = numbered(0..30_000, |i| format!("CIRCLE A 10 {i} 20 0 40 0.1\n"));
    let star = numbered(0..9000, |i| format!("LINE A 10 0 20 0 11 {i} 21 9\n"));
    let nest = numbered(1..2000, |i| format!("CIRCLE A 10 0 20 0 40 {i}\n"));
    let noise: Vec<u8> =
        (0..9000_u32).map(|i| i.wrapping_mul(2_654_435_761).to_le_bytes()[2]).collect();
    let unit = Some(4);
    let far: String = (0..64).fold(String::new(), |all, _| all + "[");
    let list: [(&str, Vec<u8>); 34] = [
        ("empty.dxf", Vec::new()),
        ("empty.svg", Vec::new()),
        ("empty.stl", Vec::new()),
        ("empty.obj", Vec::new()),
        ("empty.toml", Vec::new()),
        ("noise.dxf", noise.clone()),
        ("noise.svg", noise.clone()),
        ("noise.stl", noise.clone()),
        ("noise.obj", noise.clone()),
        ("noise.toml", noise.clone()),
        ("tiny.dxf", dxf(unit, &square(1e-9, 0.0)).into_bytes()),
        ("large.dxf", dxf(unit, &square(1e9, 0.0)).into_bytes()),
        ("away.dxf", dxf(unit, &square(1e-3, 1e9)).into_bytes()),
        ("vast.dxf", dxf(unit, &square(1e99, 0.0)).into_bytes()),
        ("subnormal.dxf", dxf(unit, &square(1e-310, 0.0)).into_bytes()),
        ("bomb.dxf", dxf(unit, &bomb).into_bytes()),
        ("nest.dxf", dxf(unit, &nest).into_bytes()),
        ("spots.dxf", dxf(unit, &many(40_000, "LINE A 10 0 20 0 11 1 21 0\n")).into_bytes()),
        ("star.dxf", dxf(unit, &star).into_bytes()),
        ("blocks.dxf", with_tables(unit, "", &blocks, "INSERT A 2 B13 10 0 20 0").into_bytes()),
        (
            "rows.dxf",
            with_tables(unit, "", &blocks, "INSERT A 2 B1 10 0 20 0 70 9999999999 71 3")
                .into_bytes(),
        ),
        (
            "knots.dxf",
            dxf(unit, &format!("SPLINE A 71 3 {}", many(9000, "40 0 10 1 20 2 "))).into_bytes(),
        ),
        ("degree.dxf", dxf(unit, "SPLINE A 71 99999999999 10 0 20 0").into_bytes()),
        ("thin.dxf", dxf(unit, "ELLIPSE A 10 0 20 0 11 1e9 21 0 40 1e-12").into_bytes()),
        ("codes.dxf", many(50_000, "0\nLINE\n").into_bytes()),
        ("laughs.svg", svg(&format!("{laughs}<use href=\"#l19\"/>")).into_bytes()),
        ("entities.svg", entities.into_bytes()),
        ("deep.svg", svg(&deep).into_bytes()),
        ("unclosed.svg", many(100_000, "<g>").into_bytes()),
        ("zigzag.svg", svg(&format!("<path d=\"M0 0 {zigzag} L3000 90 L0 90 Z\"/>")).into_bytes()),
        ("latin.svg", b"<svg><text>\xe9\xff</text></svg>".to_vec()),
        ("claims.stl", [vec![0; 80], u32::MAX.to_le_bytes().to_vec(), vec![0; 50]].concat()),
        ("numbers.obj", b"v 1e999 nan 0\nv 0 0 0\nv 1 0 0\nf 1 2 99999999999999999999\n".to_vec()),
        ("deep.toml", format!("[part]\nplanar = {}", far.repeat(400)).into_bytes()),
    ];
    list.into_iter().map(|(name, content)| (name.to_owned(), content)).collect()
}

/// A text for each number, one after the other.
fn numbered(range: std::ops::Range<u32>, text: impl Fn(u32) -> String) -> String {
    range.map(text).collect::<Vec<_>>().concat()
}
