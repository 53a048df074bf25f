c Problem:    theta1-min
c Rows:       6
c Columns:    2
c Non-zeros:  12
c Status:     INFEASIBLE (FINAL)
c Objective:  theta1_min = 0.7045700897 (MINimum)
c
s bas 6 2 n i 0.704570089667913
i 1 b -5.720942 0
i 2 u 2.09732 0.0901185058351733
i 3 b 3.07716562370117 0
i 4 l -5.720942 -0.0901185058351733
i 5 b 2.09732 0
i 6 b 3.07716562370117 0
j 1 b 0.704570089667913 0
j 2 b 1.20702523469562 0
e o f
