//! Preloads that keep every contact on the part, in words.

use super::analysis_text::AnalysisText;
use super::needed::{BasisWord, FoundPreloads, NeededReport, RemedyReport};
use super::number::beside;
use super::page::Page;
use crate::wording::{digits, precise_digits};

impl AnalysisText<'_> {
    /// The preloads that the load cases need.
    pub(super) fn needed_preloads(&self, page: &mut Page) {
        let Some(needed) = &self.report.needed_preloads else { return };
        let NeededReport { reserve, least, scaled } = needed;
        let unit = &self.report.units.force;
        page.line("");
        let what = if *reserve > 0.0 {
            format!("under which each contact keeps {} of its preload", digits(*reserve))
        } else {
            "under which no contact lifts off".to_owned()
        };
        page.line(format_args!("preloads {what}, whatever load case acts"));
        let columns = [column("least total", least), column("all times", scaled)];
        let columns: Vec<_> = columns.into_iter().flatten().collect();
        if !columns.is_empty() {
            let mut head = vec!["contact".to_owned(), format!("present [{unit}]")];
            for (name, _) in &columns {
                head.extend([format!("{name} [{unit}]"), format!("{name}, under load [{unit}]")]);
            }
            let mut rows = vec![head];
            for (i, contact) in self.report.contacts.iter().enumerate() {
                let mut row = vec![i.to_string(), precise_digits(contact.preload)];
                for (_, found) in &columns {
                    row.extend([
                        precise_digits(found.preloads[i]),
                        beside(found.total, found.least_forces[i]),
                    ]);
                }
                rows.push(row);
            }
            let present = self.report.contacts.iter().map(|contact| contact.preload).sum();
            let mut total = vec!["total".to_owned(), digits(present)];
            for (_, found) in &columns {
                total.extend([digits(found.total), String::new()]);
            }
            rows.push(total);
            page.table(&rows);
            page.line("under load: the least force of the contact under any load case");
        }
        for (remedy, what) in
            [(least, "no preloads do"), (scaled, "scaling the present ones does not")]
        {
            match remedy {
                RemedyReport::None { reason } => page.line(format_args!("{what}: {reason}")),
                RemedyReport::Found(found) if found.basis == BasisWord::Present => page.line(
                    "to first order at the present preloads: how forces change depends on \
                     preloads, and that did not settle",
                ),
                RemedyReport::Found(_) => {}
            }
        }
    }
}

/// A column of the table, if there are such preloads.
fn column<'a>(name: &str, remedy: &'a RemedyReport) -> Option<(String, &'a FoundPreloads)> {
    let RemedyReport::Found(found) = remedy else { return None };
    let factor = found.factor.map(|factor| format!("{name} {}", digits(factor)));
    Some((factor.unwrap_or_else(|| name.to_owned()), found))
}
