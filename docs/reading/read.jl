using DelimitedFiles
rows, header = readdlm("reference/data/trajectories/relaxation.csv", ',', String; header=true)
println(parse.(BigFloat, rows[rows[:, 1] .== "1", vec(header) .== "y"]))
