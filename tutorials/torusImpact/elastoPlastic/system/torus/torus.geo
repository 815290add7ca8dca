//------------------------------------------------------------------------------
// vertexContact: torus about the z axis, tube of 10 mm thickness about a circle
// of 35 mm radius; size is the length of the edges [mm]. Made in metres.
//------------------------------------------------------------------------------
DefineConstant[size = 2.3];

R = 0.035;
r = 0.005;
Mesh.CharacteristicLengthMin = size*1e-3;
Mesh.CharacteristicLengthMax = size*1e-3;

// Section of the tube at x = R: centre and four arcs
Point(1) = {R, 0, 0};
Point(2) = {R + r, 0, 0};
Point(3) = {R, 0, r};
Point(4) = {R - r, 0, 0};
Point(5) = {R, 0, -r};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

// Four quarters about z. An extrusion returns its end, the body and its sides
section = 1;
bodies[] = {};
sides[] = {};
For i In {1:4}
    quarter[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi/2} { Surface{section}; };
    section = quarter[0];
    bodies[] += quarter[1];
    sides[] += {quarter[2], quarter[3], quarter[4], quarter[5]};
EndFor
Coherence;

Physical Volume("torus") = {bodies[]};
Physical Surface("outer") = {sides[]};
