//! The placement of fingers on a solid, on its faces or among candidates.

use std::path::Path;

use clench::contact::{Curvature, Geometry};
use clench::optimize::polyhedron::{self, Fingers, Part, ROUNDNESS, Touch, fingers_among};
use clench::optimize::{OptimizeError, Outcome, Placement, Solution};
use clench::shape::{Extent, Polyhedron};

use super::found::round;
use super::{Found, Held, On, OutOfRange, Shown};
use crate::answer::Answer;
use crate::arguments::OptimizeArguments;
use crate::failure::Failure;
use crate::input::schema::{self, File};
use crate::input::{self, Body, Document, GivenContact, Holder, Solid};
use crate::picture::{self, Figures, Picture};
use crate::report::html::Source;
use crate::report::{OptimumReport, OptimumText, PlacementReport, Question, SolidSubject, Subject};

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
    let task = Task::new(arguments, document, &file, body)?;
    let meshes = input::mesh_file(document, &file.part).into_iter().collect();
    name_mesh(&mut file.part, document);
    let question = Question {
        // Candidates may be anywhere.
        most_on_face: Some(match arguments.candidates {
            Some(_) => arguments.fingers,
            None => arguments.most_on_face.get(),
        }),
        roundness: Some(arguments.roundness.unwrap_or(ROUNDNESS)),
        flatness: Some(body.shape.flatness),
        ..super::question(arguments, &file, (3, &arguments.effort_on_solid()))
    };
    let outcome = match task.search(&question) {
        Ok(outcome) => outcome,
        Err(error) if super::is_unanswered(&error) => {
            let fixed: Vec<Touch> = task.fixed.iter().map(GivenContact::touch).collect();
            let picture = Picture::Solid(picture::of_solid(&body.shape, &fixed));
            let shown = Shown { picture, figures: None, texts: Vec::new(), meshes };
            return super::unanswered(arguments, &question, &error, shown);
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
    let report = OptimumReport::new(&question, &outcome, placements);
    let picture = picture::of_optimum_on_solid(&report, &outcome.best, &body.shape);
    let figures = super::drawn(arguments, || Figures::of_optimum_on_solid(&report, &picture))?;
    let subject = Subject::Solid(SolidSubject {
        solid: &body.shape.polyhedron,
        places: match &task.places {
            Places::Faces(part) => part.facets().len(),
            Places::Candidates(candidates) => candidates.len(),
        },
        chosen: matches!(task.places, Places::Candidates(_)),
        fixed: task.fixed.len(),
    });
    let texts = document.sources().into_iter().chain(task.given).collect();
    let words = OptimumText { name: document.name(), subject, report: &report };
    let picture = Picture::Solid(picture);
    super::answered(arguments, &words, Shown { picture, figures, texts, meshes })
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
        body: &'a Body<Solid>,
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
        Ok(Self { arguments, solid: &body.shape, fixed, places, given: sources })
    }

    fn search(&self, question: &Question<'_>) -> Result<Outcome<3, 3>, OptimizeError> {
        let arguments = self.arguments;
        let asked = Fingers {
            fixed: self.fixed.iter().map(GivenContact::touch).collect(),
            objective: arguments.objective(3),
            least_share: arguments.least_share,
            most_on_face: arguments.most_on_face.get(),
            roundness: arguments.roundness.unwrap_or(ROUNDNESS),
            ..Fingers::new(arguments.fingers)
        };
        let effort = arguments.effort_on_solid();
        super::watched(question.units, |watch| match &self.places {
            Places::Faces(part) => polyhedron::fingers(part, &asked, &effort, watch),
            Places::Candidates(candidates) => {
                let touches: Vec<Touch> = candidates.iter().map(GivenContact::touch).collect();
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
                let given = &candidates[on];
                let held = held(given, Some(On::Candidate(on)), share);
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
