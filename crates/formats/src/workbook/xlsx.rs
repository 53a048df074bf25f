//! Sheets of Excel's `.xlsx`: the parts of the workbook, then the cells of one sheet.

use boundfit_exact::Foreign;
use quick_xml::events::Event;

use super::archive::{Archive, attribute, unreadable};
use super::text::Lines;
use super::xlsx_book::{Book, refuse_many};
use super::xlsx_cells::read_cells;
use super::{Choice, Listed, chosen};

use crate::error::InputErrorKind;

/// Hands the cells of the sheet that is wanted over; gives the sheet.
pub(super) fn read_sheet(
    archive: &mut Archive,
    wanted: Option<&str>,
    lines: &mut Lines,
) -> Result<Choice, InputErrorKind> {
    let package = relations(archive, "_rels/.rels", "")?;
    let main = path_of(&package, "officeDocument").unwrap_or("xl/workbook.xml");
    let (folder, file) = main.rsplit_once('/').unwrap_or(("", main));
    let parts = relations(archive, &join(folder, &format!("_rels/{file}.rels")), folder)?;
    let of_kind = |kind: &str, usual: &str| {
        path_of(&parts, kind).map_or_else(|| join(folder, usual), ToOwned::to_owned)
    };
    let mut book = Book::default();
    let mut sheets = book.read_workbook(archive, main)?;
    // Charts, dialogs and macros are sheets too.
    let path_of_sheet = |id: &str| {
        let part = parts.iter().find(|part| part.id == id && part.kind == "worksheet");
        part.map(|part| part.path.as_str())
    };
    sheets.retain(|(_, id)| path_of_sheet(id).is_some());
    let (sheets, ids): (Vec<Listed>, Vec<String>) = sheets.into_iter().unzip();
    let choice = chosen(sheets, wanted)?;
    let id = ids.get(choice.index).ok_or_else(|| unreadable("it has no sheet"))?;
    book.read_styles(archive, &of_kind("styles", "styles.xml"))?;
    book.read_texts(archive, &of_kind("sharedStrings", "sharedStrings.xml"))?;
    let path = path_of_sheet(id).unwrap_or_default();
    let missing = || unreadable(format!("there is no {} in it", Foreign::of(path).quoted()));
    read_cells(&mut archive.part(path)?.ok_or_else(missing)?, &book, lines)?;
    Ok(choice)
}

/// A relation from one part to another.
struct Relation {
    id: String,
    /// The last word of its type.
    kind: String,
    path: String,
}

/// Reads the relations of a part whose own path is in this folder; none where it has no relations.
fn relations(archive: &mut Archive, path: &str, folder: &str) -> Result<Vec<Relation>, InputErrorKind> {
    let mut relations = Vec::new();
    let Some(mut part) = archive.part(path)? else { return Ok(relations) };
    loop {
        match part.next()? {
            Event::Start(element) if element.local_name().as_ref() == "Relationship" => {
                let of = |name| attribute(&element, name);
                let (id, kind, target) = (of("Id")?, of("Type")?, of("Target")?);
                let kind = kind.as_deref().and_then(|kind| kind.rsplit('/').next()).unwrap_or_default();
                let path = join(folder, target.as_deref().unwrap_or_default());
                relations.push(Relation { id: id.unwrap_or_default().into(), kind: kind.to_owned(), path });
                refuse_many(relations.len())?;
            }
            Event::Eof => return Ok(relations),
            _ => {}
        }
    }
}

fn path_of<'a>(relations: &'a [Relation], kind: &str) -> Option<&'a str> {
    relations.iter().find(|relation| relation.kind == kind).map(|relation| relation.path.as_str())
}

/// A path as seen from a folder; one that begins with a slash is seen from the archive.
fn join(folder: &str, path: &str) -> String {
    let from_above = if path.starts_with('/') { "" } else { folder };
    let mut parts: Vec<&str> = Vec::new();
    for part in from_above.split('/').chain(path.split('/')) {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_seen_from_a_folder_or_from_the_archive() {
        for (folder, path, joined) in [
            ("xl", "worksheets/sheet1.xml", "xl/worksheets/sheet1.xml"),
            ("xl", "/xl/sheet1.xml", "xl/sheet1.xml"),
            ("xl/a", "../b.xml", "xl/b.xml"),
            ("", "../../b.xml", "b.xml"),
        ] {
            assert_eq!(join(folder, path), joined);
        }
    }
}
