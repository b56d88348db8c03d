//! TOML → what the types of a case ask for, with every fault at its key.
//!
//! serde's own tagged, untagged and flattened types copy a table before they read it, and lose where its keys stand. Here they are
//! read in place: a type derives `Deserialize` as it would for any format, and this reader finds in the document what it asks
//! for.
//!
//! | the type has | the file has |
//! |---|---|
//! | an enum | a table whose `kind` names the variant and whose other keys are its fields, or the name alone |
//! | an enum with variants `$text`, `$list`, `$table` | one of these; the variant is told by what stands there |
//! | an enum with a variant `$other` | as above; a `kind` that is none of the others belongs to the enum in `$other` |
//! | a field `$rest` | all keys that are not other fields: an enum with keys beside it |
//! | a field `$rest:key` | the same: a struct with keys beside it, which needs `key` |
//!
//! A number may be a text with its unit, "150 kN", where [`keys`] knows the unit of its key.
//!
//! A constructor that refuses what was read (`serde(try_from)`, or `D::Error::custom`) says at which key by
//! [`OutOfRange`](crate::quantity::OutOfRange) or [`keyed`](crate::quantity::keyed).
//!
//! The file is long because serde asks for a reader of every shape a value can have.

mod fault;

use super::error::Finding;
use super::keys;
use fault::{Fault, What, join, plain, words};
use serde::Deserialize;
use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, Expected, MapAccess, SeqAccess, Unexpected,
    VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;
use toml::de::{DeTable, DeValue};

/// The key that names a variant.
const KIND: &str = "kind";
const REST: &str = "$rest";
const OTHER: &str = "$other";

/// What `document` says, which stands for the table `root` of a case (empty for a whole one).
///
/// # Errors
/// The first thing that does not fit, at its key.
pub fn of_table<'de, T: Deserialize<'de>>(document: &'de DeTable<'de>, root: &str) -> Result<T, Finding> {
    T::deserialize(Node::table(document, root)).map_err(Fault::finding)
}

/// A value of the document, with its path in a case where that is needed; a table as those of its keys that are in question.
#[derive(Clone)]
enum Node<'de> {
    Text(&'de str, String),
    Whole(i64),
    Number(f64),
    Switch(bool),
    Date(String),
    List(&'de [toml::Spanned<DeValue<'de>>], String),
    Table(Vec<(&'de str, &'de DeValue<'de>)>, String),
}

impl<'de> Node<'de> {
    fn table(table: &'de DeTable<'de>, at: &str) -> Self {
        let keys = table.iter().map(|(key, value)| (key.get_ref().as_ref(), value.get_ref()));
        Self::Table(keys.collect(), at.to_owned())
    }

    /// The `value` that stands at the path `at`.
    fn of(value: &'de DeValue<'de>, at: &str) -> Result<Self, Fault> {
        Ok(match value {
            DeValue::String(text) => Self::Text(text, at.to_owned()),
            DeValue::Integer(digits) => {
                let value = i64::from_str_radix(digits.as_str(), digits.radix());
                Self::Whole(value.map_err(|_| Fault::wrong(digits, "a whole number with fewer digits"))?)
            }
            DeValue::Float(digits) => {
                let value = digits.as_str().parse();
                Self::Number(value.map_err(|_| Fault::wrong(digits, "a number"))?)
            }
            DeValue::Boolean(value) => Self::Switch(*value),
            DeValue::Datetime(date) => Self::Date(date.to_string()),
            DeValue::Array(list) => Self::List(list, at.to_owned()),
            DeValue::Table(table) => Self::table(table, at),
        })
    }

    fn words(&self) -> String {
        match self {
            Self::Text(text, _) => words(Unexpected::Str(text)),
            Self::Whole(value) => words(Unexpected::Signed(*value)),
            Self::Number(value) => words(Unexpected::Float(*value)),
            Self::Switch(value) => words(Unexpected::Bool(*value)),
            Self::Date(text) => format!("the date {text}"),
            Self::List(..) => words(Unexpected::Seq),
            Self::Table(..) => words(Unexpected::Map),
        }
    }

    /// The marker of a variant told by its shape.
    fn shape(&self) -> &'static str {
        match self {
            Self::Text(..) => "$text",
            Self::List(..) => "$list",
            Self::Table(..) => "$table",
            _ => "",
        }
    }

    fn whole<V: Visitor<'de>>(self, visitor: V, most: u64) -> Result<V::Value, Fault> {
        match self {
            Self::Whole(value) if u64::try_from(value).is_ok_and(|value| value <= most) => {
                visitor.visit_u64(value.unsigned_abs())
            }
            other if most == u64::MAX => Err(Fault::wrong(other.words(), "a whole number, zero or above")),
            other => Err(Fault::wrong(other.words(), format!("a whole number from 0 to {most}"))),
        }
    }
}

impl<'de> Deserializer<'de> for Node<'de> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self {
            Self::Text(text, _) => visitor.visit_borrowed_str(text),
            Self::Whole(value) => visitor.visit_i64(value),
            Self::Number(value) => visitor.visit_f64(value),
            Self::Switch(value) => visitor.visit_bool(value),
            Self::Date(text) => visitor.visit_string(text),
            Self::List(list, at) => visitor.visit_seq(Items { list, at, next: 0 }),
            Self::Table(keys, at) => visitor.visit_map(Keys { keys, at, rest: None, known: &[], next: 0 }),
        }
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self {
            Self::Switch(value) => visitor.visit_bool(value),
            other => Err(Fault::wrong(other.words(), "true or false")),
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self {
            Self::Whole(value) => visitor.visit_f64(value as f64),
            Self::Number(value) => visitor.visit_f64(value),
            Self::Text(text, ref at) => match keys::unit(at) {
                Some(unit) => visitor.visit_f64(unit.read(text).map_err(Fault::misread)?),
                None if text.trim().parse::<f64>().is_ok() => {
                    Err(Fault::wrong(self.words(), "a number").help("remove the quotes"))
                }
                None => Err(Fault::wrong(self.words(), "a number")),
            },
            other => Err(Fault::wrong(other.words(), "a number")),
        }
    }

    fn deserialize_u8<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.whole(visitor, u8::MAX.into())
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.whole(visitor, u32::MAX.into())
    }

    fn deserialize_u64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.whole(visitor, u64::MAX)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self {
            Self::Text(text, _) => visitor.visit_borrowed_str(text),
            other => Err(Fault::wrong(other.words(), "text")),
        }
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match self {
            Self::Table(keys, _) if keys.is_empty() => visitor.visit_unit(),
            Self::Table(keys, _) => Err(Fault::unknown_field(keys[0].0, &[])),
            other => Err(Fault::wrong(other.words(), "a table")),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self {
            Self::List(list, at) => visitor.visit_seq(Items { list, at, next: 0 }),
            other => Err(Fault::wrong(other.words(), "a list").help(
                "a list is written [a, b, …], or, where it is one of tables, with [[name]] above each",
            )),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let Self::Table(keys, at) = self else {
            return Err(Fault::wrong(self.words(), "a table")
                .help("a table is written { … }, or with [name], in single brackets, above it"));
        };
        let Some(marker) = fields.iter().find(|field| field.starts_with(REST)) else {
            return visitor.visit_map(Keys { keys, at, rest: None, known: fields, next: 0 });
        };
        let (keys, rest): (Vec<_>, Vec<_>) = keys.into_iter().partition(|(key, _)| fields.contains(key));
        // an empty rest is left to the default of its field
        let rest = (!rest.is_empty()).then_some((*marker, rest));
        visitor.visit_map(Keys { keys, at, rest, known: fields, next: 0 })
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let shape = self.shape();
        if variants.contains(&shape) {
            return visitor.visit_enum(Variant { name: shape, fields: self });
        }
        if variants.iter().any(|v| ["$text", "$list", "$table"].contains(v)) {
            return Err(Fault::wrong(self.words(), &visitor as &dyn Expected));
        }
        match self {
            Self::Text(name, at) => visitor.visit_enum(Variant { name, fields: Self::Table(Vec::new(), at) }),
            Self::Table(ref keys, ref at) => {
                let Some((_, kind)) = keys.iter().find(|(key, _)| *key == KIND) else {
                    return Err(Fault::new(What::Missing { key: KIND, allowed: plain(variants) }));
                };
                let DeValue::String(name) = kind else {
                    let wanted = format!("one of {}", plain(variants).join(", "));
                    return Err(Fault::wrong(Self::of(kind, at)?.words(), wanted).below(KIND));
                };
                let name: &str = name;
                if variants.contains(&OTHER) && !variants.contains(&name) {
                    let other = visitor.visit_enum(Variant { name: OTHER, fields: self });
                    return other.map_err(|fault| fault.beside_kinds(variants));
                }
                let fields = keys.iter().filter(|(key, _)| *key != KIND).copied().collect();
                let fields = Self::Table(fields, at.clone());
                visitor.visit_enum(Variant { name, fields }).map_err(|fault| match fault.what {
                    What::Name { .. } if fault.path.is_empty() => fault.below(KIND),
                    _ => fault,
                })
            }
            other => Err(Fault::wrong(other.words(), format!("one of {}", plain(variants).join(", ")))),
        }
    }

    forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u16 u128 f32 char bytes byte_buf unit tuple tuple_struct map identifier ignored_any
    }
}

/// A list, item by item.
struct Items<'de> {
    list: &'de [toml::Spanned<DeValue<'de>>],
    /// Its path.
    at: String,
    next: usize,
}

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Fault> {
        let Some(item) = self.list.get(self.next) else { return Ok(None) };
        let place = format!("[{}]", self.next);
        self.next += 1;
        let node = Node::of(item.get_ref(), &join(&self.at, &place));
        node.and_then(|node| seed.deserialize(node)).map(Some).map_err(|f| f.below(&place))
    }
}

/// A table, key by key, and then what is left as one more.
struct Keys<'de> {
    keys: Vec<(&'de str, &'de DeValue<'de>)>,
    /// Path of the table.
    at: String,
    rest: Option<(&'static str, Vec<(&'de str, &'de DeValue<'de>)>)>,
    /// All keys of this table but those of the rest.
    known: &'static [&'static str],
    next: usize,
}

impl<'de> MapAccess<'de> for Keys<'de> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Fault> {
        let key = match (self.keys.get(self.next), &self.rest) {
            (Some((key, _)), _) => key,
            (None, Some((marker, _))) => marker,
            (None, None) => return Ok(None),
        };
        seed.deserialize(StrDeserializer::new(key)).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        if let Some((key, value)) = self.keys.get(self.next) {
            self.next += 1;
            let node = Node::of(value, &join(&self.at, key));
            return node.and_then(|node| seed.deserialize(node)).map_err(|fault| fault.below(key));
        }
        let (_, rest) = self.rest.take().unwrap_or_default();
        seed.deserialize(Node::Table(rest, self.at.clone())).map_err(|fault| fault.beside_keys(self.known))
    }
}

/// A variant by its name, with its fields.
struct Variant<'de> {
    name: &'de str,
    fields: Node<'de>,
}

impl<'de> EnumAccess<'de> for Variant<'de> {
    type Error = Fault;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Fault> {
        seed.deserialize(StrDeserializer::new(self.name)).map(|variant| (variant, self))
    }
}

impl<'de> VariantAccess<'de> for Variant<'de> {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        match self.fields {
            Node::Table(keys, _) if !keys.is_empty() => {
                Err(Fault::unknown_field(keys[0].0, &[]).of(self.name))
            }
            _ => Ok(()),
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Fault> {
        seed.deserialize(self.fields).map_err(|fault| fault.of(self.name))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Fault> {
        self.fields.deserialize_any(visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.fields.deserialize_struct("", fields, visitor).map_err(|fault| fault.of(self.name))
    }
}
