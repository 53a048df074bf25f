Model status
Optimal

# Primal solution values
Feasible
Objective 1
# Columns 99999999999
theta1 1
