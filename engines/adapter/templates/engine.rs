//! An engine in Rust, standard library alone: casts of balls.
//!   rustc --edition 2021 -O engine.rs && graze certify --engine ./engine
//!
//! To change: 1. `cast` calls your engine, 2. `SAYS` names your shapes and what you promise. docs/reference/protocol.md has every field.
use std::io::{self, BufRead, Write};

// 2. "shapes": ["sphere", "capsule", "box", "hull"]
const SAYS: &str = r#"{"schema": "graze.engine/1", "name": "balls-rust", "scalar": "double", "shapes": ["sphere"], "queries": {"cast": {"answers": ["time", "normal"], "relative_tolerance": 1e-7}}}"#;

/// As much of JSON as questions have. A crate of your own does as well.
enum Json {
    Number(f64),
    Text(String),
    List(Vec<Json>),
    Object(Vec<(String, Json)>),
}

impl Json {
    fn get(&self, name: &str) -> &Json {
        match self {
            Json::Object(fields) => &fields.iter().find(|(known, _)| known == name).expect(name).1,
            _ => panic!("an object is expected"),
        }
    }
    fn number(&self) -> f64 {
        match self {
            Json::Number(x) => *x,
            _ => panic!("a number is expected"),
        }
    }
    fn vector(&self) -> [f64; 3] {
        match self {
            Json::List(items) => [items[0].number(), items[1].number(), items[2].number()],
            _ => panic!("a vector is expected"),
        }
    }
    fn items(&self) -> &[Json] {
        match self {
            Json::List(items) => items,
            _ => panic!("a list is expected"),
        }
    }
    fn text(&self) -> &str {
        match self {
            Json::Text(text) => text,
            _ => panic!("a string is expected"),
        }
    }
}

struct Reader<'a> {
    text: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    fn peek(&mut self) -> u8 {
        while self.text[self.at].is_ascii_whitespace() {
            self.at += 1;
        }
        self.text[self.at]
    }
    /// Whether the next is `c`, which is then passed.
    fn take(&mut self, c: u8) -> bool {
        let is_next = self.peek() == c;
        self.at += usize::from(is_next);
        is_next
    }
    /// Names and ids of questions have no escapes.
    fn string(&mut self) -> String {
        assert!(self.take(b'"'));
        let begin = self.at;
        while self.text[self.at] != b'"' {
            self.at += 1;
        }
        self.at += 1;
        String::from_utf8_lossy(&self.text[begin..self.at - 1]).into_owned()
    }
    fn value(&mut self) -> Json {
        match self.peek() {
            b'"' => Json::Text(self.string()),
            b'[' => {
                self.at += 1;
                let mut items = Vec::new();
                while !self.take(b']') {
                    items.push(self.value());
                    self.take(b',');
                }
                Json::List(items)
            }
            b'{' => {
                self.at += 1;
                let mut fields = Vec::new();
                while !self.take(b'}') {
                    let name = self.string();
                    assert!(self.take(b':'));
                    fields.push((name, self.value()));
                    self.take(b',');
                }
                Json::Object(fields)
            }
            _ => {
                let begin = self.at;
                while self.at < self.text.len() && !b",]} ".contains(&self.text[self.at]) {
                    self.at += 1;
                }
                let number = std::str::from_utf8(&self.text[begin..self.at]).unwrap();
                Json::Number(number.parse().expect("a number"))
            }
        }
    }
}

fn dot(x: [f64; 3], y: [f64; 3]) -> f64 {
    x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
}
/// x + s y
fn moved(x: [f64; 3], s: f64, y: [f64; 3]) -> [f64; 3] {
    [x[0] + s * y[0], x[1] + s * y[1], x[2] + s * y[2]]
}

fn cross(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
}

/// A body at t = 0, in world axes: the hull of points, rounded by a radius. Cylinders, cones and ellipsoids are not of this
/// form, and come with radius and half_height (their axis is z) or with radii.
fn form_of(body: &Json) -> (Vec<[f64; 3]>, f64) {
    let shape = body.get("shape");
    let (points, radius) = match shape.get("type").text() {
        "sphere" => (vec![[0.0; 3]], shape.get("radius").number()),
        "capsule" => {
            let h = shape.get("half_height").number();
            (vec![[0.0, 0.0, -h], [0.0, 0.0, h]], shape.get("radius").number())
        }
        "box" => {
            let h = shape.get("half_extents").vector();
            let corner = |k: usize| std::array::from_fn(|i| if k >> i & 1 == 1 { h[i] } else { -h[i] });
            ((0..8).map(corner).collect(), 0.0)
        }
        "hull" => (shape.get("vertices").items().iter().map(Json::vector).collect(), 0.0),
        _ => (Vec::new(), 0.0),
    };
    let q = body.get("orientation").items();
    let axis = [q[1].number(), q[2].number(), q[3].number()];
    let placed = |x: [f64; 3]| {
        let side = cross(axis, x);
        let turned = moved(moved(x, 2.0 * q[0].number(), side), 2.0, cross(axis, side));
        moved(turned, 1.0, body.get("position").vector())
    };
    (points.into_iter().map(placed).collect(), radius)
}

/// What follows the id of the answer; lengths in the question's unit, times in its t.
fn cast(a: &Json, b: &Json, t_max: f64) -> String {
    let miss = r#""outcome": "miss""#.to_string();
    let ((points_a, radius_a), (points_b, radius_b)) = (form_of(a), form_of(b));
    // 1. Your engine, by these, the displacements of a and b, and t_max. What follows casts balls.
    if points_a.len() != 1 || points_b.len() != 1 {
        return r#""outcome": "unsupported""#.to_string();
    }
    let reach = radius_a + radius_b;
    let gap = moved(points_b[0], -1.0, points_a[0]);
    let motion = moved(b.get("displacement").vector(), -1.0, a.get("displacement").vector());
    let (along, speed, apart) = (dot(gap, motion), dot(motion, motion), dot(gap, gap).sqrt());
    if apart <= reach {
        return r#""outcome": "initially_overlapping""#.to_string();
    }
    // The squared distance of the centres is least at t = -along / speed; rest is what remains of the gap there.
    if along >= 0.0 {
        return miss;
    }
    let rest = moved(gap, -along / speed, motion);
    let aside = dot(rest, rest).sqrt();
    if aside > reach {
        return miss;
    }
    let half_chord = ((reach - aside) * (reach + aside) * speed).sqrt();
    let time = (apart - reach) * (apart + reach) / (half_chord - along);
    if time > t_max {
        return miss;
    }
    // The gap at `time`, of two perpendicular parts: gap + time * motion would cancel where the bodies come from afar.
    let touching = moved(rest, -half_chord / speed, motion);
    let is_gap = dot(touching, touching) > 0.0; // points that meet leave none
    let normal = if is_gap { touching } else { motion.map(|v| -v) };
    let length = dot(normal, normal).sqrt();
    format!(
        r#""outcome": "hit", "time": {time:e}, "normal": [{:e}, {:e}, {:e}]"#,
        normal[0] / length,
        normal[1] / length,
        normal[2] / length
    )
}

fn main() {
    let mut out = io::stdout();
    writeln!(out, "{SAYS}").unwrap();
    out.flush().unwrap();
    for line in io::stdin().lock().lines() {
        let line = line.unwrap();
        let q = Reader { text: line.as_bytes(), at: 0 }.value();
        let answer = cast(q.get("a"), q.get("b"), q.get("t_max").number());
        writeln!(out, r#"{{"schema": "graze.answer/1", "id": "{}", {answer}}}"#, q.get("id").text()).unwrap();
        out.flush().unwrap();
    }
}
