//------------------------------------------------------------------------------
// vertexContact: four feet of 8 x 8 x 8 mm, 0.1 mm above the floor; size is the
// length of their edges [mm]. Made in metres.
//------------------------------------------------------------------------------
SetFactory("OpenCASCADE");
DefineConstant[size = 2];

Mesh.CharacteristicLengthMin = 1e-3*size;
Mesh.CharacteristicLengthMax = 1e-3*size;

a = 0.008;
z = 0.0001;
Box(1) = {-0.029, -0.019, z, a, a, a};
Box(2) = {0.021, -0.019, z, a, a, a};
Box(3) = {-0.029, 0.011, z, a, a, a};
Box(4) = {0.021, 0.011, z, a, a, a};

e = 1e-5;
bottom() = Surface In BoundingBox {-1, -1, z - e, 1, 1, z + e};
top() = Surface In BoundingBox {-1, -1, z + a - e, 1, 1, z + a + e};
sides() = Surface{:};
sides() -= {bottom(), top()};
Physical Volume("bumper") = {1:4};
Physical Surface("bottom") = {bottom()};
Physical Surface("top") = {top()};
Physical Surface("sides") = {sides()};
