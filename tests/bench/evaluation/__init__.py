"""What tests/bench/evaluate and tests/bench/report are made of.

runs      one run in a process of its own (through measured), and how far they are (progress)
rows      the CSV file: a row a run
sessions  on what machine, with what version and command the rows came to be
summary   the runs of one method on one scene
table     the markdown table
targets   the speed that Accord has to reach, and what it reached
paper     what the ARC paper published
against_robots, boxes, timeline   pictures, with their style and svg (matplotlib)
page      HTML
report    all of it as one HTML file
"""
