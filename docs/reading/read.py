import csv, decimal, json, pathlib
folder = pathlib.Path("reference/data")
package = json.loads((folder / "datapackage.json").read_text())
path = {table["name"]: table["path"] for table in package["resources"]}
with open(folder / path["trajectories.relaxation"], newline="") as file:
    rows = list(csv.DictReader(file))
print([decimal.Decimal(row["y"]) for row in rows if row["t"] == "1"])
