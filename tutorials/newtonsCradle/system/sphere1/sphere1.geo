//------------------------------------------------------------------------------
// vertexContact: quarter of a sphere of 10 mm radius about (0 0 0), y > 0 and
// z > 0. Edges of size [mm] at both ends in x, where it will touch, larger ones
// elsewhere. Made in metres.
//------------------------------------------------------------------------------
DefineConstant[size = 0.24];

R = 0.01;

Point(1) = {0, 0, 0};
Point(2) = {-R, 0, 0};
Point(3) = {R, 0, 0};
Point(4) = {0, R, 0};
Point(5) = {0, 0, R};
Line(1) = {2, 1};
Line(2) = {1, 3};
Circle(3) = {2, 1, 4};
Circle(4) = {4, 1, 3};
Circle(5) = {2, 1, 5};
Circle(6) = {5, 1, 3};
Circle(7) = {4, 1, 5};
Curve Loop(1) = {3, 7, -5};
Surface(1) = {1};
Curve Loop(2) = {4, -6, -7};
Surface(2) = {2};
Curve Loop(3) = {1, 2, -4, -3};
Plane Surface(3) = {3};
Curve Loop(4) = {5, 6, -2, -1};
Plane Surface(4) = {4};
Surface Loop(1) = {1, 2, 3, 4};
Volume(1) = {1};

// Edges of size up to 1.2 mm from the ends, about 1.2 times the radius of the
// largest contact, and growing by a fifth of the distance beyond, to 7 times it
Mesh.CharacteristicLengthMin = size*1e-3;
Mesh.CharacteristicLengthMax = 7*size*1e-3;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
Mesh.CharacteristicLengthFromPoints = 0;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.2*(Sqrt((%g - Sqrt(x*x))^2 + y*y + z*z) - 0.0012)",
    size*1e-3, R);
Background Field = 1;

Physical Volume("sphere") = {1};
Physical Surface("surface") = {1, 2};
// The mirrors (createPatchDict)
Physical Surface("cutZ") = {3};
Physical Surface("cutY") = {4};
