solution status: optimal solution found
objective value:                  0.00179089203479447
theta1                            0.00179089203479447 	(obj:1)
theta2                             0.0226924697253966 	(obj:0)
