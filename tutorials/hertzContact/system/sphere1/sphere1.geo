// Above the plane z = 0
up = 1;
Include "../sphere.geo";
