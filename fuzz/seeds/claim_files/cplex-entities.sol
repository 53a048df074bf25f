<?xml version="1.0"?>
<!DOCTYPE a [<!ENTITY b "bbbbbbbbbb"><!ENTITY c "&b;&b;&b;&b;">]>
<CPLEXSolution version="1.2"><header problemName="theta1-min" solutionStatusString="&c;"/></CPLEXSolution>
