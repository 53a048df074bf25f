c Problem:    theta1-min
c Rows:       7
c Columns:    2
c Non-zeros:  13
c Status:     UNBOUNDED
c Objective:  theta1_min = 1.95 (MINimum)
c
s bas 7 2 f i 1.95
i 1 b 1.95 0
i 2 b 3.9 0
i 3 b 3.9 0
i 4 b 3.9 0
i 5 b 3.9 0
i 6 l 3.9 0.5
i 7 b 3.9 0
j 1 b 1.95 0
j 2 f 0 -0.5
e o f
