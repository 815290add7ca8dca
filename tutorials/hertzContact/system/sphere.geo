//------------------------------------------------------------------------------
// vertexContact: quarter of a sphere of 10 mm radius, x > 0 and y > 0, 0.1 mm
// above (up = 1) or below (up = -1) the plane z = 0. Edges of size [mm] where
// it will touch, larger ones elsewhere. Made in metres.
//------------------------------------------------------------------------------
DefineConstant[size = 0.21];

R = 0.01;
zC = up*(R + 1e-4);

// Centre, pole that will touch, other pole, and two points of the equator, in
// the order that makes the lower sphere the upper one after half a turn about
// the line x = y, z = 0, so that the two meshes do not match
Point(1) = {0, 0, zC};
Point(2) = {0, 0, zC - up*R};
Point(3) = {0, 0, zC + up*R};
Point(4) = {up > 0 ? R : 0, up > 0 ? 0 : R, zC};
Point(5) = {up > 0 ? 0 : R, up > 0 ? R : 0, zC};
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

// Edges of size up to 2 mm from the pole, about 1.2 times the radius of the
// largest contact, and growing by a fifth of the distance beyond, to 7 times it
Mesh.CharacteristicLengthMin = size*1e-3;
Mesh.CharacteristicLengthMax = 7*size*1e-3;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
Mesh.CharacteristicLengthFromPoints = 0;
Field[1] = MathEval;
Field[1].F = Sprintf("%g + 0.2*(Sqrt(x*x + y*y + (%g - z)^2) - 0.002)",
    size*1e-3, zC - up*R);
Background Field = 1;

Physical Volume("sphere") = {1};
Physical Surface("surface") = {1, 2};
// The mirrors (createPatchDict)
Physical Surface("cutX") = {up > 0 ? 4 : 3};
Physical Surface("cutY") = {up > 0 ? 3 : 4};
