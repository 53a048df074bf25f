c Problem:    theta1-min
c Rows:       6
c Columns:    2
c Non-zeros:  12
c Status:     UNDEFINED
c Objective:  theta1_min = 0 (MINimum)
c
s bas 6 2 u u 0
i 1 b 0 0
i 2 b 0 0
i 3 b 0 0
i 4 b 0 0
i 5 b 0 0
i 6 b 0 0
j 1 f 0 0
j 2 f 0 0
e o f
