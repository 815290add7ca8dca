//------------------------------------------------------------------------------
// vertexContact: a closed box of 60 x 40 x 30 mm, walls of 4 mm, the underside
// 8.1 mm above the floor; size is the length of the edges of the feet [mm],
// those of the box are twice as long. Made in metres.
//------------------------------------------------------------------------------
SetFactory("OpenCASCADE");
DefineConstant[size = 2];

Mesh.CharacteristicLengthMin = 2e-3*size;
Mesh.CharacteristicLengthMax = 2e-3*size;

z = 0.0081;
Box(1) = {-0.03, -0.02, z, 0.06, 0.04, 0.03};
Box(2) = {-0.026, -0.016, z + 0.004, 0.052, 0.032, 0.022};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };

e = 1e-5;
bottom() = Surface In BoundingBox {-1, -1, z - e, 1, 1, z + e};
others() = Surface{:};
others() -= {bottom()};
Physical Volume("box") = {3};
Physical Surface("bottom") = {bottom()};
Physical Surface("surface") = {others()};
