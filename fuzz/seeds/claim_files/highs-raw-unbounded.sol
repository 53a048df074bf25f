Model status
Unbounded

# Primal solution values
Feasible
Objective 1.95
# Columns 2
theta1 1.95
theta2 0
# Rows 6
row1_upper 3.9
row2_upper 3.9
row3_upper 3.9
row1_lower 3.9
row2_lower 3.9
row3_lower 3.9

# Dual solution values
Infeasible
# Columns 2
theta1 0
theta2 -0.5
# Rows 6
row1_upper 0
row2_upper 0
row3_upper 0
row1_lower 0
row2_lower 0.5
row3_lower 0

# Basis
HiGHS_basis_file v2
Valid
# Columns 2
theta1 1
theta2 3
# Rows 6
row1_upper 1
row2_upper 1
row3_upper 1
row1_lower 1
row2_lower 0
row3_lower 1
