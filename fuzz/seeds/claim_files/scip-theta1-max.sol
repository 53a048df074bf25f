solution status: optimal solution found
objective value:                 -0.00184840036351874
theta1                            0.00184840036351874 	(obj:-1)
theta2                             0.0226003527364027 	(obj:0)
