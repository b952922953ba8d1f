//! XML as instruments write it: elements with their paths, one by one. A document type
//! declaration with anything in it is refused, and one that names a file is passed over: no entity
//! is ever expanded, and no file read.

use crate::binary::Bytes;
use crate::error::ReadError;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::Event;
use quick_xml::{Reader, XmlVersion};
use std::collections::BTreeMap;

/// Elements nested deeper than this are refused.
const DEEPEST: usize = 32;

/// An element at its end.
pub(crate) struct Element<'e> {
    /// Names from the root to this element, without prefixes.
    pub(crate) path: &'e [String],
    /// Names without prefixes, and values.
    pub(crate) attributes: &'e [(String, String)],
    /// The text after its last child, untrimmed.
    pub(crate) text: &'e str,
}

impl Element<'_> {
    pub(crate) fn name(&self) -> &str {
        self.path.last().map_or("", String::as_str)
    }

    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }
}

/// Calls `visit` at the end of every element of `xml`; `name` is what messages call the document.
pub(crate) fn walk(
    xml: Bytes<'_>,
    name: &str,
    mut visit: impl FnMut(&Element<'_>) -> Result<(), ReadError>,
) -> Result<(), ReadError> {
    let text = crate::text::decode(xml.data);
    let mut reader = Reader::from_str(&text);
    reader.config_mut().expand_empty_elements = true;
    let (mut path, mut value) = (Vec::<String>::new(), String::new());
    let mut attributes = Vec::<Vec<(String, String)>>::new();
    loop {
        let at = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX);
        let broken = |what: String| xml.fault(at, format!("{name}{what}"));
        match reader.read_event().map_err(|e| broken(format!(": {e}")))? {
            Event::Start(tag) => {
                if path.len() > DEEPEST {
                    return Err(broken(format!(": elements nested deeper than {DEEPEST}")));
                }
                path.push(tag.local_name().as_ref().to_owned());
                let own = tag.attributes().filter_map(Result::ok).map(|a| {
                    let value = a.normalized_value(XmlVersion::Implicit1_0);
                    let value = value.unwrap_or_else(|_| a.value.clone()).into_owned();
                    (a.key.local_name().as_ref().to_owned(), value)
                });
                attributes.push(own.collect());
                value.clear();
            }
            Event::End(_) => {
                let own = attributes.pop().unwrap_or_default();
                visit(&Element { path: &path, attributes: &own, text: &value })?;
                path.pop();
                value.clear();
            }
            Event::Text(text) => value += text.as_ref(),
            Event::CData(text) => value += text.as_ref(),
            Event::GeneralRef(reference) => {
                // The five entities of XML itself and character references; no others exist here.
                let own = || reference.resolve_char_ref().ok().flatten().map(String::from);
                let known = resolve_predefined_entity(&reference).map(str::to_owned).or_else(own);
                let unknown = || broken(format!(": entity &{}; is not expanded", &*reference));
                value += &known.ok_or_else(unknown)?;
            }
            Event::DocType(declaration) if !declaration.as_ref().contains('[') => {}
            Event::DocType(_) => {
                return Err(broken(": a document type declaration is refused".into()));
            }
            Event::Eof if path.is_empty() => return Ok(()),
            Event::Eof => return Err(broken(" ends inside an element".into())),
            Event::Decl(_) | Event::PI(_) | Event::Comment(_) | Event::Empty(_) => {}
        }
    }
}

/// The text of every element that has some, by its path below the root; of equal paths the first.
pub(crate) fn fields(xml: Bytes<'_>, name: &str) -> Result<BTreeMap<String, String>, ReadError> {
    let mut fields = BTreeMap::new();
    walk(xml, name, |element| {
        let [_root, path @ ..] = element.path else { return Ok(()) };
        let text = element.text.trim();
        if !text.is_empty() {
            xml.check_items(fields.len() as u64 + 1)?;
            fields.entry(path.join("/")).or_insert_with(|| text.to_owned());
        }
        Ok(())
    })?;
    Ok(fields)
}
