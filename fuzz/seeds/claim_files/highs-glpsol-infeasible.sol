c Problem:    theta1-min
c Rows:       7
c Columns:    2
c Non-zeros:  13
c Status:     INFEASIBLE (FINAL)
c Objective:  theta1_min = 0.9860408427 (MINimum)
c
s bas 7 2 u u 0.9860408427411
