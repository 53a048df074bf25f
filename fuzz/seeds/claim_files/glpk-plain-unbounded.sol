c Problem:    theta1-min
c Rows:       6
c Columns:    2
c Non-zeros:  12
c Status:     UNBOUNDED
c Objective:  theta1_min = 1.95 (MINimum)
c
s bas 6 2 f n 1.95
i 1 b 3.9 0
i 2 b 3.9 0
i 3 b 3.9 0
i 4 b 3.9 0
i 5 l 3.9 0.5
i 6 b 3.9 0
j 1 b 1.95 0
j 2 f 0 -0.5
e o f
