import csv, decimal
rows = list(csv.DictReader(open("reference/data/trajectories/relaxation.csv")))
print([decimal.Decimal(row["y"]) for row in rows if row["t"] == "1"])
