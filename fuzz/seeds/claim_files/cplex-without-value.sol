<?xml version="1.0"?>
<CPLEXSolution version="1.2">
<header problemName="theta1-min" solutionStatusString="optimal"/>
<variables><variable name="theta1" value="1"/>
<variable name="theta2" index="1"/></variables>
</CPLEXSolution>
