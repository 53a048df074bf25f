Optimal - objective value -0.00184840
      0 theta1         0.0018484004                       0
      1 theta2          0.022600353                       0
