//! What is read, and what is said of what does not fit.

use super::*;

#[derive(Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
struct Case {
    shape: Vec<Beside>,
}

#[derive(Debug, Deserialize, PartialEq)]
struct Beside {
    name: Option<String>,
    #[serde(rename = "$rest")]
    shape: Shape,
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
enum Shape {
    Point,
    Circle {
        radius: f64,
    },
    Several(Inner),
    #[serde(rename = "$other")]
    Other(Solid),
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
struct Inner {
    sides: Count,
    count: u8,
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
enum Solid {
    Cube { edge: f64 },
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(expecting = "a list, or a table with `from` and `to`", deny_unknown_fields)]
enum Count {
    #[serde(rename = "$list")]
    List(Vec<u8>),
    #[serde(rename = "$table")]
    Range { from: u8, to: u8 },
}

fn reading(text: &str) -> Result<Case, (String, String, Option<String>)> {
    let table = DeTable::parse(text).unwrap();
    of_table(table.get_ref()).map_err(|f| (f.path, f.message, f.help))
}

#[test]
fn reads_what_is_there() {
    let text = "[[shape]]\nkind = \"point\"\n[[shape]]\nname = \"a\"\nkind = \"circle\"\nradius = 1\n[[shape]]\n\
                kind = \"several\"\nsides = [3, 4]\ncount = 2\n[[shape]]\nkind = \"cube\"\nedge = 0.5\n";
    let shapes = reading(text).unwrap().shape;
    let of = |i: usize| &shapes[i].shape;
    assert_eq!(*of(0), Shape::Point);
    assert_eq!((of(1), shapes[1].name.as_deref()), (&Shape::Circle { radius: 1.0 }, Some("a")));
    assert_eq!(*of(2), Shape::Several(Inner { sides: Count::List(vec![3, 4]), count: 2 }));
    assert_eq!(*of(3), Shape::Other(Solid::Cube { edge: 0.5 }));
}

#[test]
fn every_fault_at_its_key() {
    let several = "kind = \"several\"\ncount = 1\nsides";
    for (text, path, message, help) in [
        ("kind = \"circle\"\nradius = \"1\"", "shape[0].radius", "text \"1\", wanted a number", ""),
        ("kind = \"circle\"", "shape[0]", "missing key `radius`, needed by kind = \"circle\"", "radius = …"),
        (
            "kind = \"circle\"\nradius = 1\nraduis = 1",
            "shape[0].raduis",
            "unknown key `raduis` of kind = \"circle\"",
            "did you mean `radius`? allowed: radius, name",
        ),
        (
            "kind = \"point\"\nsize = 1",
            "shape[0].size",
            "unknown key `size` of kind = \"point\"",
            "allowed: name",
        ),
        (
            "kind = \"circel\"",
            "shape[0].kind",
            "unknown value \"circel\"",
            "did you mean `circle`? allowed: cube, point, circle, several",
        ),
        ("radius = 1", "shape[0]", "missing key `kind`", "point, circle, several"),
        ("kind = 3", "shape[0].kind", "found the number 3, wanted one of point", ""),
        ("kind = \"cube\"\nedge = true", "shape[0].edge", "found true, wanted a number", ""),
        (&format!("{several} = [1, -2]"), "shape[0].sides[1]", "found the number -2", ""),
        (&format!("{several} = [1, 300]"), "shape[0].sides[1]", "from 0 to 255", ""),
        (&format!("{several} = 3"), "shape[0].sides", "wanted a list, or a table with `from`", ""),
        (
            &format!("{several} = {{ from = 1, two = 2 }}"),
            "shape[0].sides.two",
            "unknown key `two`",
            "from, to",
        ),
    ] {
        let (at, said, advice) = reading(&format!("[[shape]]\n{text}\n")).unwrap_err();
        assert_eq!(at, path, "{text}: {said}");
        assert!(said.contains(message), "{text}: {said}");
        assert!(advice.unwrap_or_default().contains(help), "{text}: {said}");
    }
    assert_eq!(reading("shape = 1").unwrap_err().0, "shape");
    assert_eq!(reading("shap = []").unwrap_err().1, "unknown key `shap`");
}
