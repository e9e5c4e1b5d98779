// SPDX-License-Identifier: MIT
// Formulas as docs/equation_files.md has them, set as MathML. A reader of its own, as small as what it shows: it has to show a
// formula, not to compute it.

const mathSpace = "http://www.w3.org/1998/Math/MathML";
function math(name, ...children) {
  const made = document.createElementNS(mathSpace, name);
  made.append(...children);
  return made;
}

const greek = new Map(("alpha α beta β gamma γ delta δ epsilon ε kappa κ lambda λ mu μ nu ν omega ω phi φ psi ψ rho ρ " +
  "sigma σ tau τ theta θ xi ξ zeta ζ pi π").split(" ").map((word, i, all) => [word, all[i + 1]]).filter((_, i) => i % 2 === 0));

// k1 has a subscript, g_over_L is a quotient, mu is a letter.
function mathName(name) {
  const [over, under] = name.split("_over_");
  if (under) return math("mfrac", mathName(over), mathName(under));
  const [, letters, index] = /^(.*?)_?(\d*|_\w+)$/.exec(name);
  const letter = greek.get(letters) ?? letters;
  const identifier = /_/.test(letter) ? math("mtext", letter.replaceAll("_", " ")) : math("mi", letter);
  return index ? math("msub", identifier, math("mn", index.replace("_", ""))) : identifier;
}

// Brackets round a single letter or number do not grow with it.
function inBrackets(inner, open = "(", close = ")") {
  const marks = [open, close].map((mark) => math("mo", mark));
  if (["mi", "mn"].includes(inner.nodeName)) for (const mark of marks) mark.setAttribute("stretchy", "false");
  return math("mrow", marks[0], inner, marks[1]);
}
const primes = new Map([["1", "′"], ["2", "″"]]);

// D^order x; whole orders as primes.
function derivative(unknown, order) {
  if (order.textContent === "0") return unknown;
  const prime = primes.get(order.textContent);
  if (prime) {
    const mark = math("mo", prime);
    for (const side of ["lspace", "rspace"]) mark.setAttribute(side, "0");
    return math("mrow", unknown, mark);
  }
  return math("mrow", math("msup", math("mi", "D"), order), unknown);
}

// D^order and J^order of a formula; from the end T backwards with t and T beside it.
const integral = (of, order) => math("mrow", math("msup", math("mi", "J"), order), of);
const fromTheEnd = (letter) => (of, order) =>
  math("mrow", math("msub", math("mrow"), math("mi", "t")), math("msubsup", math("mi", letter), math("mi", "T"), order), of);

// What has a notation of its own, by its name; another number of arguments has that of any function.
const notations = new Map(Object.entries({
  D: derivative,
  J: integral,
  D_right: fromTheEnd("D"),
  J_right: fromTheEnd("J"),
  sum: (index, x) => math("mrow", math("munder", math("mo", "∑"), index), x),
  sqrt: (x) => math("msqrt", x),
  abs: (x) => inBrackets(x, "|", "|"),
  gamma: (x) => math("mrow", math("mi", "Γ"), inBrackets(x)),
  step: (x) => math("mrow", math("mi", "θ"), inBrackets(x)),
  mittag_leffler: (a, b, z) => math("mrow", math("msub", math("mi", "E"), math("mrow", a, math("mo", ","), b)), inBrackets(z)),
}));

// Longer formulas and deeper ones are shown as they are written.
const mostLetters = 2000, mostLevels = 100;

class FormulaSetter {
  constructor(text) {
    this.tokens = text.match(/[A-Za-z]\w*|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?|\S/g) ?? [];
    this.level = 0;
  }
  take(symbol) {
    const found = this.tokens[0] === symbol;
    if (found) this.tokens.shift();
    return found;
  }
  sum() {
    const parts = [this.product()];
    while (["+", "-"].includes(this.tokens[0])) parts.push(math("mo", this.tokens.shift() === "-" ? "−" : "+"), this.product());
    return parts.length > 1 ? math("mrow", ...parts) : parts[0];
  }
  product() {
    let parts = [this.signed()];
    while (["*", "/"].includes(this.tokens[0])) {
      if (this.tokens.shift() === "*") {
        const next = this.signed();
        parts.push(...(next.firstChild?.nodeName === "mn" || next.nodeName === "mn" ? [math("mo", "·")] : []), next);
      } else {
        parts = [math("mfrac", bare(parts.length > 1 ? math("mrow", ...parts) : parts[0]), bare(this.signed()))];
      }
    }
    return parts.length > 1 ? math("mrow", ...parts) : parts[0];
  }
  signed() {
    if (++this.level > mostLevels) throw new RangeError("a formula that is too deep");
    const made = this.withSign();
    this.level -= 1;
    return made;
  }
  withSign() {
    if (this.take("-")) return math("mrow", math("mo", "−"), this.signed());
    if (this.take("+")) return this.signed();
    const base = this.single();
    return this.take("^") ? math("msup", base, bare(this.signed())) : base;
  }
  single() {
    if (this.take("(")) {
      const inner = this.sum();
      this.take(")");
      return inBrackets(inner);
    }
    const token = this.tokens.shift() ?? "";
    if (/^[\d.]/.test(token)) return math("mn", token);
    return this.take("(") ? this.call(token) : mathName(token);
  }
  call(name) {
    const parts = [];
    do parts.push(this.sum()); while (this.take(","));
    this.take(")");
    const notation = notations.get(name);
    if (notation?.length === parts.length) return notation(...parts);
    const listed = parts.flatMap((part, i) => (i ? [math("mo", ","), part] : [part]));
    return math("mrow", math("mi", name), inBrackets(parts.length > 1 ? math("mrow", ...listed) : parts[0]));
  }
}

// Without brackets that a bar or a raised place makes needless.
function bare(node) {
  const [open, inner, close] = node.childNodes;
  return node.nodeName === "mrow" && open?.textContent === "(" && close?.textContent === ")" && node.childNodes.length === 3 ? inner : node;
}

function formula(text) {
  if (text.length > mostLetters) return math("mtext", text);
  try {
    return new FormulaSetter(text).sum();
  } catch (error) {
    if (error instanceof RangeError) return math("mtext", text);
    throw error;
  }
}

function equation({ left, right }) {
  const whole = math("math", math("mrow", formula(left), math("mo", "="), formula(right)));
  whole.setAttribute("display", "block");
  whole.setAttribute("alttext", `${left} = ${right}`);
  return whole;
}
