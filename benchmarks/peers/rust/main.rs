// SPDX-License-Identifier: MIT
// Solves the equation of a task (docs/external_solvers.md) with the crate numra-fde: peer L1 TASK. To build it, make this file
// the main.rs of a package that depends on numra-fde and serde_json.
use numra_fde::{FdeOptions, FdeSolver, FdeSystem, L1Solver};
use serde_json::Value;
use std::time::Instant;

enum Formula {
    Number(f64),
    Time,
    Unknown(usize),
    Call(String, Vec<Formula>),
}

// Reads a formula in which every operation has parentheses of its own.
struct Reader<'a> {
    text: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    fn formula(&mut self) -> Formula {
        if self.text[self.at] != b'(' {
            return self.operand();
        }
        self.at += 1;
        let first = if self.text[self.at] == b'-' && self.text[self.at + 1] != b'.' && !self.text[self.at + 1].is_ascii_digit() {
            Formula::Number(0.0)
        } else {
            self.formula()
        };
        let result = match self.text[self.at] {
            b')' => first,
            operation => {
                self.at += 1;
                Formula::Call((operation as char).to_string(), vec![first, self.formula()])
            }
        };
        self.at += 1;
        result
    }

    // A number, which may be negative, an unknown, or a call.
    fn operand(&mut self) -> Formula {
        let start = self.at;
        let is_number = self.text[start] == b'-' || self.text[start].is_ascii_digit();
        while self.at < self.text.len() {
            let c = self.text[self.at];
            let exponent = is_number && (c == b'-' || c == b'+') && (self.at == start || self.text[self.at - 1] == b'e');
            if !(c.is_ascii_alphanumeric() || c == b'.' || c == b'_' || exponent) {
                break;
            }
            self.at += 1;
        }
        let word = std::str::from_utf8(&self.text[start..self.at]).unwrap();
        if is_number {
            return Formula::Number(word.parse().unwrap());
        }
        if self.at < self.text.len() && self.text[self.at] == b'(' {
            let mut arguments = vec![];
            while self.text[self.at] != b')' {
                self.at += 1;
                arguments.push(self.formula());
            }
            self.at += 1;
            return Formula::Call(word.to_string(), arguments);
        }
        match word {
            "t" => Formula::Time,
            _ => Formula::Unknown(word[1..].parse::<usize>().unwrap() - 1),
        }
    }
}

fn value(of: &Formula, t: f64, y: &[f64]) -> f64 {
    match of {
        Formula::Number(number) => *number,
        Formula::Time => t,
        Formula::Unknown(i) => y[*i],
        Formula::Call(name, arguments) => {
            let a = value(&arguments[0], t, y);
            let b = arguments.get(1).map_or(0.0, |second| value(second, t, y));
            match name.as_str() {
                "+" => a + b,
                "-" => a - b,
                "*" => a * b,
                "/" => a / b,
                "power" => a.powf(b),
                "sin" => a.sin(),
                "cos" => a.cos(),
                "tan" => a.tan(),
                "asin" => a.asin(),
                "acos" => a.acos(),
                "atan" => a.atan(),
                "atan2" => a.atan2(b),
                "sinh" => a.sinh(),
                "cosh" => a.cosh(),
                "tanh" => a.tanh(),
                "exp" => a.exp(),
                "log" => a.ln(),
                "sqrt" => a.sqrt(),
                "abs" => a.abs(),
                "floor" => a.floor(),
                "min" => a.min(b),
                "max" => a.max(b),
                "sign" => if a == 0.0 { 0.0 } else { a.signum() },
                "step" => if a == 0.0 { 0.5 } else { (a.signum() + 1.0) / 2.0 },
                _ => refuse(&format!("the adapter has no function {name}")),
            }
        }
    }
}

struct Equation {
    order: f64,
    rhs: Vec<Formula>,
}

impl FdeSystem<f64> for Equation {
    fn dim(&self) -> usize {
        self.rhs.len()
    }
    fn alpha(&self) -> f64 {
        self.order
    }
    fn rhs(&self, t: f64, y: &[f64], f: &mut [f64]) {
        for (entry, formula) in f.iter_mut().zip(&self.rhs) {
            *entry = value(formula, t, y);
        }
    }
}

fn refuse(reason: &str) -> ! {
    eprintln!("{reason}");
    std::process::exit(77);
}

fn main() {
    let file = std::env::args().last().unwrap();
    let task: Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    println!("# code: numra-fde\n# language: Rust");
    let rows = task["rows"].as_array().unwrap();
    let order = rows[0]["order"].as_f64().unwrap();
    if rows.iter().any(|row| row["order"].as_f64() != Some(order) || row["side"] == "right") {
        refuse("takes systems of one order");
    }
    let Some(formulas) = task["system"]["rhs"].as_array() else {
        refuse("the adapter needs the right-hand sides as formulas, which this scene does not have")
    };
    let rhs = formulas.iter().map(|text| Reader { text: text.as_str().unwrap().as_bytes(), at: 0 }.formula()).collect();
    let equation = Equation { order, rhs };
    let initial: Vec<f64> = rows.iter().map(|row| row["initial"][0].as_f64().unwrap()).collect();
    let (end, steps) = (task["end_time"].as_f64().unwrap(), task["steps"].as_u64().unwrap() as usize);
    // Without the margin the solver may take a step too many: it rounds end / dt upwards.
    let options = FdeOptions::default().dt(end / steps as f64 * (1.0 + 1e-14)).max_steps(steps + 1);
    let solve = || match L1Solver::solve(&equation, 0.0, end, &initial, &options) {
        Ok(result) => result,
        Err(reason) => refuse(&reason),
    };
    let start = Instant::now();
    let result = solve();
    let first = start.elapsed().as_secs_f64();
    let mut seconds: Vec<f64> = vec![];
    while task["timed"] == true && (seconds.is_empty() || (seconds.len() < 5 && seconds.iter().sum::<f64>() < 0.5)) {
        let start = Instant::now();
        solve();
        seconds.push(start.elapsed().as_secs_f64());
    }
    if task["timed"] == true {
        let words: Vec<String> = seconds.iter().map(f64::to_string).collect();
        println!("# first: {first}\n# seconds: {}", words.join(" "));
    }
    println!("# times: own");
    let columns = task["system"]["columns"].as_array().unwrap();
    let shown: Vec<usize> = (0..columns.len()).filter(|&i| columns[i].is_string()).collect();
    let names: Vec<&str> = shown.iter().map(|&i| columns[i].as_str().unwrap()).collect();
    println!("t,{}", names.join(","));
    for (n, t) in result.t.iter().enumerate() {
        let values: Vec<String> = shown.iter().map(|&i| result.y_at(n)[i].to_string()).collect();
        println!("{t},{}", values.join(","));
    }
}
