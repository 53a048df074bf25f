c Objective:  theta1_min = 1 (MINimum)
s bas 18446744073709551615 3 f f 1
j 3 b 1 0
e o f
