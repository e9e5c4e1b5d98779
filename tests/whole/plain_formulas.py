# SPDX-License-Identifier: MIT
"""Formulas of equation files as Python code."""

import ast
import math

NAMES = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "erf", "erfc", "gamma", "pi", "floor", "ceil")
FUNCTIONS = {name: getattr(math, name) for name in NAMES} | {"abs": abs, "min": min, "max": max, "mod": lambda a, b: a % b}
FUNCTIONS |= {"sign": lambda x: (x > 0) - (x < 0), "step": lambda x: (1 + (x > 0) - (x < 0)) / 2}


class Uncertain(Exception):
    """There is no value that could be relied on."""


class Formulas(ast.NodeTransformer):
    """Compiles formulas. D(x, q), J(f, q) and x(t - tau) in them become names of nodes."""

    def __init__(self, document: dict) -> None:
        self.unknowns, self.names = set(document["unknown"]), dict(FUNCTIONS)
        self.names |= {name: self.number(value) for name, value in document.get("parameters", {}).items()}
        self.nodes: list[tuple] = []  # a letter, what it is of, and q or tau

    def number(self, value: object, **names: float) -> float:
        return float(eval(str(value).replace("^", "**"), self.names | names))  # noqa: S307

    def code(self, text: str):  # noqa: ANN201
        return self.compiled(self.visit(ast.parse(text.replace("^", "**"), mode="eval").body))

    def compiled(self, body: ast.expr):  # noqa: ANN201
        return compile(ast.fix_missing_locations(ast.Expression(body)), "formula", "eval")

    def visit_Call(self, call: ast.Call) -> ast.expr:  # noqa: N802
        self.generic_visit(call)
        name = call.func.id
        if name == "J":
            node = ("J", self.compiled(call.args[0]), call.args[1])
        elif name == "D":
            node = ("D", call.args[0].id, call.args[1])
        elif name in self.unknowns:
            node = ("x", name, call.args[0].right)
        else:
            return call
        node = (*node[:2], self.number(ast.unparse(node[2])))
        if node not in self.nodes:
            self.nodes.append(node)
        return ast.Name(f"node{self.nodes.index(node)}", ast.Load())

    def value(self, code: object, state: dict[str, float]) -> float:
        return eval(code, self.names, state)  # noqa: S307
