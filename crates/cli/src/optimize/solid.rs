//! The placement of fingers on a solid, on its faces or among candidates.

use std::path::{Path, PathBuf};

use clench::contact::{Curvature, Geometry};
use clench::optimize::polyhedron::{self, Fingers, Part, ROUNDNESS, Spacing, Touch, fingers_among};
use clench::optimize::{OptimizeError, Outcome, Placement, Solution};
use clench::shape::{BallTip, Extent, Polyhedron};

use super::found::round;
use super::{Found, Held, On, OutOfRange, Shown, room};
use crate::answer::Answer;
use crate::arguments::OptimizeArguments;
use crate::failure::Failure;
use crate::input::schema::{self, File};
use crate::input::{self, Body, Document, Finite, GivenContact, Holder, Solid};
use crate::picture::{self, Figures, Picture};
use crate::report::html::Source;
use crate::report::{
    self, MeetsReport, OptimumReport, OptimumText, PlacementReport, Question, SolidSubject, Subject,
};

/// Where fingers may go.
enum Places {
    /// On the faces of the part.
    Faces(Box<Part>),
    /// Where one of these contacts is.
    Candidates(Vec<GivenContact>),
}

/// The solid, what is given, and what may be chosen.
struct Task<'a> {
    arguments: &'a OptimizeArguments,
    solid: &'a Solid,
    fixed: Vec<GivenContact>,
    places: Places,
    /// Of those candidates whose tips have room, the numbers.
    open: Vec<usize>,
    left_out: Vec<MeetsReport>,
    overlapping: Vec<MeetsReport>,
    /// The files of what is given.
    given: Vec<Source>,
}

/// Runs the command on a solid.
pub(super) fn optimize(
    arguments: &OptimizeArguments,
    document: &Document,
    mut file: schema::File,
    body: &Body<Solid>,
) -> Result<Answer, Failure> {
    arguments.check_for_solid().map_err(|message| Failure::Usage { message })?;
    let tip = asked_tip(arguments, document, &mut file)?;
    let mut task = Task::new(arguments, document, &file, (body, &tip))?;
    let besides: Vec<_> = input::mesh_file(document, &file.part).into_iter().collect();
    arguments.output.check_apart(besides.iter().map(PathBuf::as_path))?;
    name_mesh(&mut file.part, document);
    let mut warnings = super::left_aside(document, &file);
    warnings.extend(report::in_pieces(body.shape.polyhedron.pieces()));
    let question = Question {
        // Candidates may be anywhere.
        most_on_face: Some(match arguments.candidates {
            Some(_) => arguments.fingers,
            None => arguments.most_on_face(),
        }),
        roundness: Some(arguments.roundness.unwrap_or(ROUNDNESS)),
        flatness: Some(body.shape.flatness),
        warnings: &warnings,
        ..super::question(arguments, &file, (3, &arguments.effort_on_solid()))
    };
    let outcome = match task.restricted(&tip).and_then(|()| task.search(&question)) {
        Ok(outcome) => outcome,
        Err(error) if super::is_unanswered(&error) => {
            return super::unanswered(arguments, &question, &error);
        }
        Err(error) => return Err(super::refused(document.name(), error)),
    };
    let placement = |solution| {
        let found = task.examined(solution)?;
        Ok(PlacementReport::spatial(&question, &found))
    };
    let others = outcome.others.iter().map(placement).collect::<Result<Vec<_>, OutOfRange>>();
    let placements = placement(&outcome.best).and_then(|best| Ok((best, others?)));
    let placements = placements.map_err(super::out_of_range(document.name()))?;
    let surface = match &task.places {
        Places::Faces(part) => room::surface(part),
        Places::Candidates(_) => None,
    };
    let accessible = room::report(surface, &task.left_out, &task.overlapping);
    let report =
        OptimumReport { accessible, ..OptimumReport::new(&question, &outcome, placements) };
    let picture = picture::of_optimum_on_solid(&report, &outcome.best, &body.shape);
    let figures = super::drawn(arguments, || Figures::of_optimum_on_solid(&report, &picture))?;
    let subject = Subject::Solid(SolidSubject {
        solid: &body.shape.polyhedron,
        places: match &task.places {
            Places::Faces(part) => part.facets().len(),
            Places::Candidates(_) => task.open.len(),
        },
        chosen: matches!(task.places, Places::Candidates(_)),
        fixed: task.fixed.len(),
    });
    let texts = document.sources().into_iter().chain(task.given).collect();
    let words = OptimumText { name: document.name(), subject, report: &report };
    let picture = Picture::Solid(picture);
    super::answered(arguments, &words, Shown { picture, figures, texts, besides })
}

/// The tip of the fingers that are placed; the file gets the margin that was asked for, so that a
/// report repeats it.
fn asked_tip(
    arguments: &OptimizeArguments,
    document: &Document,
    file: &mut schema::File,
) -> Result<BallTip, Failure> {
    let refused = |option: &str| {
        let option = option.to_owned();
        move |error| {
            let source = Box::new(OptimizeError::Access(error));
            Failure::Option { option, source }
        }
    };
    let Some(spatial) = &mut file.part.spatial else {
        return BallTip::new(arguments.finger_radius).map_err(refused("--finger-radius"));
    };
    let tip = input::tip(document, spatial)?;
    let tip = tip.with_radius(arguments.finger_radius).map_err(refused("--finger-radius"))?;
    let Some(margin) = arguments.margin else { return Ok(tip) };
    let margin = margin.max(tip.margin());
    spatial.margin = Some(Finite(margin));
    tip.with_margin(margin).map_err(refused("--margin"))
}

/// Names the mesh as it is found from the current folder, where a report is likely to be read.
fn name_mesh(part: &mut schema::Part, document: &Document) {
    let path = input::mesh_file(document, part);
    if let (Some(spatial), Some(path)) = (&mut part.spatial, path) {
        spatial.mesh = Some(input::FileName(path.display().to_string()));
    }
}

impl<'a> Task<'a> {
    fn new(
        arguments: &'a OptimizeArguments,
        document: &Document,
        file: &File,
        (body, tip): (&'a Body<Solid>, &BallTip),
    ) -> Result<Self, Failure> {
        let holder = Holder { name: document.name(), units: &file.units, body };
        let mut sources = Vec::new();
        let mut given = |path: &Path| -> Result<_, Failure> {
            let (contacts, source) = input::given_contacts(path, holder)?;
            sources.push(source);
            Ok(contacts)
        };
        let fixed = arguments.fix.as_deref().map_or(Ok(Vec::new()), &mut given)?;
        let places = match arguments.candidates.as_deref() {
            None => Places::Faces(Box::new(input::touchable(document, &file.part, body)?)),
            Some(path) => Places::Candidates(given(path)?),
        };
        let solid = &body.shape;
        let overlapping = room::overlapping(solid, &fixed, &radii(&fixed, 0.0), tip);
        let left_out = match &places {
            Places::Faces(_) => Vec::new(),
            Places::Candidates(all) => {
                room::obstructed(solid, all, &radii(all, arguments.finger_radius), tip)
            }
        };
        let count = match &places {
            Places::Faces(_) => 0,
            Places::Candidates(all) => all.len(),
        };
        let is_open = |i: &usize| left_out.iter().all(|out| out.contact != *i);
        let open = (0..count).filter(is_open).collect();
        Ok(Self { arguments, solid, fixed, places, open, left_out, overlapping, given: sources })
    }

    /// Keeps to where a tip has room.
    fn restricted(&mut self, tip: &BallTip) -> Result<(), OptimizeError> {
        let (left, fingers) = (self.open.len(), self.arguments.fingers);
        match &mut self.places {
            Places::Faces(part) => **part = part.as_ref().clone().accessible_to(tip)?,
            Places::Candidates(_) if left < fingers && !self.left_out.is_empty() => {
                let out = self.left_out.len();
                return Err(OptimizeError::CandidatesObstructed { left, out, fingers });
            }
            Places::Candidates(_) => {}
        }
        Ok(())
    }

    fn search(&self, question: &Question<'_>) -> Result<Outcome<3, 3>, OptimizeError> {
        let arguments = self.arguments;
        let asked = Fingers {
            fixed: self.fixed.iter().map(GivenContact::touch).collect(),
            objective: arguments.objective(3),
            least_share: arguments.least_share,
            most_on_face: arguments.most_on_face(),
            roundness: arguments.roundness.unwrap_or(ROUNDNESS),
            spacing: Spacing {
                radius: arguments.finger_radius,
                clearance: arguments.clearance.unwrap_or(0.0),
                given: radii(&self.fixed, 0.0),
                candidates: match &self.places {
                    Places::Faces(_) => Vec::new(),
                    Places::Candidates(all) => {
                        let all = radii(all, arguments.finger_radius);
                        self.open.iter().map(|&i| all[i]).collect()
                    }
                },
            },
            ..Fingers::new(arguments.fingers)
        };
        let effort = arguments.effort_on_solid();
        super::watched(question.units, |watch| match &self.places {
            Places::Faces(part) => polyhedron::fingers(part, &asked, &effort, watch),
            Places::Candidates(candidates) => {
                let touches: Vec<Touch> =
                    self.open.iter().map(|&i| candidates[i].touch()).collect();
                let body = self.polyhedron().extreme_points();
                fingers_among(body, &touches, &asked, &effort, watch)
            }
        })
    }

    /// What the search does not say about a placement.
    fn examined<'s>(&self, solution: &'s Solution<3, 3>) -> Result<Found<'s, 3, 3>, OutOfRange> {
        let fixed = self.fixed.iter().zip(&solution.given_shares);
        let fixed = fixed.map(|(given, &share)| held(given, given.face.map(On::Face), share));
        let fixed = fixed.map(|held| Held { fixed: true, ..held });
        let placed = solution.placements.iter().map(|p| self.placed(p));
        let contacts = fixed.chain(placed).collect();
        let body = Extent::from(self.polyhedron());
        Found::new(solution, contacts, body, self.arguments.preload)
    }

    fn placed(&self, placement: &Placement<3>) -> Held<3> {
        let Placement { on, point, inward_normal, share } = *placement;
        let radius = self.arguments.finger_radius;
        match &self.places {
            Places::Faces(part) => Held {
                on: Some(On::Face(on)),
                fixed: false,
                geometry: Geometry::on_face(point, inward_normal, radius),
                finger: round(radius),
                stiffness: part.face_stiffness()[on],
                share: share.max(0.0),
            },
            Places::Candidates(candidates) => {
                let number = self.open[on];
                let given = &candidates[number];
                let held = held(given, Some(On::Candidate(number)), share);
                if given.finger.is_some() {
                    return held;
                }
                let geometry = Geometry { finger: Curvature::round(radius), ..held.geometry };
                Held { geometry, finger: round(radius), ..held }
            }
        }
    }

    fn polyhedron(&self) -> &Polyhedron {
        &self.solid.polyhedron
    }
}

/// The radii of the tips of contacts; `other` of those that have no finger.
fn radii(contacts: &[GivenContact], other: f64) -> Vec<f64> {
    contacts.iter().map(|contact| contact.tip_radius().unwrap_or(other)).collect()
}

fn held(given: &GivenContact, on: Option<On>, share: f64) -> Held<3> {
    Held {
        on,
        fixed: false,
        geometry: given.geometry(),
        finger: given.finger.clone().unwrap_or_else(|| round(0.0)),
        stiffness: given.touch().stiffness,
        // Shares are zero or more up to rounding.
        share: share.max(0.0),
    }
}
