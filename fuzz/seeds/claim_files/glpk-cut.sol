c Objective:  theta1_min = 1 (MINimum)
s bas 1 2 f f 1
i 1 b 0 0
j 1 b 1 0
