# SPDX-License-Identifier: MIT
# Solves the equation of a task (docs/external_solvers.md) with FractionalDiffEq.jl or FdeSolver.jl:
#   julia --project=FOLDER peer.jl FractionalDiffEq.jl PITrap TASK
#   julia --project=FOLDER peer.jl FdeSolver.jl PC TASK
# The project FOLDER has JSON and the package. This adapter was written from the documentation of FractionalDiffEq 0.5
# and FdeSolver 1.0; it has not been run.
using JSON

function refuse(reason)
    println(stderr, reason)
    exit(77)
end

power(a, b) = a^b
step(x) = (sign(x) + 1) / 2
atan2(y, x) = atan(y, x)

# The function of t and y whose value has these formulas as entries.
function function_of(formulas)
    numbered = replace.(formulas, r"\by(\d+)\b" => s"y[\1]")
    eval(Meta.parse("(t, y) -> [" * join(numbered, ", ") * "]"))
end

function matrix_of(rows)
    numbered = [join(replace.(row, r"\by(\d+)\b" => s"y[\1]"), " ") for row in rows]
    eval(Meta.parse("(t, y) -> Float64[" * join(numbered, "; ") * "]"))
end

function fractional_diff_eq(rule, task, h)
    if startswith(rule, "MT")
        haskey(task, "multi_term") && length(task["multi_term"]) == 1 || refuse("takes one equation, linear in its derivatives")
        equation = task["multi_term"][1]
        f = function_of([equation["rhs"]])
        right_hand_side(u, p, t) = Base.invokelatest(f, t, [u])[1]
        problem = FractionalDiffEq.MultiTermsFODEProblem(Float64.(equation["coefficients"]), Float64.(equation["orders"]),
                                                         right_hand_side, Float64.(equation["initial"]), (0.0, task["end_time"]))
        return () -> FractionalDiffEq.solve(problem, getfield(FractionalDiffEq, Symbol(rule))(), dt = h)
    end
    f = function_of(task["system"]["rhs"])
    orders = [row["order"] for row in task["rows"]]
    initial = [Float64(row["initial"][1]) for row in task["rows"]]
    any(row -> length(row["initial"]) > 1, task["rows"]) && refuse("the adapter takes orders up to 1")
    function right_hand_side!(du, u, p, t)
        du .= Base.invokelatest(f, t, u)
    end
    problem = FractionalDiffEq.FODEProblem(right_hand_side!, orders, initial, (0.0, task["end_time"]))
    () -> FractionalDiffEq.solve(problem, getfield(FractionalDiffEq, Symbol(rule))(), dt = h)
end

function fde_solver(rule, task, h)
    f = function_of(task["system"]["rhs"])
    orders = [Float64(row["order"]) for row in task["rows"]]
    most = maximum(length(row["initial"]) for row in task["rows"])
    initial = [k <= length(row["initial"]) ? Float64(row["initial"][k]) : 0.0 for row in task["rows"], k in 1:most]
    right_hand_side(t, y) = Base.invokelatest(f, t, y)
    span = [0.0, task["end_time"]]
    rule == "PC" && return () -> FdeSolver.FDEsolver(right_hand_side, span, initial, orders, h = h)
    matrix = matrix_of(task["system"]["jacobian"])
    jacobian(t, y) = Base.invokelatest(matrix, t, y)
    () -> FdeSolver.FDEsolver(right_hand_side, span, initial, orders, JF = jacobian, h = h, tol = 1e-12)
end

# Times, and values with a row for each unknown.
table_of(solution) = hasproperty(solution, :t) ? (solution.t, reduce(hcat, solution.u)) : (solution[1], permutedims(solution[2]))

function main(code, rule, file)
    task = JSON.parsefile(file)
    println("# code: ", code, "\n# language: Julia ", VERSION)
    haskey(task, "system") || refuse("the adapter needs the right-hand sides as formulas, which this scene does not have")
    any(row -> row["order"] == 0 || row["side"] == "right", task["rows"]) && refuse("takes initial-value problems only")
    h = task["end_time"] / task["steps"]
    solve = code == "FdeSolver.jl" ? fde_solver(rule, task, h) : fractional_diff_eq(rule, task, h)
    start = time_ns()
    solution = solve()
    first = (time_ns() - start) / 1e9
    seconds = Float64[]
    while task["timed"] && (isempty(seconds) || (length(seconds) < 5 && sum(seconds) < 0.5))
        start = time_ns()
        solve()
        push!(seconds, (time_ns() - start) / 1e9)
    end
    task["timed"] && println("# first: ", first, "\n# seconds: ", join(seconds, " "))
    columns = task["system"]["columns"]
    shown = findall(!isnothing, columns[1:size(table_of(solution)[2], 1)])
    println("# times: own\n", join(["t"; columns[shown]], ","))
    t, y = table_of(solution)
    for n in eachindex(t)
        println(join([t[n]; y[shown, n]], ","))
    end
end

code, rule, file = ARGS
code == "FdeSolver.jl" ? (@eval import FdeSolver) : (@eval import FractionalDiffEq)
Base.invokelatest(main, code, rule, file)
